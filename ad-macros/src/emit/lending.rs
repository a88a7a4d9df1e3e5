//! Calls that add to the cotangents of their caller in place.
//!
//! A pullback returns the cotangents of its parameters. For a slice that is a vector of the length
//! of the slice, made of zeros and added to that of the caller: a loop that calls a function of a
//! slice n times would take n² steps. So beside `vjp` stands `vjp_onto`, which callers take when
//! they pass references: its pullback takes one more argument, a tuple with a member for each
//! parameter. What is behind a reference to a slice, a `Vec` or a type of its own is lent: the
//! caller moves the cotangent that it has so far into the tuple, the reverse sweep starts from that
//! instead of zero, and the result is the whole, which moves back. All other members are
//! `ad::rt::NotLent`. Where nothing is lent `vjp_onto` is `vjp`, and so it is for a function that
//! was imported with a rule. What is lent, the types tell (`ad::rt::PullbackOnto`): the macro that
//! writes the call does not know the signature of what it calls.
//!
//! Turned down: `&mut` in place of moving there and back (a variable may be passed twice, and what
//! is an array here may be a slice there); sparse cotangents (an indirection for each element in
//! all other uses). Arrays are not lent, for moving them costs as much as adding them up.
//!
//! What is behind a `&mut` comes in and goes out anyway. `vjp` brings what goes out, as what was lent,
//! to the size of the parameter, for which it keeps the lengths of all lists in it; `vjp_onto` does not:
//! what lacks zeros at its end is a cotangent too, and the walk would cost as much as the whole has
//! elements. The same holds of values that move into the call: what their cotangents lack callers do not
//! miss.
//!
//! A method `m` of an `impl` block has `lent_2_to_m` beside `m_vjp` (2 is the number of arguments), if
//! it takes `&self`, and `lent_2_to_mut_m` for receivers that may change; the latter alone if it takes
//! `&mut self`. Rules of other crates and the methods of traits need not have one, so the caller
//! asks first: `lending_2_to_m`, or `lending_2_to_mut_m`, says that there is one, and a trait in the body of
//! the caller, which yields to the type's own method, says that there is none. (The names do not begin with `m`, or the
//! compiler would propose them where `m_vjp` is missing. There are two, since of methods of one name
//! the compiler takes those by `&self` first, be they the type's or a trait's.)

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};
use syn::{Expr, Lit, ReceiverKind, Type};

use crate::emit::header::{Header, lints, turbofish};
use crate::emit::sized;
use crate::lower::may_move;
use crate::parse::function::{Function, Place};
use crate::parse::signature::Parameter;
use crate::types::{has_fixed_size, is_box, pointee};

/// Whether callers may lend cotangents to the function: its reverse sweep is written here.
pub fn is_possible(function: &Function<'_>) -> bool {
    let is_placed = match (function.place, function.signature.receiver()) {
        (Place::Free, _) => true,
        (Place::Impl(_), Some(receiver)) => !matches!(receiver.kind, ReceiverKind::Typed(..)),
        _ => false,
    };
    is_placed && function.options.vjp.is_none() && !function.callables.any()
}

/// Whether callers lend the cotangent of a parameter.
pub fn is_lent(parameter: &Parameter) -> bool {
    let may_be_large = match pointee(&parameter.ty) {
        Type::Slice(_) => true,
        Type::Path(_) => !has_fixed_size(&parameter.ty, &[]) && !is_box(&parameter.ty),
        _ => false,
    };
    parameter.is_shared && !parameter.is_constant && may_be_large
}

/// Whether `vjp` brings the cotangent of a parameter to size if callers [may lend](is_possible): it
/// is lent, or is that of a `&mut` or of a value that moves.
pub fn is_sized_by_vjp(parameter: &Parameter, scalars: &[Ident]) -> bool {
    let Parameter { ty, is_exclusive, is_shared, is_constant, .. } = parameter;
    let is_handed_over = *is_exclusive || !is_shared && may_move(ty, scalars);
    is_lent(parameter) || is_handed_over && !is_constant && !has_fixed_size(ty, scalars)
}

