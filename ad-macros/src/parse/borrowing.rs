//! Finds functions whose pullbacks hold on to what references among the parameters refer to.
//!
//! A pullback holds copies, so that a function may be called on local variables of another one, and outlive
//! them. A value with a lifetime of its own that is made of a parameter, `View { data: xs }` of an
//! `xs: &[f64]`, has a tangent of that lifetime, which the pullback names. Where a body writes out such a
//! value, that is seen; where a call makes it, where it refers to a field, or where a `Vec` of references is
//! kept, a function says so with `#[differentiable(borrows)]`.

use std::collections::HashSet;

use syn::visit::{self, Visit};
use syn::{Block, Expr, ExprCall, ExprStruct, FnArg, Local, Pat, Path, Signature, Type};

use crate::types::is_constant_mark;

/// Whether a value is made of a reference to what a parameter refers to.
pub fn keeps_references(signature: &Signature, body: &Block) -> bool {
    let references = signature.inputs.iter().filter_map(reference).collect();
    let mut finder = Finder { references, found: false };
    finder.visit_block(body);
    finder.found
}

/// The name of a parameter that is a shared reference.
fn reference(input: &FnArg) -> Option<String> {
    let is_shared =
        |ty: &Type| matches!(ty, Type::Reference(reference) if reference.mutability.is_none());
    let FnArg::Typed(typed) = input else { return None };
    let Pat::Ident(name) = &*typed.pat else { return None };
    (is_shared(&typed.ty) && !typed.attrs.iter().any(is_constant_mark))
        .then(|| name.ident.to_string())
}

struct Finder {
    /// The names of references.
    references: HashSet<String>,
    found: bool,
}

impl Finder {
    /// Whether an expression is a reference to what a parameter refers to.
    fn is_reference(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Paren(inner) => self.is_reference(&inner.expr),
            Expr::Path(path) => self.is_name(&path.path),
            Expr::Reference(reference) => {
                reference.mutability.is_none() && self.is_part(&reference.expr)
            }
            _ => false,
        }
    }

    /// Whether an expression is certainly a part of what a parameter refers to. A field may be a reference
    /// itself, which outlives the one that leads to it.
    fn is_part(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Paren(inner) => self.is_part(&inner.expr),
            Expr::Path(path) => self.is_name(&path.path),
            Expr::Index(index) => self.is_part(&index.expr),
            _ => false,
        }
    }

    fn is_name(&self, path: &Path) -> bool {
        path.get_ident().is_some_and(|name| self.references.contains(&name.to_string()))
    }
}

impl<'ast> Visit<'ast> for Finder {
    fn visit_local(&mut self, local: &'ast Local) {
        visit::visit_local(self, local);
        if let (Pat::Ident(name), Some(init)) = (&local.pat, &local.init)
            && self.is_reference(&init.expr)
        {
            self.references.insert(name.ident.to_string());
        }
    }

    fn visit_expr_struct(&mut self, made: &'ast ExprStruct) {
        self.found |= made.fields.iter().any(|field| self.is_reference(&field.expr));
        visit::visit_expr_struct(self, made);
    }

    fn visit_expr_call(&mut self, call: &'ast ExprCall) {
        self.found |=
            makes_value(&call.func) && call.args.iter().any(|part| self.is_reference(part));
        visit::visit_expr_call(self, call);
    }
}

/// Whether what is called is a struct or a variant of the user's: those of options and results hold what they
/// are given without a name for its lifetime.
fn makes_value(function: &Expr) -> bool {
    let Expr::Path(path) = function else { return false };
    path.path.segments.last().is_some_and(|last| {
        let name = last.ident.to_string();
        name.starts_with(char::is_uppercase) && !matches!(&*name, "Some" | "Ok" | "Err")
    })
}
