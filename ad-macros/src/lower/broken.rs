//! `break v;` in a loop, where `v` lives outside of it and may not be `Copy`.
//!
//! As with [`returned`](super::returned) a `v` that was moved out of one iteration is missing in the next. So the loop is
//! left without a value, which stands behind it.

use proc_macro2::Ident;
use syn::visit::Visit;
use syn::visit_mut::{self, VisitMut};
use syn::{Expr, ExprLoop, Label, Lifetime, Stmt, parse_quote};

use super::returned::is_outer;
use super::{Lowerer, desugar};
use crate::options::is_own;

impl Lowerer<'_> {
    /// A statement whose value is that of a loop, with the loop before it, if it is left with such values alone.
    pub(super) fn breaking_behind(&mut self, stmt: &Stmt) -> Option<Vec<Stmt>> {
        let mut stmt = stmt.clone();
        let value = match &mut stmt {
            Stmt::Local(local) => &mut *local.init.as_mut()?.expr,
            Stmt::Expr(Expr::Assign(assign), _) => &mut *assign.right,
            Stmt::Expr(Expr::Return(jump), _) => &mut **jump.expr.as_mut()?,
            Stmt::Expr(value, None) => value,
            _ => return None,
        };
        let Expr::Loop(written) = value else { return None };
        let (before, behind) = self.with_values_behind(written)?;
        *value = behind;
        Some(before.into_iter().chain([stmt]).collect())
    }

    /// The loop as statements, and its value.
    fn with_values_behind(&mut self, written: &ExprLoop) -> Option<(Vec<Stmt>, Expr)> {
        if written.attrs.iter().any(is_own) {
            return None;
        }
        let mut a_loop = written.clone();
        let mut bound = desugar::Bound::default();
        bound.visit_block(&a_loop.body);
        let reason = self.names.unwritten("left");
        let label = a_loop.label.as_ref().map(|label| label.name.clone());
        let label = label.unwrap_or_else(|| Lifetime::new(&format!("'{reason}"), reason.span()));
        let mut breaks =
            Breaks { label: &label, reason: &reason, is_nested: false, found: Vec::new() };
        breaks.visit_block_mut(&mut a_loop.body);
        let values = breaks.found;
        let are_outer = values.iter().all(|value| is_outer(value, &bound.names));
        if !are_outer || !values.iter().any(|value| self.is_movable(value)) {
            return None;
        }
        a_loop.label = Some(Label { name: label, colon_token: Default::default() });
        let numbered = values.into_iter().enumerate().rev();
        let value = numbered.fold(None, |others: Option<Expr>, (number, value)| {
            Some(match others {
                None => value,
                Some(others) => parse_quote!(if #reason == #number { #value } else { #others }),
            })
        });
        let before = vec![
            parse_quote!(let mut #reason = 0_usize;),
            Stmt::Expr(Expr::Loop(a_loop), Some(Default::default())),
        ];
        value.map(|value| (before, value))
    }
}

/// Takes the values from the `break`s out of a loop.
struct Breaks<'l> {
    /// The label of the loop.
    label: &'l Lifetime,
    /// Takes the number of the value.
    reason: &'l Ident,
    /// Whether a `break` without label leaves a loop within the loop.
    is_nested: bool,
    /// The values.
    found: Vec<Expr>,
}

impl Breaks<'_> {
    fn nested(&mut self, visit: impl FnOnce(&mut Self)) {
        let is_nested = std::mem::replace(&mut self.is_nested, true);
        visit(self);
        self.is_nested = is_nested;
    }
}

impl VisitMut for Breaks<'_> {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        match &*expr {
            Expr::ForLoop(_) | Expr::While(_) | Expr::Loop(_) => {
                self.nested(|breaks| visit_mut::visit_expr_mut(breaks, expr));
            }
            _ => visit_mut::visit_expr_mut(self, expr),
        }
        let Expr::Break(syn::ExprBreak { label, expr: Some(value), .. }) = &*expr else { return };
        let leaves_it = match label {
            Some(label) => label == self.label,
            None => !self.is_nested,
        };
        if leaves_it {
            let (Self { label, reason, .. }, number) = (&*self, self.found.len());
            let jump = parse_quote!({ #reason = #number; break #label; });
            self.found.push((**value).clone());
            *expr = jump;
        }
    }

    // Those of closures and items are theirs.
    fn visit_expr_closure_mut(&mut self, _: &mut syn::ExprClosure) {}

    fn visit_item_mut(&mut self, _: &mut syn::Item) {}
}