/// Whether there has to be a `vjp_onto`: of a function wherever it may be passed what may be a reference, of
/// a method where callers lend.
pub fn is_asked_for(function: &Function<'_>, header: &Header) -> bool {
    matches!(function.place, Place::Free) || header.is_split()
}

/// A method that may be lent cotangents, as it is called.
#[derive(PartialEq, Eq, PartialOrd, Ord, Clone)]
pub struct Method {
    pub name: Ident,
    /// The number of its arguments.
    pub arity: usize,
    /// Whether what it is called on may be changed by it.
    pub is_mutable: bool,
}

impl Method {
    /// The function that is lent cotangents.
    fn onto(&self) -> Ident {
        self.prefixed("lent")
    }

    /// The function that says that there is such a one.
    fn lends(&self) -> Ident {
        self.prefixed("lending")
    }

    fn prefixed(&self, prefix: &str) -> Ident {
        let Self { name, arity, is_mutable } = self;
        let to = if *is_mutable { "to_mut" } else { "to" };
        format_ident!("{}_{}_{}_{}", prefix, arity, to, name, span = Span::call_site())
    }

    /// What says of types without a method that is lent cotangents that they have none.
    pub fn default_trait(&self) -> TokenStream {
        let (onto, lends) = (self.onto(), self.lends());
        let mutability = self.is_mutable.then(|| quote!(mut));
        let types: Vec<_> = (0..self.arity).map(|index| format_ident!("A{index}")).collect();
        quote! {
            trait #lends {
                fn #lends(&self) -> ::ad::rt::LendsNothing {
                    ::ad::rt::LendsNothing
                }

                fn #onto<#(#types),*>(&#mutability self #(, _: #types)*) {}
            }
            impl<T: ?::core::marker::Sized> #lends for T {}
        }
    }

    /// Value and pullback: of the method that is lent cotangents, if there is one, called on `lender`, or else of `vjp`.
    /// No other variables have names that begin with that of the `record`.
    pub fn call(
        &self,
        record: &Ident,
        [receiver, lender]: [&TokenStream; 2],
        vjp: &TokenStream,
        arguments: &[TokenStream],
    ) -> TokenStream {
        let (onto, lends) = (self.onto(), self.lends());
        let names = ["lends", "onto", "own"].map(|name| format_ident!("{record}_{name}"));
        let [choice, lent, own] = &names;
        quote! {{
            let #choice = #receiver.#lends();
            let (mut #lent, mut #own) = (::core::option::Option::None, ::core::option::Option::None);
            if #choice.lends(&#lent, &#own) {
                #choice.lent();
                #lent = ::core::option::Option::Some(#lender.#onto(#(#arguments),*));
            } else {
                #own = ::core::option::Option::Some(#receiver.#vjp(#(#arguments),*));
            }
            #choice.choose(#lent, #own)
        }}
    }
}

/// Whether the type of a constant does not depend on what it is passed to: it is written down for
/// either function, and one of them takes anything.
pub fn has_own_type(constant: &TokenStream) -> bool {
    fn has(expr: &Expr) -> bool {
        match expr {
            // Taken by what takes anything, a number without a type is an `i32`.
            Expr::Lit(literal) => match &literal.lit {
                Lit::Int(number) => {
                    !number.suffix().is_empty() || number.base10_parse::<i32>().is_ok()
                }
                _ => true,
            },
            Expr::Path(path) => path.path.segments.last().is_some_and(|last| {
                let name = last.ident.to_string();
                !name.starts_with(char::is_uppercase) || name.to_uppercase() == name
            }),
            Expr::Paren(inner) => has(&inner.expr),
            Expr::Tuple(tuple) => tuple.elems.iter().all(has),
            Expr::Cast(_) => true,
            Expr::Unary(inner) => has(&inner.expr),
            Expr::Reference(inner) => inner.mutability.is_none() && has(&inner.expr),
            Expr::Field(field) => has(&field.base),
            Expr::Index(index) => has(&index.expr),
            Expr::Binary(binary) => has(&binary.left) && has(&binary.right),
            Expr::MethodCall(call) => call.method == "len" && has(&call.receiver),
            Expr::Call(call) => {
                matches!(&*call.func, Expr::Path(path) if path.path.segments.last().is_some_and(|last| last.ident == "constant"))
                    && call.args.iter().all(has)
            }
            _ => false,
        }
    }
    syn::parse2::<Expr>(constant.clone()).is_ok_and(|expr| has(&expr))
}

