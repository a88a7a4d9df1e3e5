//! The tangent of the result of each operation.

use proc_macro2::{Span, TokenStream};
use quote::{quote, quote_spanned};
use syn::{Member, Type};

use super::{Tangent, Writer};
use crate::analyse::uses::is_part_of_value;
use crate::ir::primal::Primal;
use crate::ir::{BinaryOperator, Operand, Operation, Place, Projection, Shape, VarId};

impl Writer<'_> {
    pub(super) fn define(
        &mut self,
        var: VarId,
        ty: Option<&Type>,
        operation: &Operation,
    ) -> TokenStream {
        let ty = ty.map(|ty| quote!(: #ty));
        let ident = self.ident(var).clone();
        let mutability = self.lowered.vars[var].mutable.then(|| quote!(mut));
        let span = ident.span();
        match operation {
            Operation::Call { callee, arguments } => return self.call(var, callee, arguments),
            Operation::Binary(operator, left, right) => {
                if let Some(tangent) = self.arithmetic(*operator, *left, *right) {
                    let value = Primal(&self.lowered.vars).operation(operation, span);
                    self.numbers.insert(var);
                    let dot = self.new_dot(var, Tangent::Owned);
                    return quote!(let #ident = #value; let #dot = #tangent;);
                }
                let moves = [left, right].iter().any(|&&var| self.tangents[var] != Tangent::Still);
                if moves {
                    self.numbers.insert(var);
                    let pushed = self.operator(*operator, false, *left, *right);
                    let dot = self.new_dot(var, Tangent::Owned);
                    return quote!(let (#ident, #dot) = #pushed;);
                }
            }
            Operation::Negate(value) if self.tangents[*value] != Tangent::Still => {
                let (value, tangent) = (self.ident(*value).clone(), self.owned(*value));
                self.numbers.insert(var);
                let dot = self.new_dot(var, Tangent::Owned);
                return quote_spanned!(span=>
                    let (#ident, #dot) = ::ad::rules::NegPullback::neg_jvp(#value, #tangent););
            }
            Operation::Closure(closure) => {
                let object = self.object(closure);
                return quote!(let #ident #ty = #object;);
            }
            Operation::Named { primal, derivative } => {
                let jvp = derivative.jvp();
                return quote!(let #ident = ::ad::function::named(#primal, #jvp););
            }
            _ => {}
        }

        let value = Primal(&self.lowered.vars).operation(operation, span);
        let definition = quote!(let #mutability #ident #ty = #value;);
        if self.stays_still(var, operation) {
            return definition;
        }
        if self.is_number(operation) {
            self.numbers.insert(var);
        }
        let (tangent, kind) = self.tangent_of(var, operation);
        let dot = self.new_dot(var, kind);
        // A field that is given its tangent later changes, too.
        let fields = self.fields(var, operation);
        // So does what a part may move out of.
        let changes = !fields.is_empty() || self.lowered.movable.contains(&var);
        let mutability = match changes {
            true => Some(quote!(mut)),
            false => mutability,
        };
        if changes {
            self.changing.insert(var);
        }
        // What moves out of a variable goes after the tangent has been told its type by the value.
        quote!(#definition let #mutability #dot = #tangent; #fields)
    }

    /// Whether an operation certainly gives a number or a vector.
    fn is_number(&self, operation: &Operation) -> bool {
        match operation {
            Operation::Value(_) | Operation::Cast(..) => true,
            Operation::Use(Operand::Var(var)) => self.numbers.contains(var),
            Operation::Use(Operand::Constant(tokens)) => {
                matches!(syn::parse2::<syn::Lit>(tokens.clone()), Ok(syn::Lit::Float(_)))
            }
            Operation::Read(Place { root, path }) => match &path[..] {
                [] => self.numbers.contains(root),
                [Projection::Index(index)] => {
                    self.of_numbers.contains(root) && !index.to_string().contains("..")
                }
                _ => false,
            },
            _ => false,
        }
    }

    /// Names the tangent of `var`, and remembers what it is.
    pub(super) fn new_dot(&mut self, var: VarId, kind: Tangent) -> proc_macro2::Ident {
        self.tangents[var] = kind;
        self.dot(var)
    }

    /// Whether the result of an operation certainly has a tangent of zero, and keeps it.
    fn stays_still(&self, var: VarId, operation: &Operation) -> bool {
        let var = &self.lowered.vars[var];
        if !var.active {
            return true;
        }
        let is_still = |var: VarId| self.tangents[var] == Tangent::Still;
        let operands_are = match operation {
            Operation::Use(operand) => self.is_still(operand),
            Operation::Read(place) | Operation::Clone(place, _) | Operation::Borrow(place) => {
                is_still(place.root)
            }
            Operation::Value(value) | Operation::Negate(value) | Operation::Cast(value, _) => {
                is_still(*value)
            }
            Operation::Binary(_, left, right) => is_still(*left) && is_still(*right),
            Operation::Aggregate { parts, .. } => parts.iter().all(|(_, part)| self.is_still(part)),
            Operation::UpdateStruct { parts, rest, .. } => {
                is_still(rest.root) && parts.iter().all(|(_, part)| self.is_still(part))
            }
            Operation::Repeat { value, .. } => is_still(*value),
            Operation::Call { .. } | Operation::Closure(_) | Operation::Named { .. } => false,
        };
        operands_are && !var.mutable
    }

    /// What the rule of an operator makes of the operands and their tangents.
    pub(super) fn operator(
        &mut self,
        operator: BinaryOperator,
        assigns: bool,
        left: VarId,
        right: VarId,
    ) -> TokenStream {
        let span = self.ident(left).span();
        let operands = [left, right].map(|operand| self.ident(operand).clone());
        let tangents = [left, right].map(|operand| match self.tangents[operand] {
            Tangent::Still => quote!(::ad::Additive::zero()),
            _ => self.owned(operand),
        });
        let rule = operator.rule(assigns, "jvp", span);
        quote_spanned!(span=> #rule(#(#operands,)* #(#tangents),*))
    }

    /// The tangent of what an operation defines as `var`, after that has been defined, and what it
    /// is.
    fn tangent_of(&mut self, var: VarId, operation: &Operation) -> (TokenStream, Tangent) {
        let ident = self.ident(var).clone();
        let mutable = self.lowered.vars[var].mutable;
        let zero = quote!(::ad::rt::zero_like(&#ident));
        match operation {
            Operation::Use(Operand::Constant(_)) => (zero, Tangent::OwnedTarget),
            Operation::Use(Operand::Var(source)) => match self.tangents[*source] {
                Tangent::Still => (zero, Tangent::OwnedTarget),
                Tangent::Shared if !mutable => {
                    let dot = self.dot(*source);
                    (quote!(#dot), Tangent::Shared)
                }
                Tangent::Shared => {
                    let dot = self.dot(*source);
                    (quote!(::ad::rt::read(&#ident, #dot)), Tangent::OwnedTarget)
                }
                kind => (self.owned(*source), kind),
            },
            Operation::Read(place) | Operation::Clone(place, _)
                if self.tangents[place.root] == Tangent::Still =>
            {
                (zero, Tangent::OwnedTarget)
            }
            Operation::Read(place) | Operation::Clone(place, _) => {
                (self.read(var, place), Tangent::OwnedTarget)
            }
            Operation::Value(value) => {
                let place = Place::of(*value);
                let tangent = self.shared(&place);
                (quote!(::ad::rt::read(&#ident, #tangent)), Tangent::Owned)
            }
            Operation::Borrow(place) => (self.shared(place), Tangent::Shared),
            Operation::Cast(value, ty) => {
                let (source, tangent) = (self.ident(*value).clone(), self.owned(*value));
                let span = ident.span();
                let pushed = quote_spanned!(span=>
                    ::ad::rules::CastPullback::<#ty>::cast_pushforward(#source, #tangent));
                (pushed, Tangent::Owned)
            }
            Operation::Aggregate { shape, parts, .. } => {
                (self.aggregate(var, shape, parts), Tangent::Owned)
            }
            Operation::UpdateStruct { rest, .. } => {
                if self.tangents[rest.root] == Tangent::Still {
                    return (zero, Tangent::Owned);
                }
                let is_whole = rest.path.is_empty()
                    && !matches!(self.tangents[rest.root], Tangent::Shared | Tangent::Exclusive);
                let rest = match is_whole {
                    true => self.owned(rest.root),
                    false => {
                        let tangent = self.shared(rest);
                        quote!(::ad::rt::read(&#ident, #tangent))
                    }
                };
                (rest, Tangent::Owned)
            }
            Operation::Repeat { value, is_vec, .. } => {
                let element = self.owned(*value);
                let repeated = match is_vec {
                    true => quote!(::std::vec![#element; #ident.len()]),
                    false => quote!(::ad::rt::repeated(&#ident, #element)),
                };
                (repeated, Tangent::Owned)
            }
            Operation::Binary(..)
            | Operation::Negate(_)
            | Operation::Call { .. }
            | Operation::Closure(_)
            | Operation::Named { .. } => (zero, Tangent::Owned),
        }
    }

    /// The tangent of a copy of a place, or of what moves out of it.
    fn read(&mut self, var: VarId, place: &Place) -> TokenStream {
        let ident = self.ident(var).clone();
        let is_local = self.tangents[place.root] != Tangent::Shared
            && self.tangents[place.root] != Tangent::Exclusive;
        if place.path.is_empty() && is_local {
            let dot = self.dot(place.root);
            return match self.uses.end_with(place.root, self.position) {
                true => quote!(#dot),
                false => self.copy(place.root, quote!(#dot)),
            };
        }
        // What a pattern took from a `#[constant]` field has elements without tangents.
        if let [Projection::Index(_)] = &place.path[..]
            && self.is_own(place.root)
        {
            let tangent = self.tangent_place(place);
            return match self.of_numbers.contains(&place.root) {
                true => quote!(#tangent),
                false => quote!(::ad::rt::copy(&#tangent)),
            };
        }
        let tangent = match is_local && self.ends_as_a_part(place) {
            // The fields may be those of the content of a box, out of which nothing moves by itself.
            true => {
                self.taken_apart.insert(place.root);
                let tangent = self.tangent_place(place);
                quote!(::ad::rt::take(&mut #tangent))
            }
            false => self.shared(place),
        };
        let span = ident.span().resolved_at(Span::call_site());
        quote_spanned!(span=> ::ad::rt::read(&#ident, #tangent))
    }

    /// Whether a place is a part of a variable whose tangent may change, and nothing uses that part after this
    /// statement.
    fn ends_as_a_part(&self, place: &Place) -> bool {
        let root = place.root;
        let may_change = self.lowered.vars[root].mutable
            || self.changing.contains(&root)
            || self.lowered.parameters.iter().any(|parameter| parameter.var == root);
        is_part_of_value(place)
            && self.lowered.movable.contains(&root)
            && may_change
            && self.uses.end_with(root, self.position)
    }

    /// The tangent of a part of a value that is defined as `var`; `access` leads from there to it.
    fn part(&mut self, var: VarId, part: &Operand, access: TokenStream) -> TokenStream {
        match part {
            Operand::Var(part) if self.tangents[*part] != Tangent::Still => self.moved_part(*part),
            _ => {
                let ident = self.ident(var);
                quote!(::ad::rt::zero_like(&#ident #access))
            }
        }
    }

    /// The tangent of a part whose value has moved into the whole.
    fn moved_part(&mut self, part: VarId) -> TokenStream {
        let dot = self.dot(part);
        match self.tangents[part] {
            // What is lent by a `#[constant]` field has none, which the type of the reference tells.
            Tangent::Shared => {
                let ident = self.ident(part);
                quote!(::ad::rt::read(#ident, #dot))
            }
            Tangent::Exclusive => quote!(::ad::rt::target(#dot)),
            _ => self.owned(part),
        }
    }

    fn aggregate(&mut self, var: VarId, shape: &Shape, parts: &[(Member, Operand)]) -> TokenStream {
        let ident = self.ident(var).clone();
        let by_member = |writer: &mut Self| -> Vec<TokenStream> {
            let part =
                |(member, part): &(Member, Operand)| writer.part(var, part, quote!(.#member));
            parts.iter().map(part).collect()
        };
        match shape {
            Shape::Tuple => {
                let parts = by_member(self);
                quote!((#(#parts,)*))
            }
            Shape::Array | Shape::Vec => {
                let parts = parts.iter().enumerate().map(|(index, (_, part))| {
                    let index = syn::Index::from(index);
                    self.part(var, part, quote!([#index]))
                });
                let parts: Vec<_> = parts.collect();
                match shape {
                    Shape::Vec => quote!(::std::vec![#(#parts),*]),
                    _ => quote!([#(#parts),*]),
                }
            }
            Shape::Boxed => {
                let part = self.part(var, &parts[0].1, TokenStream::new());
                quote!(::ad::Boxed::new(#part))
            }
            Shape::Transparent => self.part(var, &parts[0].1, TokenStream::new()),
            Shape::Flow => {
                let (member, part) = &parts[0];
                let zero = quote!(::ad::Additive::zero());
                let part = match part {
                    Operand::Var(part) if self.tangents[*part] != Tangent::Still => {
                        self.moved_part(*part)
                    }
                    _ => zero.clone(),
                };
                let is_first = quote!(#member).to_string() == "0";
                let sides = if is_first { quote!((#part, #zero)) } else { quote!((#zero, #part)) };
                quote!(::ad::rt::tangent_of(&#ident, #sides))
            }
            // The type of the tangent has no name here; its fields follow.
            Shape::Struct | Shape::Variant(_)
                if parts.iter().all(|(_, part)| !self.is_still(part)) =>
            {
                quote!(::ad::rt::zero_of(&#ident))
            }
            Shape::Struct | Shape::Updated | Shape::Variant(_) => {
                quote!(::ad::rt::zero_like(&#ident))
            }
        }
    }

    /// Gives the tangent of a struct those of its fields.
    fn fields(&mut self, var: VarId, operation: &Operation) -> TokenStream {
        let (variant, parts, is_update) = match operation {
            Operation::Aggregate { shape: Shape::Struct | Shape::Updated, parts, .. } => {
                (None, parts, false)
            }
            Operation::Aggregate { shape: Shape::Variant(variant), parts, .. } => {
                (Some(quote!(.#variant)), parts, false)
            }
            Operation::UpdateStruct { parts, .. } => (None, parts, true),
            _ => return TokenStream::new(),
        };
        let (ident, dot) = (self.ident(var).clone(), self.dot(var));
        let mut tokens = TokenStream::new();
        for (member, part) in parts {
            let tangent = match part {
                Operand::Var(part) if self.tangents[*part] != Tangent::Still => {
                    let tangent = self.moved_part(*part);
                    quote!(::ad::rt::pass(#tangent))
                }
                // In place of what the rest held there. A `#[constant]` field has none.
                _ if is_update => {
                    quote!(::ad::rt::still(&#ident.#member, &mut ::ad::rt::Slot::new()))
                }
                _ => continue,
            };
            tokens.extend(quote!(#dot #variant.#member = #tangent;));
        }
        tokens
    }
}
