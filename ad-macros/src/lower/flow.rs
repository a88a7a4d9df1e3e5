//! Statements, and what becomes of early exits.
//!
//! An exit is the end of a block. What follows a statement that may exit moves into the arm that
//! does not (`if bad { return a; } rest` becomes `if bad { a } else { rest }`). Where several arms
//! go on, or a loop may exit, the statement becomes a value of type `ControlFlow`, and the rest
//! the `Continue` arm of a match on it. `e?` becomes a match on `e`.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::visit::Visit;
use syn::{Expr, Lit, Local, Member, Pat, RangeLimits, Stmt, parse_quote};

use super::pattern::Matched;
use super::{Lowerer, OnFailure, desugar, exits};
use crate::ir::{
    Arm, Branch, BranchKind, Loop, Operand, Operation, Place, Projection, Shape, Statement, VarId,
};

/// What the end of a block means.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    /// The value of the block.
    Value,
    /// The value of the function.
    Function,
    /// A `ControlFlow`: `Continue` with the value of the block, or `Break` with that of the
    /// function.
    Flow,
}

impl Lowerer<'_> {
    pub(super) fn function_body(&mut self, stmts: &[Stmt]) -> Operand {
        self.statements(stmts.to_vec(), End::Function)
    }

    /// The value of a block without exits.
    pub(super) fn block_value(&mut self, stmts: &[Stmt]) -> Operand {
        self.scope(|lowerer| lowerer.statements(stmts.to_vec(), End::Value))
    }

    fn statements(&mut self, stmts: Vec<Stmt>, end: End) -> Operand {
        let mut stmts = stmts.into_iter();
        while let Some(stmt) = stmts.next() {
            if exits::stmt_exits(&stmt) {
                return self.exiting(stmt, stmts.collect(), end);
            }
            match stmt {
                Stmt::Expr(expr, None) if stmts.len() == 0 => {
                    let value = self.operand(&expr, "value");
                    return self.normal_end(value, end);
                }
                stmt => self.statement(&stmt),
            }
        }
        self.normal_end(Self::unit(), end)
    }

    fn normal_end(&mut self, value: Operand, end: End) -> Operand {
        match end {
            End::Value | End::Function => value,
            End::Flow => self.control_flow("Continue", "1", value),
        }
    }

    fn exit(&mut self, value: Operand, end: End) -> Operand {
        match end {
            End::Function => value,
            End::Flow => self.control_flow("Break", "0", value),
            End::Value => unreachable!("exits have been looked for"),
        }
    }

    fn control_flow(&mut self, variant: &str, member: &str, value: Operand) -> Operand {
        let variant = format_ident!("{variant}");
        let tokens = self.tokens(&value);
        let expression = quote!(::core::ops::ControlFlow::#variant(#tokens));
        let Operand::Var(var) = value else {
            return Operand::Constant(expression);
        };
        let member: Member = syn::parse_str(member).expect("a number");
        let span = self.ident(var).span();
        Operand::Var(self.define(
            "flow",
            span,
            true,
            Operation::Aggregate {
                expression,
                shape: Shape::Flow,
                parts: vec![(member, Operand::Var(var))],
            },
        ))
    }

    /// A statement without exits.
    fn statement(&mut self, stmt: &Stmt) {
        match stmt {
            Stmt::Local(local) => self.local(local),
            Stmt::Item(item) => {
                self.refuse(item, "move this item out of the differentiable function");
            }
            Stmt::Macro(call) => {
                self.refuse_macro(&call.mac);
            }
            Stmt::Expr(expr, _) => self.expression_statement(expr),
        }
    }

    pub(super) fn expression_statement(&mut self, expr: &Expr) {
        match expr {
            Expr::Assign(assign) => self.assign(assign),
            Expr::Binary(binary) if exits::is_update(&binary.op) => self.update(binary),
            Expr::If(_) | Expr::Match(_) => {
                self.branch_statement(expr, &mut |lowerer, body| {
                    lowerer.operand(body, "value");
                    Self::unit()
                });
            }
            Expr::ForLoop(for_loop) => {
                self.for_loop(for_loop, End::Value);
            }
            Expr::Block(block) if block.label.is_none() => {
                self.block_value(&block.block.stmts);
            }
            _ => {
                if let Operand::Constant(tokens) = self.operand(expr, "value") {
                    self.push(Statement::Plain {
                        code: quote!(let _ = #tokens;),
                        defines: Vec::new(),
                    });
                }
            }
        }
    }

    fn local(&mut self, local: &Local) {
        let Some(init) = &local.init else {
            self.refuse(local, "give the variable a value where it is declared");
            return;
        };
        let (pat, ty) = match &local.pat {
            Pat::Type(typed) => (&*typed.pat, Some(&*typed.ty)),
            pat => (pat, None),
        };
        if ty.is_some_and(crate::signature::is_discrete) {
            return self.discrete_local(pat, ty, &init.expr);
        }
        let hint = match pat {
            Pat::Ident(pat) => pat.ident.to_string(),
            _ => "value".to_owned(),
        };
        let value = self.operand(&init.expr, &hint);
        self.bind_pattern(pat, ty, value);
    }

    /// Lowers `stmt`, which may exit, and what follows it.
    fn exiting(&mut self, stmt: Stmt, rest: Vec<Stmt>, end: End) -> Operand {
        match stmt {
            Stmt::Expr(Expr::Return(exit), _)
                if !exit.expr.as_ref().is_some_and(|e| exits::expr_exits(e)) =>
            {
                let value = match &exit.expr {
                    Some(expr) => self.operand(expr, "value"),
                    None => Self::unit(),
                };
                self.exit(value, end)
            }
            Stmt::Expr(expr, semi) if is_control(&expr) => {
                let is_value = semi.is_none() && rest.is_empty();
                self.control(&expr, None, rest, end, is_value)
            }
            Stmt::Local(Local { pat, init: Some(init), .. })
                if init.diverge.is_none() && is_control(&init.expr) =>
            {
                self.control(&init.expr, Some(&pat), rest, end, false)
            }
            Stmt::Local(Local { pat, init: Some(init), .. }) if !exits::expr_exits(&init.expr) => {
                let (_, otherwise) = init.diverge.expect("nothing else exits");
                self.let_else(&pat, &init.expr, &otherwise, rest, end)
            }
            mut stmt => {
                let expr = match &mut stmt {
                    Stmt::Local(Local { init: Some(init), .. }) => Some(&mut *init.expr),
                    Stmt::Expr(expr, _) => Some(expr),
                    _ => None,
                };
                if let Some(expr @ (Expr::While(_) | Expr::Loop(_))) = &expr {
                    return self.refuse_expression(expr);
                }
                if let Some(expr) = &expr
                    && exits::assigns_within(expr)
                {
                    return self.refuse(
                        expr,
                        "an early exit and an assignment within one expression are not supported: bind their parts to variables with `let` first",
                    );
                }
                match expr.and_then(|expr| exits::hoist(expr, self.names)) {
                    Some((name, part)) => {
                        let mut following = vec![stmt];
                        following.extend(rest);
                        self.hoisted(name, part, following, end)
                    }
                    None => self.refuse(
                        stmt,
                        "an exit from here cannot be differentiated: bind the value to a variable with `let` first",
                    ),
                }
            }
        }
    }

    /// Binds `name` to `part`, which may exit, and goes on with `rest`.
    fn hoisted(&mut self, name: Ident, part: Expr, rest: Vec<Stmt>, end: End) -> Operand {
        let Expr::Try(attempt) = part else {
            return self.control(&part, Some(&parse_quote!(#name)), rest, end, false);
        };
        let value = &attempt.expr;
        let attempt = match self.on_failure {
            OnFailure::None => parse_quote!(match #value {
                ::core::option::Option::Some(#name) => {}
                ::core::option::Option::None => return ::core::option::Option::None,
            }),
            OnFailure::Err => {
                let error = self.names.unwritten("error");
                let span = attempt.question_token.span();
                let propagate = quote_spanned!(span=> ::ad::rt::propagate(#error));
                parse_quote!(match #value {
                    ::core::result::Result::Ok(#name) => {}
                    ::core::result::Result::Err(#error) => {
                        return ::core::result::Result::Err(#propagate);
                    }
                })
            }
            OnFailure::Unknown => {
                return self.refuse(
                    attempt.question_token,
                    "`?` is supported in functions that return an `Option` or a `Result`: use `match`",
                );
            }
        };
        self.match_else(&attempt, rest, end)
    }

    /// `let pat = expr else { otherwise }; rest`
    fn let_else(
        &mut self,
        pat: &Pat,
        expr: &Expr,
        otherwise: &Expr,
        rest: Vec<Stmt>,
        end: End,
    ) -> Operand {
        let mut bound = desugar::Bound::default();
        bound.visit_pat(pat);
        let (names, mutabilities) = (&bound.names, &bound.mutabilities);
        if desugar::alternatives(pat).len() > 1 {
            let value = parse_quote!(match #expr { #pat => (#(#names,)*), _ => #otherwise });
            let names = parse_quote!((#(#mutabilities #names,)*));
            return self.control(&value, Some(&names), rest, end, false);
        }
        let matched = parse_quote!(match #expr { #pat => {} _ => #otherwise });
        self.match_else(&matched, rest, end)
    }

    /// A `match` of which the arm with an empty block goes on with `rest`.
    fn match_else(&mut self, matched: &Expr, rest: Vec<Stmt>, end: End) -> Operand {
        let mut rest = Some(rest);
        self.branch_value(matched, &mut |lowerer, body| match body {
            Expr::Block(block) if block.block.stmts.is_empty() => {
                lowerer.statements(rest.take().unwrap_or_default(), end)
            }
            body => lowerer.statements(as_statements(body), end),
        })
    }

    /// Lowers `let pat = expr; rest`, where `expr` is a control structure that may exit. With
    /// `is_value`, the value of `expr` is that of the block.
    fn control(
        &mut self,
        expr: &Expr,
        pat: Option<&Pat>,
        rest: Vec<Stmt>,
        end: End,
        is_value: bool,
    ) -> Operand {
        // A condition that may exit is evaluated before.
        let mut expr = expr.clone();
        if let Expr::If(syn::ExprIf { cond, .. }) | Expr::Match(syn::ExprMatch { expr: cond, .. }) =
            &mut expr
            && exits::expr_exits(cond)
        {
            let Some((name, part)) = exits::hoist(cond, self.names) else {
                return self.refuse(&*cond, "bind the condition to a variable with `let` first");
            };
            let following: Stmt = match pat {
                Some(pat) => parse_quote!(let #pat = #expr;),
                None if is_value => Stmt::Expr(expr, None),
                None => Stmt::Expr(expr, Some(Default::default())),
            };
            let mut stmts = vec![following];
            stmts.extend(rest);
            return self.hoisted(name, part, stmts, end);
        }

        let expr = desugar::branch(expr);
        let is_branch = matches!(expr, Expr::If(_) | Expr::Match(_));
        if is_branch && (is_value || (pat.is_none() && rest.is_empty())) {
            return self.branch_value(&expr, &mut |lowerer, body| {
                lowerer.scope(|lowerer| lowerer.statements(as_statements(body), end))
            });
        }

        if is_branch {
            let bodies = arm_bodies(&expr);
            let going_on: Vec<_> = bodies.iter().filter(|b| !exits::expr_diverges(b)).collect();
            if going_on.len() <= 1 && going_on.iter().all(|body| !exits::expr_exits(body)) {
                let mut rest = Some(rest);
                return self.branch_value(&expr, &mut |lowerer, body| {
                    if exits::expr_diverges(body) {
                        return lowerer.scope(|l| l.statements(as_statements(body), end));
                    }
                    let value = lowerer.block_value(&as_statements(body));
                    // What follows does not see the names that the arm's pattern binds.
                    lowerer.scopes.last_mut().expect("the arm opened a scope").clear();
                    if let Some(pat) = pat {
                        let (pat, ty) = split_type(pat);
                        lowerer.bind_pattern(pat, ty, value);
                    }
                    lowerer.statements(rest.take().unwrap_or_default(), end)
                });
            }
        }

        let flow = match &expr {
            Expr::If(_) | Expr::Match(_) => self.branch_value(&expr, &mut |lowerer, body| {
                lowerer.scope(|lowerer| lowerer.statements(as_statements(body), End::Flow))
            }),
            Expr::Block(block) => {
                let stmts = block.block.stmts.clone();
                self.scope(|lowerer| lowerer.statements(stmts, End::Flow))
            }
            Expr::ForLoop(for_loop) => self.for_loop(for_loop, End::Flow),
            other => return self.refuse(other, "an exit from here cannot be differentiated"),
        };
        self.go_on(flow, pat, rest, end, expr.span())
    }

    /// Leaves with the content of a `Break`, or goes on with that of a `Continue`.
    fn go_on(
        &mut self,
        flow: Operand,
        pat: Option<&Pat>,
        rest: Vec<Stmt>,
        end: End,
        span: proc_macro2::Span,
    ) -> Operand {
        let flow = self.named(flow, "flow", span);
        let active = self.vars[flow].active;
        let content = |lowerer: &mut Self, member: &str| {
            let ident = lowerer.names.fresh("content", span);
            let var = lowerer.var(ident.clone(), false, active);
            let member: Member = syn::parse_str(member).expect("a number");
            let binding = crate::ir::Binding { var, path: vec![Projection::Field(member)] };
            (quote!(#ident), binding, var)
        };
        let use_of = |lowerer: &Self, var: VarId| match active {
            true => Operand::Var(var),
            false => {
                let ident = lowerer.ident(var);
                Operand::Constant(quote!(#ident))
            }
        };

        let mut left = None;
        let leave = self.block(|lowerer| {
            let (ident, binding, var) = content(lowerer, "0");
            left = Some((quote!(::core::ops::ControlFlow::Break(#ident)), binding));
            let value = use_of(lowerer, var);
            lowerer.exit(value, end)
        });
        let mut right = None;
        let stay = self.block(|lowerer| {
            let (ident, binding, var) = content(lowerer, "1");
            right = Some((quote!(::core::ops::ControlFlow::Continue(#ident)), binding));
            if let Some(pat) = pat {
                let (pat, ty) = split_type(pat);
                let value = use_of(lowerer, var);
                lowerer.bind_pattern(pat, ty, value);
            }
            lowerer.statements(rest, end)
        });
        let arms = [(left, leave), (right, stay)].map(|(pattern, body)| {
            let (pattern, binding) = pattern.expect("set by the block");
            Arm { pattern, guard: None, bindings: vec![binding], body }
        });

        let ident = self.ident(flow).clone();
        let source = active.then(|| Place { root: flow, path: Vec::new() });
        self.branch(BranchKind::Match(quote!(#ident), source), arms.into(), true, span)
    }

    fn for_loop(&mut self, expr: &syn::ExprForLoop, end: End) -> Operand {
        if let Some(label) = &expr.label {
            return self.refuse(label, "labels are not supported: a loop is left by `return` only");
        }
        let Expr::Range(range) = strip_parens(&expr.expr) else {
            return self.refuse(
                &expr.expr,
                "only loops over a range `a..b` or `a..=b` can be differentiated: loop over an index",
            );
        };
        let (Some(from), Some(to)) = (&range.start, &range.end) else {
            return self.refuse(range, "the range of a differentiable loop needs both ends");
        };
        let trip_count = literal_length(from, to, &range.limits);
        let limits = &range.limits;
        let (from, to) = (self.plain_constant(from), self.plain_constant(to));
        let iterator = quote!(#from #limits #to);

        let mut pattern = TokenStream::new();
        let mut defines = Vec::new();
        let body = self.block(|lowerer| {
            match &*expr.pat {
                Pat::Ident(pat) if pat.by_ref.is_none() && pat.mutability.is_none() => {
                    let var = lowerer.bind(&pat.ident, false, false);
                    let ident = lowerer.ident(var);
                    pattern = quote!(#ident);
                    defines.push(var);
                }
                Pat::Wild(_) => pattern = quote!(_),
                pat => {
                    lowerer.refuse(pat, "name the loop variable: `for i in a..b`");
                }
            }
            lowerer.statements(expr.body.stmts.clone(), end)
        });

        let span = expr.for_token.span;
        let record = self.names.fresh("tape", span);
        let exit = (end == End::Flow).then(|| {
            let ident = self.names.fresh("flow", span);
            self.var(ident, false, true)
        });
        self.push(Statement::Loop(Loop {
            pattern,
            defines,
            iterator,
            body,
            record,
            trip_count,
            exit,
        }));
        exit.map_or_else(Self::unit, Operand::Var)
    }

    /// An `if` or `match`; `lower_arm` gives the value of each arm's body.
    pub(super) fn branch_value(
        &mut self,
        expr: &Expr,
        lower_arm: &mut dyn FnMut(&mut Self, &Expr) -> Operand,
    ) -> Operand {
        let (kind, arms) = self.branch_arms(expr, lower_arm);
        self.branch(kind, arms, true, expr.span())
    }

    /// An `if` or `match` whose value nobody asks for.
    fn branch_statement(
        &mut self,
        expr: &Expr,
        lower_arm: &mut dyn FnMut(&mut Self, &Expr) -> Operand,
    ) {
        let (kind, arms) = self.branch_arms(expr, lower_arm);
        self.branch(kind, arms, false, expr.span());
    }

    fn branch(
        &mut self,
        kind: BranchKind,
        arms: Vec<Arm>,
        wants_value: bool,
        span: proc_macro2::Span,
    ) -> Operand {
        let record = self.names.fresh("path", span);
        let result = wants_value.then(|| {
            let active = arms.iter().any(|arm| matches!(arm.body.value, Operand::Var(_)));
            let ident = self.names.fresh("value", span);
            self.var(ident, false, active)
        });
        self.push(Statement::Branch(Branch { result, record, kind, arms }));
        match result {
            Some(var) if self.vars[var].active => Operand::Var(var),
            Some(var) => {
                let ident = self.ident(var);
                Operand::Constant(quote!(#ident))
            }
            None => Self::unit(),
        }
    }

    fn branch_arms(
        &mut self,
        expr: &Expr,
        lower_arm: &mut dyn FnMut(&mut Self, &Expr) -> Operand,
    ) -> (BranchKind, Vec<Arm>) {
        match &desugar::branch(expr.clone()) {
            Expr::If(branch) => {
                let then = &branch.then_branch;
                let then: Expr = parse_quote!(#then);
                let otherwise = desugar::otherwise(branch);
                if let Expr::Let(condition) = strip_parens(&branch.cond) {
                    let (pat, matched) = (&condition.pat, &condition.expr);
                    let as_match: Expr =
                        parse_quote!(match #matched { #pat => #then, _ => #otherwise });
                    return self.branch_arms(&as_match, lower_arm);
                }
                let condition = self.plain(&branch.cond);
                let arms = [then, otherwise].map(|body| Arm {
                    pattern: TokenStream::new(),
                    guard: None,
                    bindings: Vec::new(),
                    body: self.block(|lowerer| lower_arm(lowerer, &body)),
                });
                (BranchKind::If(condition), arms.into())
            }
            Expr::Match(branch) => {
                let (matched, source) = self.scrutinee(&branch.expr);
                let reference = match &source {
                    _ if matches!(*branch.expr, Expr::Reference(_)) => true,
                    Some(place) => place.path.is_empty() && self.vars[place.root].reference,
                    None => false,
                };
                let matched_value =
                    Matched { active: source.is_some(), refutable: true, reference };
                let arms = branch.arms.iter().map(|arm| {
                    let (pat, guard) = match &arm.pat {
                        Pat::Guard(guarded) => (&*guarded.pat, Some(&guarded.guard)),
                        pat => (pat, None),
                    };
                    let mut pattern = TokenStream::new();
                    let mut bindings = Vec::new();
                    let mut guard_tokens = None;
                    let body = self.block(|lowerer| {
                        (pattern, bindings) = lowerer.pattern(pat, matched_value);
                        guard_tokens = guard.map(|guard| lowerer.plain(guard));
                        lower_arm(lowerer, &arm.body)
                    });
                    Arm { pattern, guard: guard_tokens, bindings, body }
                });
                let arms = arms.collect();
                (BranchKind::Match(matched, source), arms)
            }
            other => unreachable!("not a branch: {}", quote!(#other)),
        }
    }
}

fn is_control(expr: &Expr) -> bool {
    matches!(expr, Expr::If(_) | Expr::Match(_) | Expr::Block(_) | Expr::ForLoop(_))
}

fn strip_parens(expr: &Expr) -> &Expr {
    match expr {
        Expr::Paren(paren) => strip_parens(&paren.expr),
        Expr::Group(group) => strip_parens(&group.expr),
        _ => expr,
    }
}

pub(super) fn split_type(pat: &Pat) -> (&Pat, Option<&syn::Type>) {
    match pat {
        Pat::Type(typed) => (&typed.pat, Some(&typed.ty)),
        pat => (pat, None),
    }
}

/// The statements of a block, or an expression as the only one.
fn as_statements(expr: &Expr) -> Vec<Stmt> {
    match expr {
        Expr::Block(block) if block.label.is_none() => block.block.stmts.clone(),
        expr => vec![Stmt::Expr(expr.clone(), None)],
    }
}

/// What the arms of an `if` or `match` evaluate to; a missing `else` is an empty block.
fn arm_bodies(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::If(branch) => {
            let then = &branch.then_branch;
            vec![parse_quote!(#then), desugar::otherwise(branch)]
        }
        Expr::Match(branch) => branch.arms.iter().map(|arm| (*arm.body).clone()).collect(),
        _ => Vec::new(),
    }
}

/// The length of a range between two literals.
fn literal_length(from: &Expr, to: &Expr, limits: &RangeLimits) -> Option<usize> {
    let literal = |expr: &Expr| match strip_parens(expr) {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(number) => number.base10_parse::<usize>().ok(),
            _ => None,
        },
        _ => None,
    };
    let (from, to) = (literal(from)?, literal(to)?);
    Some(match limits {
        RangeLimits::HalfOpen(_) => to.saturating_sub(from),
        RangeLimits::Closed(_) => (to + 1).saturating_sub(from),
    })
}
