//! The pullbacks of the arithmetic operators.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{quote, quote_spanned};

use super::Sweeper;
use super::contribute::Target;
use crate::analyse::products::Products;
use crate::floats;
use crate::ir::primal::Primal;
use crate::ir::{BinaryOperator, Operation, VarId};

impl Sweeper<'_> {
    /// Gives the cotangent of `-value` to `value`.
    pub(super) fn pull_back_negation(
        &mut self,
        reverse: &mut TokenStream,
        record: &Ident,
        value: VarId,
        cotangent: TokenStream,
    ) {
        if self.numbers.number(value).is_some() {
            return self.subtract(reverse, value, cotangent);
        }
        let span = self.span(value);
        let pulled = quote_spanned!(span=> #record.pull_back(#cotangent));
        self.contribute(reverse, value, &[], pulled);
    }

    /// Gives the cotangent of the result of an operator to its operands.
    pub(super) fn pull_back_binary(
        &mut self,
        reverse: &mut TokenStream,
        record: &Ident,
        operator: BinaryOperator,
        operands: [VarId; 2],
        cotangent: TokenStream,
        span: Span,
    ) {
        let [left, right] = operands;
        if self.are_numbers(left, right) {
            match operator {
                BinaryOperator::Add => {
                    self.add(reverse, left, &[], cotangent.clone());
                    return self.add(reverse, right, &[], cotangent);
                }
                BinaryOperator::Sub => {
                    self.add(reverse, left, &[], cotangent.clone());
                    return self.subtract(reverse, right, cotangent);
                }
                BinaryOperator::Mul if !self.calls_for(operands) => {
                    let to_left = self.scaled(&cotangent, right);
                    let to_right = self.scaled(&cotangent, left);
                    self.add(reverse, left, &[], to_left);
                    return self.add(reverse, right, &[], to_right);
                }
                BinaryOperator::Div if self.numbers.is_regular_constant(right) => {
                    let denominator = self.ident(right);
                    let to_left = quote!(#cotangent / #denominator);
                    return self.add(reverse, left, &[], to_left);
                }
                BinaryOperator::Mul | BinaryOperator::Div | BinaryOperator::Rem => {}
            }
        }
        let pulled = match (operator, &self.products) {
            (BinaryOperator::Mul, Some(Products { name, .. })) => {
                let [left, right] = operands.map(|operand| self.ident(operand));
                quote_spanned!(span=> #name.mul_pullback(#left, #right, #cotangent))
            }
            (BinaryOperator::Div, Some(Products { name, .. })) if self.are_numbers(left, right) => {
                let [left, right] = operands.map(|operand| self.ident(operand));
                quote_spanned!(span=> #name.div_pullback(#left, #right, #cotangent))
            }
            _ => self.binary_pullback((operator, false), record, operands, cotangent, span),
        };
        let targets = operands.map(|root| Some(Target::whole(root)));
        self.contribute_all(reverse, &targets, pulled, false);
    }

    /// A product, a quotient or a remainder, whose operands the reverse sweep names once more. What a
    /// function returned may be of a type that is not `Copy`.
    pub(super) fn product(
        &self,
        operator: BinaryOperator,
        operands: [VarId; 2],
        span: Span,
    ) -> TokenStream {
        let is_of_numbers = |function: &str| {
            floats::takes_number(function)
                || function.starts_with("f64 ::")
                || function.starts_with("f32 ::")
        };
        let is_returned = |operand: VarId| {
            self.numbers.number(operand).is_none()
                && matches!(self.facts.operation(operand), Some(Operation::Call { callee, .. })
                    if !is_of_numbers(&callee.primal.to_string()))
        };
        let is_returned = operands.into_iter().any(is_returned);
        let [left, right] = operands.map(|operand| {
            let ident = self.ident(operand);
            match is_returned && self.numbers.number(operand).is_none() {
                true => quote_spanned!(span=> ::ad::rt::again(&#ident)),
                false => quote!(#ident),
            }
        });
        let operator = Primal::operator(operator);
        quote_spanned!(span=> #left #operator #right)
    }

    /// Keeps what the pullback of a sum, a difference or a negation needs of the operands: in most
    /// cases their types. `record` is named after the operation.
    pub(super) fn kept(
        &mut self,
        record: &Ident,
        operation: &str,
        operands: &[VarId],
    ) -> TokenStream {
        if operands.iter().all(|&operand| self.numbers.number(operand).is_some())
            || matches!(*operands, [left, right] if self.are_numbers(left, right))
        {
            return TokenStream::new();
        }
        let span = self.span(operands[0]);
        let operation = Ident::new(operation, span);
        if self.loop_depth > 0 {
            self.top.extend(quote_spanned!(span=>
                let #record = ::ad::rt::#operation::of_unknown();));
        }
        let operands = operands.iter().map(|&operand| self.ident(operand));
        match self.loop_depth {
            0 => quote_spanned!(span=> let #record = ::ad::rt::#operation::of(#(&#operands),*);),
            _ => quote!(#record.keep(#(&#operands),*);),
        }
    }

    /// Whether both operands of an operator are numbers.
    pub(super) fn are_numbers(&self, left: VarId, right: VarId) -> bool {
        self.numbers.are_numbers([left, right])
    }

    /// Whether the pullback of a product is one call instead of two products.
    fn calls_for(&self, factors: [VarId; 2]) -> bool {
        let is_called = self.products.as_ref().is_some_and(|products| !products.are_chosen());
        is_called && factors.iter().all(|&factor| self.vars[factor].active)
    }

    /// A cotangent times a factor, which annihilates a factor that is not finite if it is zero. A
    /// literal needs no such care.
    fn scaled(&self, cotangent: &TokenStream, factor: VarId) -> TokenStream {
        let ident = self.ident(factor);
        match &self.products {
            _ if self.numbers.is_regular_constant(factor) => quote!(#cotangent * #ident),
            Some(Products { name, .. }) => quote!(#name.scale(#cotangent, #ident)),
            None => quote!(::ad::rt::scale(#cotangent, #ident)),
        }
    }

    /// The cotangents of both operands, of which the left is what a place held before if the operator
    /// `assigns`; `record` holds what is kept of those of a linear operator.
    pub(super) fn binary_pullback(
        &self,
        (operator, assigns): (BinaryOperator, bool),
        record: &Ident,
        operands: [VarId; 2],
        cotangent: TokenStream,
        span: Span,
    ) -> TokenStream {
        if operator.is_linear() {
            return quote_spanned!(span=> #record.pull_back(#cotangent));
        }
        let [left, right] = operands.map(|operand| self.ident(operand));
        let rule = operator.rule(assigns, "pullback", span);
        quote_spanned!(span=> #rule(#left, #right, #cotangent))
    }
}
