//! Finds early exits: `return`, `?`, `break`, `continue`.

use std::collections::HashSet;

use proc_macro2::Ident;
use quote::ToTokens;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::visit_mut::{self, VisitMut};
use syn::{Block, Expr, Label, Lifetime, Stmt, parse_quote, parse_quote_spanned};

use crate::floats;
use crate::lower::iterate::chain::is_chain;
use crate::lower::search::has;
use crate::lower::syntax::{calls, macro_diverges, makes_value, root_name, simple_path};
use crate::names::{Names, collect_variables};
use crate::rules;

/// A jump, as the user wrote it.
#[derive(Clone, PartialEq, Eq)]
pub enum Exit {
    /// `return`, `?`
    Return,
    /// `break`, with its label.
    Break(Option<Lifetime>),
    /// `continue`, with its label.
    Continue(Option<Lifetime>),
}

/// The jumps out of an expression.
pub fn exits(expr: &Expr) -> Vec<Exit> {
    let mut finder = Finder::default();
    finder.visit_expr(expr);
    finder.found
}

/// The jumps out of a block.
pub fn block_exits(block: &Block) -> Vec<Exit> {
    let mut finder = Finder::default();
    finder.visit_block(block);
    finder.found
}

/// Whether a statement ends more than itself: control may leave it, or it is a `let .. else`.
pub fn stmt_exits(stmt: &Stmt) -> bool {
    let mut finder = Finder::default();
    finder.visit_stmt(stmt);
    !finder.found.is_empty()
        || matches!(stmt, Stmt::Local(local)
        if local.init.as_ref().is_some_and(|init| init.diverge.is_some()))
}

/// Whether control may leave `expr` early.
pub fn expr_exits(expr: &Expr) -> bool {
    !exits(expr).is_empty()
}

/// Whether a part of `expr`, other than `expr` itself, is an assignment. An exit taken out of such
/// an expression could change places with it.
pub fn assigns_within(expr: &Expr) -> bool {
    has(expr, |part| match part {
        _ if std::ptr::eq(part, expr) => None,
        Expr::Assign(_) => Some(true),
        Expr::Binary(binary) if is_update(&binary.op) => Some(true),
        _ => None,
    })
}

/// The places that evaluating `expr` may change, other than as the receivers of methods.
pub fn changed_places(expr: &Expr) -> Vec<&Expr> {
    #[derive(Default)]
    struct Changes<'ast>(Vec<&'ast Expr>);

    impl<'ast> Visit<'ast> for Changes<'ast> {
        fn visit_expr(&mut self, expr: &'ast Expr) {
            self.0.extend(match expr {
                Expr::Assign(assign) => Some(&*assign.left),
                Expr::Binary(binary) if is_update(&binary.op) => Some(&*binary.left),
                Expr::Reference(reference) if reference.mutability.is_some() => {
                    Some(&*reference.expr)
                }
                _ => None,
            });
            visit::visit_expr(self, expr);
        }
    }

    let mut finder = Changes::default();
    finder.visit_expr(expr);
    finder.0
}

/// Whether evaluating an expression may change a variable.
pub fn may_change(expr: &Expr) -> bool {
    calls(expr) || !changed_places(expr).is_empty()
}

/// Whether evaluating `later` may change what `earlier` reads. Where that is a place which a method refers
/// to, only what is certain counts: for the rest the compiler sees to it.
fn changes(later: &Expr, earlier: &Expr, is_referred_to: bool) -> bool {
    struct Lent<'ast>(Vec<&'ast Ident>);

    impl<'ast> Visit<'ast> for Lent<'ast> {
        fn visit_expr(&mut self, expr: &'ast Expr) {
            match expr {
                Expr::Call(call) => self.0.extend(call.args.iter().filter_map(simple_path)),
                Expr::MethodCall(call) => {
                    self.0.extend(call.args.iter().filter_map(simple_path));
                    self.0.extend(root_name(&call.receiver));
                }
                _ => {}
            }
            visit::visit_expr(self, expr);
        }
    }

    if let Expr::Reference(_) | Expr::Closure(_) = earlier {
        return false;
    }
    let mut lent = Lent(changed_places(later).into_iter().filter_map(root_name).collect());
    if !is_referred_to && simple_path(earlier).is_none() {
        lent.visit_expr(later);
    }
    let mut read = HashSet::new();
    collect_variables(earlier.to_token_stream(), &mut read);
    lent.0.iter().any(|name| read.contains(&name.to_string()))
}

