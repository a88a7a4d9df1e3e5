//! Iterators that have a name: `let pairs = a.iter().zip(b); pairs.map(..).sum()` is one chain.
//!
//! Nothing of an iterator is evaluated before it is used up, but for what it goes over. So it may stand where its
//! name stands, if that is in one place, outside of loops and closures, and if what it copies does not change on
//! the way.

use std::collections::HashSet;

use proc_macro2::Ident;
use quote::ToTokens;
use syn::visit::{self, Visit};
use syn::visit_mut::{self, VisitMut};
use syn::{Expr, Local, Macro, Pat, Stmt, parse_quote};

use super::exits::is_update;
use crate::lower::iterate::chain::{is_adapter, is_chain, is_source};
use crate::lower::search::{Bound, has};
use crate::lower::syntax::{is_plain_name, strip_parens};
use crate::names::identifiers;

/// The statements behind one that gives an iterator a name, with the iterator in its place.
pub fn inlined(stmt: &Stmt, rest: &[Stmt]) -> Option<Vec<Stmt>> {
    let Stmt::Local(Local { pat: Pat::Ident(name), init: Some(init), .. }) = stmt else {
        return None;
    };
    let chain = &*init.expr;
    if !is_plain_name(name) || init.diverge.is_some() || !is_unused(chain) {
        return None;
    }
    let mut place = Place { name: &name.ident, chain, uses: 0, is_certain: true };
    let mut stmts = rest.to_vec();
    // The last statement before the use, or with it.
    let mut last = 0;
    for (index, stmt) in stmts.iter_mut().enumerate() {
        let hides = matches!(stmt, Stmt::Local(local) if Bound::has(&local.pat, &name.ident));
        match stmt {
            Stmt::Local(Local { init: Some(init), .. }) => place.visit_local_init_mut(init),
            stmt => place.visit_stmt_mut(stmt),
        }
        last = if place.uses == 0 { index + 1 } else { last };
        if hides {
            break;
        }
    }
    let Place { uses: 1, is_certain: true, .. } = place else { return None };

    // What the iterator names means the same there.
    let bound: HashSet<_> =
        Bound::within(chain).iter().map(|bound| bound.ident.to_string()).collect();
    let named = identifiers(chain.to_token_stream()).into_iter().map(|name| name.to_string());
    let named = named.filter(|name| !bound.contains(name)).chain([name.ident.to_string()]);
    let mut copied = HashSet::new();
    copies(chain, &mut copied);
    let mut changes = Changes { named: named.collect(), copied, found: false };
    for (index, stmt) in rest.iter().enumerate().take(last + 1) {
        match stmt {
            // What it binds is there behind the use.
            Stmt::Local(Local { init: Some(init), .. }) if index == last => {
                changes.visit_local_init(init);
            }
            stmt => changes.visit_stmt(stmt),
        }
    }
    (!changes.found).then_some(stmts)
}

/// Whether an expression is an iterator over what is a place, a range or such iterators.
fn is_unused(expr: &Expr) -> bool {
    let Expr::MethodCall(call) = strip_parens(expr) else { return false };
    let is_known = is_source(&call.method) || is_adapter(&call.method);
    if !is_known || !is_chain(expr) || call.method == "drain" || call.method == "peekable" {
        return false;
    }
    let receiver = strip_parens(&call.receiver);
    (is_unused(receiver) || is_pure(receiver)) && call.args.iter().all(is_pure)
}

/// Whether it makes no difference where an expression is evaluated, as long as what it names stays as it is.
fn is_pure(expr: &Expr) -> bool {
    match strip_parens(expr) {
        Expr::Closure(closure) => closure.capture.is_none(),
        Expr::MethodCall(_) => is_unused(expr),
        expr => !has(expr, |part| match part {
            Expr::Lit(_)
            | Expr::Path(_)
            | Expr::Field(_)
            | Expr::Index(_)
            | Expr::Range(_)
            | Expr::Reference(_)
            | Expr::Binary(_)
            | Expr::Paren(_) => None,
            Expr::MethodCall(call) if call.method == "len" => None,
            _ => Some(true),
        }),
    }
}

