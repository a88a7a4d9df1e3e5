//! Calls of functions and methods, and what they are given.

use proc_macro2::TokenStream;
use quote::{format_ident, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Expr, ExprPath, Path, PathArguments};

use super::Lowerer;
use super::array::is_from_fn;
use super::construct::is_type_name;
use super::higher::{refused_function, refused_method};
use super::no_diff::undifferentiated;
use crate::ir::{Argument, Operand, Operation, Projection, Statement, TypedBy};
use crate::primal::Primal;

impl Lowerer<'_> {
    /// `&e`
    pub(super) fn reference(&mut self, reference: &syn::ExprReference, hint: &str) -> Operand {
        if let Some(token) = &reference.mutability {
            return self.refuse(
                token,
                "`&mut` is supported for the argument of a call and in `let name = &mut place` only: name the place itself where it is changed",
            );
        }
        match self.argument(&Expr::Reference(reference.clone())) {
            Argument::Value(operand) => operand,
            Argument::Function(var) => Operand::Var(var),
            Argument::Borrow(place)
            | Argument::Callee(place)
            | Argument::PassedOn(place, _)
            | Argument::Exclusive(place)
            | Argument::Reborrow(place)
            | Argument::Receiver(place) => {
                let operation = Operation::Borrow(place);
                let var = self.define(hint, reference.span(), true, operation);
                self.references.insert(var);
                Operand::Var(var)
            }
        }
    }

    pub(super) fn argument(&mut self, expr: &Expr) -> Argument {
        self.argument_of(expr, None)
    }

    /// What a function is given for a parameter that may tell the type of a closure.
    fn argument_of(&mut self, expr: &Expr, typed_by: Option<TypedBy>) -> Argument {
        if let Some(function) = self.function_argument(expr, typed_by) {
            return function;
        }
        if self.depth(expr) > 0
            && let Some(place) = self.active_place(expr)
        {
            return match self.is_exclusive_alias(expr) {
                true => Argument::Exclusive(place),
                false => Argument::Borrow(place),
            };
        }
        let Expr::Reference(reference) = expr else {
            // A `&mut` parameter is passed on by reborrowing what it refers to.
            return match self.place(expr) {
                Some(mut place) if place.path.is_empty() && self.vars[place.root].exclusive => {
                    place.path.push(Projection::Deref);
                    Argument::Reborrow(place)
                }
                _ => Argument::Value(self.operand(expr, "argument")),
            };
        };
        if reference.mutability.is_some() {
            return match self.target(&reference.expr) {
                Some(place) => Argument::Exclusive(place),
                None => Argument::Value(Self::unit()),
            };
        }
        if let Some(place) = self.active_place(&reference.expr) {
            return Argument::Borrow(place);
        }
        match self.operand(&reference.expr, "target") {
            Operand::Constant(tokens) => Argument::Value(Operand::Constant(quote!((&#tokens)))),
            Operand::Var(root) => Argument::Borrow(crate::ir::Place { root, path: Vec::new() }),
        }
    }

    pub(super) fn argument_tokens(&self, argument: &Argument) -> TokenStream {
        Primal(&self.vars).argument(argument)
    }

    pub(super) fn call(&mut self, call: &syn::ExprCall, hint: &str) -> Operand {
        if let Expr::Closure(_) = super::flow::strip_parens(&call.func) {
            let given = call.args.iter().map(|argument| self.given(argument)).collect();
            return self.apply(&call.func, given);
        }
        let Expr::Path(function) = super::flow::strip_parens(&call.func) else {
            return self.refuse(
                &call.func,
                "only functions called by name can be differentiated: write a `#[differentiable]` function",
            );
        };
        let path = &function.path;
        if let Some(name) = path.get_ident() {
            if self.named_closure(&call.func).is_some() {
                let given = call.args.iter().map(|argument| self.given(argument)).collect();
                return self.apply(&call.func, given);
            }
            if let Some(var) = self.lookup(name) {
                return match self.functions.get(&var) {
                    Some(&arity) => self.call_of_parameter(call, var, arity, hint),
                    None => self.refuse(
                        name,
                        "what this calls is not known here: write a `#[differentiable]` function, or a parameter of a type `F: Fn(..) -> ..`",
                    ),
                };
            }
        }
        if let Some(message) = refused_function(path) {
            return self.refuse(path, message);
        }
        let last = path.segments.last().expect("a path has a segment");
        if last.ident == "stop_gradient" {
            let expr = Expr::Call(call.clone());
            let tokens = self.plain(&expr);
            return self.settled(&expr, tokens);
        }
        if let Some(closure) = undifferentiated(call) {
            return Operand::Constant(self.no_diff(&call.func, closure));
        }
        if is_from_fn(path) {
            return self.array_from_fn(call, path, hint);
        }
        if is_type_name(&last.ident) {
            return self.construct(call, function, hint);
        }
        if is_box_new(path) && call.args.len() == 1 {
            return self.boxed(call, hint);
        }

        let twin = twin_of(function);
        let arguments = call.args.iter().enumerate().map(|(index, argument)| {
            let typed_by = twin.clone().map(|function| TypedBy { function, method: None, index });
            self.argument_of(argument, typed_by)
        });
        let arguments: Vec<_> = arguments.collect();
        let primal = quote!(#function);
        let vjp = known_vjp(path).unwrap_or_else(|| vjp_of(function));
        let hint = if hint == "value" { last.ident.to_string() } else { hint.to_owned() };
        self.finish_call(primal, vjp, false, arguments, &hint, call.span())
    }

    pub(super) fn method_call(&mut self, call: &syn::ExprMethodCall, hint: &str) -> Operand {
        let special = self
            .consumed(call, hint)
            .or_else(|| self.optional(call, hint))
            .or_else(|| self.mapped(call, hint))
            .or_else(|| self.lent(call, hint))
            .or_else(|| self.extended(call));
        if let Some(value) = special {
            return value;
        }
        let name = call.method.to_string();
        if is_predicate(&name) {
            return self.discrete(&Expr::MethodCall(call.clone()));
        }
        if let Some(message) = refused_method(&call.method) {
            return self.refuse(&call.method, message);
        }
        let receiver = self.receiver(call);
        let called_on = match &receiver {
            Argument::Receiver(place) if self.vars[place.root].mutable => Some(place.root),
            _ => None,
        };
        if matches!(&*name, "x" | "y" | "z") && call.args.is_empty() {
            self.check_element(&call.method, &receiver);
        }
        let mut arguments = vec![receiver];
        self.called_on.extend(called_on);
        let called = self.argument_tokens(&arguments[0]);
        arguments.extend(call.args.iter().enumerate().map(|(index, argument)| {
            // What it is given decides, and computes nothing.
            if is_comparing(&name) {
                return Argument::Value(Operand::Constant(self.plain_in_place(argument)));
            }
            self.argument_of(
                argument,
                Some(TypedBy {
                    function: called.clone(),
                    method: Some(call.method.clone()),
                    index: index + 1,
                }),
            )
        }));
        if called_on.is_some() {
            self.called_on.pop();
        }
        // What an argument refers to, the method cannot change.
        let is_shared = |argument: &Argument| matches!(argument, Argument::Borrow(place) if called_on == Some(place.root));
        if arguments[1..].iter().any(is_shared)
            && let Argument::Receiver(place) = &arguments[0]
        {
            arguments[0] = Argument::Borrow(place.clone());
        }
        let (method, turbofish) = (&call.method, &call.turbofish);
        let vjp = format_ident!("{}_vjp", method);
        let hint = if hint == "value" { name } else { hint.to_owned() };
        let (primal, vjp) = (quote!(#method #turbofish), quote!(#vjp #turbofish));
        self.finish_call(primal, vjp, true, arguments, &hint, call.span())
    }

    /// `x`, `y`, `z`: vectors of glam have no such methods but those of `ad`, so another trait could
    /// lend them others than those that the rules differentiate. With `ad`'s own in scope the
    /// compiler does not know which to call then.
    fn check_element(&mut self, method: &syn::Ident, receiver: &Argument) {
        let receiver = self.argument_tokens(receiver);
        let code = quote_spanned! {method.span()=>
            let _ = || ::ad::rt::like(&#receiver).#method();
            let _ = || {
                use ::ad::rt::by_reference::*;
                (&::ad::rt::like(&#receiver)).#method()
            };
        };
        self.push(Statement::Plain { code, defines: Vec::new() });
    }

    pub(super) fn finish_call(
        &mut self,
        primal: TokenStream,
        vjp: TokenStream,
        method: bool,
        arguments: Vec<Argument>,
        hint: &str,
        span: proc_macro2::Span,
    ) -> Operand {
        let constant = arguments.iter().all(|argument| match argument {
            Argument::Value(operand) => matches!(operand, Operand::Constant(_)),
            Argument::Exclusive(place) | Argument::Reborrow(place) => !self.vars[place.root].active,
            Argument::Borrow(_)
            | Argument::Receiver(_)
            | Argument::Function(_)
            | Argument::Callee(_)
            | Argument::PassedOn(..) => false,
        });
        if constant {
            let tokens: Vec<_> = arguments.iter().map(|a| self.argument_tokens(a)).collect();
            let value = match (method, &tokens[..]) {
                (true, [receiver, arguments @ ..]) => {
                    quote!(#receiver.#primal(#(#arguments),*))
                }
                (_, arguments) => quote!(#primal(#(#arguments),*)),
            };
            let changes = |argument: &Argument| {
                matches!(argument, Argument::Exclusive(_) | Argument::Reborrow(_))
            };
            if !arguments.iter().any(changes) {
                return Operand::Constant(value);
            }
            // What it changes is read before and after: it has its place among the statements.
            let operation = Operation::Use(Operand::Constant(value));
            let value = self.define(hint, span, false, operation);
            let ident = self.ident(value);
            return Operand::Constant(quote!(#ident));
        }
        let called = usize::from(matches!(arguments.first(), Some(Argument::Callee(_))));
        self.passes_functions |=
            arguments[called..].iter().any(|argument| Primal(&self.vars).is_function(argument));
        let operation = Operation::Call { primal, vjp, method, arguments };
        Operand::Var(self.define(hint, span, true, operation))
    }
}

/// `Box::new`
fn is_box_new(path: &Path) -> bool {
    let mut segments = path.segments.iter().rev();
    segments.next().is_some_and(|last| last.ident == "new")
        && segments.next().is_some_and(|owner| owner.ident == "Box")
}

/// Comparisons, tests and what makes texts, by the names that glam and the standard library give
/// them. That the result has no derivative is checked by its type.
pub(super) fn is_predicate(name: &str) -> bool {
    name.starts_with("is_")
        || matches!(name, "len" | "to_string")
        || matches!(name, "cmplt" | "cmple" | "cmpgt" | "cmpge" | "cmpeq" | "cmpne")
        || matches!(name, "cmp" | "partial_cmp" | "total_cmp")
        || matches!(name, "lt" | "le" | "gt" | "ge" | "eq" | "ne" | "all" | "any")
}

/// Methods that are given a comparison.
fn is_comparing(name: &str) -> bool {
    matches!(name, "sort_by" | "sort_unstable_by")
}

/// The derivative of a function of the standard library.
fn known_vjp(path: &Path) -> Option<TokenStream> {
    let mut segments = path.segments.iter().rev();
    let name = &segments.next()?.ident;
    let is_known = segments.next()?.ident == "mem"
        && ["swap", "replace", "take"].iter().any(|known| name == known);
    is_known.then(|| quote!(::ad::rules::replace::#name::vjp))
}

/// Whether a path leads to a function of a type.
fn is_associated(function: &ExprPath) -> bool {
    function.qself.is_some()
        || function.path.segments.iter().rev().nth(1).is_some_and(|owner| {
            is_type_name(&owner.ident) || owner.ident == "f32" || owner.ident == "f64"
        })
}

/// The type that has the derivatives of a function that is not associated.
fn twin_of(function: &ExprPath) -> Option<TokenStream> {
    if is_associated(function) {
        return None;
    }
    let mut path = function.path.clone();
    path.segments.last_mut()?.arguments = PathArguments::None;
    Some(quote!(#path))
}

/// The path of the derivative: `Type::f_vjp` for an associated function, `f::vjp` for another.
pub(super) fn vjp_of(function: &ExprPath) -> TokenStream {
    let path = &function.path;
    let mut segments: Vec<_> = path.segments.iter().cloned().collect();
    let Some(last) = segments.last_mut() else { return quote!(#function) };
    let arguments = std::mem::replace(&mut last.arguments, PathArguments::None);
    if is_associated(function) {
        last.ident = format_ident!("{}_vjp", last.ident);
        last.arguments = arguments;
        if let Some(qself) = &function.qself {
            // The derivative may come from another trait than the function.
            let (ty, name) = (&qself.ty, segments.last());
            return quote!(<#ty>::#name);
        }
        let leading = &path.leading_colon;
        return quote!(#leading #(#segments)::*);
    }
    let leading = &path.leading_colon;
    let turbofish = match &arguments {
        PathArguments::AngleBracketed(arguments) => {
            let mut arguments = arguments.clone();
            arguments.colon2_token = Some(Default::default());
            quote!(#arguments)
        }
        _ => TokenStream::new(),
    };
    quote!(#leading #(#segments)::*::vjp #turbofish)
}
