//! Calls of functions and methods, and what they are given.

pub mod callee;
pub mod closure;
pub mod comparison;
pub mod function;
pub mod higher;
pub mod links;
pub mod macros;
pub mod own_methods;

use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};
use syn::Expr;
use syn::spanned::Spanned;

use self::callee::{is_box_new, is_from_fn, is_swap, is_taken, makes_room};
use self::higher::{refused_function, refused_method};
use super::Lowerer;
use super::place::apart::{are_other_fields, overlap};
use super::plain::hidden::decodes;
use super::plain::no_diff::{stopped, undifferentiated};
use super::syntax::{is_type_name, makes_value, strip_parens};
use crate::ir::primal::Primal;
use crate::ir::{
    Argument, Callee, Derivative, Operand, Operation, Place, Projection, Statement, TypedBy,
};
use crate::rules;

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
                true => Argument::Reborrow(place),
                false => Argument::Borrow(place),
            };
        }
        if let Some(element) = self.shared_element(expr) {
            return Argument::Borrow(element);
        }
        let Expr::Reference(reference) = expr else {
            // A `&mut` parameter is passed on by reborrowing what it refers to.
            let is_exclusive = |lowerer: &Self, place: &Place| {
                place.path.is_empty() && lowerer.vars[place.root].exclusive
            };
            return match self.place_if(expr, is_exclusive) {
                Some(mut place) => {
                    place.path.push(Projection::Deref);
                    Argument::Reborrow(place)
                }
                None => Argument::Value(self.operand(expr, "argument")),
            };
        };
        if reference.mutability.is_some() {
            if makes_value(&reference.expr) {
                return self.exclusive_value(&reference.expr);
            }
            return match self.target(&reference.expr) {
                Some(place) => Argument::Exclusive(place),
                None => Argument::Value(Self::unit()),
            };
        }
        match self.place(&reference.expr) {
            Some(place) if self.vars[place.root].active => return Argument::Borrow(place),
            Some(place) => {
                let place = self.place_tokens(&place);
                return Argument::Value(Operand::Constant(quote!((&#place))));
            }
            None => {}
        }
        let target = self.operand(&reference.expr, "target");
        match self.kept(target, &reference.expr) {
            Operand::Constant(tokens) => Argument::Value(Operand::Constant(quote!((&#tokens)))),
            Operand::Var(root) => Argument::Borrow(Place::of(root)),
        }
    }

    /// `&mut value`
    fn exclusive_value(&mut self, expr: &Expr) -> Argument {
        let value = self.operand(expr, "value");
        let place = self.changeable(value, "value", expr.span());
        // What begins with numbers may be given others.
        self.vars[place.root].active |= is_of_numbers(expr);
        Argument::Exclusive(place)
    }

    /// A value that nothing else names, as a variable that may be changed.
    pub(super) fn changeable(&mut self, value: Operand, hint: &str, span: Span) -> Place {
        let ident = self.names.fresh(hint, span);
        let root = self.var(ident, true, matches!(value, Operand::Var(_)));
        self.push(Statement::Define { var: root, ty: None, operation: Operation::Use(value) });
        Place::of(root)
    }

    pub(super) fn argument_tokens(&self, argument: &Argument) -> TokenStream {
        Primal(&self.vars).argument(argument)
    }

    pub(super) fn call(&mut self, call: &syn::ExprCall, hint: &str) -> Operand {
        if let Expr::Closure(_) = strip_parens(&call.func) {
            let given = self.all_given(call);
            return self.apply(&call.func, given);
        }
        let Expr::Path(function) = strip_parens(&call.func) else {
            return self.refuse(
                &call.func,
                "only functions called by name can be differentiated: write a `#[differentiable]` function",
            );
        };
        let path = &function.path;
        if let Some(name) = path.get_ident() {
            if let Some(function) = self.function_of_name(&call.func) {
                let func = Box::new(function);
                return self.call(&syn::ExprCall { func, ..call.clone() }, hint);
            }
            if self.named_closure(&call.func).is_some() {
                let given = self.all_given(call);
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
        if stopped(call).is_some() {
            let expr = Expr::Call(call.clone());
            let tokens = self.plain(&expr);
            return self.settled(&expr, tokens);
        }
        if let Some(closure) = undifferentiated(call) {
            return Operand::Constant(self.no_diff(&call.func, closure));
        }
        if is_taken(path)
            && let Some(Expr::Path(kind)) = call.args.first()
            && let Some(Expr::Reference(element)) = call.args.last()
            && let Some(place) = self.place(&element.expr)
        {
            return self.clone_place(place, self.variable(kind), hint);
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
        if makes_room(path)
            && let Some(length) = call.args.first()
        {
            let length = self.operand(length, "length");
            let length = self.without_derivative(&length);
            return Operand::Constant(quote!(#function(#length)));
        }

        let derivative = self.derivative_of(function);
        let twin = match &derivative {
            Derivative::Twin { ty, is_of_attribute: true, .. } => Some(ty.clone()),
            _ => None,
        };
        let arguments = call.args.iter().enumerate().map(|(index, argument)| {
            let typed_by = twin.clone().map(|function| TypedBy { function, method: None, index });
            let value = self.argument_of(argument, typed_by);
            self.argument_in_turn(value, argument, call.args.iter().skip(index + 1))
        });
        let mut arguments: Vec<_> = arguments.collect();
        if is_swap(path)
            && let Some(value) = self.swap_elements(call, &arguments)
        {
            return value;
        }
        self.check_apart(call, &arguments);
        if !self.is_constant_call(&arguments) {
            self.check_attribute(function);
            self.check_constants(&mut arguments, &call.args);
        }
        let hint = if hint == "value" { last.ident.to_string() } else { hint.to_owned() };
        let primal = quote!(#function);
        let callee = Callee { primal, derivative, is_method: false, may_have_rule: false };
        self.finish_call(callee, arguments, &hint, call.span())
    }

    pub(super) fn method_call(&mut self, call: &syn::ExprMethodCall, hint: &str) -> Operand {
        let is_own = self.calls_own_methods(&call.receiver);
        let is_certainly_own = self.certainly_calls_own_methods(&call.receiver);
        let special = match is_own {
            true => None,
            false => self
                .lent(call, hint)
                .or_else(|| self.consumed(call, hint))
                .or_else(|| self.optional(call, hint))
                .or_else(|| self.mapped(call, hint)),
        };
        // Ranges and iterators are given to nothing else.
        let special = special.or_else(|| self.ranged(call, hint)).or_else(|| self.extended(call));
        if let Some(value) = special {
            return value;
        }
        let name = call.method.to_string();
        let whole = Expr::MethodCall(call.clone());
        if is_predicate(&name) && !self.is_change(&whole) {
            return self.discrete(&whole);
        }
        if let Some(message) = refused_method(&call.method) {
            return self.refuse(&call.method, message);
        }
        // What a method gives may be the guard of a cell.
        if let Expr::MethodCall(_) = strip_parens(&call.receiver) {
            self.check_cells(&whole, self.scopes.count());
        }
        let receiver = self.receiver(call);
        let receiver = self.argument_in_turn(receiver, &call.receiver, &call.args);
        if !is_own
            && matches!(&*name, "iter" | "iter_mut" | "into_iter")
            && !self.is_constant_call(std::slice::from_ref(&receiver))
        {
            return self.refuse_iterator(call);
        }
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
        let carries = !self.is_constant_call(&arguments);
        arguments.extend(call.args.iter().enumerate().map(|(index, argument)| {
            if !is_certainly_own
                && let Some(decides) = self.deciding(call, argument, (&called, carries))
            {
                return decides;
            }
            let typed_by = TypedBy {
                function: called.clone(),
                method: Some(call.method.clone()),
                index: index + 1,
            };
            let value = self.argument_of(argument, Some(typed_by));
            self.argument_in_turn(value, argument, call.args.iter().skip(index + 1))
        }));
        if called_on.is_some() {
            self.called_on.pop();
        }
        // What an argument refers to, the method cannot change.
        if let (Some(_), Argument::Receiver(receiver)) = (called_on, &arguments[0])
            && arguments[1..].iter().any(|argument| {
                matches!(argument, Argument::Borrow(place)
                    if place.root == receiver.root && !are_other_fields(place, receiver))
            })
        {
            arguments[0] = Argument::Borrow(receiver.clone());
        }
        if !self.is_constant_call(&arguments) {
            let written = std::iter::once(&*call.receiver).chain(&call.args);
            self.check_constants(&mut arguments, written);
        }
        self.check_apart(call, &arguments);
        let hint = if hint == "value" { name } else { hint.to_owned() };
        let turbofish = call.turbofish.as_ref().map(ToTokens::to_token_stream);
        let mut callee = Callee::method(&call.method, turbofish);
        callee.may_have_rule &= !is_own;
        let is_clone = callee.name().is_some_and(|name| name == "clone") && arguments.len() == 1;
        let value = self.finish_call(callee, arguments, &hint, call.span());
        if let (true, Operand::Var(copy)) = (is_clone, &value) {
            let copy = self.ident(*copy);
            let code = quote_spanned!(call.span()=> ::ad::check_clone!(#called, #copy););
            self.push_plain(code);
        }
        value
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
        self.push_plain(code);
    }

    /// Whether no derivative flows into a call.
    fn is_constant_call(&self, arguments: &[Argument]) -> bool {
        arguments.iter().all(|argument| match argument {
            Argument::Value(operand) => matches!(operand, Operand::Constant(_)),
            argument => argument.changeable().is_some_and(|place| !self.vars[place.root].active),
        })
    }

    /// A `&mut` that a call is passed by its name, beside itself or a part of it, is taken as `&`, and so is what the call
    /// is on: nothing else would be allowed.
    fn share_repeated(arguments: &mut [Argument]) {
        let place = |argument: &Argument| match argument {
            Argument::Reborrow(place) | Argument::Borrow(place) | Argument::Receiver(place) => {
                Some(place.clone())
            }
            _ => None,
        };
        let places: Vec<_> = arguments.iter().map(place).collect();
        for (index, argument) in arguments.iter_mut().enumerate() {
            let (Argument::Reborrow(own) | Argument::Receiver(own)) = argument else { continue };
            let others = places.iter().enumerate().filter(|(other, _)| *other != index);
            if others.filter_map(|(_, place)| place.as_ref()).any(|place| overlap(own, place)) {
                *argument = Argument::Borrow(own.clone());
            }
        }
    }

    pub(super) fn finish_call(
        &mut self,
        callee: Callee,
        mut arguments: Vec<Argument>,
        hint: &str,
        span: proc_macro2::Span,
    ) -> Operand {
        Self::share_repeated(&mut arguments);
        if self.is_constant_call(&arguments) {
            let tokens: Vec<_> = arguments.iter().map(|a| self.argument_tokens(a)).collect();
            if callee.name().is_some_and(decodes) {
                self.check_decoded(&quote!(#(#tokens)*), &callee.primal);
            }
            let primal = &callee.primal;
            let value = match (callee.is_method, &tokens[..]) {
                (true, [receiver, arguments @ ..]) => {
                    quote!(#receiver.#primal(#(#arguments),*))
                }
                (_, arguments) => quote!(#primal(#(#arguments),*)),
            };
            let changes = |argument: &Argument| {
                matches!(argument, Argument::Exclusive(_) | Argument::Reborrow(_))
            };
            if !arguments.iter().any(changes) {
                return match self.is_text_of_active(&quote!(#(#tokens)*)) {
                    true => self.check_read(value, hint, span),
                    false => Operand::Constant(value),
                };
            }
            // What it changes is read before and after: it has its place among the statements.
            return Operand::Constant(self.named_tokens(hint, span, value));
        }
        if let Some(name) =
            callee.name().filter(|name| !rules::is_for_every_type(&name.to_string()))
        {
            let is_function =
                |(_, argument): &(usize, &Argument)| Primal(&self.vars).is_function(argument);
            let functions = arguments.iter().enumerate().filter(is_function);
            self.called.method(name, functions.map(|(index, _)| index));
        }
        let called = usize::from(matches!(arguments.first(), Some(Argument::Callee(_))));
        self.passes_functions |=
            arguments[called..].iter().any(|argument| Primal(&self.vars).is_function(argument));
        let may_refer = self.may_give_reference(&callee, &arguments);
        let operation = Operation::Call { callee, arguments };
        let value = self.define(hint, span, true, operation);
        self.vars[value].reference = may_refer;
        Operand::Var(value)
    }

    /// Whether what a call gives may hold a reference to a number.
    fn may_give_reference(&self, callee: &Callee, arguments: &[Argument]) -> bool {
        const LENDING: [&str; 8] =
            ["get", "first", "last", "split_first", "split_last", "as_ref", "as_deref", "as_slice"];
        const HANDING_ON: [&str; 6] = ["unwrap", "expect", "unwrap_or", "or", "xor", "flatten"];
        let is_one_of = |names: &[&str]| {
            callee.name().is_some_and(|name| names.iter().any(|known| name == known))
        };
        is_one_of(&LENDING)
            || is_one_of(&HANDING_ON)
                && matches!(arguments.first(), Some(Argument::Value(Operand::Var(var)))
                    if self.vars[*var].reference)
    }
}

/// Comparisons, tests and what makes texts, by the names that glam and the standard library give
/// them. That the result has no derivative is checked by its type.
pub(super) fn is_predicate(name: &str) -> bool {
    name.starts_with("is_")
        || matches!(name, "len" | "to_string" | "max_position" | "min_position")
        || matches!(name, "cmplt" | "cmple" | "cmpgt" | "cmpge" | "cmpeq" | "cmpne")
        || matches!(name, "cmp" | "partial_cmp" | "total_cmp")
        || matches!(name, "lt" | "le" | "gt" | "ge" | "eq" | "ne" | "all" | "any")
        || matches!(name, "partition_point" | "contains" | "starts_with" | "ends_with")
        || name.starts_with("binary_search")
}

/// Whether an expression is certainly a number, or an array of numbers.
fn is_of_numbers(expr: &Expr) -> bool {
    match strip_parens(expr) {
        Expr::Lit(literal) => matches!(literal.lit, syn::Lit::Int(_) | syn::Lit::Float(_)),
        Expr::Cast(_) => true,
        Expr::Unary(unary) => is_of_numbers(&unary.expr),
        Expr::Binary(binary) => is_of_numbers(&binary.left),
        Expr::Repeat(repeat) => is_of_numbers(&repeat.expr),
        Expr::Array(array) => array.elems.first().is_some_and(is_of_numbers),
        _ => false,
    }
}
