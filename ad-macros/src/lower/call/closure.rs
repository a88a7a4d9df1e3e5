//! Closures: the body takes the place of each call.
//!
//! A closure is no value here. Where it is called, or given to an adapter of an iterator, its body
//! is lowered anew, with the names it saw where it was written; so what it captures is used and
//! changed where it lives, and gets its cotangent there. A `move` closure takes copies of the
//! variables that may change.
//!
//! Turned down: making every closure a value with a pullback, as one is that a function is given
//! (see [`function`](crate::lower::call::function)): it would copy what it captures, and a captured variable that
//! the closure changes has no place there.

use std::collections::HashSet;
use std::rc::Rc;

use proc_macro2::Ident;
use quote::ToTokens;
use syn::{Expr, ExprClosure, ReturnType, parse_quote};

use crate::ir::{Operand, Operation, Place, Statement, Target};
use crate::lower::flow::ends::End;
use crate::lower::iterate::item::Item;
use crate::lower::rewrite::exits::changed_places;
use crate::lower::scopes::{Name, Scopes};
use crate::lower::search::Bound;
use crate::lower::state::{Alias, Closure, JumpKind};
use crate::lower::syntax::{as_statements, root_name, strip_parens};
use crate::lower::{Lowerer, OnFailure};
use crate::names;