/// Whether the operator is a compound assignment.
pub fn is_update(operator: &syn::BinOp) -> bool {
    use syn::BinOp::*;
    matches!(
        operator,
        AddAssign(_)
            | SubAssign(_)
            | MulAssign(_)
            | DivAssign(_)
            | RemAssign(_)
            | BitXorAssign(_)
            | BitAndAssign(_)
            | BitOrAssign(_)
            | ShlAssign(_)
            | ShrAssign(_)
    )
}

#[derive(Default)]
struct Finder<'ast> {
    found: Vec<Exit>,
    /// The number of loops around the expression visited, within that searched.
    loops: usize,
    /// The labels in scope there.
    labels: Vec<&'ast Lifetime>,
}

impl<'ast> Finder<'ast> {
    fn add(&mut self, exit: Exit) {
        if !self.found.contains(&exit) {
            self.found.push(exit);
        }
    }

    /// Whether a `break` or `continue` leaves what is searched.
    fn leaves(&self, label: Option<&Lifetime>) -> bool {
        match label {
            Some(label) => !self.labels.contains(&label),
            None => self.loops == 0,
        }
    }

    fn labelled(&mut self, label: Option<&'ast Label>, loops: usize, body: &'ast Block) {
        self.labels.extend(label.map(|label| &label.name));
        self.loops += loops;
        self.visit_block(body);
        self.loops -= loops;
        if label.is_some() {
            self.labels.pop();
        }
    }
}

impl<'ast> Visit<'ast> for Finder<'ast> {
    fn visit_expr(&mut self, expr: &'ast Expr) {
        match expr {
            Expr::Return(_) | Expr::Try(_) => {
                self.add(Exit::Return);
                visit::visit_expr(self, expr);
            }
            Expr::Break(jump) => {
                if self.leaves(jump.label.as_ref()) {
                    self.add(Exit::Break(jump.label.clone()));
                }
                visit::visit_expr(self, expr);
            }
            Expr::Continue(jump) => {
                if self.leaves(jump.label.as_ref()) {
                    self.add(Exit::Continue(jump.label.clone()));
                }
            }
            Expr::ForLoop(a_loop) => {
                self.visit_expr(&a_loop.expr);
                self.labelled(a_loop.label.as_ref(), 1, &a_loop.body);
            }
            Expr::While(a_loop) => {
                self.visit_expr(&a_loop.cond);
                self.labelled(a_loop.label.as_ref(), 1, &a_loop.body);
            }
            Expr::Loop(a_loop) => self.labelled(a_loop.label.as_ref(), 1, &a_loop.body),
            Expr::Block(block) => self.labelled(block.label.as_ref(), 0, &block.block),
            Expr::Closure(_) | Expr::Async(_) => {}
            _ => visit::visit_expr(self, expr),
        }
    }

    fn visit_item(&mut self, _: &'ast syn::Item) {}
}

/// Whether the end of the block is never reached.
pub fn diverges(stmts: &[Stmt]) -> bool {
    match stmts.last() {
        Some(Stmt::Expr(expr, _)) => expr_diverges(expr),
        Some(Stmt::Macro(call)) => macro_diverges(&call.mac),
        _ => false,
    }
}

/// Whether the expression never has a value.
pub fn expr_diverges(expr: &Expr) -> bool {
    let block_diverges = |block: &Block| diverges(&block.stmts);
    match expr {
        Expr::Return(_) | Expr::Break(_) | Expr::Continue(_) => true,
        Expr::Macro(call) => macro_diverges(&call.mac),
        Expr::Loop(a_loop) => {
            let breaks = |exit: &Exit| match exit {
                Exit::Break(None) => true,
                Exit::Break(label) => *label == a_loop.label.as_ref().map(|l| l.name.clone()),
                _ => false,
            };
            !block_exits(&a_loop.body).iter().any(breaks)
        }
        Expr::Paren(inner) => expr_diverges(&inner.expr),
        Expr::Block(block) if block.label.is_none() => block_diverges(&block.block),
        Expr::If(branch) => {
            block_diverges(&branch.then_branch)
                && branch.else_branch.as_ref().is_some_and(|(_, other)| expr_diverges(other))
        }
        Expr::Match(branch) => branch.arms.iter().all(|arm| expr_diverges(&arm.body)),
        _ => false,
    }
}

