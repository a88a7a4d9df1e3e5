//! Conditions and patterns rewritten to plainer ones, before they are lowered.
//!
//! A chain of conditions becomes one `match` within another or, where there is more to do if it fails, a
//! `match` on an option of what the chain binds, so that the code for that is written once. An or-pattern
//! that binds names becomes an arm for each alternative: what a name is bound to, and so where its cotangent
//! goes, differs.

use proc_macro2::Ident;
use syn::visit::{self, Visit};
use syn::visit_mut::{self, VisitMut};
use syn::{Arm, BinOp, Expr, ExprIf, Pat, Stmt, Token, parse_quote};

use crate::lower::syntax::is_type_name;
use crate::names::Names;

/// An `if` or `match` in plainer form.
pub fn branch(expr: Expr) -> Expr {
    match expr {
        Expr::If(branch) if is_chain(&branch.cond) => chain(branch),
        Expr::If(branch) => match &*branch.cond {
            Expr::Let(condition) if alternatives(&condition.pat).len() > 1 => {
                let (pat, matched) = (&condition.pat, &condition.expr);
                let (then, otherwise) = (&branch.then_branch, otherwise(&branch));
                self::branch(parse_quote!(match #matched { #pat => #then, _ => #otherwise }))
            }
            _ => Expr::If(branch),
        },
        Expr::Match(mut branch) => {
            let split = |arm: &Arm| {
                let arm = arm.clone();
                alternatives(&arm.pat).into_iter().map(move |pat| Arm { pat, ..arm.clone() })
            };
            branch.arms = branch.arms.iter().flat_map(split).collect();
            Expr::Match(branch)
        }
        expr => expr,
    }
}

/// What an `if` evaluates to if its condition does not hold.
pub fn otherwise(branch: &ExprIf) -> Expr {
    match &branch.else_branch {
        Some((_, otherwise)) => (**otherwise).clone(),
        None => parse_quote!({}),
    }
}

/// Whether `let` is one of several conditions.
fn is_chain(condition: &Expr) -> bool {
    let conditions = conditions(condition);
    conditions.len() > 1 && conditions.iter().any(|part| matches!(part, Expr::Let(_)))
}

/// The conditions that `&&` joins.
pub fn conditions(condition: &Expr) -> Vec<&Expr> {
    match condition {
        Expr::Binary(binary) if matches!(binary.op, BinOp::And(_)) => {
            let mut parts = conditions(&binary.left);
            parts.extend(conditions(&binary.right));
            parts
        }
        condition => vec![condition],
    }
}

fn chain(branch: ExprIf) -> Expr {
    let mut bound = Bound::default();
    let mut splits = false;
    for condition in conditions(&branch.cond) {
        if let Expr::Let(condition) = condition {
            bound.visit_pat(&condition.pat);
            splits |= alternatives(&condition.pat).len() > 1;
        }
    }
    let (names, mutabilities) = (&bound.names, &bound.mutabilities);
    let (then, otherwise) = (&branch.then_branch, otherwise(&branch));
    if is_short(&otherwise) && !splits {
        return nested(&branch.cond, parse_quote!(#then), &otherwise);
    }
    let some = parse_quote!(::core::option::Option::Some((#(#names,)*)));
    let outcome = nested(&branch.cond, some, &parse_quote!(::core::option::Option::None));
    parse_quote!(match #outcome {
        ::core::option::Option::Some((#(#mutabilities #names,)*)) => #then,
        ::core::option::Option::None => #otherwise,
    })
}

/// A value as what a `match`, an `if` or a `for` looks at, which has struct literals in parentheses and brackets only.
pub fn scrutinee(value: &Expr) -> Expr {
    fn has_bare_struct(value: &Expr) -> bool {
        match value {
            Expr::Struct(_) => true,
            Expr::Binary(binary) => has_bare_struct(&binary.left) || has_bare_struct(&binary.right),
            Expr::Cast(cast) => has_bare_struct(&cast.expr),
            Expr::Field(field) => has_bare_struct(&field.base),
            Expr::Index(index) => has_bare_struct(&index.expr),
            Expr::MethodCall(call) => has_bare_struct(&call.receiver),
            Expr::Reference(reference) => has_bare_struct(&reference.expr),
            Expr::Try(attempt) => has_bare_struct(&attempt.expr),
            Expr::Unary(unary) => has_bare_struct(&unary.expr),
            _ => false,
        }
    }
    if has_bare_struct(value) { parse_quote!((#value)) } else { value.clone() }
}

/// `then` where all conditions hold, and else `otherwise`, which is written once for each.
pub fn nested(condition: &Expr, then: Expr, otherwise: &Expr) -> Expr {
    conditions(condition).into_iter().rev().fold(then, |then, condition| match condition {
        Expr::Let(condition) => {
            let (pat, matched) = (&condition.pat, &condition.expr);
            parse_quote!(match #matched { #pat => #then, _ => #otherwise })
        }
        condition => parse_quote!(if #condition { #then } else { #otherwise }),
    })
}

/// Whether a block does nothing, or only jumps.
fn is_short(block: &Expr) -> bool {
    let Expr::Block(block) = block else { return false };
    match &block.block.stmts[..] {
        [] => true,
        [Stmt::Expr(Expr::Break(jump), _)] => jump.expr.is_none(),
        [Stmt::Expr(jump, _)] => matches!(jump, Expr::Continue(_)),
        _ => false,
    }
}

/// `let r = if c { &mut a } else { &mut b }; rest` as `if c { let r = &mut a; rest } else { let r = &mut
/// b; rest }`: the place that a name stands for is known where it is used.
pub fn chosen_reference(stmt: &Stmt, rest: &[Stmt]) -> Option<Stmt> {
    let Stmt::Local(syn::Local { pat, init: Some(init), .. }) = stmt else { return None };
    let mut choice = (*init.expr).clone();
    let mut is_chosen = true;
    let mut go_on = |place: &Expr| -> syn::Block {
        is_chosen &= matches!(place, Expr::Reference(place) if place.mutability.is_some());
        parse_quote!({ let #pat = #place; #(#rest)* })
    };
    match &mut choice {
        Expr::If(branch) => {
            branch.then_branch = go_on(only_value(&branch.then_branch)?);
            let (_, otherwise) = branch.else_branch.as_mut()?;
            let Expr::Block(block) = &mut **otherwise else { return None };
            block.block = go_on(only_value(&block.block)?);
        }
        Expr::Match(branch) => {
            for arm in &mut branch.arms {
                let body = match &*arm.body {
                    Expr::Block(block) => only_value(&block.block)?,
                    body => body,
                };
                let body = go_on(body);
                *arm.body = parse_quote!(#body);
            }
        }
        _ => return None,
    }
    is_chosen.then(|| Stmt::Expr(choice, None))
}

/// The value of a block without statements.
pub fn only_value(block: &syn::Block) -> Option<&Expr> {
    match &block.stmts[..] {
        [Stmt::Expr(value, None)] => Some(value),
        _ => None,
    }
}

/// An assignment to several places, as a `let` and assignments to one each.
pub fn assignment(assign: &syn::ExprAssign, names: &mut Names) -> Option<Vec<Stmt>> {
    if !matches!(&*assign.left, Expr::Tuple(_) | Expr::Array(_) | Expr::Struct(_) | Expr::Call(_)) {
        return None;
    }
    let mut assignments = Vec::new();
    let pattern = parts(&assign.left, names, &mut assignments);
    let value = &assign.right;
    let mut statements = vec![parse_quote!(let #pattern = #value;)];
    statements.extend(assignments);
    Some(statements)
}

/// The pattern that gives a name to each place in `target`, and the assignments of the names.
fn parts(target: &Expr, names: &mut Names, into: &mut Vec<Stmt>) -> Pat {
    match target {
        Expr::Tuple(tuple) => {
            let parts: Vec<_> = tuple.elems.iter().map(|part| parts(part, names, into)).collect();
            parse_quote!((#(#parts,)*))
        }
        Expr::Array(array) => {
            let parts: Vec<_> = array.elems.iter().map(|part| parts(part, names, into)).collect();
            parse_quote!([#(#parts),*])
        }
        Expr::Call(call) => {
            let constructor = &call.func;
            let parts: Vec<_> = call.args.iter().map(|part| parts(part, names, into)).collect();
            parse_quote!(#constructor(#(#parts),*))
        }
        Expr::Struct(literal) => {
            let path = &literal.path;
            let members = literal.fields.iter().map(|field| &field.member);
            let parts: Vec<_> =
                literal.fields.iter().map(|field| parts(&field.expr, names, into)).collect();
            let rest = &literal.dot2_token;
            parse_quote!(#path { #(#members: #parts,)* #rest })
        }
        Expr::Infer(_) => parse_quote!(_),
        Expr::Range(range) if range.start.is_none() && range.end.is_none() => parse_quote!(..),
        Expr::Paren(inner) => parts(&inner.expr, names, into),
        place => {
            let name = names.unwritten("part");
            into.push(parse_quote!(#place = #name;));
            parse_quote!(#name)
        }
    }
}

/// The names that a pattern binds.
#[derive(Default)]
pub struct Bound {
    /// The names.
    pub names: Vec<Ident>,
    /// Whether each may be assigned to.
    pub mutabilities: Vec<Option<Token![mut]>>,
}

impl<'ast> Visit<'ast> for Bound {
    fn visit_pat_ident(&mut self, pat: &'ast syn::PatIdent) {
        let is_constant = pat.subpat.is_none() && is_type_name(&pat.ident);
        // Of a name that is bound again the last meaning counts; alternatives bind the same names.
        if !is_constant {
            if let Some(previous) = self.names.iter().position(|name| *name == pat.ident) {
                self.names.remove(previous);
                self.mutabilities.remove(previous);
            }
            self.names.push(pat.ident.clone());
            self.mutabilities.push(pat.mutability);
        }
        visit::visit_pat_ident(self, pat);
    }
}

/// The patterns that together match what `pat` does, none of which binds names in alternatives.
pub fn alternatives(pat: &Pat) -> Vec<Pat> {
    let Some(count) = First::count(pat) else { return vec![pat.clone()] };
    let choice = |index| {
        let mut pat = pat.clone();
        Choose(Some(index)).visit_pat_mut(&mut pat);
        alternatives(&pat)
    };
    (0..count).flat_map(choice).collect()
}

fn binds_alternatives(pat: &syn::PatOr) -> bool {
    let mut bound = Bound::default();
    bound.visit_pat_or(pat);
    !bound.names.is_empty()
}

/// Counts the alternatives of the first or-pattern that binds names.
struct First(Option<usize>);

impl First {
    fn count(pat: &Pat) -> Option<usize> {
        let mut first = Self(None);
        first.visit_pat(pat);
        first.0
    }
}

impl<'ast> Visit<'ast> for First {
    fn visit_pat_or(&mut self, pat: &'ast syn::PatOr) {
        if self.0.is_none() && binds_alternatives(pat) {
            self.0 = Some(pat.cases.len());
        }
    }
}

/// Puts one alternative in the place of the first or-pattern that binds names.
struct Choose(Option<usize>);

impl VisitMut for Choose {
    fn visit_pat_mut(&mut self, pat: &mut Pat) {
        match pat {
            Pat::Or(or) if binds_alternatives(or) => {
                if let Some(index) = self.0.take() {
                    *pat = or.cases[index].clone();
                }
            }
            pat => visit_mut::visit_pat_mut(self, pat),
        }
    }
}
