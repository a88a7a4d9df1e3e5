//! Calls: the arguments, then their tangents in the same order.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::Expr;

use super::{Tangent, Writer};
use crate::floats;
use crate::ir::primal::Primal;
use crate::ir::{Argument, Callee, Operand, Place, Projection, VarId};

/// An argument and its tangent.
struct Passed {
    value: TokenStream,
    tangent: TokenStream,
}

impl Writer<'_> {
    pub(super) fn call(
        &mut self,
        var: VarId,
        callee: &Callee,
        arguments: &[Argument],
    ) -> TokenStream {
        let mut before = TokenStream::new();
        let (jvp, method) = (callee.derivative.jvp(), callee.is_method);
        let takes_number =
            callee.method_name().is_some_and(|name| floats::takes_number(&name.to_string()));
        let passed = arguments.iter().enumerate().map(|(index, argument)| match argument {
            Argument::Receiver(place) if takes_number && self.is_number_at(place) => {
                Passed { value: self.primal_place(place), tangent: self.owned(place.root) }
            }
            argument => {
                let is_receiver = method && index == 0;
                self.argument(argument, is_receiver, is_receiver && takes_number, &mut before)
            }
        });
        let passed: Vec<_> = passed.collect();
        let values: Vec<_> = passed.iter().map(|passed| &passed.value).collect();
        let tangents = passed.iter().map(|passed| &passed.tangent);
        let call = match (method, &values[..]) {
            (true, [receiver, values @ ..]) => {
                let receiver = match &arguments[0] {
                    Argument::Borrow(_) => quote!((#receiver)),
                    _ => quote!(#receiver),
                };
                quote!(#receiver.#jvp(#(#values,)* #(#tangents),*))
            }
            (_, values) => quote!(#jvp(#(#values,)* #(#tangents),*)),
        };
        let ident = self.ident(var).clone();
        let mutability = self.lowered.vars[var].mutable.then(|| quote!(mut));
        let dot = self.new_dot(var, Tangent::OwnedTarget);
        let check = Primal(&self.lowered.vars).check_name(callee, arguments, &ident);
        let [check, after] = check.unwrap_or_default();
        quote!(#check #before let (#mutability #ident, #mutability #dot) = #call; #after)
    }

    /// An argument, with what has to stand before the call; `is_small` says that it certainly is a number or a
    /// vector, whose tangent need not be moved.
    fn argument(
        &mut self,
        argument: &Argument,
        is_receiver: bool,
        is_small: bool,
        before: &mut TokenStream,
    ) -> Passed {
        let primal = Primal(&self.lowered.vars);
        if primal.is_function(argument) {
            let value = primal.argument(argument);
            return Passed { value, tangent: quote!(()) };
        }
        match argument {
            // Neither has a tangent that its type would not tell; a closure's parameters get their
            // types from where it is passed.
            Argument::Value(Operand::Constant(tokens))
                if is_number(tokens) || is_closure(tokens) =>
            {
                Passed { value: tokens.clone(), tangent: quote!(::ad::Additive::zero()) }
            }
            Argument::Value(Operand::Constant(tokens)) => {
                let value = match is_place(tokens) {
                    true => tokens.clone(),
                    false => {
                        let name = self.names.fresh("argument", Span::call_site());
                        before.extend(quote!(let #name = #tokens;));
                        quote!(#name)
                    }
                };
                let tangent = self.still(quote!(&#value), before);
                Passed { value, tangent }
            }
            Argument::Value(Operand::Var(var)) => {
                let ident = self.ident(*var).clone();
                let value = quote!(#ident);
                let tangent = match self.tangents[*var] {
                    Tangent::Still => self.still(quote!(&#ident), before),
                    // A method may borrow its receiver.
                    Tangent::Owned if !is_receiver => self.owned(*var),
                    Tangent::OwnedTarget if !is_receiver && self.numbers.contains(var) => {
                        self.owned(*var)
                    }
                    Tangent::Owned | Tangent::OwnedTarget => {
                        let dot = self.dot(*var);
                        let block = self.lowered.vars[*var].block;
                        match self.uses.end_at_home(*var, block, self.position) {
                            true if !is_small => {
                                let last = self.names.fresh("last", Span::call_site());
                                before.extend(quote!(let mut #last = #dot;));
                                quote!(::ad::rt::pass(::ad::rt::Last(&mut #last)))
                            }
                            _ => quote!(::ad::rt::pass(&#dot)),
                        }
                    }
                    Tangent::Shared if self.is_own(*var) => {
                        let dot = self.dot(*var);
                        quote!(::ad::rt::pass(#dot))
                    }
                    Tangent::Shared => {
                        let dot = self.dot(*var);
                        self.lent_part(quote!(&#ident), quote!(#dot), before)
                    }
                    Tangent::Exclusive => {
                        let dot = self.dot(*var);
                        quote!(::ad::rt::pass(&mut *#dot))
                    }
                };
                Passed { value, tangent }
            }
            Argument::Borrow(place) => {
                let tokens = self.primal_place(place);
                let value = quote!(&#tokens);
                Passed { tangent: self.lent(place, before), value }
            }
            Argument::Exclusive(place) | Argument::Reborrow(place) => {
                let tokens = self.primal_place(place);
                let value = quote!(&mut #tokens);
                Passed { tangent: self.lent_exclusively(place, before), value }
            }
            Argument::Function(_) | Argument::Callee(_) | Argument::PassedOn(..) => {
                unreachable!("is a function")
            }
            Argument::Receiver(place) => {
                let value = self.primal_place(place);
                let may_change = self.lowered.vars[place.root].mutable
                    && !self.uses.share_receiver(self.position);
                let tangent = match may_change {
                    true if self.ends_as_a_whole(place) => {
                        let dot = self.dot(place.root);
                        quote!(::ad::rt::pass(::ad::rt::Last(&mut #dot)))
                    }
                    true => self.lent_exclusively(place, before),
                    false => self.lent(place, before),
                };
                Passed { value, tangent }
            }
        }
    }

    /// The tangent of a place that is passed by reference, or by value as a receiver.
    fn lent(&mut self, place: &Place, before: &mut TokenStream) -> TokenStream {
        let value = self.primal_place(place);
        if self.tangents[place.root] == Tangent::Still {
            return self.still(quote!(&#value), before);
        }
        let tangent = self.shared(place);
        match is_sure(place) && self.is_own(place.root) {
            true => quote!(::ad::rt::pass(#tangent)),
            false => self.lent_part(quote!(&#value), tangent, before),
        }
    }

    /// The tangent of a place that the call may change.
    fn lent_exclusively(&mut self, place: &Place, before: &mut TokenStream) -> TokenStream {
        let value = self.primal_place(place);
        if self.tangents[place.root] == Tangent::Still {
            return self.still(quote!(&#value), before);
        }
        let tangent = self.exclusive(place);
        match is_sure(place) {
            true => quote!(::ad::rt::pass(#tangent)),
            false => self.lent_part(quote!(&#value), tangent, before),
        }
    }

    /// Whether a place is a variable with a tangent of its own that nothing uses after this statement.
    fn ends_as_a_whole(&self, place: &Place) -> bool {
        place.path.is_empty()
            && matches!(self.tangents[place.root], Tangent::Owned | Tangent::OwnedTarget)
            && self.uses.end_with(place.root, self.position)
    }

    /// Whether a place is a variable that certainly is a number, with a tangent of its own.
    fn is_number_at(&self, place: &Place) -> bool {
        place.path.is_empty()
            && self.numbers.contains(&place.root)
            && matches!(self.tangents[place.root], Tangent::Owned | Tangent::OwnedTarget)
    }

    /// Whether the tangent of a variable is that of a parameter or a value, not of a field.
    pub(super) fn is_own(&self, root: VarId) -> bool {
        self.tangents[root] != Tangent::Shared
            || self.lowered.parameters.iter().any(|parameter| parameter.var == root)
    }

    /// The tangent of what does not move, made before the call, which may move the value.
    fn still(&mut self, value: TokenStream, before: &mut TokenStream) -> TokenStream {
        let (slot, zero) = self.slot();
        before.extend(quote! {
            let mut #slot = ::ad::rt::Slot::new();
            let #zero = ::ad::rt::still(#value, &mut #slot);
        });
        quote!(#zero)
    }

    /// The tangent of what may be a `#[constant]` field.
    fn lent_part(
        &mut self,
        value: TokenStream,
        tangent: TokenStream,
        before: &mut TokenStream,
    ) -> TokenStream {
        let (slot, part) = self.slot();
        before.extend(quote! {
            let mut #slot = ::ad::rt::Slot::new();
            let #part = ::ad::rt::pass_part(#value, #tangent, &mut #slot);
        });
        quote!(#part)
    }

    fn slot(&mut self) -> (Ident, Ident) {
        let mut fresh = |name| self.names.fresh(name, Span::call_site());
        (fresh("slot"), fresh("argument_dot"))
    }
}

/// Whether every step leads to what certainly has a tangent.
fn is_sure(place: &Place) -> bool {
    !place.path.iter().any(|step| matches!(step, Projection::Field(_)))
}

/// Whether the tokens are a literal number or truth value.
fn is_number(tokens: &TokenStream) -> bool {
    match syn::parse2::<Expr>(tokens.clone()) {
        Ok(Expr::Lit(literal)) => {
            !matches!(literal.lit, syn::Lit::Str(_) | syn::Lit::ByteStr(_) | syn::Lit::CStr(_))
        }
        Ok(Expr::Unary(unary)) => {
            let inner = &unary.expr;
            is_number(&quote!(#inner))
        }
        Ok(Expr::Paren(paren)) => {
            let inner = &paren.expr;
            is_number(&quote!(#inner))
        }
        _ => false,
    }
}

/// Whether the tokens are a closure.
fn is_closure(tokens: &TokenStream) -> bool {
    matches!(syn::parse2::<Expr>(tokens.clone()), Ok(Expr::Closure(_)))
}

/// Whether the tokens are a place, or the name of a constant. A value that is not `Copy` cannot be
/// taken out of a place by a `let`. `None` is of another type wherever it is written.
fn is_place(tokens: &TokenStream) -> bool {
    fn names_place(expr: &Expr) -> bool {
        match expr {
            Expr::Path(name) => !name.path.is_ident("None"),
            Expr::Paren(inner) => names_place(&inner.expr),
            Expr::Field(field) => names_place(&field.base),
            Expr::Index(element) => names_place(&element.expr) && is_index(&element.index),
            _ => false,
        }
    }
    fn is_index(expr: &Expr) -> bool {
        match expr {
            Expr::Lit(_) => true,
            Expr::Binary(binary) => is_index(&binary.left) && is_index(&binary.right),
            expr => names_place(expr),
        }
    }
    syn::parse2(tokens.clone()).is_ok_and(|expr| names_place(&expr))
}
