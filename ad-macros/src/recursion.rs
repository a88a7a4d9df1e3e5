//! Finds functions that call themselves.
//!
//! The type of a pullback holds those of the pullbacks it calls, so that of a recursive function
//! would hold itself: it has to be boxed. A function that calls itself by way of others says so
//! with `#[differentiable(boxed)]`, which one function of the circle needs.

use syn::visit::{self, Visit};
use syn::{Block, Expr, ExprCall, ExprMethodCall, Ident, Signature};

use crate::rules;

/// Whether a function calls itself by its name, by `Self::` or on `self`; a method of a type also where
/// it calls one of its name on a variable, which is part of `self` in most cases: `left.depth()`. A name
/// that has a rule is another type's there: `re.sin()`.
pub fn is_recursive(signature: &Signature, body: &Block, is_inherent: bool) -> bool {
    let is_own = !rules::is_method(&signature.ident.to_string());
    Calls {
        name: &signature.ident,
        is_method: signature.receiver().is_some(),
        counts_variables: is_inherent && is_own,
        owner: None,
        found: false,
    }
    .are_in(body)
}

/// Whether a function of the type `owner` calls itself by the name of that.
pub fn names_owner(owner: &Ident, name: &Ident, body: &Block) -> bool {
    let owner = Some(owner);
    Calls { name, is_method: true, counts_variables: false, owner, found: false }.are_in(body)
}

struct Calls<'a> {
    name: &'a Ident,
    is_method: bool,
    /// Whether a call on any variable counts.
    counts_variables: bool,
    /// What stands for `Self`.
    owner: Option<&'a Ident>,
    found: bool,
}

impl Calls<'_> {
    fn are_in(mut self, body: &Block) -> bool {
        self.visit_block(body);
        self.found
    }
}

impl<'ast> Visit<'ast> for Calls<'_> {
    fn visit_expr_call(&mut self, call: &'ast ExprCall) {
        if let Expr::Path(function) = &*call.func {
            let segments = &function.path.segments;
            let is_own = match (segments.first(), segments.last(), segments.len()) {
                (_, Some(last), 1) => !self.is_method && last.ident == *self.name,
                (Some(first), Some(last), 2) => {
                    (first.ident == "Self" || self.owner == Some(&first.ident))
                        && last.ident == *self.name
                }
                _ => false,
            };
            self.found |= is_own;
        }
        visit::visit_expr_call(self, call);
    }

    fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
        let is_own = matches!(&*call.receiver, Expr::Path(path)
            if path.path.is_ident("self") || self.counts_variables && path.path.get_ident().is_some());
        self.found |= self.is_method && is_own && call.method == *self.name;
        visit::visit_expr_method_call(self, call);
    }
}
