//! Statements, and what becomes of early exits.
//!
//! An exit is the end of a block. What follows a statement that may exit moves into the arm that
//! does not (`if bad { return a; } rest` becomes `if bad { a } else { rest }`). Where several arms
//! go on, or a loop may exit, the statement becomes a `ControlFlow` (see [`ends`]),
//! and the rest the `Continue` arm of a match on it. `e?` becomes a match on `e`.

pub mod branch;
pub mod checkpoint;
pub mod ends;
pub mod loops;
pub mod nested;
pub mod temporaries;

use quote::quote_spanned;
use syn::spanned::Spanned;
use syn::visit::Visit;
use syn::{Expr, Local, Pat, Stmt, parse_quote};

use self::ends::End;
use self::loops::LoopResult;
use super::expression::operator::is_own_type;
use super::expression::sequence;
use super::iterate::chain::array_length;
use super::rewrite::exits::Exit;
use super::rewrite::{chains, deferred, desugar, exits, told};
use super::state::{Alias, JumpKind};
use super::syntax::{
    as_statements, is_plain_name, macro_diverges, simple_name, split_type, strip_parens,
};
use super::{Lowerer, OnFailure};
use crate::ir::{Operand, Operation, Statement, Target, VarId};
use crate::types;

impl Lowerer<'_> {
    pub(super) fn function_body(&mut self, stmts: Vec<Stmt>) -> Operand {
        let stmts = sequence::exits_apart(stmts, self.names);
        self.jump(JumpKind::Function, None, |lowerer, id| {
            let end = End { here: vec![Target::Leave(id)], ..End::default() };
            lowerer.statements(stmts, &end)
        })
    }

    /// The value of a block without exits.
    pub(super) fn block_value(&mut self, stmts: &[Stmt]) -> Operand {
        self.nested(|lowerer| lowerer.statements(stmts.to_vec(), &End::default()))
    }

    pub(super) fn statements(&mut self, stmts: Vec<Stmt>, end: &End) -> Operand {
        let around = self.keeps_temporaries;
        let value = self.statement_by_statement(stmts, end);
        self.keeps_temporaries = around;
        value
    }

    fn statement_by_statement(&mut self, stmts: Vec<Stmt>, end: &End) -> Operand {
        let mut stmts = stmts.into_iter();
        while let Some(stmt) = stmts.next() {
            if let Some(names) = deferred::declared(&stmt) {
                let all: Vec<_> = std::iter::once(stmt.clone()).chain(stmts.clone()).collect();
                if let Some(initialised) = deferred::initialised(all) {
                    return self.statements(initialised, end);
                }
                self.refuse(
                    stmt,
                    "what gives this variable its value is not seen from here: declare it with its value, `let r = if c { a } else { b };`",
                );
                names.iter().for_each(|name| {
                    self.bind(name, true, true);
                });
                continue;
            }
            if let Some(chosen) = desugar::chosen_reference(&stmt, stmts.as_slice()) {
                return self.statements(vec![chosen], end);
            }
            if let Some(inlined) = chains::inlined(&stmt, stmts.as_slice()) {
                return self.statements(inlined, end);
            }
            if let Some(stepped) = self.stepped(&stmt, stmts.as_slice()) {
                return self.statements(stepped, end);
            }
            let stmt = self.plainer_loop(&stmt).unwrap_or(stmt);
            // Those of the last expression end with the block.
            let is_last = match &stmt {
                Stmt::Expr(Expr::Return(_) | Expr::Break(_), _) => true,
                Stmt::Expr(_, None) => stmts.len() == 0,
                _ => false,
            };
            let matters = self.minds_temporaries(&stmt);
            self.keeps_temporaries = matters && is_last;
            if exits::stmt_exits(&stmt) {
                let stmt = if matters && !is_last { apart(stmt) } else { stmt };
                return self.exiting(stmt, stmts.collect(), end);
            }
            match stmt {
                // What follows is never reached.
                Stmt::Macro(call) if macro_diverges(&call.mac) => {
                    return self.macro_call(&call.mac, "value");
                }
                Stmt::Expr(Expr::Macro(call), _) if macro_diverges(&call.mac) => {
                    return self.macro_call(&call.mac, "value");
                }
                Stmt::Expr(expr, None) if stmts.len() == 0 => {
                    let value = self.operand(&expr, "value");
                    return self.normal_end(value, end);
                }
                Stmt::Macro(call) if call.semi_token.is_none() && stmts.len() == 0 => {
                    let value = self.macro_call(&call.mac, "value");
                    return self.normal_end(value, end);
                }
                Stmt::Local(local) => self.local(&local, Some(stmts.as_slice()), matters),
                stmt => {
                    self.until_its_end(matters, |lowerer| {
                        lowerer.statement(&stmt);
                        Self::unit()
                    });
                }
            }
        }
        self.normal_end(Self::unit(), end)
    }

    /// A statement without exits.
    pub(super) fn statement(&mut self, stmt: &Stmt) {
        match stmt {
            Stmt::Local(local) => self.local(local, None, false),
            Stmt::Item(item) => self.local_item(item),
            Stmt::Macro(call) => {
                self.macro_call(&call.mac, "value");
            }
            Stmt::Expr(expr, _) => self.expression_statement(expr),
        }
    }

    pub(super) fn expression_statement(&mut self, expr: &Expr) {
        match expr {
            Expr::Assign(assign) => self.assign(assign),
            Expr::Binary(binary) if exits::is_update(&binary.op) => self.update(binary),
            Expr::If(_) if let Some(block) = self.if_let_apart(expr) => {
                self.expression_statement(&block);
            }
            Expr::If(_) | Expr::Match(_) => {
                self.branch_statement(expr, &mut |lowerer, body| {
                    let value = lowerer.operand(body, "value");
                    lowerer.discard(value);
                    Self::unit()
                });
            }
            Expr::ForLoop(_) | Expr::While(_) | Expr::Loop(_) => {
                self.whole_loop(expr);
            }
            Expr::Block(block) => {
                let value = self.a_block(block, &End::default());
                self.discard(value);
            }
            Expr::MethodCall(call) if let Some(links) = self.links(call) => {
                self.called_in_turn(links);
            }
            _ => {
                let value = self.operand(expr, "value");
                self.discard(value);
            }
        }
    }

    /// A declaration, and the statements that follow it in its block, if these are known; its temporaries
    /// may matter.
    fn local(&mut self, local: &Local, following: Option<&[Stmt]>, matters: bool) {
        if self.constant_local(local) {
            return;
        }
        let Some(init) = &local.init else {
            unreachable!("is declared where it gets its value");
        };
        let (pat, ty) = split_type(&local.pat);
        if let (Some(name), Expr::Closure(closure)) = (simple_name(pat), strip_parens(&init.expr)) {
            return self.closure_local(name, closure);
        }
        if let (Pat::Ident(name), Expr::Path(function)) = (pat, strip_parens(&init.expr))
            && is_plain_name(name)
            && self.is_named_function(function)
        {
            return self.function_local(&name.ident, function);
        }
        if let (Some(name), Some(place)) = (simple_name(pat), self.behind_exclusive(&init.expr)) {
            self.exclusive_alias(name, &place);
            if ty.is_some_and(|ty| is_own_type(ty, &self.scalars))
                && let Some(var) = self.lookup(name)
            {
                self.own.insert(var);
            }
            return;
        }
        if self.split_exclusively(pat, &init.expr) || self.take_apart_exclusively(pat, &init.expr) {
            return;
        }
        if let (Pat::Ident(name), None, Expr::Reference(reference)) = (pat, ty, &*init.expr)
            && is_plain_name(name)
            && self.shared_alias(&name.ident, &reference.expr)
        {
            return;
        }
        if let (Pat::Ident(name), None) = (pat, ty)
            && is_plain_name(name)
            && let Some(element) = self.shared_element(&init.expr)
        {
            self.alias_place(&name.ident, Alias::shared(element));
            return;
        }
        if ty.is_some_and(types::is_discrete) {
            return self.discrete_local(pat, ty, &init.expr, matters);
        }
        if !matters && self.take_apart(pat, ty, &init.expr) {
            return;
        }
        let hint = match pat {
            Pat::Ident(pat) => pat.ident.to_string(),
            _ => "value".to_owned(),
        };
        let (container, length) = (self.container(&init.expr), array_length(&init.expr));
        let is_own = self.is_borrowed_or_own(&init.expr);
        let has_own_methods = self.calls_own_methods(&init.expr);
        let told = ty.map(|ty| {
            let mut expr = (*init.expr).clone();
            told::tell_local(&mut expr, ty);
            expr
        });
        let value = told.as_ref().unwrap_or(&init.expr);
        let value = match matters {
            true => self.until_its_end(true, |lowerer| lowerer.operand(value, &hint)),
            false => self.operand(value, &hint),
        };
        if let (Pat::Ident(name), Operand::Constant(_), Some(following)) = (pat, &value, following)
            && name.mutability.is_some()
            && self.stays_constant(&name.ident, following)
        {
            let var = self.bind(&name.ident, true, false);
            let (ty, operation) = (ty.cloned(), Operation::Use(value));
            self.push(Statement::Define { var, ty, operation });
        } else {
            self.bind_pattern(pat, ty, value);
        }
        self.note_movable(pat, ty, &init.expr);
        if let Some(var) = simple_name(pat).and_then(|name| self.lookup(name)) {
            if is_own {
                self.own.insert(var);
            }
            if has_own_methods {
                self.own_methods.insert(var);
            }
            self.containers.extend(container.map(|container| (var, container)));
            self.lengths.extend(length.map(|length| (var, length)));
        }
    }

    /// Lowers `stmt`, which may exit, and what follows it.
    fn exiting(&mut self, stmt: Stmt, rest: Vec<Stmt>, end: &End) -> Operand {
        match stmt {
            Stmt::Expr(jump @ (Expr::Return(_) | Expr::Break(_) | Expr::Continue(_)), _)
                if !carried(&jump).is_some_and(exits::expr_exits) =>
            {
                let exit = match &jump {
                    Expr::Break(jump) => Exit::Break(jump.label.clone()),
                    Expr::Continue(jump) => Exit::Continue(jump.label.clone()),
                    _ => Exit::Return,
                };
                let value = match carried(&jump) {
                    Some(expr) => self.operand(expr, "value"),
                    None => Self::unit(),
                };
                match self.led_to(&exit) {
                    Some(target) => self.exit(target, value, end),
                    None => self.refuse(jump, "there is nothing here that this could leave"),
                }
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
            // The value comes first, whatever stands to its left.
            Stmt::Expr(Expr::Assign(syn::ExprAssign { left, right, .. }), _)
                if exits::assigns_within(&right) =>
            {
                let name = self.names.unwritten("assigned");
                let mut following =
                    vec![parse_quote!(let #name = #right;), parse_quote!(#left = #name;)];
                following.extend(rest);
                self.statements(following, end)
            }
            mut stmt => {
                let expr = match &mut stmt {
                    Stmt::Local(Local { init: Some(init), .. }) => Some(&mut *init.expr),
                    Stmt::Expr(expr, _) => Some(expr),
                    _ => None,
                };
                if let Some(expr) = &expr
                    && exits::assigns_within(expr)
                {
                    return self.refuse(
                        expr,
                        "an early exit and an assignment within one expression are not supported: bind their parts to variables with `let` first",
                    );
                }
                match expr.and_then(|expr| exits::hoist(expr, self.names)) {
                    Some(hoisted) => {
                        let mut following = vec![stmt];
                        following.extend(rest);
                        self.hoisted(hoisted, following, end)
                    }
                    None => self.refuse(
                        stmt,
                        "an exit from here cannot be differentiated: bind the value to a variable with `let` first",
                    ),
                }
            }
        }
    }

    /// Binds the name of a part, which may exit or stands before what may, and goes on with `rest`.
    fn hoisted(&mut self, hoisted: exits::Hoisted, rest: Vec<Stmt>, end: &End) -> Operand {
        let exits::Hoisted { name, mut part, called_on } = hoisted;
        let called_on = called_on.and_then(|name| self.lookup(&name));
        if !exits::expr_exits(&part) {
            self.as_argument(called_on, &parse_quote!(let #name = #part;));
            return self.statements(rest, end);
        }
        if let (Expr::Try(attempt), Some(_)) = (&mut part, called_on) {
            let (value, attempted) = (&attempt.expr, self.names.unwritten("attempted"));
            self.as_argument(called_on, &parse_quote!(let #attempted = #value;));
            attempt.expr = parse_quote!(#attempted);
        }
        let Expr::Try(attempt) = part else {
            return self.control(&part, Some(&parse_quote!(#name)), rest, end, false);
        };
        let value = desugar::scrutinee(&attempt.expr);
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
            OnFailure::ByType => {
                let failure = self.names.unwritten("failure");
                let span = attempt.question_token.span();
                let failed = quote_spanned!(span=> ::ad::rules::attempt::failed(#failure));
                parse_quote!(match ::ad::rules::attempt::split(#value) {
                    ::core::result::Result::Ok(#name) => {}
                    ::core::result::Result::Err(#failure) => return #failed,
                })
            }
        };
        self.match_else(&attempt, rest, end)
    }

    /// A statement that evaluates an argument of a method which is called on a variable.
    fn as_argument(&mut self, called_on: Option<VarId>, statement: &Stmt) {
        let around = self.called_on.len();
        self.called_on.extend(called_on);
        self.statement(statement);
        self.called_on.truncate(around);
    }

    /// `let pat = expr else { otherwise }; rest`
    fn let_else(
        &mut self,
        pat: &Pat,
        expr: &Expr,
        otherwise: &Expr,
        rest: Vec<Stmt>,
        end: &End,
    ) -> Operand {
        let mut bound = desugar::Bound::default();
        bound.visit_pat(pat);
        let (names, mutabilities) = (&bound.names, &bound.mutabilities);
        let expr = desugar::scrutinee(expr);
        if desugar::alternatives(pat).len() > 1 {
            let mut following = vec![parse_quote! {
                let (#(#mutabilities #names,)*) =
                    match #expr { #pat => (#(#names,)*), _ => #otherwise };
            }];
            following.extend(rest);
            return self.statements(following, end);
        }
        let matched = parse_quote!(match #expr { #pat => {} _ => #otherwise });
        self.match_else(&matched, rest, end)
    }

    /// A `match` of which the arm with an empty block goes on with `rest`.
    fn match_else(&mut self, matched: &Expr, rest: Vec<Stmt>, end: &End) -> Operand {
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
        end: &End,
        is_value: bool,
    ) -> Operand {
        // A condition that may exit is evaluated before.
        let mut expr = expr.clone();
        if let Expr::If(syn::ExprIf { cond, .. }) | Expr::Match(syn::ExprMatch { expr: cond, .. }) =
            &mut expr
            && exits::expr_exits(cond)
        {
            let Some(hoisted) = exits::hoist(cond, self.names) else {
                return self.refuse(&*cond, "bind the condition to a variable with `let` first");
            };
            let following: Stmt = match pat {
                Some(pat) => parse_quote!(let #pat = #expr;),
                None if is_value => Stmt::Expr(expr, None),
                None => Stmt::Expr(expr, Some(Default::default())),
            };
            let mut stmts = vec![following];
            stmts.extend(rest);
            return self.hoisted(hoisted, stmts, end);
        }

        let expr = match self.if_let_apart(&expr) {
            Some(block) => block,
            None => desugar::branch(expr),
        };
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
                    lowerer.scopes.clear();
                    lowerer.bind_rest(pat, value);
                    lowerer.statements(rest.take().unwrap_or_default(), end)
                });
            }
        }

        let mut rest = Some(rest);
        let mut go_on = |lowerer: &mut Self, value: Operand| match is_value {
            true => lowerer.normal_end(value, end),
            false => {
                lowerer.bind_rest(pat, value);
                lowerer.statements(rest.take().unwrap_or_default(), end)
            }
        };
        match &expr {
            // Nothing follows a block that always jumps.
            Expr::Block(block) if is_value || exits::expr_diverges(&expr) => {
                return self.a_block(block, end);
            }
            Expr::If(_) | Expr::Match(_) | Expr::Block(_) => {}
            Expr::ForLoop(_) | Expr::While(_) | Expr::Loop(_) => {
                let LoopResult { fork, value, targets, own } = self.a_loop(&expr);
                return self.dispatch((fork, value), &targets, own, &mut go_on, end);
            }
            other => return self.refuse(other, "an exit from here cannot be differentiated"),
        }
        let exits = self.targets(&exits::exits(&expr));
        let within = self.within(exits, end);
        let flow = match &expr {
            Expr::Block(block) => self.a_block(block, &within),
            _ => self.branch_value(&expr, &mut |lowerer, body| {
                lowerer.scope(|lowerer| lowerer.statements(as_statements(body), &within))
            }),
        };
        self.go_on(flow, &within, end, go_on)
    }

    /// A block, whose labels may be left by `break`.
    pub(super) fn a_block(&mut self, block: &syn::ExprBlock, end: &End) -> Operand {
        let label = block.label.as_ref().map(|label| label.name.clone());
        let stmts = block.block.stmts.clone();
        self.jump(JumpKind::Block, label, |lowerer, id| {
            let mut end = end.clone();
            end.here.push(Target::Leave(id));
            lowerer.nested(|lowerer| lowerer.statements(stmts, &end))
        })
    }
}

/// A statement whose temporaries matter as one with a block for them.
fn apart(stmt: Stmt) -> Stmt {
    match stmt {
        Stmt::Local(mut local) => {
            if let Some(init) = &mut local.init {
                let value = &init.expr;
                init.expr = parse_quote!({ #value });
            }
            Stmt::Local(local)
        }
        Stmt::Expr(expr, semi) => Stmt::Expr(parse_quote!({ #expr }), semi),
        stmt => stmt,
    }
}

fn is_control(expr: &Expr) -> bool {
    matches!(
        expr,
        Expr::If(_)
            | Expr::Match(_)
            | Expr::Block(_)
            | Expr::ForLoop(_)
            | Expr::While(_)
            | Expr::Loop(_)
    )
}

/// The value that a jump takes along.
fn carried(jump: &Expr) -> Option<&Expr> {
    match jump {
        Expr::Return(jump) => jump.expr.as_deref(),
        Expr::Break(jump) => jump.expr.as_deref(),
        _ => None,
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
