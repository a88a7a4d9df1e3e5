//! Functions as values: closures that are passed to functions, and parameters that are functions.
//!
//! A closure that is passed is a function of its own, whose first parameters are references to what
//! it captures. It is lowered as such, into a [`Closure`](crate::ir::Closure) that the sweep makes an
//! object of (see `ad::function`).

use std::collections::HashMap;
use std::rc::Rc;

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Expr, ExprClosure, Pat, PatType, ReturnType, Type, UnOp, parse_quote};

use super::closure::changes_captured;
use super::macros::captured_names;
use crate::ir;
use crate::ir::{
    Argument, Callee, Derivative, Operand, Operation, Place, Projection, TypedBy, VarId,
};
use crate::lower::rewrite::told;
use crate::lower::scopes::Scopes;
use crate::lower::state::{Alias, Closure};
use crate::lower::syntax::{as_statements, is_type_name, simple_name, strip_parens};
use crate::lower::{Lowerer, OnFailure};
use crate::names;
use crate::parse::signature::Parameter;

/// The function that passes references on, which methods have none of.
fn passed_on(typed_by: Option<TypedBy>) -> Option<TypedBy> {
    typed_by.filter(|typed_by| typed_by.method.is_none())
}

/// What a closure uses of the function around it.
#[derive(Default)]
struct Captured {
    vars: Vec<VarId>,
    closures: Vec<(VarId, Rc<Closure>)>,
}

