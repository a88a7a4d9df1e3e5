//! `return v;` in a loop, where `v` lives outside of it and may not be `Copy`.
//!
//! A loop of generated code is left at the end of an iteration, and to the compiler a `v` that was moved
//! before is missing in the next. So the loop is left by `break`, and the `return` stands behind it.

use proc_macro2::Ident;
use syn::visit::Visit;
use syn::visit_mut::{self, VisitMut};
use syn::{Expr, Label, Lifetime, Pat, Stmt, Type, parse_quote};

use super::exits::{self, Exit};
use super::operator::is_own_type;
use super::syntax::{is_type_name, standard_macro, strip_parens};
use super::{Lowerer, desugar};
use crate::options::is_own;
use crate::types::pointee;

impl Lowerer<'_> {
    /// A loop with these `return`s behind it, if there are some.
    pub(super) fn returning_behind(&mut self, stmt: &Stmt) -> Option<Vec<Stmt>> {
        let Stmt::Expr(written, _) = stmt else { return None };
        let mut a_loop = written.clone();
        let (attributes, label, body) = match &mut a_loop {
            Expr::ForLoop(a_loop) => (&a_loop.attrs, &mut a_loop.label, &mut a_loop.body),
            Expr::While(a_loop) => (&a_loop.attrs, &mut a_loop.label, &mut a_loop.body),
            Expr::Loop(a_loop) => (&a_loop.attrs, &mut a_loop.label, &mut a_loop.body),
            _ => return None,
        };
        if attributes.iter().any(is_own) {
            return None;
        }
        if !exits::block_exits(body).contains(&Exit::Return) {
            return None;
        }
        let mut bound = desugar::Bound::default();
        bound.visit_block(body);
        let reason = self.names.unwritten("returned");
        let own = label.as_ref().map(|label| label.name.clone());
        let own = own.unwrap_or_else(|| Lifetime::new(&format!("'{reason}"), reason.span()));
        let mut returns = Returns {
            lowerer: self,
            bound: &bound.names,
            label: &own,
            reason: &reason,
            found: Vec::new(),
        };
        returns.visit_block_mut(body);
        let found = returns.found;
        if found.is_empty() {
            return None;
        }
        *label = Some(Label { name: own, colon_token: Default::default() });
        let is_left_otherwise = !exits::expr_diverges(written);
        let mut behind = vec![
            parse_quote!(let mut #reason = 0_usize;),
            Stmt::Expr(a_loop, Some(Default::default())),
        ];
        for (index, value) in found.iter().enumerate() {
            let number = index + 1;
            behind.push(match is_left_otherwise || number < found.len() {
                true => parse_quote!(if #reason == #number { return #value; }),
                false => parse_quote!(return #value;),
            });
        }
        Some(behind)
    }

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

/// Whether a value consists of variables that live outside of a loop, which binds others.
pub(super) fn is_outer(value: &Expr, bound: &[Ident]) -> bool {
    match strip_parens(value) {
        Expr::Path(path) => match path.path.get_ident() {
            Some(name) => !bound.contains(name),
            None => true,
        },
        Expr::Lit(_) => true,
        Expr::Tuple(tuple) => tuple.elems.iter().all(|part| is_outer(part, bound)),
        Expr::Call(call) => {
            matches!(&*call.func, Expr::Path(function)
                if function.path.segments.last().is_some_and(|last| is_type_name(&last.ident)))
                && call.args.iter().all(|part| is_outer(part, bound))
        }
        Expr::Struct(literal) => {
            literal.rest.is_none()
                && literal.fields.iter().all(|field| is_outer(&field.expr, bound))
        }
        _ => false,
    }
}

/// Puts jumps out of the loop in the place of `return`s of what may not be `Copy`.
struct Returns<'l, 'a> {
    lowerer: &'l Lowerer<'a>,
    /// What the loop binds.
    bound: &'l [Ident],
    /// The label of the loop.
    label: &'l Lifetime,
    /// Takes the number of the value.
    reason: &'l Ident,
    /// What is returned.
    found: Vec<Expr>,
}

impl VisitMut for Returns<'_, '_> {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        visit_mut::visit_expr_mut(self, expr);
        let Expr::Return(syn::ExprReturn { expr: Some(value), .. }) = &*expr else { return };
        if is_outer(value, self.bound) && self.lowerer.is_movable(value) {
            self.found.push((**value).clone());
            let (Self { label, reason, .. }, number) = (&*self, self.found.len());
            *expr = parse_quote!({ #reason = #number; break #label; });
        }
    }

    // Those of closures and items are theirs.
    fn visit_expr_closure_mut(&mut self, _: &mut syn::ExprClosure) {}

    fn visit_item_mut(&mut self, _: &mut syn::Item) {}
}
