//! The tangents of places.

use proc_macro2::TokenStream;
use quote::quote;

use super::{Tangent, Writer};
use crate::ir::primal::{Primal, project};
use crate::ir::{BinaryOperator, Operand, Place, Projection, VarId};

impl Writer<'_> {
    /// The tangent of a place, as a place; a reference, where the path is empty and the tangent of
    /// the variable is one.
    ///
    /// A `*` leaves no trace: behind a reference the tangent is one, too, and a box gives its
    /// content to whoever asks for it.
    pub(super) fn tangent_place(&mut self, place: &Place) -> TokenStream {
        let dot = self.dot(place.root);
        let path: Vec<_> = place.path.iter().filter(|step| step.is_part()).cloned().collect();
        project(quote!(#dot), &path)
    }

    /// Whether the tangent of a place is a reference before anything is borrowed.
    fn is_reference(&self, place: &Place) -> bool {
        !place.path.iter().any(Projection::is_part)
            && matches!(self.tangents[place.root], Tangent::Shared | Tangent::Exclusive)
    }

    /// The tangent of a place, as `&`.
    pub(super) fn shared(&mut self, place: &Place) -> TokenStream {
        let tangent = self.tangent_place(place);
        match (self.is_reference(place), self.tangents[place.root]) {
            (true, Tangent::Exclusive) => quote!(&*#tangent),
            (true, _) => tangent,
            (false, _) => quote!(&#tangent),
        }
    }

    /// The tangent of a place, as `&mut`.
    pub(super) fn exclusive(&mut self, place: &Place) -> TokenStream {
        let tangent = self.tangent_place(place);
        match self.is_reference(place) {
            true => quote!(&mut *#tangent),
            false => quote!(&mut #tangent),
        }
    }

    /// The tangent of a place, to assign to.
    fn target(&mut self, place: &Place) -> TokenStream {
        let tangent = self.tangent_place(place);
        match self.is_reference(place) {
            true => quote!(*#tangent),
            false => tangent,
        }
    }

    /// The place itself.
    pub(super) fn primal_place(&self, place: &Place) -> TokenStream {
        Primal(&self.lowered.vars).place(place)
    }

    /// `place = value`
    pub(super) fn assign(&mut self, place: &Place, value: &Operand) -> TokenStream {
        let (target, tokens) = (self.primal_place(place), self.tokens(value));
        if self.tangents[place.root] == Tangent::Still {
            return quote!(#target = #tokens;);
        }
        let tangent = self.target(place);
        let Operand::Var(var) = value.clone() else {
            let zero = self.entering(place, quote!(::ad::rt::zero_like(&#target)));
            return quote!(#target = #tokens; #tangent = #zero;);
        };
        match self.tangents[var] {
            Tangent::Still => {
                let zero = self.entering(place, quote!(::ad::rt::zero_like(&#target)));
                quote!(#target = #tokens; #tangent = #zero;)
            }
            // To be read as long as the reference is there.
            Tangent::Shared | Tangent::Exclusive => {
                let moved = self.owned(var);
                // Where a reference to a box is assigned, one to its content may be meant.
                let moved = match self.numbers.contains(&var) {
                    true => self.entering(place, moved),
                    false => quote!(::ad::rt::pass(#moved)),
                };
                quote!(#tangent = #moved; #target = #tokens;)
            }
            Tangent::Owned | Tangent::OwnedTarget => {
                let moved = self.owned(var);
                let moved = self.entering(place, moved);
                quote!(#target = #tokens; #tangent = #moved;)
            }
        }
    }

    /// A tangent, as that of a place: behind a field or a `*` the types need not be the same.
    fn entering(&self, place: &Place, tangent: TokenStream) -> TokenStream {
        match place.path.iter().all(|step| matches!(step, Projection::Index(_))) {
            true => tangent,
            false => quote!(::ad::rt::pass(#tangent)),
        }
    }

    /// `place op= value`
    pub(super) fn update(
        &mut self,
        place: &Place,
        operator: BinaryOperator,
        previous: VarId,
        value: VarId,
    ) -> TokenStream {
        let (target, operand) = (self.primal_place(place), self.ident(value).clone());
        let token = Primal::assigning(operator);
        if self.tangents[place.root] == Tangent::Still {
            return quote!(#target #token #operand;);
        }
        let pushed = self.operator(operator, true, previous, value);
        let tangent = self.target(place);
        if place.path.iter().all(|step| matches!(step, Projection::Index(_))) {
            return quote!(#tangent = #pushed; #target #token #operand;);
        }
        let dot = self.names.fresh("tangent", self.ident(previous).span());
        quote! {
            let #dot = #pushed;
            #target #token #operand;
            #tangent = ::ad::rt::pass(#dot);
        }
    }
}