impl Lowerer<'_> {
    /// What a call is given, if it is a function.
    pub(super) fn function_argument(
        &mut self,
        expr: &Expr,
        typed_by: Option<TypedBy>,
    ) -> Option<Argument> {
        let (value, is_borrowed) = match strip_parens(expr) {
            Expr::Reference(reference) if reference.mutability.is_none() => {
                (strip_parens(&reference.expr), true)
            }
            Expr::Reference(reference) if self.is_function(&reference.expr) => {
                self.refuse(
                    expr,
                    "a function is not passed behind a `&mut`: pass a closure that calls it, `|x| f(x)`",
                );
                return None;
            }
            expr => (expr, false),
        };
        let named = self.function_of_name(value);
        let value = named.as_ref().unwrap_or(value);
        let object = match (self.named_closure(value), value) {
            (Some(closure), _) => self.object(&closure.body, &closure.scopes, typed_by.clone()),
            (None, Expr::Closure(closure)) => {
                let scopes = self.scopes.clone();
                self.object(closure, &scopes, typed_by.clone())
            }
            (None, Expr::Path(path)) if self.is_named_function(path) => {
                self.check_attribute(path);
                let derivative = self.derivative_of(path);
                let operation = Operation::Named { primal: quote!(#path), derivative };
                self.define("function", path.span(), true, operation)
            }
            (None, Expr::Path(path)) => {
                let function = self.variable(path)?;
                if !self.functions.contains_key(&function) {
                    return None;
                }
                let place = self.function_place(function);
                if is_borrowed || self.is_reference(value) || self.may_refer(function) {
                    return passed_on(typed_by).map(|by| Argument::PassedOn(place, by));
                }
                self.again(place, path.span())
            }
            // A copy of what is behind a reference.
            (None, Expr::Unary(unary)) if matches!(unary.op, UnOp::Deref(_)) && !is_borrowed => {
                let Expr::Path(path) = strip_parens(&unary.expr) else { return None };
                let function = self.variable(path)?;
                if !self.functions.contains_key(&function) {
                    return None;
                }
                let place = self.function_place(function);
                self.again(place, path.span())
            }
            _ => return None,
        };
        self.vars[object].is_function = true;
        let place = Place::of(object);
        Some(match (is_borrowed, passed_on(typed_by)) {
            (true, Some(by)) => Argument::PassedOn(place, by),
            (true, None) => Argument::Borrow(place),
            (false, _) => Argument::Function(object),
        })
    }

    /// Whether an expression is a closure, or a parameter that is a function.
    fn is_function(&self, expr: &Expr) -> bool {
        let expr = strip_parens(expr);
        matches!(expr, Expr::Closure(_))
            || self.named_closure(expr).is_some()
            || self.function_parameter(expr).is_some()
    }

    /// A parameter that is a function, to be passed on.
    fn again(&mut self, function: Place, span: proc_macro2::Span) -> VarId {
        let arguments = vec![Argument::Callee(function)];
        let callee = of_function_module(format_ident!("again"));
        let operation = Operation::Call { callee, arguments };
        self.define("function", span, true, operation)
    }

    /// Whether a path that is passed leads to a function: what else is no variable has a name in
    /// capitals.
    pub fn is_named_function(&self, path: &syn::ExprPath) -> bool {
        let is_local = self.variable(path).is_some();
        let last = path.path.segments.last();
        !is_local && last.is_some_and(|last| !is_type_name(&last.ident))
    }

    /// `let name = function;`, if what is named leads to a function.
    pub fn function_local(&mut self, name: &syn::Ident, function: &syn::ExprPath) {
        let var = self.unwritten_var(name, false, false);
        self.function_names.insert(var, Expr::Path(function.clone()));
        self.alias(name, var);
    }

    /// The function that a variable stands for.
    pub fn function_of_name(&self, expr: &Expr) -> Option<Expr> {
        let Expr::Path(path) = strip_parens(expr) else { return None };
        self.function_names.get(&self.variable(path)?).cloned()
    }

    /// The call of a parameter that is a function.
    pub(super) fn call_of_parameter(
        &mut self,
        call: &syn::ExprCall,
        function: VarId,
        arity: usize,
        hint: &str,
    ) -> Operand {
        if call.args.len() != arity {
            return self.refuse(call, "the function is given another number of arguments");
        }
        let mut arguments = vec![Argument::Callee(self.function_place(function))];
        arguments.extend(call.args.iter().enumerate().map(|(index, argument)| {
            let value = self.argument(argument);
            self.argument_in_turn(value, argument, call.args.iter().skip(index + 1))
        }));
        let hint = match hint {
            "value" => self.ident(function).to_string(),
            hint => hint.to_owned(),
        };
        let callee = of_function_module(format_ident!("call_{arity}"));
        self.finish_call(callee, arguments, &hint, call.span())
    }

    /// The number of arguments of a parameter that is a function, and a reference to it.
    pub fn function_parameter(&self, expr: &Expr) -> Option<(usize, TokenStream)> {
        let Expr::Path(path) = strip_parens(expr) else { return None };
        let var = self.variable(path)?;
        let arity = *self.functions.get(&var)?;
        let place = self.place_tokens(&self.function_place(var));
        Some((arity, quote!(&#place)))
    }

    /// The same where no derivative flows; the arguments have been renamed.
    pub fn plain_call_of_parameter(&mut self, call: &syn::ExprCall) -> Expr {
        let Some((arity, function)) = self.function_parameter(&call.func) else {
            unreachable!("the caller has asked for it");
        };
        let (callee, arguments) = (format_ident!("call_{arity}"), &call.args);
        if arguments.len() != arity {
            self.refuse(call, "the function is given another number of arguments");
        }
        parse_quote!(::ad::function::#callee(#function, #arguments))
    }

    fn function_place(&self, function: VarId) -> Place {
        match (self.aliases.get(&function), self.may_refer(function)) {
            (Some(alias), _) => alias.place.clone(),
            (None, true) => Place { root: function, path: vec![Projection::Deref] },
            (None, false) => Place::of(function),
        }
    }

    /// A closure as an object with a derivative.
    fn object(
        &mut self,
        closure: &ExprClosure,
        scopes: &Scopes,
        typed_by: Option<TypedBy>,
    ) -> VarId {
        if let Some(token) = &closure.asyncness {
            self.refuse(token, "asynchronous code has no derivative");
        }
        if changes_captured(closure) {
            self.refuse(
                closure,
                "a closure that changes a variable cannot be passed to a function: let it return what it computes",
            );
        }
        let is_typed = closure.inputs.iter().all(|input| typed(input).is_some());
        let mut arguments = Vec::new();
        for input in &closure.inputs {
            match typed(input) {
                Some(input) => arguments.push(self.closure_argument(&input.pat, &input.ty)),
                None if typed_by.is_some() => {
                    arguments.push(self.closure_argument(input, &parse_quote!(_)));
                }
                None => {
                    self.refuse(
                        input,
                        "the parameters of a closure that is passed to an associated function need types: `|x: f64|`",
                    );
                }
            }
        }
        let mut captured = Captured::default();
        self.capture(closure, scopes, &mut captured);
        // A closure calls those that were written before it.
        captured.closures.sort_by_key(|(var, _)| *var);

        let mut captures = Vec::new();
        let mut parameters = Vec::new();
        for &var in &captured.vars {
            let outer = self.ident(var).clone();
            let ident = self.names.fresh(&outer.to_string(), outer.span());
            let place = match self.aliases.get(&var) {
                Some(alias) => alias.place.clone(),
                None => Place::of(var),
            };
            let copy = self.place_tokens(&place);
            let may_be_shared = !self.vars[var].active && !self.functions.contains_key(&var);
            let captured = match may_be_shared {
                true => quote_spanned!(outer.span()=>
                    { ::ad::rt::shared_by_a_copy(&#copy); (#copy).to_owned() }),
                false => quote!((#copy).to_owned()),
            };
            captures.push((captured, place));
            parameters.push(Parameter {
                ident,
                pattern: None,
                ty: parse_quote!(&_),
                is_exclusive: false,
                is_shared: true,
                is_mutable_receiver: false,
                arity: self.functions.get(&var).copied(),
                is_constant: false,
            });
        }
        let function = self.object_function(closure, scopes, &captured, &parameters, &arguments);
        parameters.extend(arguments.into_iter().map(|(parameter, _)| parameter));
        let typed_by = typed_by.filter(|_| !is_typed);
        let object = ir::Closure { captures, parameters, function, typed_by };
        self.define("function", closure.span(), true, Operation::Closure(Box::new(object)))
    }

    /// The body of a closure, as that of a function of what it captures and its arguments.
    fn object_function(
        &mut self,
        closure: &ExprClosure,
        scopes: &Scopes,
        captured: &Captured,
        parameters: &[Parameter],
        arguments: &[(Parameter, Pat)],
    ) -> ir::Lowered {
        // What was a reference is one within, too; a value is the place behind one.
        let depth = |var: &VarId| match self.aliases.get(var) {
            Some(alias) => alias.depth,
            None => usize::from(self.vars[*var].exclusive || self.may_refer(*var)),
        };
        let depths: Vec<_> = captured.vars.iter().map(depth).collect();
        let mut inner =
            Lowerer::new(OnFailure::of_closure(&closure.output), self.names, self.errors);
        inner.is_object = true;
        inner.variants = self.variants.clone();
        inner.scalars = self.scalars.clone();
        inner.local_functions = self.local_functions.clone();
        inner.exclusive_methods = self.exclusive_methods.clone();
        inner.called = std::mem::take(&mut self.called);
        let mut vars = Vec::new();
        let body = inner.block(|inner| {
            let mut meanings = HashMap::new();
            for ((parameter, &outer), depth) in parameters.iter().zip(&captured.vars).zip(depths) {
                let var = inner.parameter_var(parameter);
                let is_active = match self.aliases.get(&outer) {
                    Some(alias) => self.vars[alias.place.root].active,
                    None => self.vars[outer].active,
                };
                inner.vars[var].active = is_active;
                vars.push(var);
                let place = Place { root: var, path: vec![Projection::Deref] };
                let alias = inner.unwritten_var(&parameter.ident, false, is_active);
                inner.aliases.insert(alias, Alias { place, depth, is_exclusive: false });
                inner.functions.extend(self.functions.get(&outer).map(|&arity| (alias, arity)));
                inner.lengths.extend(self.lengths.get(&outer).map(|&length| (alias, length)));
                inner.containers.extend(self.containers.get(&outer).map(|&c| (alias, c)));
                meanings.insert(outer, alias);
            }
            for (outer, closure) in &captured.closures {
                let scopes = closure.scopes.renamed(&meanings);
                let body = closure.body.clone();
                let var = inner.unwritten_var(&format_ident!("closure"), false, false);
                inner.closures.insert(var, Rc::new(Closure { body, scopes }));
                meanings.insert(*outer, var);
            }
            let outside = std::mem::replace(&mut inner.scopes, scopes.renamed(&meanings));
            inner.scopes.open();
            for (argument, pattern) in arguments {
                let var = inner.parameter_var(argument);
                vars.push(var);
                let value = inner.operand_of(var);
                inner.bind_pattern(pattern, None, value);
            }
            let mut statements = as_statements(&closure.body);
            if let ReturnType::Type(_, ty) = &closure.output {
                statements = told::statements(statements, ty);
            }
            let value = inner.function_body(statements);
            inner.scopes = outside;
            match &closure.output {
                ReturnType::Default => value,
                ReturnType::Type(_, ty) => inner.typed(value, ty),
            }
        });
        let all: Vec<_> = parameters
            .iter()
            .chain(arguments.iter().map(|(argument, _)| argument))
            .cloned()
            .collect();
        let mut function = inner.finished(&all, &vars, body);
        self.called = std::mem::take(&mut function.called);
        // The function around it brings what has gathered to its size.
        function.parameters.iter_mut().take(parameters.len()).for_each(|p| p.has_shape = false);
        function
    }

    fn closure_argument(&mut self, pat: &Pat, ty: &Type) -> (Parameter, Pat) {
        let name = simple_name(pat).map_or("argument".to_owned(), ToString::to_string);
        let is_shared = match ty {
            Type::Reference(reference) => {
                if let Some(token) = &reference.mutability {
                    self.refuse(
                        token,
                        "a function that is passed cannot take a `&mut`: let it return what it computes",
                    );
                }
                true
            }
            _ => false,
        };
        let parameter = Parameter {
            ident: self.names.fresh(&name, pat.span()),
            pattern: None,
            ty: ty.clone(),
            is_exclusive: false,
            is_shared,
            is_mutable_receiver: false,
            arity: None,
            is_constant: false,
        };
        (parameter, pat.clone())
    }

    /// Looks for the variables that a closure uses, and those that closures use which it calls.
    fn capture(&self, closure: &ExprClosure, scopes: &Scopes, into: &mut Captured) {
        let mut used = names::identifiers(closure.to_token_stream());
        used.extend(captured(closure.to_token_stream()));
        used.sort();
        for name in used {
            let Some(var) = scopes.lookup(&name) else { continue };
            if let Some(called) = self.closures.get(&var) {
                if into.closures.iter().all(|(known, _)| *known != var) {
                    into.closures.push((var, called.clone()));
                    self.capture(&called.body, &called.scopes, into);
                }
            } else if !into.vars.contains(&var) {
                into.vars.push(var);
            }
        }
    }
}

/// A function of `ad::function`, with its derivative.
fn of_function_module(name: Ident) -> Callee {
    let owner = quote!(::ad::function::);
    Callee {
        primal: quote!(#owner #name),
        derivative: Derivative::Sibling { owner, name, turbofish: None },
        is_method: false,
        may_have_rule: false,
    }
}

fn typed(pat: &Pat) -> Option<&PatType> {
    match pat {
        Pat::Type(typed) => Some(typed),
        Pat::Paren(inner) => typed(&inner.pat),
        _ => None,
    }
}

/// The names that format strings name.
fn captured(tokens: TokenStream) -> Vec<Ident> {
    let within = |token| match token {
        TokenTree::Group(group) => captured(group.stream()),
        TokenTree::Literal(literal) => {
            let span = literal.span();
            match syn::Lit::new(literal) {
                syn::Lit::Str(text) => captured_names(&text.value(), span),
                _ => Vec::new(),
            }
        }
        TokenTree::Ident(_) | TokenTree::Punct(_) => Vec::new(),
    };
    tokens.into_iter().flat_map(within).collect()
}
