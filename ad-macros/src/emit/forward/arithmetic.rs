//! The tangents of arithmetic on numbers, where they are as plain as the arithmetic.

use proc_macro2::TokenStream;
use quote::quote;

use super::{Tangent, Writer};
use crate::ir::{BinaryOperator, VarId};

impl Writer<'_> {
    /// The tangent of a sum or a difference of numbers, or of a product or a quotient with a
    /// literal, which no partial derivative can make singular; `None` for others, which have rules,
    /// and for what does not move.
    pub(super) fn arithmetic(
        &mut self,
        operator: BinaryOperator,
        left: VarId,
        right: VarId,
    ) -> Option<TokenStream> {
        if !self.scalars.are_numbers([left, right]) {
            return None;
        }
        let moves = [left, right].map(|operand| self.tangents[operand] != Tangent::Still);
        match (operator, moves) {
            (BinaryOperator::Add, [true, true]) => {
                let [left, right] = [left, right].map(|operand| self.owned(operand));
                Some(quote!(#left + #right))
            }
            (BinaryOperator::Add | BinaryOperator::Sub, [true, false]) => Some(self.owned(left)),
            (BinaryOperator::Add, [false, true]) => Some(self.owned(right)),
            (BinaryOperator::Sub, [true, true]) => {
                let [left, right] = [left, right].map(|operand| self.owned(operand));
                Some(quote!(#left - #right))
            }
            (BinaryOperator::Sub, [false, true]) => {
                let right = self.owned(right);
                Some(quote!(-#right))
            }
            (BinaryOperator::Mul, [true, false]) if self.scalars.is_regular_constant(right) => {
                let (left, right) = (self.owned(left), self.ident(right).clone());
                Some(quote!(#left * #right))
            }
            (BinaryOperator::Mul, [false, true]) if self.scalars.is_regular_constant(left) => {
                let (left, right) = (self.ident(left).clone(), self.owned(right));
                Some(quote!(#left * #right))
            }
            (BinaryOperator::Div, [true, false]) if self.scalars.is_regular_constant(right) => {
                let (left, right) = (self.owned(left), self.ident(right).clone());
                Some(quote!(#left / #right))
            }
            _ => None,
        }
    }
}
