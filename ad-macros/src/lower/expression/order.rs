//! The order in which the parts of an expression are evaluated.
//!
//! What carries a derivative gets its name before the expression that it is a part of is evaluated. A
//! constant that is computed by a call may draw a random number, or read what a later call changes: it
//! gets a name too, where another call follows it.

use quote::{ToTokens, quote};
use syn::Expr;
use syn::spanned::Spanned;

use crate::ir::{Argument, Operand, Operation};
use crate::lower::Lowerer;
use crate::lower::call::macros::never;
use crate::lower::iterate::item::Item;
use crate::lower::search::has;
use crate::lower::syntax::{calls, is_type_name};
use crate::names::{identifiers, is_in};
use crate::rules;

impl Lowerer<'_> {
    /// `operand`, the value of `expr`, evaluated before `following` are.
    pub fn in_turn<'e>(
        &mut self,
        operand: Operand,
        expr: &Expr,
        following: impl IntoIterator<Item = &'e Expr>,
    ) -> Operand {
        let is_constant = matches!(operand, Operand::Constant(_));
        let matters = |next: &Expr| {
            calls(next) || self.reads_changeable(next) && self.may_change_for(expr, next)
        };
        if !is_constant || !calls(expr) || !following.into_iter().any(matters) {
            return operand;
        }
        let var = self.define("constant", expr.span(), false, Operation::Use(operand));
        self.constant(var)
    }

    /// Whether evaluating an expression may change what the next one reads: a variable that both name, or one that a
    /// closure has captured or a `&mut` refers to. Anything else keeps its place, for what it makes may be a guard, which
    /// ends with the statement.
    fn may_change_for(&self, expr: &Expr, next: &Expr) -> bool {
        let names = |expr: &Expr| identifiers(expr.to_token_stream());
        let read = names(next);
        self.calls_closure(expr, &|_| true)
            || names(expr).into_iter().any(|name| {
                read.contains(&name)
                    || self.lookup(&name).is_some_and(|var| self.vars[var].exclusive)
            })
    }

    /// The same for what a call is given.
    pub fn argument_in_turn<'e>(
        &mut self,
        argument: Argument,
        expr: &Expr,
        following: impl IntoIterator<Item = &'e Expr>,
    ) -> Argument {
        match argument {
            Argument::Value(operand) => Argument::Value(self.in_turn(operand, expr, following)),
            argument => argument,
        }
    }

    /// Evaluates what nobody uses.
    pub fn discard(&mut self, value: Operand) {
        if let Operand::Constant(tokens) = value
            && tokens.clone().into_iter().nth(1).is_some()
            && tokens.to_string() != never().to_string()
        {
            self.push_plain(quote!(let _ = #tokens;));
        }
    }

    /// Evaluates an item that nobody uses.
    pub fn discard_item(&mut self, item: Item) {
        match item {
            Item::Value(value) => self.discard(value),
            Item::Tuple(items) => items.into_iter().for_each(|item| self.discard_item(item)),
            Item::Constant(_) | Item::Reference(_) | Item::Copy(_) | Item::Moved(_) => {}
        }
    }
}

/// Whether a function or a method is called in an expression, other than methods by whose names integers are
/// made of integers: one's own type may have a method with the name of any other.
pub fn may_have_effect(expr: &Expr) -> bool {
    const OF_INTEGERS: &str =
        "len min max clamp abs abs_diff pow rem_euclid saturating_add saturating_sub";
    calls_other_than(expr, |name| is_in(OF_INTEGERS, name))
}

/// Whether a function or a method is called in an expression of which it is not known that it has no
/// effect.
pub fn calls_function(expr: &Expr) -> bool {
    calls_other_than(expr, |name| rules::is_method(name) && !rules::changes_receiver(name))
}

/// Whether a function is called in an expression, or a method that is not of some names.
fn calls_other_than(expr: &Expr, is_known: impl Fn(&str) -> bool) -> bool {
    has(expr, |part| {
        let is_harmless = match part {
            Expr::Call(call) => matches!(&*call.func, Expr::Path(function)
                if function.path.segments.last().is_some_and(|last| is_type_name(&last.ident))),
            Expr::MethodCall(call) => is_known(&call.method.to_string()),
            Expr::Macro(_) => false,
            _ => true,
        };
        (!is_harmless).then_some(true)
    })
}
