//! Finds functions that call themselves.
//!
//! The type of a pullback holds those of the pullbacks it calls, so that of a recursive function
//! would hold itself: it has to be boxed. A function that calls itself by way of others says so
//! with `#[differentiable(boxed)]`, which one function of the circle needs.

use syn::visit::{self, Visit};
use syn::{Block, Expr, ExprCall, ExprMethodCall, Ident, Signature};

/// Whether a function calls itself by its name, by `Self::` or on `self`.
pub fn is_recursive(signature: &Signature, body: &Block) -> bool {
    let mut calls =
        Calls { name: &signature.ident, is_method: signature.receiver().is_some(), found: false };
    calls.visit_block(body);
    calls.found
}

struct Calls<'a> {
    name: &'a Ident,
    is_method: bool,
    found: bool,
}

impl<'ast> Visit<'ast> for Calls<'_> {
    fn visit_expr_call(&mut self, call: &'ast ExprCall) {
        if let Expr::Path(function) = &*call.func {
            let segments = &function.path.segments;
            let is_own = match (segments.first(), segments.last(), segments.len()) {
                (_, Some(last), 1) => !self.is_method && last.ident == *self.name,
                (Some(first), Some(last), 2) => first.ident == "Self" && last.ident == *self.name,
                _ => false,
            };
            self.found |= is_own;
        }
        visit::visit_expr_call(self, call);
    }

    fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
        let on_self = matches!(&*call.receiver, Expr::Path(path) if path.path.is_ident("self"));
        self.found |= self.is_method && on_self && call.method == *self.name;
        visit::visit_expr_method_call(self, call);
    }
}
