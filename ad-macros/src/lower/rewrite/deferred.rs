//! Variables that get their value after their declaration.
//!
//! `let r; if c { r = a; } else { r = b; }` becomes `let r = if c { let r = a; r } else { let r = b;
//! r };`: where a variable begins, its value is known. The compiler has checked of the function
//! itself that every way to a use assigns once, so each first assignment is the declaration.

use proc_macro2::Ident;
use quote::quote;
use syn::visit::{self, Visit};
use syn::visit_mut::{self, VisitMut};
use syn::{Block, Expr, Local, Pat, Stmt, Token, Type, parse_quote};

use super::desugar::{Bound, otherwise};
use super::exits;
use crate::lower::syntax::{as_statements, strip_parens};

/// A variable that has no value yet.
#[derive(Clone)]
struct Deferred {
    name: Ident,
    mutability: Option<Token![mut]>,
    ty: Option<Type>,
}

impl Deferred {
    /// `let name: ty = value;`
    fn declared(&self, value: &Expr) -> Stmt {
        let Self { name, mutability, ty } = self;
        let ty = ty.as_ref().map(|ty| quote!(: #ty));
        parse_quote!(let #mutability #name #ty = #value;)
    }
}

/// The statements of a block, the first of which declares a variable without value, with every
/// variable declared where it is given its value. `None` where this cannot be done.
pub fn initialised(stmts: Vec<Stmt>) -> Option<Vec<Stmt>> {
    let rewritten = rewrite(stmts, &mut Vec::new(), &[])?;
    Some(rewritten.stmts)
}

/// The names that a declaration without value introduces, if it is one.
pub fn declared(stmt: &Stmt) -> Option<Vec<Ident>> {
    match stmt {
        Stmt::Local(Local { pat, init: None, .. }) => {
            let mut bound = Bound::default();
            bound.visit_pat(pat);
            Some(bound.names)
        }
        _ => None,
    }
}

/// Statements with declarations in place of first assignments.
struct Rewritten {
    stmts: Vec<Stmt>,
    /// What they declare.
    declared: Vec<Ident>,
}

/// Rewrites the statements of a block in which `deferred` have no value yet. `carried` is what a
/// `break` out of the loop around them takes along, once it has a value.
fn rewrite(stmts: Vec<Stmt>, deferred: &mut Vec<Deferred>, carried: &[Ident]) -> Option<Rewritten> {
    let mut rewritten = Rewritten { stmts: Vec::new(), declared: Vec::new() };
    for mut stmt in stmts {
        if !carried.is_empty() && carried.iter().all(|name| rewritten.declared.contains(name)) {
            Breaks { carried, depth: 0 }.visit_stmt_mut(&mut stmt);
        }
        if let Stmt::Local(Local { pat, init: None, .. }) = &stmt {
            declare(pat, None, deferred)?;
            continue;
        }
        let assigned = assigned(&stmt, deferred);
        if assigned.is_empty() {
            if let Stmt::Local(local) = &stmt {
                let mut bound = Bound::default();
                bound.visit_pat(&local.pat);
                deferred.retain(|variable| !bound.names.contains(&variable.name));
            }
            rewritten.stmts.push(stmt);
            continue;
        }
        let Stmt::Expr(expr, _) = stmt else { return None };
        let (stmt, names) = first_assignment(expr, &assigned, carried)?;
        deferred.retain(|variable| !names.contains(&variable.name));
        rewritten.stmts.push(stmt);
        // Of several together the types follow.
        if names.len() > 1 {
            let declared = assigned.iter().filter(|variable| names.contains(&variable.name));
            let typed = declared.filter(|variable| variable.ty.is_some()).map(|variable| {
                let name = &variable.name;
                variable.declared(&parse_quote!(#name))
            });
            rewritten.stmts.extend(typed);
        }
        rewritten.declared.extend(names);
    }
    Some(rewritten)
}

/// Notes the variables that `let pat: ty;` declares.
fn declare(pat: &Pat, ty: Option<&Type>, into: &mut Vec<Deferred>) -> Option<()> {
    match pat {
        Pat::Type(typed) => declare(&typed.pat, Some(&typed.ty), into),
        Pat::Ident(ident) if ident.by_ref.is_none() && ident.subpat.is_none() => {
            into.retain(|variable| variable.name != ident.ident);
            let (name, mutability) = (ident.ident.clone(), ident.mutability);
            into.push(Deferred { name, mutability, ty: ty.cloned() });
            Some(())
        }
        Pat::Tuple(tuple) => tuple.elems.iter().enumerate().try_for_each(|(index, part)| {
            let ty = match ty {
                Some(Type::Tuple(types)) => types.elems.get(index),
                _ => None,
            };
            declare(part, ty, into)
        }),
        _ => None,
    }
}

/// Those of `deferred` that a statement assigns to.
fn assigned(stmt: &Stmt, deferred: &[Deferred]) -> Vec<Deferred> {
    struct Finder<'a> {
        deferred: &'a [Deferred],
        found: Vec<Ident>,
    }

    impl Finder<'_> {
        fn target(&mut self, target: &Expr) {
            match strip_parens(target) {
                Expr::Path(path) => {
                    let named = |variable: &&Deferred| path.path.is_ident(&variable.name);
                    self.found.extend(self.deferred.iter().find(named).map(|v| v.name.clone()));
                }
                Expr::Tuple(tuple) => tuple.elems.iter().for_each(|part| self.target(part)),
                _ => {}
            }
        }
    }

    impl<'ast> Visit<'ast> for Finder<'_> {
        fn visit_expr_assign(&mut self, assign: &'ast syn::ExprAssign) {
            self.target(&assign.left);
            visit::visit_expr_assign(self, assign);
        }

        fn visit_item(&mut self, _: &'ast syn::Item) {}
    }

    let mut finder = Finder { deferred, found: Vec::new() };
    finder.visit_stmt(stmt);
    deferred.iter().filter(|variable| finder.found.contains(&variable.name)).cloned().collect()
}

/// The statement that stands for `expr`, which assigns to `assigned` for the first time, and the
/// variables that have a value after it.
fn first_assignment(
    expr: Expr,
    assigned: &[Deferred],
    carried: &[Ident],
) -> Option<(Stmt, Vec<Ident>)> {
    match expr {
        Expr::Assign(assign) => {
            let value = &assign.right;
            let holds_more = !self::assigned(&parse_quote!(#value;), assigned).is_empty();
            match strip_parens(&assign.left) {
                _ if holds_more => None,
                Expr::Path(_) => {
                    let variable = assigned.first()?;
                    Some((variable.declared(value), vec![variable.name.clone()]))
                }
                Expr::Tuple(tuple) => {
                    let part = |part: &Expr| match part {
                        Expr::Path(path) => {
                            let named = |v: &&Deferred| path.path.is_ident(&v.name);
                            let Deferred { name, mutability, .. } = assigned.iter().find(named)?;
                            Some(quote!(#mutability #name))
                        }
                        Expr::Infer(_) => Some(quote!(_)),
                        _ => None,
                    };
                    let parts: Option<Vec<_>> = tuple.elems.iter().map(part).collect();
                    let parts = parts?;
                    let names = assigned.iter().map(|variable| variable.name.clone());
                    Some((parse_quote!(let (#(#parts,)*) = #value;), names.collect()))
                }
                _ => None,
            }
        }
        Expr::If(mut branch) => {
            let mut then = arm(branch.then_branch.stmts.clone(), assigned, carried)?;
            let mut other = match &branch.else_branch {
                Some(_) => arm(as_statements(&otherwise(&branch)), assigned, carried)?,
                None => Arm { stmts: Vec::new(), declared: Some(Vec::new()) },
            };
            let names = in_all(&[&then, &other], assigned);
            then.end_with(&names);
            other.end_with(&names);
            let stmts = &then.stmts;
            branch.then_branch = parse_quote!({ #(#stmts)* });
            if branch.else_branch.is_some() {
                let stmts = &other.stmts;
                branch.else_branch = Some((Default::default(), parse_quote!({ #(#stmts)* })));
            }
            Some((ended(Expr::If(branch), &names), bare(&names)))
        }
        Expr::Match(mut branch) => {
            let bodies = branch.arms.iter();
            let arms: Option<Vec<_>> =
                bodies.map(|it| arm(as_statements(&it.body), assigned, carried)).collect();
            let mut arms = arms?;
            let names = in_all(&arms.iter().collect::<Vec<_>>(), assigned);
            for (arm, rewritten) in branch.arms.iter_mut().zip(&mut arms) {
                rewritten.end_with(&names);
                let stmts = &rewritten.stmts;
                arm.body = parse_quote!({ #(#stmts)* });
                arm.comma = Some(Default::default());
            }
            Some((ended(Expr::Match(branch), &names), bare(&names)))
        }
        Expr::Block(mut block) if block.label.is_none() => {
            let mut inner = arm(block.block.stmts, assigned, carried)?;
            let names = in_all(&[&inner], assigned);
            inner.end_with(&names);
            let stmts = &inner.stmts;
            block.block = parse_quote!({ #(#stmts)* });
            Some((ended(Expr::Block(block), &names), bare(&names)))
        }
        Expr::Loop(mut a_loop) => {
            let names = bare(assigned);
            a_loop.body = body(a_loop.body, assigned, &names)?;
            let mut bare_breaks = BareBreaks::default();
            bare_breaks.visit_block(&a_loop.body);
            // One that leaves before, or by its label.
            if bare_breaks.found || a_loop.label.is_some() {
                return None;
            }
            Some((ended(Expr::Loop(a_loop), assigned), names))
        }
        // It may run no iteration, so that nothing after it reads what it assigns.
        Expr::ForLoop(mut a_loop) => {
            a_loop.body = body(a_loop.body, assigned, &[])?;
            Some((Stmt::Expr(Expr::ForLoop(a_loop), None), Vec::new()))
        }
        Expr::While(mut a_loop) => {
            a_loop.body = body(a_loop.body, assigned, &[])?;
            Some((Stmt::Expr(Expr::While(a_loop), None), Vec::new()))
        }
        _ => None,
    }
}

/// The body of a loop.
fn body(block: Block, assigned: &[Deferred], carried: &[Ident]) -> Option<Block> {
    let stmts = rewrite(block.stmts, &mut assigned.to_vec(), carried)?.stmts;
    Some(parse_quote!({ #(#stmts)* }))
}

/// An arm of a branch.
struct Arm {
    stmts: Vec<Stmt>,
    /// What has a value at its end; `None` if that is never reached.
    declared: Option<Vec<Ident>>,
}

fn arm(stmts: Vec<Stmt>, assigned: &[Deferred], carried: &[Ident]) -> Option<Arm> {
    let diverges = exits::diverges(&stmts);
    let Rewritten { stmts, declared } = rewrite(stmts, &mut assigned.to_vec(), carried)?;
    Some(Arm { stmts, declared: (!diverges).then_some(declared) })
}

/// The variables that have a value at the end of each arm.
fn in_all(arms: &[&Arm], assigned: &[Deferred]) -> Vec<Deferred> {
    let in_arm = |variable: &Deferred, arm: &Arm| match &arm.declared {
        Some(declared) => declared.contains(&variable.name),
        None => true,
    };
    let in_all = |variable: &&Deferred| arms.iter().all(|arm| in_arm(variable, arm));
    assigned.iter().filter(in_all).cloned().collect()
}

impl Arm {
    /// Gives the arm the value of these variables.
    fn end_with(&mut self, names: &[Deferred]) {
        if self.declared.is_none() || names.is_empty() {
            return;
        }
        if let Some(Stmt::Expr(_, semi @ None)) = self.stmts.last_mut() {
            *semi = Some(Default::default());
        }
        let value = together(&bare(names));
        self.stmts.push(Stmt::Expr(value, None));
    }
}

fn bare(variables: &[Deferred]) -> Vec<Ident> {
    variables.iter().map(|variable| variable.name.clone()).collect()
}

fn together(names: &[Ident]) -> Expr {
    match names {
        [name] => parse_quote!(#name),
        names => parse_quote!((#(#names,)*)),
    }
}

/// A statement that declares these variables by the value of `expr`, if there are any.
fn ended(expr: Expr, names: &[Deferred]) -> Stmt {
    match names {
        [] => Stmt::Expr(expr, Some(Default::default())),
        [variable] => variable.declared(&expr),
        variables => {
            let mutabilities = variables.iter().map(|variable| &variable.mutability);
            let names = bare(variables);
            parse_quote!(let (#(#mutabilities #names,)*) = #expr;)
        }
    }
}

/// Gives the jumps out of a loop the value of the variables that it declares.
struct Breaks<'a> {
    carried: &'a [Ident],
    depth: usize,
}

impl VisitMut for Breaks<'_> {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        let is_loop = matches!(expr, Expr::ForLoop(_) | Expr::While(_) | Expr::Loop(_));
        self.depth += usize::from(is_loop);
        visit_mut::visit_expr_mut(self, expr);
        self.depth -= usize::from(is_loop);
        if let Expr::Break(jump) = expr
            && self.depth == 0
            && jump.label.is_none()
            && jump.expr.is_none()
        {
            jump.expr = Some(Box::new(together(self.carried)));
        }
    }

    // Jumps in closures and items are theirs.
    fn visit_expr_closure_mut(&mut self, _: &mut syn::ExprClosure) {}

    fn visit_item_mut(&mut self, _: &mut syn::Item) {}
}

/// Looks for jumps out of a loop without a value.
#[derive(Default)]
struct BareBreaks {
    found: bool,
    depth: usize,
}

impl<'ast> Visit<'ast> for BareBreaks {
    fn visit_expr(&mut self, expr: &'ast Expr) {
        let is_loop = matches!(expr, Expr::ForLoop(_) | Expr::While(_) | Expr::Loop(_));
        if let Expr::Break(jump) = expr {
            self.found |= self.depth == 0 && jump.expr.is_none();
        }
        self.depth += usize::from(is_loop);
        visit::visit_expr(self, expr);
        self.depth -= usize::from(is_loop);
    }

    fn visit_expr_closure(&mut self, _: &'ast syn::ExprClosure) {}

    fn visit_item(&mut self, _: &'ast syn::Item) {}
}