/// What an iterator, or a part of it, copies where it is made.
fn copies(expr: &Expr, copied: &mut HashSet<String>) {
    match strip_parens(expr) {
        Expr::MethodCall(call) => {
            match strip_parens(&call.receiver) {
                Expr::Path(_) if call.method != "into_iter" => {}
                receiver => copies(receiver, copied),
            }
            call.args.iter().for_each(|argument| copies(argument, copied));
        }
        Expr::Closure(_) => {}
        Expr::Reference(reference) if matches!(*reference.expr, Expr::Path(_)) => {}
        expr => {
            let names = identifiers(expr.to_token_stream()).into_iter();
            copied.extend(names.map(|name| name.to_string()));
        }
    }
}

/// Puts an iterator in the place of its name.
struct Place<'n> {
    name: &'n Ident,
    chain: &'n Expr,
    uses: usize,
    is_certain: bool,
}

impl Place<'_> {
    /// What may run more than once, or later.
    fn repeated(&mut self, visit: impl FnOnce(&mut Self)) {
        let before = self.uses;
        visit(self);
        self.is_certain &= self.uses == before;
    }
}

impl VisitMut for Place<'_> {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        match expr {
            Expr::Path(path) if path.path.is_ident(self.name) => {
                let chain = self.chain;
                *expr = parse_quote!((#chain));
                self.uses += 1;
            }
            Expr::ForLoop(a_loop) => {
                self.visit_expr_mut(&mut a_loop.expr);
                self.repeated(|place| place.visit_block_mut(&mut a_loop.body));
            }
            Expr::If(branch) => {
                self.visit_expr_mut(&mut branch.cond);
                let before = self.uses;
                self.visit_block_mut(&mut branch.then_branch);
                let then = std::mem::replace(&mut self.uses, before);
                if let Some((_, otherwise)) = &mut branch.else_branch {
                    self.visit_expr_mut(otherwise);
                }
                self.uses = self.uses.max(then);
            }
            Expr::While(_) | Expr::Loop(_) | Expr::Closure(_) => {
                self.repeated(|place| visit_mut::visit_expr_mut(place, expr));
            }
            _ => visit_mut::visit_expr_mut(self, expr),
        }
    }

    fn visit_macro_mut(&mut self, call: &mut Macro) {
        self.is_certain &= !call.tokens.to_string().contains(&self.name.to_string());
    }
}

/// Looks for what may give one of the names another meaning or value.
struct Changes {
    named: HashSet<String>,
    /// Those that may be changed in between.
    copied: HashSet<String>,
    found: bool,
}

/// Whether an expression names one of these.
fn names(place: &Expr, any: &HashSet<String>) -> bool {
    let names = identifiers(place.to_token_stream());
    names.iter().any(|name| any.contains(&name.to_string()))
}

impl<'ast> Visit<'ast> for Changes {
    fn visit_pat_ident(&mut self, pat: &'ast syn::PatIdent) {
        self.found |= self.named.contains(&pat.ident.to_string());
        visit::visit_pat_ident(self, pat);
    }

    fn visit_expr(&mut self, expr: &'ast Expr) {
        let changed = match expr {
            Expr::Assign(assign) => Some(&assign.left),
            Expr::Binary(update) if is_update(&update.op) => Some(&update.left),
            Expr::Reference(reference) if reference.mutability.is_some() => Some(&reference.expr),
            Expr::MethodCall(call) => {
                let looks = call.method == "len" || call.method == "iter";
                let is_place = matches!(
                    strip_parens(&call.receiver),
                    Expr::Path(_) | Expr::Field(_) | Expr::Index(_)
                );
                self.found |= is_place && !looks && names(&call.receiver, &self.copied);
                None
            }
            _ => None,
        };
        self.found |= changed.is_some_and(|place| names(place, &self.named));
        visit::visit_expr(self, expr);
    }

    fn visit_macro(&mut self, call: &'ast Macro) {
        let names = identifiers(call.tokens.clone());
        self.found |= names.iter().any(|name| self.copied.contains(&name.to_string()));
    }
}
