//! Values without a name that have an effect when they are dropped: `x * guard().factor() * f(y)`.
//!
//! Rust drops such a value at the end of the statement, and lowering cuts statements into pieces. So
//! where something could notice that, the value gets a name, and the statement a block of its own: the
//! block ends as the statement does. The rules are those of the edition of 2024.

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, ExprIf, Label, Lifetime, Local, Stmt, UnOp, parse_quote};

use crate::floats;
use crate::ir::{Operand, Operation, Statement};
use crate::lower::call::callee::is_associated;
use crate::lower::call::macros::elements;
use crate::lower::iterate::chain::is_chain;
use crate::lower::rewrite::{desugar, exits};
use crate::lower::syntax::{is_type_name, strip_parens};
use crate::lower::{Lowerer, call};
use crate::rules;

impl Lowerer<'_> {
    /// Whether dropping a value without a name too early or too late could be noticed within a statement.
    pub fn minds_temporaries(&self, stmt: &Stmt) -> bool {
        match stmt {
            Stmt::Local(Local { init: Some(init), .. }) => match strip_parens(&init.expr) {
                Expr::Closure(_) => false,
                // Lives as long as the reference to it.
                Expr::Reference(reference) if self.is_temporary(&reference.expr) => false,
                value => self.temporaries_in(value).matter(),
            },
            Stmt::Expr(expr, _) => self.temporaries_in(expr).matter(),
            _ => false,
        }
    }

    /// Lowers a statement, in a block of its own if its temporaries matter.
    pub fn until_its_end(
        &mut self,
        matters: bool,
        lower: impl FnOnce(&mut Self) -> Operand,
    ) -> Operand {
        let around = std::mem::replace(&mut self.keeps_temporaries, matters);
        let value = match matters {
            true => self.nested(lower),
            false => lower(self),
        };
        self.keeps_temporaries = around;
        value
    }

    /// Gives a name to the value of `expr`, of which only a part or a reference is used.
    pub fn kept(&mut self, value: Operand, expr: &Expr) -> Operand {
        self.keep(&value, expr).unwrap_or(value)
    }

    /// The same; nothing if the value stays as it is.
    pub fn keep(&mut self, value: &Operand, expr: &Expr) -> Option<Operand> {
        let is_constant = matches!(value, Operand::Constant(_));
        if !self.keeps_temporaries || !is_constant || !self.is_temporary(expr) {
            return None;
        }
        let ident = self.names.fresh("temporary", expr.span());
        let var = self.var(ident, true, false);
        self.temporaries.insert(var);
        let operation = Operation::Use(value.clone());
        self.push(Statement::Define { var, ty: None, operation });
        Some(self.constant(var))
    }

    /// Whether an expression without derivative uses a part of a temporary that is to be kept.
    pub fn uses_kept(&self, expr: &Expr) -> bool {
        self.keeps_temporaries && self.temporaries_in(expr).made > 0
    }

    /// An `if let` whose temporaries matter, as a block: they live until its first branch ends, and not
    /// in the second.
    pub fn if_let_apart(&mut self, expr: &Expr) -> Option<Expr> {
        let Expr::If(branch) = expr else { return None };
        let conditions = desugar::conditions(&branch.cond);
        let mut finder = Finder { lowerer: self, made: 0, called: 0, is_apart: false };
        for condition in &conditions {
            if let Expr::Let(condition) = strip_parens(condition) {
                finder.visit_used(&condition.expr);
            }
        }
        if finder.made == 0 || finder.called + self.temporaries_in(expr).called == 0 {
            return None;
        }
        let ExprIf { then_branch: then, .. } = branch;
        let name = self.names.unwritten("chosen");
        let label = Lifetime::new(&format!("'{name}"), name.span());
        let mut then = then.clone();
        if !exits::diverges(&then.stmts) {
            let value = match then.stmts.pop() {
                Some(Stmt::Expr(value, None)) => value,
                last => {
                    then.stmts.extend(last);
                    parse_quote!(())
                }
            };
            let result = self.names.unwritten("value");
            then.stmts.push(parse_quote!(let #result = #value;));
            then.stmts.push(parse_quote!(break #label #result;));
        }
        let chosen = desugar::nested(&branch.cond, parse_quote!(#then), &parse_quote!({}));
        let otherwise = desugar::otherwise(branch);
        let label = Label { name: label, colon_token: Default::default() };
        Some(parse_quote!(#label { #chosen; #otherwise }))
    }

    fn temporaries_in(&self, expr: &Expr) -> Finder<'_, '_> {
        let mut finder = Finder { lowerer: self, made: 0, called: 0, is_apart: false };
        finder.visit_expr(expr);
        finder
    }

    /// Whether an expression makes a value without derivative, of which it is not known that its end has
    /// no effect.
    fn is_temporary(&self, expr: &Expr) -> bool {
        self.may_end(expr) && !self.mentions_active(expr)
    }

    fn may_end(&self, expr: &Expr) -> bool {
        match strip_parens(expr) {
            Expr::Call(call) => match &*call.func {
                Expr::Path(function) if is_associated(function) => {
                    let owner = function.path.segments.iter().rev().nth(1);
                    owner.is_none_or(|owner| self.may_end_as(&owner.ident))
                        || call.args.iter().any(|part| self.may_end(part))
                }
                Expr::Path(function) => {
                    let last = function.path.segments.last();
                    let is_constructor = last.is_some_and(|last| is_type_name(&last.ident));
                    !is_constructor || call.args.iter().any(|part| self.may_end(part))
                }
                _ => true,
            },
            Expr::MethodCall(call) => match &*call.method.to_string() {
                name if floats::takes_number(name) || call::is_predicate(name) => false,
                // An iterator ends with what it runs over, but `drain` takes out what is left.
                name if name != "drain" && is_chain(expr) => self.may_end(&call.receiver),
                name => !rules::is_method(name) || self.may_end(&call.receiver),
            },
            Expr::Try(attempt) => self.may_end(&attempt.expr),
            Expr::Tuple(tuple) => tuple.elems.iter().any(|part| self.may_end(part)),
            Expr::Array(array) => array.elems.iter().any(|part| self.may_end(part)),
            Expr::Struct(_) | Expr::If(_) | Expr::Match(_) | Expr::Block(_) => true,
            _ => false,
        }
    }
}

/// Looks for temporaries, and for calls that could notice when they are dropped.
struct Finder<'l, 'a> {
    lowerer: &'l Lowerer<'a>,
    /// How many temporaries end with what is searched.
    made: usize,
    /// How many calls there are that do not belong to a temporary.
    called: usize,
    /// Whether the temporaries of what is visited end with it.
    is_apart: bool,
}

impl Finder<'_, '_> {
    fn matter(&self) -> bool {
        self.made > 0 && self.made + self.called > 1
    }

    /// A value of which a part or a reference is used.
    fn visit_used(&mut self, value: &Expr) {
        let value = strip_parens(value);
        if !self.lowerer.is_temporary(value) {
            return self.visit_expr(value);
        }
        match value {
            // What is handed on was counted where it was made.
            Expr::MethodCall(call) if rules::is_method(&call.method.to_string()) => {
                return self.visit_expr(value);
            }
            Expr::Call(call) => call.args.iter().for_each(|part| self.visit_expr(part)),
            Expr::MethodCall(call) => {
                self.visit_used(&call.receiver);
                call.args.iter().for_each(|part| self.visit_expr(part));
            }
            value => visit::visit_expr(self, value),
        }
        match self.is_apart {
            true => self.called += 1,
            false => self.made += 1,
        }
    }

    fn visit_apart(&mut self, visit: impl FnOnce(&mut Self)) {
        let was_apart = std::mem::replace(&mut self.is_apart, true);
        visit(self);
        self.is_apart = was_apart;
    }

    /// Whether a value is reached through a temporary.
    fn is_reached(&self, value: &Expr) -> bool {
        let value = strip_parens(value);
        self.lowerer.is_temporary(value)
            || match value {
                Expr::MethodCall(call) => self.is_reached(&call.receiver),
                Expr::Field(field) => self.is_reached(&field.base),
                Expr::Index(index) => self.is_reached(&index.expr),
                Expr::Unary(unary) => self.is_reached(&unary.expr),
                Expr::Reference(reference) => self.is_reached(&reference.expr),
                _ => false,
            }
    }
}

impl<'ast> Visit<'ast> for Finder<'_, '_> {
    fn visit_expr(&mut self, expr: &'ast Expr) {
        match expr {
            Expr::MethodCall(call) => {
                let name = call.method.to_string();
                match floats::takes_number(&name) {
                    true => self.visit_expr(&call.receiver),
                    false => self.visit_used(&call.receiver),
                }
                call.args.iter().for_each(|argument| self.visit_expr(argument));
                let is_known = rules::is_method(&name) || call::is_predicate(&name);
                self.called += usize::from(!is_known && !self.is_reached(&call.receiver));
            }
            Expr::Call(call) => {
                call.args.iter().for_each(|argument| self.visit_expr(argument));
                let is_constructor = matches!(&*call.func, Expr::Path(function)
                    if function.path.segments.last().is_some_and(|last| is_type_name(&last.ident)));
                let is_given = call.args.iter().any(|argument| {
                    matches!(argument, Expr::Reference(_)) && self.is_reached(argument)
                });
                self.called += usize::from(!is_constructor && !is_given);
            }
            Expr::Field(field) => self.visit_used(&field.base),
            Expr::Index(index) => {
                self.visit_used(&index.expr);
                self.visit_expr(&index.index);
            }
            Expr::Unary(unary) if matches!(unary.op, UnOp::Deref(_)) => {
                self.visit_used(&unary.expr);
            }
            Expr::Reference(reference) => self.visit_used(&reference.expr),
            Expr::Binary(binary) => match binary.op {
                BinOp::And(_) | BinOp::Or(_) => self.visit_apart(|finder| {
                    finder.visit_expr(&binary.left);
                    finder.visit_expr(&binary.right);
                }),
                BinOp::Eq(_)
                | BinOp::Ne(_)
                | BinOp::Lt(_)
                | BinOp::Le(_)
                | BinOp::Gt(_)
                | BinOp::Ge(_) => {
                    self.visit_used(&binary.left);
                    self.visit_used(&binary.right);
                }
                _ => visit::visit_expr(self, expr),
            },
            Expr::Match(branch) => {
                self.visit_used(&branch.expr);
                branch.arms.iter().for_each(|arm| self.visit_arm(arm));
            }
            Expr::If(_) | Expr::While(_) | Expr::Closure(_) => {
                self.visit_apart(|finder| visit::visit_expr(finder, expr));
            }
            Expr::Macro(call) => match elements(&call.mac) {
                Some(elements) => elements.iter().for_each(|element| self.visit_expr(element)),
                None => self.called += 1,
            },
            expr => visit::visit_expr(self, expr),
        }
    }

    fn visit_block(&mut self, block: &'ast syn::Block) {
        self.visit_apart(|finder| visit::visit_block(finder, block));
    }

    fn visit_item(&mut self, _: &'ast syn::Item) {}
}
