//! Which variables are of types that are known not to be `Copy`, as far as declarations tell.

use syn::visit::Visit;
use syn::{Expr, Pat, Type};

use super::Lowerer;
use super::operator::is_own_type;
use super::syntax::{is_type_name, standard_macro, strip_parens};
use crate::types::pointee;

impl Lowerer<'_> {
    /// Whether a value is made of variables whose values may not be `Copy`.
    pub(super) fn is_movable(&self, value: &Expr) -> bool {
        struct Finder<'l, 'a>(&'l Lowerer<'a>, bool);

        impl<'ast> Visit<'ast> for Finder<'_, '_> {
            fn visit_expr_path(&mut self, path: &'ast syn::ExprPath) {
                let var = self.0.variable(path);
                self.1 |= var
                    .is_some_and(|var| self.0.movable.contains(&var) || self.0.own.contains(&var));
            }
        }

        let mut finder = Finder(self, false);
        finder.visit_expr(value);
        finder.1
    }

    /// Notes the variables of a declaration whose values may not be `Copy`, as far as it tells.
    pub(super) fn note_movable(&mut self, pat: &Pat, ty: Option<&Type>, value: &Expr) {
        let name = match (pat, strip_parens(value)) {
            (Pat::Ident(name), _) => &name.ident,
            (Pat::Tuple(names), Expr::Tuple(values)) if names.elems.len() == values.elems.len() => {
                for (name, value) in names.elems.iter().zip(&values.elems) {
                    self.note_movable(name, None, value);
                }
                return;
            }
            _ => return,
        };
        let is_movable = match ty {
            Some(ty) => is_vec_or_box(ty) || is_own_type(ty, &self.scalars),
            None => makes_movable(value),
        };
        if let Some(var) = self.lookup(name).filter(|_| is_movable) {
            self.movable.insert(var);
        }
    }
}

/// `Vec<T>`, `Box<T>`, `String`
pub(super) fn is_vec_or_box(ty: &Type) -> bool {
    matches!(pointee(ty), Type::Path(path) if path.path.segments.last()
        .is_some_and(|last| ["Vec", "Box", "String"].iter().any(|name| last.ident == name)))
}

/// Whether an expression makes a new `Vec` or the like.
fn makes_movable(value: &Expr) -> bool {
    match strip_parens(value) {
        Expr::Macro(call) => {
            matches!(standard_macro(&call.mac.path).as_deref(), Some("vec" | "format"))
        }
        Expr::MethodCall(call) => ["clone", "collect", "to_vec", "to_owned", "to_string"]
            .iter()
            .any(|name| call.method == name),
        Expr::Call(call) => matches!(&*call.func, Expr::Path(path)
            if path.path.segments.iter().rev().nth(1).is_some_and(|owner| is_type_name(&owner.ident))),
        Expr::Struct(_) => true,
        _ => false,
    }
}