/// Writes the two functions.
pub struct Functions<'a> {
    function: &'a Function<'a>,
    header: &'a Header,
    inputs: &'a TokenStream,
    bounds: &'a [TokenStream],
}

impl<'a> Functions<'a> {
    /// For a function with these generated parameters and bounds.
    pub fn new(
        function: &'a Function<'a>,
        header: &'a Header,
        inputs: &'a TokenStream,
        bounds: &'a [TokenStream],
    ) -> Self {
        Self { function, header, inputs, bounds }
    }

    /// The body of `vjp`, and `vjp_onto`. One of them has the sweeps in it, the other calls it.
    pub fn vjp_and_onto(&self, sweeps: &TokenStream) -> (TokenStream, TokenStream) {
        match self.header.is_split() {
            true => {
                let call = self.call(&self.onto_name());
                let vjp = sized::vjp(self.header, &call, &self.header.sized_by_vjp, false);
                (vjp, self.onto(sweeps))
            }
            false => {
                let vjp = self.call(&format_ident!("vjp"));
                (sweeps.clone(), self.onto(&quote!({ #vjp })))
            }
        }
    }

    fn onto(&self, body: &TokenStream) -> TokenStream {
        if let Place::Free = self.function.place {
            return self.onto_as(&self.onto_name(), &quote!(pub), body);
        }
        let own = self.method_onto(self.changes_receiver(), body);
        let as_mutable = (!self.changes_receiver()).then(|| {
            let call = self.call(&self.onto_name());
            self.method_onto(true, &quote!({ #call }))
        });
        quote!(#own #as_mutable)
    }

    /// The function that is lent cotangents, and the one that says so.
    fn method_onto(&self, is_mutable: bool, body: &TokenStream) -> TokenStream {
        let (method, visibility) = (self.method(is_mutable), self.function.visibility);
        let onto = self.onto_as(&method.onto(), &quote!(#visibility), body);
        let lends = method.lends();
        quote! {
            #onto

            #[doc(hidden)]
            #[allow(unused, non_snake_case)]
            #[inline(always)]
            #visibility fn #lends(&self) -> ::ad::rt::Lends {
                ::ad::rt::Lends
            }
        }
    }

    /// The function that is lent cotangents, under this name.
    fn onto_as(&self, name: &Ident, visibility: &TokenStream, body: &TokenStream) -> TokenStream {
        let Self { function, header, inputs, bounds } = self;
        let generics = &function.callables.signature.generics;
        let generics = (!generics.params.is_empty()).then_some(generics);
        let pullback = function.pullback_type(header, header.lends());
        let lints = lints();
        quote! {
            #[doc(hidden)]
            #lints
            #[inline]
            #visibility fn #name #generics (#inputs) -> #pullback
            where #(#bounds),*
            #body
        }
    }

    /// The name of the function that is lent cotangents.
    fn onto_name(&self) -> Ident {
        match self.function.place {
            Place::Free => format_ident!("vjp_onto"),
            _ => self.method(self.changes_receiver()).onto(),
        }
    }

    /// The method, as it is called on what may change or on what may not.
    fn method(&self, is_mutable: bool) -> Method {
        let name = self.function.signature.ident.clone();
        Method { name, arity: self.header.parameters.len() - 1, is_mutable }
    }

    /// Whether the function is a method that takes `&mut self`.
    fn changes_receiver(&self) -> bool {
        self.header.parameters[0].is_exclusive
    }

    /// The call of the other function with the same arguments.
    fn call(&self, other: &Ident) -> TokenStream {
        let arguments = self.header.parameters.iter().map(|parameter| &parameter.ident);
        let turbofish = turbofish(&self.function.callables.signature);
        quote!(Self::#other #turbofish (#(#arguments),*))
    }
}
