//! Methods of lists that are given a function which decides, and computes nothing: in which order elements come, and
//! which of them stay.

use proc_macro2::TokenStream;
use quote::{format_ident, quote, quote_spanned};
use syn::{Expr, ExprClosure, ExprMethodCall, Ident, Pat};

use crate::ir::{Argument, Operand};
use crate::lower::Lowerer;
use crate::lower::syntax::strip_parens;

/// The number of elements that a method gives to the function which decides for it.
fn compared(name: &str) -> Option<usize> {
    match name {
        "sort_by" | "sort_unstable_by" | "dedup_by" => Some(2),
        "sort_by_key" | "sort_unstable_by_key" | "retain" | "dedup_by_key" => Some(1),
        _ => None,
    }
}

impl Lowerer<'_> {
    /// The function that decides for a method of this list, if it is such a method; whether its elements carry a
    /// derivative.
    pub fn deciding(
        &mut self,
        call: &ExprMethodCall,
        function: &Expr,
        (list, carries): (&TokenStream, bool),
    ) -> Option<Argument> {
        let count = compared(&call.method.to_string())?;
        if carries && call.method.to_string().starts_with("sort_unstable") {
            self.check_order_is_told(call, function, list);
        }
        let decides = self.plain_of_elements(function, carries);
        Some(Argument::Value(Operand::Constant(match strip_parens(function) {
            Expr::Closure(_) => decides,
            _ => {
                let elements = (0..count).map(|index| format_ident!("element_{index}"));
                let elements: Vec<_> = elements.collect();
                quote!(|#(#elements),*| #decides(#(#elements),*))
            }
        })))
    }

    /// The derivative of a sort keeps the order of equal elements. One that does not may leave them in another order,
    /// which only does not matter where equal elements are the same number.
    fn check_order_is_told(&mut self, call: &ExprMethodCall, compare: &Expr, list: &TokenStream) {
        if compares_themselves(compare) {
            self.push_plain(quote_spanned!(call.method.span()=> ::ad::rt::are_told_apart(&#list);));
            return;
        }
        let stable = call.method.to_string().replace("_unstable", "");
        self.refuse(
            &call.method,
            format!("where elements are equal, their order after `{}` is not specified, and may be another one in the derivative: write `{stable}`, which keeps it", call.method),
        );
    }

    /// Whether an expression names a variable that changes and is taken for a constant, itself or in the body of a
    /// closure that has a name.
    pub fn names_changing_constant(&mut self, function: &Expr) -> bool {
        if let Some(closure) = self.named_closure(function) {
            let scopes = std::mem::replace(&mut self.scopes, closure.scopes.clone());
            let found = self.names_changing_constant(&closure.body.body);
            self.scopes = scopes;
            return found;
        }
        let mut names = Vec::new();
        self.mentions(function, |path| {
            names.push(Expr::Path(path.clone()));
            false
        });
        names.iter().any(|name| match self.root_of(name) {
            Some(root) if self.closures.contains_key(&root) => self.names_changing_constant(name),
            root => root.is_some_and(|root| self.vars[root].mutable && !self.vars[root].active),
        })
    }
}

/// Whether a function compares two elements by what they are: `|a, b| a.total_cmp(b)`, `f64::total_cmp`.
fn compares_themselves(function: &Expr) -> bool {
    match strip_parens(function) {
        Expr::Path(path) => {
            path.path.segments.last().is_some_and(|segment| segment.ident == "total_cmp")
        }
        Expr::Closure(ExprClosure { inputs, body, .. }) => {
            let [Some(a), Some(b)] = [0, 1].map(|index| inputs.get(index).and_then(name)) else {
                return false;
            };
            let of = compared_names(body);
            of == Some([a, b]) || of == Some([b, a])
        }
        _ => false,
    }
}

/// The name that a pattern is.
fn name(pat: &Pat) -> Option<&Ident> {
    match pat {
        Pat::Ident(name) if name.subpat.is_none() => Some(&name.ident),
        _ => None,
    }
}

/// The names of what is compared with what.
fn compared_names(order: &Expr) -> Option<[&Ident; 2]> {
    let Expr::MethodCall(call) = strip_parens(order) else { return None };
    match &*call.method.to_string() {
        "unwrap" | "expect" | "reverse" => compared_names(&call.receiver),
        "total_cmp" | "partial_cmp" => Some([named(&call.receiver)?, named(call.args.first()?)?]),
        _ => None,
    }
}

/// The name of a variable, or of what a reference refers to.
fn named(expr: &Expr) -> Option<&Ident> {
    match strip_parens(expr) {
        Expr::Reference(reference) => named(&reference.expr),
        Expr::Unary(unary) => named(&unary.expr),
        Expr::Path(path) => path.path.get_ident(),
        _ => None,
    }
}
