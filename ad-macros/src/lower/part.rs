//! Methods that lend parts of a slice: `first`, `last`, `get`, `split_at`, `split_first`, and those
//! that lend two parts to be changed, as `split_at_mut`. Each is written with indices, so that a
//! cotangent goes to the part it belongs to, in constant time.

use quote::quote_spanned;
use syn::{Expr, ExprMethodCall, Pat, parse_quote};

use super::Lowerer;
use super::chain::is_chain;
use super::closure::simple_name;
use crate::ir::{Operand, Statement};

impl Lowerer<'_> {
    /// The part of a slice, if `call` is such a method of a place, or `unwrap` or `expect` of one.
    pub(super) fn lent(&mut self, call: &ExprMethodCall, hint: &str) -> Option<Operand> {
        let unwrapped = match (&*call.method.to_string(), &*call.receiver) {
            ("unwrap" | "expect", Expr::MethodCall(inner)) => Some(inner),
            _ => None,
        };
        let inner = unwrapped.unwrap_or(call);
        let slice = &inner.receiver;
        let index = self.names.unwritten("position");
        let positions: Vec<_> = inner.args.iter().collect();
        let (position, element): (Expr, Expr) = match (&*inner.method.to_string(), &positions[..]) {
            _ if is_chain(slice) => return None,
            ("first", []) => (parse_quote!(0), parse_quote!(&#slice[#index])),
            // Of an empty one the position is too large.
            ("last", []) => {
                (parse_quote!(#slice.len().wrapping_sub(1)), parse_quote!(&#slice[#index]))
            }
            // By a range it lends another slice.
            ("get", [position]) if !matches!(position, Expr::Range(_)) => {
                (parse_quote!(#position), parse_quote!(&#slice[#index]))
            }
            ("split_first", []) => {
                (parse_quote!(0), parse_quote!((&#slice[#index], &#slice[#index + 1..])))
            }
            ("split_last", []) => (
                parse_quote!(#slice.len().wrapping_sub(1)),
                parse_quote!((&#slice[#index], &#slice[..#index])),
            ),
            ("split_at", [position]) if unwrapped.is_none() => {
                (parse_quote!(#position), parse_quote!((&#slice[..#index], &#slice[#index..])))
            }
            _ => return None,
        };
        let place = self.active_place(slice)?;
        // Somebody else's type may have a method of this name.
        let place = self.place_tokens(&place);
        let code = quote_spanned!(inner.method.span()=> ::ad::rt::is_sequence(&#place););
        self.push(Statement::Plain { code, defines: Vec::new() });
        let is_whole = unwrapped.is_some() || inner.method == "split_at";
        let desugared: Expr = match is_whole {
            true => parse_quote!({ let #index: usize = #position; #element }),
            false => parse_quote!({
                let #index: usize = #position;
                if #index < #slice.len() {
                    ::core::option::Option::Some(#element)
                } else {
                    ::core::option::Option::None
                }
            }),
        };
        let part = self.operand(&desugared, hint);
        if let Operand::Var(var) = part {
            self.vars[var].reference = true;
        }
        Some(part)
    }

    /// `let (left, right) = slice.split_at_mut(position)` and its kin: two names for parts. Says whether
    /// it is that.
    pub(super) fn split_exclusively(&mut self, pat: &Pat, value: &Expr) -> bool {
        let Pat::Tuple(names) = pat else { return false };
        let (Some(first), Some(second), 2) = (
            names.elems.first().and_then(simple_name),
            names.elems.last().and_then(simple_name),
            names.elems.len(),
        ) else {
            return false;
        };
        let call = match value {
            Expr::MethodCall(call) if call.method == "unwrap" || call.method == "expect" => {
                match &*call.receiver {
                    Expr::MethodCall(inner) if inner.method != "split_at_mut" => inner,
                    _ => return false,
                }
            }
            Expr::MethodCall(call) if call.method == "split_at_mut" => call,
            _ => return false,
        };
        let slice = &call.receiver;
        let index = self.names.unwritten("position");
        let arguments: Vec<_> = call.args.iter().collect();
        let (position, parts): (Expr, [Expr; 2]) = match (&*call.method.to_string(), &arguments[..])
        {
            ("split_at_mut", [position]) => (
                parse_quote!(#position),
                [parse_quote!(#slice[..#index]), parse_quote!(#slice[#index..])],
            ),
            ("split_first_mut", []) => (
                parse_quote!(0),
                [parse_quote!(#slice[#index]), parse_quote!(#slice[#index + 1..])],
            ),
            ("split_last_mut", []) => (
                parse_quote!(#slice.len() - 1),
                [parse_quote!(#slice[#index]), parse_quote!(#slice[..#index])],
            ),
            _ => return false,
        };
        let Some(place) = self.active_place(slice) else { return false };
        let place = self.place_tokens(&place);
        let code = quote_spanned!(call.method.span()=> ::ad::rt::is_sequence(&#place););
        self.push(Statement::Plain { code, defines: Vec::new() });
        self.statement(&parse_quote!(let #index: usize = #position;));
        for (name, part) in [first, second].into_iter().zip(&parts) {
            self.exclusive_alias(name, part);
        }
        true
    }
}
