//! Code without derivative that changes something: `if bump(v)`, `w[bump(&mut v)]`.
//!
//! What is changed has a derivative although what is computed has none. So such code is not passed on as
//! it is: its parts are evaluated one after the other, and the calls that change something become
//! operations.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::{BinOp, Expr, parse_quote};

use crate::lower::Lowerer;
use crate::lower::call::closure::changes_captured;
use crate::lower::rewrite::desugar::scrutinee;
use crate::lower::search::has;
use crate::lower::state::Closure;
use crate::lower::syntax::strip_parens;
use crate::{floats, rules};

impl Lowerer<'_> {
    /// Whether evaluating an expression visibly changes something through which a derivative may flow.
    /// What is changed behind a receiver the types tell, which refuse it.
    pub fn changes(&self, expr: &Expr) -> bool {
        // What a closure does it does where it is called.
        has(expr, |part| match part {
            Expr::Closure(_) => Some(false),
            part => self.is_change(part).then_some(true),
        })
    }

    /// Whether the call itself changes something, whatever its parts do.
    pub fn is_change(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Call(call) => {
                let changes = |closure: &Closure| changes_captured(&closure.body);
                self.named_closure(&call.func).is_some_and(|closure| changes(&closure))
                    || call.args.iter().any(|argument| self.is_lent_exclusively(argument))
            }
            Expr::MethodCall(call) => {
                let name = call.method.to_string();
                call.args.iter().any(|argument| self.is_lent_exclusively(argument))
                    || (rules::changes_receiver(&name)
                        || changes_option(&name, call.args.len())
                        || self.exclusive_methods.contains(&name))
                        && self.can_change(&call.receiver)
                    || self.tests_what_changes(call)
            }
            _ => false,
        }
    }

    fn is_call_of_closure(&self, expr: &Expr) -> bool {
        matches!(expr, Expr::Call(call) if self.named_closure(&call.func).is_some())
    }

    /// Whether an argument lets the call change a variable through which a derivative may flow.
    pub fn is_lent_exclusively(&self, argument: &Expr) -> bool {
        match strip_parens(argument) {
            Expr::Reference(reference) => reference.mutability.is_some(),
            Expr::Path(path) => self.variable(path).is_some_and(|var| {
                self.is_lent(var) || (self.vars[var].exclusive && self.vars[var].active)
            }),
            _ => false,
        }
    }

    /// The value of an expression without derivative that changes something.
    pub(super) fn in_order(&mut self, expr: &Expr) -> TokenStream {
        let value = match expr {
            Expr::Paren(inner) => return self.in_order(&inner.expr),
            expr if self.is_change(expr) || self.is_call_of_closure(expr) => {
                let value = self.operand(expr, "value");
                self.without_derivative(&value)
            }
            Expr::Binary(binary) => match binary.op {
                BinOp::And(_) => {
                    let (left, right) = (scrutinee(&binary.left), &binary.right);
                    let both = parse_quote!(if #left { #right } else { false });
                    self.chosen(&both)
                }
                BinOp::Or(_) => {
                    let (left, right) = (scrutinee(&binary.left), &binary.right);
                    let either = parse_quote!(if #left { true } else { #right });
                    self.chosen(&either)
                }
                operator => {
                    let [left, right] = self.parts_in_order([&*binary.left, &*binary.right]);
                    quote!((#left #operator #right))
                }
            },
            Expr::Unary(unary) => {
                let (operator, [operand]) = (unary.op, self.parts_in_order([&*unary.expr]));
                quote!((#operator #operand))
            }
            Expr::MethodCall(call) => {
                let (method, turbofish) = (&call.method, &call.turbofish);
                let receiver = match strip_parens(&call.receiver) {
                    // What is no number may not be moved out of what it is an element of.
                    part @ Expr::Index(_) if !floats::takes_number(&method.to_string()) => {
                        self.operand(&parse_quote!(&#part), "receiver")
                    }
                    receiver => self.operand(receiver, "receiver"),
                };
                let receiver = match self.keep(&receiver, &call.receiver) {
                    Some(kept) => self.tokens(&kept),
                    None => {
                        let receiver = self.tokens(&receiver);
                        quote!((*&#receiver))
                    }
                };
                let arguments: Vec<_> =
                    call.args.iter().map(|argument| self.part_in_order(argument)).collect();
                quote!(#receiver.#method #turbofish(#(#arguments),*))
            }
            Expr::Call(call) => {
                let function = &call.func;
                let arguments: Vec<_> =
                    call.args.iter().map(|argument| self.part_in_order(argument)).collect();
                quote!(#function(#(#arguments),*))
            }
            expr => {
                let value = self.operand(expr, "value");
                self.without_derivative(&value)
            }
        };
        self.named_tokens("constant", expr.span(), value)
    }

    /// The value of an `if` without derivative.
    fn chosen(&mut self, branch: &Expr) -> TokenStream {
        let value = self.operand(branch, "value");
        self.without_derivative(&value)
    }

    fn parts_in_order<const N: usize>(&mut self, parts: [&Expr; N]) -> [TokenStream; N] {
        parts.map(|part| self.part_in_order(part))
    }

    /// A part of an expression, as it is here and now.
    fn part_in_order(&mut self, part: &Expr) -> TokenStream {
        if let Expr::Lit(_) = strip_parens(part) {
            return part.to_token_stream();
        }
        let value = self.operand(part, "value");
        let value = self.kept(value, part);
        let var = self.named(value, "part", part.span());
        self.ident(var).to_token_stream()
    }
}

/// Whether a method of options changes its receiver.
fn changes_option(name: &str, arguments: usize) -> bool {
    matches!((name, arguments), ("take", 0) | ("replace", 1))
}
