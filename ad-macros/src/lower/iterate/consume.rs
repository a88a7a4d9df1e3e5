//! What ends a chain of iterator adapters: sums, products, folds, searches. Each is a loop.

use proc_macro2::Ident;
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{Block, Expr, ExprMethodCall, GenericArgument, Pat, Type, parse_quote};

use super::chain::{is_adapter, is_chain, is_source};
use super::item::Item;
use super::source::LOOK_AHEAD;
use crate::ir::Shape;
use crate::ir::{Arm, BinaryOperator, BranchKind, Operand, Operation, Place, Statement, VarId};
use crate::lower::Lowerer;
use crate::lower::expression::construct;
use crate::lower::expression::order::may_have_effect;
use crate::lower::place::pattern;
use crate::lower::rewrite::desugar::scrutinee;
use crate::lower::syntax::strip_parens;
use crate::names::Names;

impl Lowerer<'_> {
    /// The value of a method that uses an iterator up, if `call` is one.
    pub fn consumed(&mut self, call: &ExprMethodCall, hint: &str) -> Option<Operand> {
        if !is_chain(&call.receiver) {
            return None;
        }
        let arguments: Vec<_> = call.args.iter().collect();
        let last = Ident::new("last", call.method.span());
        let value = match (&*call.method.to_string(), &arguments[..]) {
            ("sum", []) => self.accumulated(call, BinaryOperator::Add, hint),
            ("product", []) => self.accumulated(call, BinaryOperator::Mul, hint),
            ("fold", [start, function]) => self.folded(&call.receiver, start, function, hint),
            ("reduce", [function]) => self.reduced(call, Some(function), hint),
            ("last", []) => self.reduced(call, None, hint),
            ("nth", [position]) => {
                let name = self.names.unwritten("position");
                let chain = self.made_before(position, &call.receiver);
                self.statement(&parse_quote!(let #name: usize = #position;));
                self.operand(&parse_quote!(#chain.take(#name + 1).skip(#name).#last()), hint)
            }
            ("next", []) => {
                let chain = &call.receiver;
                self.operand(&parse_quote!(#chain.take(1).#last()), hint)
            }
            ("find", [function]) => {
                let chain = &call.receiver;
                self.operand(&parse_quote!(#chain.filter(#function).take(1).#last()), hint)
            }
            ("find_map", [function]) => {
                let chain = &call.receiver;
                self.operand(&parse_quote!(#chain.filter_map(#function).take(1).#last()), hint)
            }
            ("for_each", [function]) => {
                self.each(&call.receiver, &mut |lowerer, item| {
                    let value = lowerer.apply(function, vec![item]);
                    lowerer.discard(value);
                });
                Self::unit()
            }
            ("collect", []) => self.collected(call, hint),
            ("unzip", []) => self.in_two(call, None, hint),
            ("partition", [function]) => self.in_two(call, Some(function), hint),
            _ if self.tests_what_changes(call) => self.tested(call, hint),
            ("count", []) | ("any" | "all" | "contains" | "position" | "rposition", [_]) => {
                self.discrete(&Expr::MethodCall(call.clone()))
            }
            ("max_by", [compare]) => self.extreme(call, compare, true, hint),
            ("min_by", [compare]) => self.extreme(call, compare, false, hint),
            (_, _) if is_chain(&Expr::MethodCall(call.clone())) => self.refuse_iterator(call),
            (name, _) => self.refuse(
                &call.method,
                format!("the iterator method `{name}` is not supported: write a `for` loop"),
            ),
        };
        Some(value)
    }

    /// Whether a method tests or counts the items of an iterator that changes something, as `drain` does: a
    /// loop of its own, while one that only reads is called as it is.
    pub fn tests_what_changes(&self, call: &ExprMethodCall) -> bool {
        matches!(
            (&*call.method.to_string(), call.args.len()),
            ("count", 0) | ("any" | "all" | "position", 1)
        ) && is_chain(&call.receiver)
            && self.changes(&call.receiver)
    }

    /// `.count()`, `.any(function)`, `.all(function)`, `.position(function)`
    fn tested(&mut self, call: &ExprMethodCall, hint: &str) -> Operand {
        let [item, count, found] =
            ["item", "count", "found"].map(|name| self.names.unwritten(name));
        let (chain, function) = (scrutinee(&call.receiver), call.args.first());
        let test: Expr = match &*call.method.to_string() {
            "count" => parse_quote!({
                let mut #count: usize = 0;
                for _ in #chain {
                    #count += 1;
                }
                #count
            }),
            "position" => parse_quote!({
                let mut #count: usize = 0;
                let mut #found: bool = false;
                for #item in #chain {
                    if (#function)(#item) {
                        #found = true;
                        break;
                    }
                    #count += 1;
                }
                if #found { ::core::option::Option::Some(#count) } else { ::core::option::Option::None }
            }),
            name => {
                let is_any = name == "any";
                parse_quote!({
                    let mut #found: bool = !#is_any;
                    for #item in #chain {
                        if (#function)(#item) == #is_any {
                            #found = #is_any;
                            break;
                        }
                    }
                    #found
                })
            }
        };
        self.operand(&test, hint)
    }

    /// `.unzip()`, and with a function `.partition(function)`: into two `Vec`s, one by one.
    fn in_two(&mut self, call: &ExprMethodCall, function: Option<&Expr>, hint: &str) -> Operand {
        let [left, right, first, second] =
            ["left", "right", "first", "second"].map(|name| self.names.unwritten(name));
        let chain = scrutinee(&call.receiver);
        let (item, pushes): (Pat, Block) = match function {
            None => (
                parse_quote!((#first, #second)),
                parse_quote!({ #left.push(#first); #right.push(#second); }),
            ),
            Some(function) => (
                parse_quote!(#first),
                parse_quote!({
                    let #second = (#function)(&#first);
                    if #second { #left.push(#first); } else { #right.push(#first); }
                }),
            ),
        };
        let both = parse_quote!({
            let (mut #left, mut #right) = (::std::vec::Vec::new(), ::std::vec::Vec::new());
            for #item in #chain #pushes
            (#left, #right)
        });
        self.operand(&both, hint)
    }

    /// An iterator that stands by itself.
    pub fn refuse_iterator(&mut self, call: &ExprMethodCall) -> Operand {
        if call.method == "peekable" {
            return self.refuse(&call.method, LOOK_AHEAD);
        }
        self.refuse(
            call,
            "an iterator has no derivative: write it where it is used up, by a `for` loop, `sum`, `fold`",
        )
    }

    /// `.sum()`, `.product()`
    fn accumulated(
        &mut self,
        call: &ExprMethodCall,
        operator: BinaryOperator,
        hint: &str,
    ) -> Operand {
        let ty = type_argument(call);
        if let Some(ty) = &ty
            && let Some(value) = self.accumulated_attempts(call, ty, operator, hint)
        {
            return value;
        }
        let asked = ty.as_ref().map(|ty| quote!(::<#ty>));
        let start = match operator {
            BinaryOperator::Add => quote!(::ad::rt::empty_sum #asked ()),
            _ => quote!(::ad::rt::empty_product #asked ()),
        };
        let hint = if hint == "value" { "total" } else { hint };
        let name = hint.to_owned();
        let total = self.changing(hint, Operand::Constant(start), call);
        self.each(&call.receiver, &mut |lowerer, item| {
            let is_by_value = !matches!(item, Item::Reference(_));
            let value = lowerer.plain_item(item);
            let value = lowerer.named(value, "term", call.method.span());
            if asked.is_none() && is_by_value {
                let [total, item] = [total, value].map(|var| lowerer.ident(var));
                let told = quote!(::ad::rt::is_of_items(&#total, &#item););
                lowerer.push_plain(told);
            }
            let place = Place::of(total);
            let read = Operation::Read(place.clone());
            let before = lowerer.define("partial", call.method.span(), true, read);
            // Not `+=`: the standard library asks for a sum of values, not for that.
            let sum = Operation::Binary(operator, before, value);
            let sum = lowerer.define(&name, call.method.span(), true, sum);
            lowerer.store(place, Operand::Var(sum));
        });
        self.read_place(Place::of(total), hint)
    }

    /// `.fold(start, function)`
    fn folded(&mut self, chain: &Expr, start: &Expr, function: &Expr, hint: &str) -> Operand {
        let chain = &self.made_before(start, chain);
        let start = self.operand(start, hint);
        let state = self.changing(hint, start, chain);
        self.each(chain, &mut |lowerer, item| {
            let place = Place::of(state);
            let before = Item::Value(lowerer.read_place(place.clone(), "before"));
            let value = lowerer.apply(function, vec![before, item]);
            lowerer.store(place, value);
        });
        self.read_place(Place::of(state), hint)
    }

    /// An iterator with names in place of the values that it is made of: they come before `next`.
    fn made_before(&mut self, next: &Expr, chain: &Expr) -> Expr {
        struct Values<'n> {
            names: &'n mut Names,
            found: Vec<(Ident, Expr)>,
        }

        impl VisitMut for Values<'_> {
            fn visit_expr_mut(&mut self, expr: &mut Expr) {
                match expr {
                    Expr::Closure(_) | Expr::Lit(_) | Expr::Path(_) => {}
                    Expr::Range(_) => self.value(expr),
                    Expr::Index(index) => {
                        self.visit_expr_mut(&mut index.expr);
                        self.value(&mut index.index);
                    }
                    Expr::MethodCall(call)
                        if is_adapter(&call.method) || is_source(&call.method) =>
                    {
                        self.visit_expr_mut(&mut call.receiver);
                        let is_number = is_source(&call.method)
                            || ["take", "skip", "step_by"].iter().any(|name| call.method == name);
                        for argument in &mut call.args {
                            match is_number {
                                true => self.value(argument),
                                false => self.visit_expr_mut(argument),
                            }
                        }
                    }
                    Expr::Array(_) | Expr::Repeat(_) | Expr::Call(_) | Expr::MethodCall(_)
                        if !is_chain(expr) =>
                    {
                        self.value(expr);
                    }
                    expr => visit_mut::visit_expr_mut(self, expr),
                }
            }
        }

        impl Values<'_> {
            fn value(&mut self, expr: &mut Expr) {
                match expr {
                    Expr::Lit(_) => {}
                    Expr::Range(range) => {
                        range.start.iter_mut().chain(&mut range.end).for_each(|to| self.value(to));
                    }
                    _ => {
                        let name = self.names.unwritten("made");
                        self.found.push((name.clone(), expr.clone()));
                        *expr = parse_quote!(#name);
                    }
                }
            }
        }

        let mut chain = chain.clone();
        if may_have_effect(next) || self.reads_changeable(next) {
            let mut values = Values { names: self.names, found: Vec::new() };
            values.visit_expr_mut(&mut chain);
            for (name, value) in values.found {
                self.statement(&parse_quote!(let #name = #value;));
            }
        }
        chain
    }

    /// `.reduce(function)`, and without a function `.last()`.
    fn reduced(&mut self, call: &ExprMethodCall, function: Option<&Expr>, hint: &str) -> Operand {
        let none = Operand::Constant(quote!(::core::option::Option::None));
        let state = self.changing(hint, none, call);
        let [so_far, before, value] =
            ["so_far", "before", "item"].map(|name| self.names.unwritten(name));
        self.each(&call.receiver, &mut |lowerer, item| {
            let item = Item::Value(lowerer.owned(item, call));
            lowerer.scope(|lowerer| {
                lowerer.alias(&so_far, state);
                lowerer.bind_item(&parse_quote!(#value), item);
                let next: Expr = match function {
                    Some(function) => parse_quote!(match #so_far {
                        ::core::option::Option::Some(#before) => {
                            ::core::option::Option::Some((#function)(#before, #value))
                        }
                        ::core::option::Option::None => ::core::option::Option::Some(#value),
                    }),
                    None => parse_quote!(::core::option::Option::Some(#value)),
                };
                lowerer.expression_statement(&parse_quote!(#so_far = #next));
            });
        });
        self.read_place(Place::of(state), hint)
    }

    /// `.max_by(compare)`, `.min_by(compare)`: of equal items the last is the greatest, the first
    /// the least, as in the standard library.
    fn extreme(
        &mut self,
        call: &ExprMethodCall,
        compare: &Expr,
        is_max: bool,
        hint: &str,
    ) -> Operand {
        if self.names_changing_constant(compare) {
            // It could be given a derivative by the best item so far, which stands for a constant here.
            return self.refuse(
                compare,
                "a comparison does not name what changes here: give it another name by `let` before, or compare in a `for` loop",
            );
        }
        let none = Operand::Constant(quote!(::core::option::Option::None));
        let best = self.changing(hint, none, call);
        let best_ident = self.ident(best).clone();
        self.each(&call.receiver, &mut |lowerer, item| {
            if item.refers() {
                lowerer.refuse(
                    &call.method,
                    format!(
                        "`{}` of references is not supported: put `.copied()` before it",
                        call.method
                    ),
                );
                return;
            }
            let span = call.method.span();
            let value = lowerer.item_value(item);
            let value = lowerer.named(value, "candidate", span);
            let candidate = Item::Value(lowerer.operand_of(value));
            // The best so far, and whether the candidate takes its place.
            let held_ident = lowerer.names.fresh("held", span);
            let held_var = lowerer.var(held_ident.clone(), false, false);
            let before = lowerer.vars.len();
            let takes = lowerer.block(|lowerer| {
                let shown = vec![Item::Constant(held_var), candidate.clone().borrowed(lowerer)];
                let order = lowerer.order(compare, shown);
                let order = lowerer.without_derivative(&order);
                Operand::Constant(match is_max {
                    true => quote!((#order).is_le()),
                    false => quote!((#order).is_gt()),
                })
            });
            if takes.may_change(before) {
                let message =
                    "a comparison that changes something is not supported: compare in a `for` loop";
                lowerer.refuse(compare, message);
            }
            let first = lowerer.block(|_| Operand::Constant(quote!(true)));
            let some = Arm {
                pattern: quote!(::core::option::Option::Some(#held_ident)),
                guard: None,
                bindings: Vec::new(),
                body: takes,
            };
            let none = Arm { pattern: quote!(_), ..Arm::plain(first) };
            let candidate = lowerer.ident(value).clone();
            let held = quote!(::ad::rt::held(&#best_ident, &#candidate));
            let kind = BranchKind::Match(held, None);
            let replaces = lowerer.branch(kind, vec![some, none], true, span);
            let replaces = lowerer.tokens(&replaces);

            let keep = lowerer.block(|_| Self::unit());
            let replace = lowerer.block(|lowerer| {
                let expression = quote!(::core::option::Option::Some(#candidate));
                let parts = construct::numbered(vec![Operand::Var(value)]);
                let shape = Shape::Transparent;
                let operation = Operation::Aggregate { expression, shape, parts };
                let new = Operand::Var(lowerer.define("best", span, true, operation));
                lowerer.store(Place::of(best), new);
                Self::unit()
            });
            let arms = [replace, keep].map(Arm::plain);
            lowerer.branch(BranchKind::If(replaces), arms.into(), false, span);
        });
        self.read_place(Place::of(best), hint)
    }

    /// What a comparison says of two items; the name of a function decides, and needs no derivative.
    fn order(&mut self, compare: &Expr, items: Vec<Item>) -> Operand {
        let (Expr::Path(path), None) = (strip_parens(compare), self.named_closure(compare)) else {
            return self.apply(compare, items);
        };
        self.scope(|lowerer| {
            let names = lowerer.named_items(items);
            lowerer.discrete(&parse_quote!(#path(#(#names),*)))
        })
    }

    /// A new variable that a loop changes.
    pub(super) fn changing(&mut self, hint: &str, start: Operand, at: impl ToTokens) -> VarId {
        let active = match &start {
            Operand::Var(_) => true,
            Operand::Constant(tokens) => !pattern::is_discrete_literal(tokens),
        };
        let ident = self.names.fresh(hint, at.span());
        let var = self.var(ident, true, active);
        self.push(Statement::Define { var, ty: None, operation: Operation::Use(start) });
        var
    }

    /// `place = value`
    fn store(&mut self, place: Place, value: Operand) {
        if self.vars[place.root].active {
            self.push(Statement::Assign { place, value });
        } else {
            let (target, value) = (self.place_tokens(&place), self.without_derivative(&value));
            self.push_plain(quote!(#target = #value;));
        }
    }

    /// An item as a value, not as a reference to one.
    fn plain_item(&mut self, item: Item) -> Operand {
        match item {
            Item::Reference(alias) => self.read_place(alias.place, "term"),
            Item::Value(Operand::Var(var)) => Operand::Var(self.number(var)),
            item => self.item_value(item),
        }
    }

    /// Runs `body` for each item.
    fn each(&mut self, chain: &Expr, body: &mut dyn FnMut(&mut Lowerer<'_>, Item)) {
        self.run_chain(chain, &mut |lowerer, item, end| {
            body(lowerer, item);
            lowerer.normal_end(Self::unit(), end)
        });
    }
}

/// `T` of `.method::<T>()`
pub(super) fn type_argument(call: &ExprMethodCall) -> Option<Type> {
    match call.turbofish.as_ref()?.args.first()? {
        GenericArgument::Type(ty) => Some(ty.clone()),
        _ => None,
    }
}
