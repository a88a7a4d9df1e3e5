//! Types that are written in one place and needed in another.
//!
//! In `let rows: Vec<f64> = m.iter().map(|row| row.iter().sum()).collect();` the type of the sums stands
//! far from them. The derivative adds them up where they stand, so it is told there; and `x.into()`, what it
//! makes of `x`. In `(&self.vector, 1.0)` a reference becomes one to a slice, if that is what the function returns: the
//! derivative gives the reference a name, and the name the type.

use proc_macro2::{Ident, Span};
use syn::visit::Visit;
use syn::visit_mut::{self, VisitMut};
use syn::{
    Expr, ExprClosure, ExprLit, ExprMethodCall, ExprPath, Lit, Local, Member, Pat, Stmt, Type,
    parse_quote,
};

use super::desugar::Bound;
use super::variants::content;
use crate::lower::iterate::chain::is_chain;
use crate::lower::syntax::{is_transparent, outcome};
use crate::types::{element, is_float};

/// The statements of the body of a function whose result is of this type.
pub fn statements(mut stmts: Vec<Stmt>, ty: &Type) -> Vec<Stmt> {
    let mut returns = Returns { ty, found: false };
    stmts.iter_mut().for_each(|stmt| returns.visit_stmt_mut(stmt));
    tell_last(&mut stmts, ty, returns.found);
    stmts
}

/// Tells what is returned early its type.
struct Returns<'t> {
    ty: &'t Type,
    found: bool,
}

impl VisitMut for Returns<'_> {
    fn visit_expr_return_mut(&mut self, jump: &mut syn::ExprReturn) {
        visit_mut::visit_expr_return_mut(self, jump);
        if let Some(value) = &mut jump.expr {
            self.found = true;
            tell_within(value, self.ty, true);
        }
    }

    // Those of closures and items are theirs.
    fn visit_expr_closure_mut(&mut self, _: &mut ExprClosure) {}

    fn visit_item_mut(&mut self, _: &mut syn::Item) {}
}

/// Tells what a variable is set to the type of the variable.
pub fn tell_local(value: &mut Expr, ty: &Type) {
    match value {
        Expr::MethodCall(call) if is_into(call) => {}
        value => tell(value, ty),
    }
}

/// Tells an expression its type.
pub(super) fn tell(value: &mut Expr, ty: &Type) {
    tell_within(value, ty, false);
}

fn tell_last(stmts: &mut [Stmt], ty: &Type, is_part: bool) {
    let Some((Stmt::Expr(value, None), before)) = stmts.split_last_mut() else { return };
    tell_within(value, ty, is_part);
    if let (Expr::Path(ExprPath { path, .. }), true) = (value, is_float(ty))
        && let Some(name) = path.get_ident()
    {
        tell_literal(before, name, ty);
    }
}

/// Tells a variable that begins as a literal its type.
fn tell_literal(stmts: &mut [Stmt], name: &Ident, ty: &Type) {
    let binds = |pat: &Pat| {
        let mut bound = Bound::default();
        bound.visit_pat(pat);
        bound.names.contains(name)
    };
    let mut locals = stmts.iter_mut().rev().filter_map(|stmt| match stmt {
        Stmt::Local(local) => Some(local),
        _ => None,
    });
    let is_literal = |value: &Expr| match value {
        Expr::Lit(ExprLit { lit: Lit::Float(float), .. }) => float.suffix().is_empty(),
        _ => false,
    };
    if let Some(Local { pat, init: Some(init), .. }) = locals.find(|local| binds(&local.pat))
        && matches!(pat, Pat::Ident(_))
        && is_literal(&init.expr)
    {
        *pat = Pat::Type(parse_quote!(#pat: #ty));
    }
}

/// Tells an expression its type. What is a part of another value, or one of several, gets it before it meets
/// the others: a reference may be of another type, which is made this one there.
fn tell_within(value: &mut Expr, ty: &Type, is_part: bool) {
    match value {
        Expr::Paren(paren) => tell_within(&mut paren.expr, ty, is_part),
        Expr::Block(block) => tell_last(&mut block.block.stmts, ty, is_part),
        Expr::If(branch) => {
            tell_last(&mut branch.then_branch.stmts, ty, true);
            if let Some((_, otherwise)) = &mut branch.else_branch {
                tell_within(otherwise, ty, true);
            }
        }
        Expr::Match(branch) => {
            branch.arms.iter_mut().for_each(|arm| tell_within(&mut arm.body, ty, true));
        }
        Expr::Tuple(parts) => {
            if let Type::Tuple(types) = ty {
                let both = parts.elems.iter_mut().zip(&types.elems);
                both.for_each(|(part, ty)| tell_within(part, ty, true));
            }
        }
        Expr::Call(call) if let Some(content) = constructed(&call.func, ty) => {
            call.args.iter_mut().for_each(|part| tell_within(part, content, true));
        }
        Expr::MethodCall(call) if call.args.is_empty() && is_chain(&call.receiver) => {
            if call.method == "sum" || call.method == "product" {
                call.turbofish.get_or_insert_with(|| parse_quote!(::<#ty>));
            }
            if call.method == "collect" {
                match element(ty) {
                    Some(element) => tell_items(&mut call.receiver, element),
                    None if is_no_vec(ty) => {
                        call.turbofish.get_or_insert_with(|| parse_quote!(::<#ty>));
                    }
                    None => {}
                }
            }
        }
        Expr::MethodCall(call) if is_into(call) && !matches!(ty, Type::Infer(_)) => {
            write_down(value, ty, "into");
        }
        Expr::Reference(_) | Expr::Path(_) | Expr::Field(_) | Expr::MethodCall(_)
            if is_part
                && matches!(ty, Type::Reference(reference) if reference.mutability.is_none()) =>
        {
            write_down(value, ty, "part");
        }
        _ => {}
    }
}

/// Writes the type of a value beside it.
fn write_down(value: &mut Expr, ty: &Type, name: &str) {
    let name = Ident::new(name, Span::mixed_site());
    *value = parse_quote!({
        let #name: #ty = #value;
        #name
    });
}

/// The type of what `Some` or `Ok` makes a value of this type of.
fn constructed<'t>(function: &Expr, ty: &'t Type) -> Option<&'t Type> {
    let Expr::Path(ExprPath { path, .. }) = function else { return None };
    let is_first = is_transparent(path) || outcome(path) == Some(Member::from(0));
    content(ty).filter(|_| is_first)
}

/// `x.into()`
fn is_into(call: &ExprMethodCall) -> bool {
    call.method == "into" && call.args.is_empty()
}

/// Whether a name certainly is that of something else in the standard library than a `Vec`.
fn is_no_vec(ty: &Type) -> bool {
    const OTHERS: [&str; 9] = [
        "Option", "Result", "String", "Box", "VecDeque", "HashMap", "HashSet", "BTreeMap",
        "BTreeSet",
    ];
    matches!(ty, Type::Path(path)
        if path.path.segments.last().is_some_and(|last| OTHERS.iter().any(|name| last.ident == name)))
}

/// Tells an iterator the type of its items.
pub fn tell_items(iterator: &mut Expr, ty: &Type) {
    if let Expr::MethodCall(call) = iterator
        && call.method == "map"
        && let Some(Expr::Closure(ExprClosure { body, .. })) = call.args.first_mut()
    {
        tell(body, ty);
    }
}