impl Lowerer<'_> {
    /// `let name = |..| ..;`
    pub fn closure_local(&mut self, name: &Ident, closure: &ExprClosure) {
        let mut scopes = self.scopes.clone();
        if closure.capture.is_some() {
            self.move_captured(closure, &mut scopes);
        }
        let var = self.unwritten_var(name, false, false);
        self.closures.insert(var, Rc::new(Closure { body: closure.clone(), scopes }));
        self.alias(name, var);
    }

    /// Lets a `move` closure that is being written have copies of the changeable variables that it
    /// captures.
    fn move_captured(&mut self, closure: &ExprClosure, scopes: &mut Scopes) {
        scopes.open();
        for name in names::identifiers(closure.to_token_stream()) {
            let Some(root) = self.scopes.lookup(&name) else { continue };
            if !self.vars[root].mutable
                || self.aliases.contains_key(&root)
                || scopes.lookup_innermost(&name).is_some()
            {
                continue;
            }
            let (active, span) = (self.vars[root].active, self.ident(root).span());
            let ident = self.names.fresh(&name.to_string(), span);
            let value = match active {
                true => Operation::Read(Place::of(root)),
                false => Operation::Use(self.constant(root)),
            };
            let copy = self.var(ident, true, active);
            self.push(Statement::Define { var: copy, ty: None, operation: value });
            scopes.bind(&name, copy);
        }
    }

    /// The closure that an expression names.
    pub fn named_closure(&self, expr: &Expr) -> Option<Rc<Closure>> {
        let Expr::Path(path) = strip_parens(expr) else { return None };
        let var = self.variable(path)?;
        self.closures.get(&var).cloned()
    }

    /// The value of a closure or a function for these arguments.
    pub fn apply(&mut self, function: &Expr, arguments: Vec<Item>) -> Operand {
        if let Some(closure) = self.named_closure(function) {
            // Its names are those of the place where it was written.
            let scopes = std::mem::replace(&mut self.scopes, closure.scopes.clone());
            let value = self.inlined(&closure.body, arguments);
            self.scopes = scopes;
            return value;
        }
        match strip_parens(function) {
            Expr::Closure(closure) => self.inlined(closure, arguments),
            Expr::Path(path) => self.scope(|lowerer| {
                let names = lowerer.named_items(arguments);
                lowerer.operand(&parse_quote!(#path(#(#names),*)), "value")
            }),
            other => self.refuse(other, "write a closure or the name of a function here"),
        }
    }

    /// Items by names, which are bound here.
    pub fn named_items(&mut self, items: Vec<Item>) -> Vec<Ident> {
        let named = items.into_iter().map(|item| {
            let name = self.names.unwritten("argument");
            self.bind_item(&parse_quote!(#name), item);
            name
        });
        named.collect()
    }

    fn inlined(&mut self, closure: &ExprClosure, arguments: Vec<Item>) -> Operand {
        if let Some(token) = &closure.asyncness {
            return self.refuse(token, "asynchronous code has no derivative");
        }
        if closure.inputs.len() != arguments.len() {
            return self.refuse(closure, "the closure is given another number of arguments");
        }
        let in_closure = OnFailure::of_closure(&closure.output);
        let on_failure = std::mem::replace(&mut self.on_failure, in_closure);
        let value = self.jump(JumpKind::Function, None, |lowerer, id| {
            lowerer.nested(|lowerer| {
                let mut statements = as_statements(&closure.body);
                for (pat, argument) in closure.inputs.iter().zip(arguments) {
                    lowerer.bind_item_of(pat, argument, &mut statements);
                }
                let end = End { here: vec![Target::Leave(id)], ..End::default() };
                lowerer.statements(statements, &end)
            })
        });
        self.on_failure = on_failure;
        match &closure.output {
            ReturnType::Default => value,
            ReturnType::Type(_, ty) => self.typed(value, ty),
        }
    }

    /// A value whose type the user gave.
    pub(super) fn typed(&mut self, value: Operand, ty: &syn::Type) -> Operand {
        let active = matches!(value, Operand::Var(_));
        let ident = self.names.fresh("returned", proc_macro2::Span::call_site());
        let var = self.var(ident, false, active);
        let operation = Operation::Use(value);
        self.push(Statement::Define { var, ty: Some(ty.clone()), operation });
        self.operand_of(var)
    }

    /// All that a call of a closure is given.
    pub(super) fn all_given(&mut self, call: &syn::ExprCall) -> Vec<Item> {
        let given = |(index, argument)| match self.given(argument) {
            Item::Value(value) => {
                let following = call.args.iter().skip(index + 1);
                Item::Value(self.in_turn(value, argument, following))
            }
            item => item,
        };
        call.args.iter().enumerate().map(given).collect()
    }

    /// What a call of a closure is given.
    pub(super) fn given(&mut self, expr: &Expr) -> Item {
        let target = match strip_parens(expr) {
            Expr::Reference(reference) => {
                Some((&*reference.expr, 1, reference.mutability.is_some()))
            }
            path if self.depth(path) > 0 => {
                Some((path, self.depth(path), self.is_exclusive_alias(path)))
            }
            _ => None,
        };
        if let Some((target, depth, is_exclusive)) = target
            && let Some(place) = self.place(target)
        {
            return Item::Reference(Alias { place, depth, is_exclusive });
        }
        Item::Value(self.operand(expr, "argument"))
    }

    /// Refuses a closure as a value.
    pub fn refuse_closure(&mut self, expr: &Expr) -> Operand {
        self.refuse(
            expr,
            "a closure can be called, passed to a function, or given to an adapter of an iterator, and nothing else",
        )
    }

    /// Refuses a closure that changes what it captures, where its calls may be left out.
    pub fn refuse_changes(&mut self, function: &Expr) {
        let changes = match (self.named_closure(function), strip_parens(function)) {
            (Some(closure), _) => changes_captured(&closure.body),
            (None, Expr::Closure(closure)) => changes_captured(closure),
            _ => false,
        };
        if changes {
            self.refuse(
                function,
                "a closure that changes a variable cannot stand before this adapter: write a `for` loop",
            );
        }
    }
}

/// Whether a closure assigns to a variable that it does not declare.
pub fn changes_captured(closure: &ExprClosure) -> bool {
    let declared = closure.inputs.iter().flat_map(Bound::by).chain(Bound::within(&closure.body));
    let declared: HashSet<_> = declared.map(|name| Name::of(&name.ident)).collect();
    let mut changed = changed_places(&closure.body).into_iter().filter_map(root_name);
    changed.any(|name| !declared.contains(&Name::of(name)))
}
