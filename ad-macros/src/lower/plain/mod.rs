//! Code through which no derivative flows: conditions, indices, range bounds. It stays as it is,
//! with variables renamed.

pub mod constancy;
pub mod effects;
pub mod hidden;
mod macros;
pub mod no_diff;

use std::collections::HashSet;

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote, quote_spanned};
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::visit_mut::{self, VisitMut};
use syn::{
    BinOp, Expr, ExprCall, ExprCast, ExprClosure, ExprMethodCall, ExprPath, Macro, Pat, Stmt,
    Token, UnOp, parse_quote, parse_quote_spanned,
};

use self::constancy::is_discrete_value;
use self::hidden::encodes;
use self::no_diff::{stopped, undifferentiated, visit_arguments};
use super::Lowerer;
use super::expression::order::may_have_effect;
use super::rewrite::{desugar, exits};
use super::search::has;
use super::syntax::{is_type_name, is_unknown_macro, standard_macro};
use crate::ir::{Operand, VarId};
use crate::names::identifiers;
use crate::types::{is_discrete, is_float};

impl Lowerer<'_> {
    /// The expression with variables renamed. The caller knows that what it is used for has no
    /// derivative (a condition, a comparison).
    pub(super) fn plain(&mut self, expr: &Expr) -> TokenStream {
        if self.changes(expr) || self.uses_kept(expr) || self.calls_closure(expr, &may_have_effect)
        {
            return self.in_order(expr);
        }
        self.visited(expr, false, false)
    }

    fn visited(&mut self, expr: &Expr, is_conditional: bool, binds_carriers: bool) -> TokenStream {
        let (mut expr, outside) = (expr.clone(), self.scopes.count());
        let (closures, carriers, is_given) = (0, HashSet::new(), false);
        Plain {
            lowerer: self,
            is_conditional,
            closures,
            outside,
            carriers,
            is_given,
            binds_carriers,
        }
        .visit_expr_mut(&mut expr);
        expr.to_token_stream()
    }

    /// The same for a condition, whose temporaries end with it.
    pub(super) fn condition(&mut self, expr: &Expr) -> TokenStream {
        let matters = self.changes(expr) && self.minds_temporaries(&Stmt::Expr(expr.clone(), None));
        let condition =
            self.until_its_end(matters, |lowerer| Operand::Constant(lowerer.plain(expr)));
        self.without_derivative(&condition)
    }

    /// The same for what is not evaluated here, once, whatever comes: nothing is put before it.
    pub(super) fn plain_in_place(&mut self, expr: &Expr) -> TokenStream {
        self.visited(expr, true, false)
    }

    /// The same for a function that is given elements, through which a derivative may flow if it `carries`.
    pub(super) fn plain_of_elements(&mut self, function: &Expr, carries: bool) -> TokenStream {
        self.visited(function, true, carries)
    }

    /// Whether an expression is a place in a variable that may change and through which a derivative
    /// may flow.
    pub(super) fn can_change(&self, place: &Expr) -> bool {
        self.root_of(place).is_some_and(|root| self.vars[root].active && self.vars[root].mutable)
    }

    /// Whether a closure that has a name and such a body is called somewhere in an expression.
    pub(super) fn calls_closure(&self, expr: &Expr, is_such: &dyn Fn(&Expr) -> bool) -> bool {
        has(expr, |part| {
            let Expr::Call(call) = part else { return None };
            is_such(&self.named_closure(&call.func)?.body.body).then_some(true)
        })
    }

    /// As [`plain`](Self::plain), where the value is used: checked by its type to have no
    /// derivative.
    pub(super) fn plain_constant(&mut self, expr: &Expr) -> TokenStream {
        let tokens = self.plain(expr);
        if self.is_certainly_constant(expr) {
            return tokens;
        }
        quote_spanned!(expr.span()=> ::ad::rt::constant(#tokens))
    }

    /// An operation whose result never has a derivative: bit operations, tests.
    pub(super) fn discrete(&mut self, expr: &Expr) -> Operand {
        let tokens = self.plain_constant(expr);
        self.settled(expr, quote!((#tokens)))
    }

    /// A constant as an operand. One that reads a variable is evaluated here, before the other
    /// operands can change the variable.
    pub(super) fn settled(&mut self, expr: &Expr, tokens: TokenStream) -> Operand {
        if !self.reads_changeable(expr) {
            return Operand::Constant(tokens);
        }
        Operand::Constant(self.named_tokens("constant", expr.span(), tokens))
    }

    /// Whether an expression reads a variable that may be assigned to.
    pub(super) fn reads_changeable(&self, expr: &Expr) -> bool {
        self.names_variable(expr, |var| self.vars[var].mutable)
    }

    /// Whether an expression names a variable of a kind.
    pub(super) fn names_variable(&self, expr: &Expr, is_such: impl Fn(VarId) -> bool) -> bool {
        has(expr, |part| match part {
            Expr::Path(path) => self.variable(path).map(&is_such),
            _ => None,
        })
    }

    fn is_certainly_constant(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Lit(_) => true,
            Expr::Paren(inner) => self.is_certainly_constant(&inner.expr),
            Expr::Cast(cast) => self.is_certainly_constant(&cast.expr),
            Expr::Unary(unary) => self.is_certainly_constant(&unary.expr),
            Expr::Binary(binary) => {
                self.is_certainly_constant(&binary.left)
                    && self.is_certainly_constant(&binary.right)
            }
            Expr::Path(path) => match self.variable(path) {
                Some(var) => !self.vars[var].active,
                None => true,
            },
            Expr::Call(call) => undifferentiated(call).is_some() || stopped(call).is_some(),
            _ => false,
        }
    }

    pub(super) fn refuse_expression(&mut self, expr: &Expr) -> Operand {
        let message = match expr {
            Expr::Macro(call) => return self.refuse_macro(&call.mac),
            Expr::Closure(_) => return self.refuse_closure(expr),
            Expr::Return(_) | Expr::Try(_) | Expr::Break(_) | Expr::Continue(_) => {
                "an exit from within an expression is not supported here: bind the value to a variable with `let` first"
            }
            Expr::Async(_) | Expr::Await(_) => {
                "asynchronous code has no derivative: differentiate the computation apart from waiting for its input"
            }
            Expr::Unsafe(_) | Expr::RawAddr(_) => {
                "`unsafe` code cannot be differentiated: wrap it in a safe function with a derivative of its own"
            }
            Expr::Let(_) => {
                "`let` is not supported in this condition: use it in the condition of an `if`"
            }
            Expr::Const(_) => "move the constant out of the differentiable function",
            _ => "this expression cannot be differentiated: compute it outside and pass the value",
        };
        self.refuse(expr, message)
    }
}

/// Looks for what may have a derivative.
struct CarrierFinder<'p, 'l, 'a> {
    plain: &'p Plain<'l, 'a>,
    /// Whether parts with the look of integers count, too.
    with_discrete: bool,
    found: bool,
}

impl<'ast> Visit<'ast> for CarrierFinder<'_, '_, '_> {
    fn visit_expr_path(&mut self, path: &'ast syn::ExprPath) {
        let var = self.plain.lowerer.variable(path);
        self.found |= var.is_some_and(|var| self.plain.is_carrier(var));
    }

    fn visit_expr(&mut self, expr: &'ast Expr) {
        let is_stopped = matches!(expr, Expr::Call(call)
            if stopped(call).is_some() || undifferentiated(call).is_some());
        if !is_stopped && (self.with_discrete || !is_discrete_value(expr)) {
            visit::visit_expr(self, expr);
        }
    }

    fn visit_macro(&mut self, call: &'ast Macro) {
        for name in identifiers(call.tokens.clone()) {
            let var = self.plain.lowerer.lookup(&name);
            self.found |= var.is_some_and(|var| self.plain.is_carrier(var));
        }
    }
}

struct Plain<'l, 'a> {
    lowerer: &'l mut Lowerer<'a>,
    /// Whether the part being visited may not be evaluated, or more than once.
    is_conditional: bool,
    /// In how many closures it lies.
    closures: usize,
    /// The number of scopes around what is visited.
    outside: usize,
    /// The names bound within it to what may have a derivative.
    carriers: HashSet<VarId>,
    /// Whether the call of which a part is visited is given what may have a derivative: a constant that it changed could
    /// keep it.
    is_given: bool,
    /// Whether the parameters of closures may have a derivative.
    binds_carriers: bool,
}

impl Plain<'_, '_> {
    /// The receiver of a method. One that takes `&mut self` would change a variable behind the reverse
    /// sweep's back; through a shared reference it does not compile.
    fn visit_receiver(&mut self, receiver: &mut Expr) {
        let way_out = if self.lowerer.can_change(receiver) {
            Some("BindTheCallWithLetBefore")
        } else if self.is_given && self.may_change_constant(receiver) {
            Some("PassItStopGradientOfTheNumber")
        } else {
            None
        };
        self.visit_place(receiver);
        if let Some(way_out) = way_out {
            let span = receiver.span();
            let way_out = Ident::new(way_out, span);
            *receiver = match self.closures {
                0 => parse_quote_spanned!(span=> (*::ad::rt::#way_out(&#receiver))),
                // What a closure returns may refer to the receiver.
                _ => parse_quote_spanned!(span=> (*&#receiver)),
            };
        }
    }

    /// Whether a variable may have a derivative.
    fn is_carrier(&self, var: VarId) -> bool {
        self.lowerer.vars[var].active || self.carriers.contains(&var)
    }

    /// Whether an expression may have a derivative, or something in it.
    fn carries(&self, expr: &Expr) -> bool {
        self.finds(expr, false)
    }

    fn finds(&self, expr: &Expr, with_discrete: bool) -> bool {
        let mut finder = CarrierFinder { plain: self, with_discrete, found: false };
        finder.visit_expr(expr);
        finder.found
    }

    /// Gives generated names to what a pattern binds to this value.
    fn bind_to(&mut self, pat: &mut Pat, carries: bool) {
        let before = self.lowerer.vars.len();
        self.rename_bound(pat);
        if carries {
            self.carriers.extend(before..self.lowerer.vars.len());
        }
    }

    /// An argument of a call, which may keep what it is given in a `&mut` that is passed by its name, or in another
    /// constant if it changes one.
    fn visit_argument(&mut self, argument: &mut Expr, is_given: bool, may_keep: bool) {
        let is_name = matches!(argument, Expr::Path(_));
        // What has the look of an integer may be none.
        let is_checked = may_keep && self.finds(argument, true) && !self.carries(argument);
        self.visit_given(is_given && is_name, |plain| plain.visit_expr_mut(argument));
        if is_checked {
            *argument = parse_quote_spanned!(argument.span()=> ::ad::rt::constant(#argument));
        }
    }

    /// Whether a call may change a constant that it is given, or whose part it is.
    fn may_change_constant(&self, place: &Expr) -> bool {
        let root = self.lowerer.root_of(place);
        root.is_some_and(|root| self.lowerer.vars[root].mutable && !self.lowerer.vars[root].active)
    }

    /// Visits parts of a call that is given what may have a derivative, or is not.
    fn visit_given(&mut self, is_given: bool, visit: impl FnOnce(&mut Self)) {
        let was_given = std::mem::replace(&mut self.is_given, is_given);
        visit(self);
        self.is_given = was_given;
    }

    fn refuse_assignment(&mut self, expr: &Expr) {
        self.lowerer.refuse(
            expr,
            "an assignment is not supported in a condition or an index: put it before",
        );
    }

    /// What may not be evaluated, or more than once.
    fn visit_conditional(&mut self, visit: impl FnOnce(&mut Self)) {
        let was_conditional = std::mem::replace(&mut self.is_conditional, true);
        visit(self);
        self.is_conditional = was_conditional;
    }

    /// A place, of which a part is used.
    fn visit_place(&mut self, place: &mut Expr) {
        match place {
            Expr::Paren(inner) => self.visit_place(&mut inner.expr),
            Expr::Field(field) => self.visit_place(&mut field.base),
            Expr::Index(index) => {
                self.visit_place(&mut index.expr);
                self.visit_given(false, |plain| plain.visit_expr_mut(&mut index.index));
            }
            Expr::Unary(unary) if matches!(unary.op, UnOp::Deref(_)) => {
                self.visit_place(&mut unary.expr);
            }
            Expr::Path(path) => *place = self.renamed(path),
            // What a method lends is of its receiver.
            Expr::MethodCall(_) => self.visit_expr_mut(place),
            other => self.visit_given(false, |plain| plain.visit_expr_mut(other)),
        }
    }

    /// What a name stands for.
    fn renamed(&mut self, path: &syn::ExprPath) -> Expr {
        let Some(var) = self.lowerer.variable(path) else {
            self.lowerer.check_capital(path);
            return Expr::Path(path.clone());
        };
        if self.lowerer.closures.contains_key(&var) {
            self.lowerer.refuse(path, "bind the value of this closure to a variable with `let` before the condition or the index that uses it");
        }
        if self.lowerer.functions.contains_key(&var) {
            self.lowerer.refuse(path, "bind the value of the call that is given this function to a variable with `let` before the condition or the index that uses it");
        }
        self.lowerer.value_of(var, path.span())
    }

    /// Gives generated names to what a pattern binds.
    fn rename_bound(&mut self, pat: &mut Pat) {
        struct Binder<'l, 'a>(&'l mut Lowerer<'a>);

        impl VisitMut for Binder<'_, '_> {
            fn visit_pat_ident_mut(&mut self, pat: &mut syn::PatIdent) {
                // It hides what else has its name. In the alternatives of a pattern it stands several
                // times, and it may turn out to be the name of a constant.
                if !is_type_name(&pat.ident) {
                    let var = self.0.scopes.lookup_innermost(&pat.ident).unwrap_or_else(|| {
                        let var = self.0.unwritten_var(&pat.ident, false, false);
                        if let Some(ident) = self.0.names.in_pattern(&pat.ident) {
                            self.0.vars[var].ident = ident;
                        }
                        self.0.alias(&pat.ident, var);
                        var
                    });
                    pat.ident = self.0.ident(var).clone();
                }
                visit_mut::visit_pat_ident_mut(self, pat);
            }

            fn visit_field_pat_mut(&mut self, field: &mut syn::FieldPat) {
                field.colon_token.get_or_insert_with(Default::default);
                visit_mut::visit_field_pat_mut(self, field);
            }
        }

        Binder(self.lowerer).visit_pat_mut(pat);
    }

    /// A variable, as it is passed on: it may not be changed.
    fn passed_on(&mut self, path: &ExprPath) -> Expr {
        let value = self.renamed(path);
        let is_exclusive = self.lowerer.variable(path).is_some_and(|var| {
            let var = &self.lowerer.vars[var];
            var.exclusive && (var.active || self.is_given)
        });
        match is_exclusive {
            true => parse_quote_spanned!(path.span()=> (&*#value)),
            false => value,
        }
    }

    /// The arguments of a call that is given what may have a derivative if it `carries`, and that may keep it.
    fn visit_given_arguments(
        &mut self,
        arguments: &mut Punctuated<Expr, Token![,]>,
        carries: bool,
        may_keep: bool,
    ) {
        let bound = std::mem::replace(&mut self.binds_carriers, carries);
        for argument in arguments {
            self.visit_argument(argument, carries, may_keep);
        }
        self.binds_carriers = bound;
    }

    /// The value of a call of a closure that has a name.
    fn value_of_closure(&mut self, call: &ExprCall) -> Option<Expr> {
        if self.is_conditional {
            self.lowerer.refuse(
                call,
                "a closure is called here under a condition: bind its value to a variable with `let` before",
            );
            return None;
        }
        let value = self.lowerer.operand(&Expr::Call(call.clone()), "value");
        Some(Expr::Verbatim(self.lowerer.tokens(&value)))
    }
}

impl VisitMut for Plain<'_, '_> {
    fn visit_block_mut(&mut self, block: &mut syn::Block) {
        self.lowerer.scopes.open();
        for stmt in &mut block.stmts {
            match stmt {
                Stmt::Local(syn::Local { pat, init: Some(init), .. }) if init.diverge.is_none() => {
                    let carries = self.carries(&init.expr);
                    self.visit_expr_mut(&mut init.expr);
                    self.bind_to(pat, carries);
                }
                Stmt::Expr(expr, _) => self.visit_expr_mut(expr),
                stmt => {
                    self.lowerer.refuse(
                        &*stmt,
                        "this is not supported in a condition or an index: put it before",
                    );
                }
            }
        }
        self.lowerer.scopes.close();
    }

    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        match expr {
            Expr::Path(path) => *expr = self.passed_on(path),
            Expr::Field(_) | Expr::Index(_) => self.visit_place(expr),
            Expr::Unary(unary) if matches!(unary.op, UnOp::Deref(_)) => self.visit_place(expr),
            Expr::Reference(reference) if reference.mutability.is_none() => {
                self.visit_place(&mut reference.expr);
            }
            call if self.is_conditional && self.lowerer.is_change(call) => {
                self.lowerer.refuse(
                    &*call,
                    "this changes something under a condition: bind its value to a variable with `let` before",
                );
            }
            Expr::Call(call) if undifferentiated(call).is_some() => {
                if let Some(closure) = undifferentiated(call) {
                    let value = self.lowerer.no_diff(&call.func, closure);
                    *expr = parse_quote!(#value);
                }
            }
            Expr::Call(call) if let Some(path) = stopped(call) => {
                self.lowerer.check_stopped(path);
                visit_arguments(self, call);
            }
            Expr::MethodCall(_) => {
                self.lowerer.check_cells(expr, self.outside);
                visit_mut::visit_expr_mut(self, expr);
            }
            Expr::Cast(cast) => self.visit_expr_cast_mut(cast),
            Expr::Reference(reference) if reference.mutability.is_some() => {
                self.lowerer
                    .refuse(&*reference, "`&mut` is not supported in a condition or an index");
            }
            Expr::Closure(closure) if closure.asyncness.is_none() => {
                self.visit_expr_closure_mut(closure);
            }
            Expr::Assign(_) => self.refuse_assignment(expr),
            Expr::Binary(binary) if exits::is_update(&binary.op) => self.refuse_assignment(expr),
            Expr::Call(call) if self.lowerer.function_parameter(&call.func).is_some() => {
                visit_arguments(self, call);
                *expr = self.lowerer.plain_call_of_parameter(call);
            }
            Expr::Call(call) if self.lowerer.named_closure(&call.func).is_some() => {
                if let Some(value) = self.value_of_closure(call) {
                    *expr = value;
                }
            }
            Expr::Binary(binary) if matches!(binary.op, BinOp::And(_) | BinOp::Or(_)) => {
                self.visit_expr_mut(&mut binary.left);
                self.visit_conditional(|plain| plain.visit_expr_mut(&mut binary.right));
            }
            Expr::Macro(call) if standard_macro(&call.mac.path).as_deref() == Some("matches") => {
                self.visit_matches(&mut call.mac);
            }
            Expr::Macro(call) if is_unknown_macro(&call.mac) => {
                match self.visit_arguments_of_macro(&mut call.mac) {
                    Some(()) => {
                        *expr = parse_quote_spanned!(call.span()=> ::ad::rt::unchanging(|| #call));
                    }
                    None => {
                        self.lowerer.refuse_macro(&call.mac);
                    }
                }
            }
            Expr::Call(_) => {
                self.lowerer.check_cells(expr, self.outside);
                let carries = self.carries(expr);
                let Expr::Call(call) = expr else { unreachable!("a call stays one") };
                let may_keep = call.args.iter().any(|argument| self.may_change_constant(argument));
                self.visit_given(false, |plain| plain.visit_expr_mut(&mut call.func));
                self.visit_given_arguments(&mut call.args, carries, may_keep);
            }
            Expr::Lit(_)
            | Expr::Paren(_)
            | Expr::Unary(_)
            | Expr::Binary(_)
            | Expr::Range(_)
            | Expr::Tuple(_)
            | Expr::Array(_) => visit_mut::visit_expr_mut(self, expr),
            Expr::Block(block) if let Some(value) = desugar::only_value(&block.block) => {
                let mut value = value.clone();
                self.visit_expr_mut(&mut value);
                *expr = parse_quote!((#value));
            }
            Expr::Block(block) if block.label.is_none() => self.visit_block_mut(&mut block.block),
            Expr::If(branch) if !matches!(*branch.cond, Expr::Let(_)) => {
                self.visit_expr_mut(&mut branch.cond);
                self.visit_conditional(|plain| {
                    plain.visit_block_mut(&mut branch.then_branch);
                    if let Some((_, otherwise)) = &mut branch.else_branch {
                        plain.visit_expr_mut(otherwise);
                    }
                });
            }
            Expr::If(_) | Expr::Match(_) | Expr::Block(_) | Expr::Struct(_) | Expr::Repeat(_) => {
                self.lowerer.refuse(
                    &*expr,
                    "bind this to a variable with `let` before the condition or the index that uses it",
                );
            }
            other => {
                self.lowerer.refuse_expression(other);
            }
        }
    }

    fn visit_expr_method_call_mut(&mut self, call: &mut ExprMethodCall) {
        let constant = self.lowerer.is_certainly_constant(&call.receiver);
        let is_given = call.args.iter().any(|argument| self.carries(argument));
        let carries = is_given || self.carries(&call.receiver);
        let may_keep = self.may_change_constant(&call.receiver);
        self.visit_given(self.is_given || is_given, |plain| {
            plain.visit_receiver(&mut call.receiver);
        });
        if encodes(&call.method) && !constant {
            let (receiver, span) = (&call.receiver, call.receiver.span());
            call.receiver = parse_quote_spanned!(span=> ::ad::rt::constant(#receiver));
        }
        self.visit_given_arguments(&mut call.args, carries, may_keep);
    }

    fn visit_expr_cast_mut(&mut self, cast: &mut ExprCast) {
        let constant = self.lowerer.is_certainly_constant(&cast.expr);
        visit_mut::visit_expr_cast_mut(self, cast);
        if !constant && !is_float(&cast.ty) {
            let (inner, ty, span) = (&cast.expr, &cast.ty, cast.span());
            cast.expr = match is_discrete(ty) {
                true => parse_quote_spanned!(span=> ::ad::rt::constant(#inner)),
                false => parse_quote_spanned!(span=> ::ad::rules::castable::<_, #ty>(#inner)),
            };
        }
    }

    fn visit_expr_closure_mut(&mut self, closure: &mut ExprClosure) {
        // Its parameters hide what else has their names.
        self.lowerer.scopes.open();
        for input in &mut closure.inputs {
            self.bind_to(input, self.binds_carriers);
        }
        self.closures += 1;
        self.visit_conditional(|plain| plain.visit_expr_mut(&mut closure.body));
        self.closures -= 1;
        self.lowerer.scopes.close();
    }
}