/// A part of an expression that is evaluated before the rest.
pub struct Hoisted {
    pub name: Ident,
    pub part: Expr,
    /// The variable that a method is called on to which the part belongs as an argument.
    pub called_on: Option<Ident>,
}

impl Hoisted {
    /// The part, whose methods see of what it is an argument for a reference, which none of them changes.
    pub fn into_argument(self) -> Expr {
        struct Shared(Ident);

        impl VisitMut for Shared {
            fn visit_expr_method_call_mut(&mut self, call: &mut syn::ExprMethodCall) {
                if root_name(&call.receiver) == Some(&self.0) {
                    let receiver = &call.receiver;
                    let span = receiver.span();
                    call.receiver = parse_quote_spanned!(span=> (&#receiver));
                }
                visit_mut::visit_expr_method_call_mut(self, call);
            }
        }

        let Self { mut part, called_on, .. } = self;
        if let Some(name) = called_on {
            Shared(name).visit_expr_mut(&mut part);
        }
        part
    }
}

/// Takes the first part of `expr` out of it that may exit and is certainly evaluated, or a call before
/// that, and leaves a new name in its place.
pub fn hoist(expr: &mut Expr, names: &mut Names) -> Option<Hoisted> {
    match expr {
        Expr::Try(inner) if expr_exits(&inner.expr) => hoist(&mut inner.expr, names),
        Expr::Try(_)
        | Expr::If(_)
        | Expr::Match(_)
        | Expr::Block(_)
        | Expr::ForLoop(_)
        | Expr::While(_)
        | Expr::Loop(_)
            if expr_exits(expr) =>
        {
            // Without this the condition would be evaluated too late.
            let condition = match expr {
                Expr::If(branch) => Some(&mut *branch.cond),
                Expr::Match(branch) => Some(&mut *branch.expr),
                _ => None,
            };
            if let Some(condition) = condition
                && expr_exits(condition)
            {
                return hoist(condition, names);
            }
            let ident = names.unwritten("value");
            let part = std::mem::replace(expr, parse_quote!(#ident));
            Some(Hoisted { name: ident, part, called_on: None })
        }
        _ => {
            let is_indexed = matches!(expr, Expr::Index(_));
            // A number is copied before the arguments are evaluated, anything else is referred to.
            let receives = matches!(expr, Expr::MethodCall(call)
                if !floats::takes_number(&call.method.to_string()));
            let is_unknown = matches!(expr, Expr::MethodCall(call)
                if !rules::is_method(&call.method.to_string()));
            let mut parts = strict_parts(expr);
            let exit = parts.iter().position(|part| expr_exits(part))?;
            for index in 0..exit {
                let (earlier, later) = parts.split_at_mut(index + 1);
                let later = &later[..exit - index];
                let is_changed = |end: &Expr| later.iter().any(|later| changes(later, end, false));
                if let Some(position) = changed_index(earlier[index], &is_changed) {
                    let name = names.unwritten("position");
                    let part = std::mem::replace(position, parse_quote!(#name));
                    return Some(Hoisted { name, part, called_on: None });
                }
            }
            // What is evaluated before stays before; an iterator is not, until it is used up.
            let stays = |index: usize| {
                let part = &*parts[index];
                let is_called_on = index == 0 && receives && !makes_value(part);
                let later = || parts[index + 1..=exit].iter().map(|part| &**part);
                calls(part) && !is_chain(part)
                    || !is_indexed && later().any(|later| changes(later, part, is_called_on))
            };
            let earlier = (0..exit).find(|&index| stays(index));
            let is_called_on = is_unknown
                && exit > 0
                && parts[1..=exit].iter().any(|part| calls_on(parts[0], part));
            let called_on = root_name(parts[0]).filter(|_| is_called_on).cloned();
            let hoisted = match earlier {
                None => hoist(parts[exit], names)?,
                Some(earlier) => {
                    let name = names.unwritten("value");
                    let part = std::mem::replace(parts[earlier], parse_quote!(#name));
                    Hoisted { name, part, called_on: None }
                }
            };
            Some(Hoisted { called_on: hoisted.called_on.or(called_on), ..hoisted })
        }
    }
}

/// The first index in a place, or in that which an iterator runs over, of which it holds that it is changed.
fn changed_index<'e>(
    place: &'e mut Expr,
    is_changed: &dyn Fn(&Expr) -> bool,
) -> Option<&'e mut Expr> {
    match place {
        Expr::Paren(inner) => changed_index(&mut inner.expr, is_changed),
        Expr::Field(field) => changed_index(&mut field.base, is_changed),
        Expr::Reference(reference) => changed_index(&mut reference.expr, is_changed),
        Expr::Unary(unary) => changed_index(&mut unary.expr, is_changed),
        Expr::MethodCall(_) if !is_chain(place) => None,
        Expr::MethodCall(call) => changed_index(&mut call.receiver, is_changed),
        Expr::Index(index) => changed_index(&mut index.expr, is_changed).or_else(|| {
            let ends: Vec<&mut Expr> = match &mut *index.index {
                Expr::Range(range) => {
                    let ends = [&mut range.start, &mut range.end];
                    ends.into_iter().flatten().map(|end| &mut **end).collect()
                }
                position => vec![position],
            };
            ends.into_iter().find(|end| is_changed(end))
        }),
        _ => None,
    }
}

/// Whether evaluating `value` certainly changes what an index of `place` reads.
pub fn changes_index(value: &Expr, place: &Expr) -> bool {
    changed_index(&mut place.clone(), &|index| changes(value, index, true)).is_some()
}

/// Whether a method is called in an expression on a place, on a part of it, or on what it is a part of.
fn calls_on(place: &Expr, expr: &Expr) -> bool {
    let place = place.to_token_stream().to_string();
    has(expr, |part| {
        let Expr::MethodCall(call) = part else { return None };
        let receiver = call.receiver.to_token_stream().to_string();
        (receiver.starts_with(&place) || place.starts_with(&receiver)).then_some(true)
    })
}

/// The parts of an expression that are evaluated whenever it is, in order.
fn strict_parts(expr: &mut Expr) -> Vec<&mut Expr> {
    match expr {
        Expr::Paren(e) => vec![&mut e.expr],
        Expr::Unary(e) => vec![&mut e.expr],
        Expr::Cast(e) => vec![&mut e.expr],
        Expr::Field(e) => vec![&mut e.base],
        Expr::Reference(e) => vec![&mut e.expr],
        Expr::Let(e) => vec![&mut e.expr],
        Expr::Repeat(e) => vec![&mut e.expr],
        Expr::Return(e) => e.expr.iter_mut().map(|e| &mut **e).collect(),
        Expr::Break(e) => e.expr.iter_mut().map(|e| &mut **e).collect(),
        Expr::Assign(e) => vec![&mut e.right],
        Expr::Binary(e) => match e.op {
            syn::BinOp::And(_) | syn::BinOp::Or(_) => vec![&mut e.left],
            operator if is_update(&operator) => vec![&mut e.right],
            _ => vec![&mut e.left, &mut e.right],
        },
        Expr::Index(e) => vec![&mut e.expr, &mut e.index],
        Expr::Call(e) => e.args.iter_mut().collect(),
        Expr::MethodCall(e) => std::iter::once(&mut *e.receiver).chain(e.args.iter_mut()).collect(),
        Expr::Tuple(e) => e.elems.iter_mut().collect(),
        Expr::Array(e) => e.elems.iter_mut().collect(),
        Expr::Struct(e) => e
            .fields
            .iter_mut()
            .map(|field| &mut field.expr)
            .chain(e.rest.iter_mut().map(|rest| &mut **rest))
            .collect(),
        _ => Vec::new(),
    }
}
