//! The sweeps of assignments: the cotangent of a place leaves it for what was assigned.

use proc_macro2::TokenStream;
use quote::quote;
use syn::spanned::Spanned;

use super::contribute::cotangent_of;
use super::{Sides, Sweeper};
use crate::ir::primal::Primal;
use crate::ir::{BinaryOperator, Operand, Place, Projection, VarId};

impl Sweeper<'_> {
    /// Whether anything flows back to a place that is assigned to here.
    pub(super) fn is_live(&mut self, place: &Place) -> bool {
        !self.is_primal && !self.is_unstarted_local(place.root)
    }

    pub(super) fn assign(&mut self, place: &Place, value: &Operand) -> Sides {
        let mut sides = Sides::default();
        let root = &self.vars[place.root];
        let target = self.place(place);
        let tokens = self.tokens(value);
        sides.forward.extend(quote!(#target = #tokens;));
        if !self.is_live(place) {
            return sides;
        }
        self.start(&mut sides.reverse, place.root);
        let cotangent = cotangent_of(&root.cotangent, &place.path);
        let taken = quote!(::ad::rt::take(#cotangent));
        match value {
            Operand::Constant(_) => sides.reverse.extend(quote!(#taken;)),
            Operand::Var(var) => {
                let part = self.part_name(place.root);
                self.check_assigned(&mut sides.reverse, *var, place);
                let taken = self.entered(*var, place, taken);
                sides.reverse.extend(quote!(let #part = #taken;));
                self.contribute(&mut sides.reverse, *var, &[], quote!(#part));
            }
        }
        sides
    }

    /// Has the compiler check that `var` may be stored in a place.
    fn check_assigned(&mut self, reverse: &mut TokenStream, var: VarId, place: &Place) {
        let field = place.path.iter().rev().find_map(|step| match step {
            Projection::Field(member) => Some(member.span()),
            _ => None,
        });
        if let Some(span) = field {
            let cotangent = cotangent_of(&self.vars[place.root].cotangent, &place.path);
            self.check_stored(reverse, var, &quote!((*#cotangent)), span);
        }
    }

    /// The cotangent of `place`, as that of the variable it was made from: `place` may lie in a
    /// `#[constant]` field or in a box.
    pub(super) fn entered(
        &mut self,
        var: VarId,
        place: &Place,
        cotangent: TokenStream,
    ) -> TokenStream {
        let is_plain = |step: &Projection| matches!(step, Projection::Index(_));
        if !self.vars[var].active || place.path.iter().all(is_plain) {
            return cotangent;
        }
        let space = self.space(var);
        quote!(#space.enter(#cotangent))
    }

    pub(super) fn update(
        &mut self,
        place: &Place,
        operator: BinaryOperator,
        previous: VarId,
        value: VarId,
    ) -> Sides {
        let mut sides = Sides::default();
        let (target, operand) = (self.place(place), self.ident(value));
        let token = Primal::assigning(operator);
        sides.forward.extend(quote!(#target #token #operand;));
        if !self.is_live(place) {
            return sides;
        }

        self.start(&mut sides.reverse, place.root);
        let root = &self.vars[place.root];
        let span = root.ident.span();
        let cotangent = cotangent_of(&root.cotangent, &place.path);
        self.check_assigned(&mut sides.reverse, value, place);
        if operator.is_linear() && self.are_numbers(previous, value) {
            // The place keeps its cotangent.
            let part = self.number_at(place.root, &place.path);
            match operator {
                BinaryOperator::Sub => self.subtract(&mut sides.reverse, value, part),
                _ => self.add(&mut sides.reverse, value, &[], part),
            }
            return sides;
        }
        let taken = quote!(::ad::rt::take(#cotangent));
        let taken = self.entered(previous, place, taken);
        let record = &self.vars[previous].record;
        let operands = [previous, value];
        let operation = match operator {
            BinaryOperator::Add => Some("Increase"),
            BinaryOperator::Sub => Some("Decrease"),
            BinaryOperator::Mul | BinaryOperator::Div | BinaryOperator::Rem => None,
        };
        if let Some(operation) = operation {
            let kept = self.kept(record, operation, &operands);
            sides.forward.extend(kept);
        }
        let pulled = self.binary_pullback((operator, true), record, operands, taken, span);
        let (to_previous, to_value) = (self.part_name(place.root), self.part_name(value));
        let value_pattern = match self.vars[value].active {
            true => quote!(#to_value),
            false => quote!(_),
        };
        sides.reverse.extend(quote! {
            let (#to_previous, #value_pattern) = #pulled;
            ::ad::rt::Absorb::absorb(#cotangent, #to_previous);
        });
        self.contribute(&mut sides.reverse, value, &[], quote!(#to_value));
        sides
    }
}
