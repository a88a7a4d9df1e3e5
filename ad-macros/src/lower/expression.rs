//! Expressions: names every intermediate result through which a derivative flows.

use proc_macro2::TokenStream;
use quote::{format_ident, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{BinOp, Expr, ExprBinary, ExprPath, Member, Path, PathArguments, Type, UnOp};

use super::Lowerer;
use super::array::is_from_fn;
use super::ends::End;
use super::higher::{refused_function, refused_method};
use super::no_diff::undifferentiated;
use crate::ir::{Argument, BinaryOperator, Operand, Operation, Projection, Shape, Statement};

impl Lowerer<'_> {
    /// Evaluates an expression. A new variable for the result, if one is needed, is named after
    /// `hint`.
    pub(super) fn operand(&mut self, expr: &Expr, hint: &str) -> Operand {
        match expr {
            Expr::Lit(literal) => Operand::Constant(quote!(#literal)),
            Expr::Paren(inner) => self.operand(&inner.expr, hint),
            Expr::Group(inner) => self.operand(&inner.expr, hint),
            Expr::Path(_) | Expr::Field(_) | Expr::Index(_) => self.read(expr, hint),
            Expr::Unary(unary) => match unary.op {
                UnOp::Deref(_) => self.read(expr, hint),
                UnOp::Neg(_) => self.negate(&unary.expr, hint, expr),
                _ => self.discrete(expr),
            },
            Expr::Binary(binary) => self.binary(binary, hint),
            Expr::Cast(cast) => self.cast(cast, hint),
            Expr::Call(call) => self.call(call, hint),
            Expr::MethodCall(call) => self.method_call(call, hint),
            Expr::Tuple(tuple) => {
                let parts = self.operands(&tuple.elems);
                let tokens = parts.iter().map(|part| self.tokens(part));
                let expression = quote!((#(#tokens,)*));
                self.aggregate(expression, Shape::Tuple, numbered(parts), hint, expr.span())
            }
            Expr::Array(array) => {
                let parts = self.operands(&array.elems);
                let tokens = parts.iter().map(|part| self.tokens(part));
                let expression = quote!([#(#tokens),*]);
                self.aggregate(expression, Shape::Array, numbered(parts), hint, expr.span())
            }
            Expr::Repeat(repeat) => {
                let length = &repeat.len;
                let length = quote!(#length);
                match self.operand(&repeat.expr, "element") {
                    Operand::Constant(tokens) => Operand::Constant(quote!([#tokens; #length])),
                    Operand::Var(value) => {
                        let operation = Operation::Repeat { value, length, is_vec: false };
                        Operand::Var(self.define(hint, expr.span(), true, operation))
                    }
                }
            }
            Expr::Macro(call) => self.macro_call(&call.mac, hint),
            Expr::Struct(literal) => self.struct_literal(literal, hint),
            Expr::Reference(reference) => self.reference(reference, hint),
            Expr::Block(block) => self.a_block(block, &End::default()),
            Expr::Loop(_) => self.loop_value(expr),
            Expr::If(_) | Expr::Match(_) => self.branch_value(expr, &mut |lowerer, body| {
                lowerer.scope(|lowerer| lowerer.operand(body, "value"))
            }),
            Expr::Range(range) => {
                self.refuse(range, "a range has no derivative: use it as the head of a `for` loop")
            }
            // The last statement of a block, or the body of an arm.
            Expr::Assign(_) | Expr::ForLoop(_) | Expr::While(_) => self.unit_expression(expr),
            other => self.refuse_expression(other),
        }
    }

    /// An expression that is written for its effect on variables.
    fn unit_expression(&mut self, expr: &Expr) -> Operand {
        self.expression_statement(expr);
        Self::unit()
    }

    pub(super) fn operands<'e>(
        &mut self,
        exprs: impl IntoIterator<Item = &'e Expr>,
    ) -> Vec<Operand> {
        exprs.into_iter().map(|expr| self.operand(expr, "value")).collect()
    }

    fn negate(&mut self, inner: &Expr, hint: &str, whole: &Expr) -> Operand {
        match self.scalar(inner, "value") {
            Operand::Constant(tokens) => Operand::Constant(quote!((-#tokens))),
            Operand::Var(var) => {
                let var = self.number(var);
                Operand::Var(self.define(hint, whole.span(), true, Operation::Negate(var)))
            }
        }
    }

    fn binary(&mut self, binary: &ExprBinary, hint: &str) -> Operand {
        let (operator, default_hint) = match binary.op {
            BinOp::Add(_) => (BinaryOperator::Add, "sum"),
            BinOp::Sub(_) => (BinaryOperator::Sub, "difference"),
            BinOp::Mul(_) => (BinaryOperator::Mul, "product"),
            BinOp::Div(_) => (BinaryOperator::Div, "quotient"),
            BinOp::Rem(_) => (BinaryOperator::Rem, "remainder"),
            BinOp::Eq(_)
            | BinOp::Ne(_)
            | BinOp::Lt(_)
            | BinOp::Le(_)
            | BinOp::Gt(_)
            | BinOp::Ge(_)
            | BinOp::And(_)
            | BinOp::Or(_) => {
                let expr = Expr::Binary(binary.clone());
                let tokens = self.plain(&expr);
                return self.settled(&expr, quote!((#tokens)));
            }
            BinOp::BitAnd(_)
            | BinOp::BitOr(_)
            | BinOp::BitXor(_)
            | BinOp::Shl(_)
            | BinOp::Shr(_) => return self.discrete(&Expr::Binary(binary.clone())),
            _ => return self.unit_expression(&Expr::Binary(binary.clone())),
        };
        let left = self.scalar(&binary.left, "value");
        let right = self.scalar(&binary.right, "value");
        let token = &binary.op;
        if let (Operand::Constant(left), Operand::Constant(right)) = (&left, &right) {
            return Operand::Constant(quote!((#left #token #right)));
        }
        let left = self.named(left, "constant", binary.left.span());
        let right = self.named(right, "constant", binary.right.span());
        let (left, right) = (self.number(left), self.number(right));
        let hint = if hint == "value" { default_hint } else { hint };
        let operation = Operation::Binary(operator, left, right);
        Operand::Var(self.define(hint, binary.span(), true, operation))
    }

    /// The operand of an operator. Of a reference the pullback would need the number, and may not
    /// hold on to the reference.
    pub(super) fn number(&mut self, var: crate::ir::VarId) -> crate::ir::VarId {
        if !self.may_refer(var) {
            return var;
        }
        let ident = self.ident(var).clone();
        self.define(&ident.to_string(), ident.span(), true, Operation::Value(var))
    }

    /// A cast to a float has a pullback; any other must not cut a derivative.
    fn cast(&mut self, cast: &syn::ExprCast, hint: &str) -> Operand {
        let ty = &cast.ty;
        let to_float = matches!(&**ty, Type::Path(path)
            if path.path.is_ident("f32") || path.path.is_ident("f64"));
        match self.operand(&cast.expr, "value") {
            Operand::Constant(tokens) => Operand::Constant(quote!((#tokens as #ty))),
            Operand::Var(var) if to_float => {
                let operation = Operation::Cast(var, (**ty).clone());
                Operand::Var(self.define(hint, cast.span(), true, operation))
            }
            Operand::Var(var) => {
                let ident = self.ident_at(var, cast.expr.span());
                let checked = quote_spanned!(cast.span()=> ::ad::rt::constant(#ident));
                Operand::Constant(quote!((#checked as #ty)))
            }
        }
    }

    /// `&e`
    fn reference(&mut self, reference: &syn::ExprReference, hint: &str) -> Operand {
        if let Some(token) = &reference.mutability {
            return self.refuse(
                token,
                "`&mut` is supported for the argument of a call and in `let name = &mut place` only: name the place itself where it is changed",
            );
        }
        match self.argument(&Expr::Reference(reference.clone())) {
            Argument::Value(operand) => operand,
            Argument::Borrow(place) | Argument::Exclusive(place) | Argument::Receiver(place) => {
                let operation = Operation::Borrow(place);
                let var = self.define(hint, reference.span(), true, operation);
                self.references.insert(var);
                Operand::Var(var)
            }
        }
    }

    fn argument(&mut self, expr: &Expr) -> Argument {
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
                    Argument::Exclusive(place)
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

    fn argument_tokens(&self, argument: &Argument) -> TokenStream {
        match argument {
            Argument::Value(operand) => self.tokens(operand),
            Argument::Borrow(place) => {
                let place = self.place_tokens(place);
                quote!(&#place)
            }
            Argument::Exclusive(place) => {
                let place = self.place_tokens(place);
                quote!(&mut #place)
            }
            Argument::Receiver(place) => self.place_tokens(place),
        }
    }

    fn call(&mut self, call: &syn::ExprCall, hint: &str) -> Operand {
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
            if self.lookup(name).is_some() {
                return self.refuse(
                    name,
                    "calls of function pointers and of closures that are parameters are not supported: write a `#[differentiable]` function",
                );
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

        let arguments: Vec<_> = call.args.iter().map(|arg| self.argument(arg)).collect();
        let primal = quote!(#function);
        let vjp = known_vjp(path).unwrap_or_else(|| vjp_of(function));
        let hint = if hint == "value" { last.ident.to_string() } else { hint.to_owned() };
        self.finish_call(primal, vjp, false, arguments, &hint, call.span())
    }

    /// `Some(x)`, `Name(x, y)`
    fn construct(&mut self, call: &syn::ExprCall, function: &ExprPath, hint: &str) -> Operand {
        let parts = self.operands(&call.args);
        let tokens = parts.iter().map(|part| self.tokens(part));
        let expression = quote!(#function(#(#tokens),*));
        let (shape, parts) = if is_transparent(&function.path) {
            (Shape::Transparent, numbered(parts))
        } else if let Some(member) = outcome(&function.path) {
            (Shape::Flow, parts.into_iter().map(|part| (member.clone(), part)).collect())
        } else if let Some(variant) = variant(&function.path) {
            (Shape::Variant(variant.clone()), numbered(parts))
        } else {
            (Shape::Struct, numbered(parts))
        };
        let value = self.aggregate(expression, shape.clone(), parts, hint, call.span());
        // A function whose name begins with a capital letter is no pattern.
        if let Operand::Var(var) = &value {
            let ident = self.ident(*var);
            let code = match shape {
                Shape::Struct => quote!(let #function(..) = &#ident;),
                Shape::Variant(_) => quote!(match &#ident { #function(..) => {} _ => {} }),
                _ => return value,
            };
            self.push(Statement::Plain { code, defines: Vec::new() });
        }
        value
    }

    fn method_call(&mut self, call: &syn::ExprMethodCall, hint: &str) -> Operand {
        if let Some(value) = self.consumed(call, hint).or_else(|| self.mapped(call, hint)) {
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
        arguments.extend(call.args.iter().map(|arg| self.argument(arg)));
        if called_on.is_some() {
            self.called_on.pop();
        }
        let (method, turbofish) = (&call.method, &call.turbofish);
        let vjp = format_ident!("{}_vjp", method);
        let hint = if hint == "value" { name } else { hint.to_owned() };
        self.finish_call(
            quote!(#method #turbofish),
            quote!(#vjp #turbofish),
            true,
            arguments,
            &hint,
            call.span(),
        )
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

    fn finish_call(
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
            Argument::Exclusive(place) => !self.vars[place.root].active,
            Argument::Borrow(_) | Argument::Receiver(_) => false,
        });
        if constant {
            let tokens: Vec<_> = arguments.iter().map(|a| self.argument_tokens(a)).collect();
            let value = match (method, &tokens[..]) {
                (true, [receiver, arguments @ ..]) => {
                    quote!(#receiver.#primal(#(#arguments),*))
                }
                (_, arguments) => quote!(#primal(#(#arguments),*)),
            };
            let changes = |argument: &Argument| matches!(argument, Argument::Exclusive(_));
            if !arguments.iter().any(changes) {
                return Operand::Constant(value);
            }
            // What it changes is read before and after: it has its place among the statements.
            let operation = Operation::Use(Operand::Constant(value));
            let value = self.define(hint, span, false, operation);
            let ident = self.ident(value);
            return Operand::Constant(quote!(#ident));
        }
        let operation = Operation::Call { primal, vjp, method, arguments };
        Operand::Var(self.define(hint, span, true, operation))
    }

    fn struct_literal(&mut self, literal: &syn::ExprStruct, hint: &str) -> Operand {
        let shape = match variant(&literal.path) {
            Some(variant) => Shape::Variant(variant.clone()),
            None => Shape::Struct,
        };
        let parts: Vec<_> = literal
            .fields
            .iter()
            .map(|field| (field.member.clone(), self.operand(&field.expr, "field")))
            .collect();
        let fields = parts.iter().map(|(member, value)| {
            let value = self.tokens(value);
            quote!(#member: #value)
        });
        let path = &literal.path;
        let Some(rest) = &literal.rest else {
            let expression = quote!(#path { #(#fields),* });
            return self.aggregate(expression, shape, parts, hint, literal.span());
        };
        let fields: Vec<_> = fields.collect();
        let rest = self.operand(rest, "rest");
        let rest_tokens = self.tokens(&rest);
        let expression = quote!(#path { #(#fields,)* ..#rest_tokens });
        match rest {
            Operand::Constant(_) => self.aggregate(expression, shape, parts, hint, literal.span()),
            Operand::Var(rest) => {
                let operation = Operation::UpdateStruct { expression, parts, rest };
                Operand::Var(self.define(hint, literal.span(), true, operation))
            }
        }
    }

    pub(super) fn aggregate(
        &mut self,
        expression: TokenStream,
        shape: Shape,
        parts: Vec<(Member, Operand)>,
        hint: &str,
        span: proc_macro2::Span,
    ) -> Operand {
        if parts.iter().all(|(_, part)| matches!(part, Operand::Constant(_))) {
            return Operand::Constant(expression);
        }
        // A pattern that takes it apart may reach into what a part refers to.
        let is_reference = |(_, part): &(Member, Operand)| match part {
            Operand::Var(var) => self.may_refer(*var),
            Operand::Constant(_) => false,
        };
        let reference = parts.iter().any(is_reference);
        let operation = Operation::Aggregate { expression, shape, parts };
        let var = self.define(hint, span, true, operation);
        self.vars[var].reference = reference;
        Operand::Var(var)
    }

    /// A copy of a place, or what is not a place.
    fn read(&mut self, expr: &Expr, hint: &str) -> Operand {
        if self.depth(expr) > 0 {
            let place = self.place(expr).expect("a reference to a place");
            return self.borrow_place(place);
        }
        if self.named_closure(expr).is_some() {
            return self.refuse_closure(expr);
        }
        if let Some(place) = self.place(expr) {
            if !self.vars[place.root].active {
                let tokens = self.place_tokens(&place);
                return self.settled(expr, tokens);
            }
            if place.path.is_empty() && !self.vars[place.root].mutable {
                return Operand::Var(place.root);
            }
            if place.path.is_empty() && self.vars[place.root].exclusive {
                return self.refuse(
                    expr,
                    "a `&mut` parameter can be passed on to a call only: elsewhere use `*` or a part of it",
                );
            }
            let hint = match (hint, place.path.last()) {
                ("value" | "argument" | "field", Some(Projection::Field(Member::Named(field)))) => {
                    field.to_string()
                }
                ("value" | "argument" | "field", _) => self.ident(place.root).to_string(),
                _ => hint.to_owned(),
            };
            return Operand::Var(self.define(&hint, expr.span(), true, Operation::Read(place)));
        }
        match expr {
            Expr::Path(path) => {
                self.check_capital(path);
                Operand::Constant(quote!(#expr))
            }
            Expr::Field(field) => {
                self.part(&field.base, Projection::Field(field.member.clone()), hint, expr)
            }
            Expr::Index(index) => match self.operand(&index.expr, "whole") {
                Operand::Constant(base) => {
                    let position = self.index(&index.index, &base);
                    Operand::Constant(quote!(#base[#position]))
                }
                Operand::Var(root) => {
                    let ident = self.ident(root).clone();
                    let step = Projection::Index(self.index(&index.index, &quote!(#ident)));
                    let place = crate::ir::Place { root, path: vec![step] };
                    Operand::Var(self.define(hint, expr.span(), true, Operation::Read(place)))
                }
            },
            Expr::Unary(unary) => self.part(&unary.expr, Projection::Deref, hint, expr),
            other => self.refuse_expression(other),
        }
    }

    /// A part of a value that has no place of its own.
    fn part(&mut self, base: &Expr, step: Projection, hint: &str, whole: &Expr) -> Operand {
        match self.operand(base, "whole") {
            Operand::Constant(base) => {
                Operand::Constant(crate::sweep::project(base, std::slice::from_ref(&step)))
            }
            Operand::Var(root) => {
                let place = crate::ir::Place { root, path: vec![step] };
                Operand::Var(self.define(hint, whole.span(), true, Operation::Read(place)))
            }
        }
    }
}

pub(super) fn numbered(parts: Vec<Operand>) -> Vec<(Member, Operand)> {
    parts.into_iter().enumerate().map(|(index, part)| (Member::from(index), part)).collect()
}

/// Types, variants and constants begin with a capital letter.
pub(super) fn is_type_name(ident: &syn::Ident) -> bool {
    ident
        .to_string()
        .trim_start_matches("r#")
        .trim_start_matches('_')
        .starts_with(char::is_uppercase)
}

/// `Some`
pub(super) fn is_transparent(path: &Path) -> bool {
    is_standard_variant(path, "Option")
        && path.segments.last().is_some_and(|last| last.ident == "Some")
}

/// Whether a path may lead to a variant of the standard library's `owner`.
fn is_standard_variant(path: &Path, owner: &str) -> bool {
    let named = path.segments.iter().rev().nth(1);
    named.is_none_or(|segment| segment.ident == owner)
}

/// `Ok`, `Err`: the member of the cotangent of a `Result`.
pub(super) fn outcome(path: &Path) -> Option<Member> {
    let last = &path.segments.last()?.ident;
    if !is_standard_variant(path, "Result") {
        return None;
    }
    match () {
        () if last == "Ok" => Some(Member::from(0)),
        () if last == "Err" => Some(Member::from(1)),
        () => None,
    }
}

/// `Enum::Variant`, told from `module::Type` by the capital letter.
pub(super) fn variant(path: &Path) -> Option<&syn::Ident> {
    let mut segments = path.segments.iter().rev();
    let last = segments.next().filter(|last| is_type_name(&last.ident))?;
    segments.next().filter(|owner| is_type_name(&owner.ident))?;
    Some(&last.ident)
}

/// `Box::new`
fn is_box_new(path: &Path) -> bool {
    let mut segments = path.segments.iter().rev();
    segments.next().is_some_and(|last| last.ident == "new")
        && segments.next().is_some_and(|owner| owner.ident == "Box")
}

/// Comparisons and tests, by the names that glam and the standard library give them. That the
/// result has no derivative is checked by its type.
pub(super) fn is_predicate(name: &str) -> bool {
    name.starts_with("is_")
        || name == "len"
        || matches!(name, "cmplt" | "cmple" | "cmpgt" | "cmpge" | "cmpeq" | "cmpne")
        || matches!(name, "cmp" | "partial_cmp" | "total_cmp")
        || matches!(name, "lt" | "le" | "gt" | "ge" | "eq" | "ne" | "all" | "any")
}

/// The derivative of a function of the standard library.
fn known_vjp(path: &Path) -> Option<TokenStream> {
    let mut segments = path.segments.iter().rev();
    let name = &segments.next()?.ident;
    let is_known = segments.next()?.ident == "mem"
        && ["swap", "replace", "take"].iter().any(|known| name == known);
    is_known.then(|| quote!(::ad::rules::replace::#name::vjp))
}

/// The path of the derivative: `Type::f_vjp` for an associated function, `f::vjp` for another.
fn vjp_of(function: &ExprPath) -> TokenStream {
    let path = &function.path;
    let mut segments: Vec<_> = path.segments.iter().cloned().collect();
    let Some(last) = segments.last_mut() else { return quote!(#function) };
    let associated = function.qself.is_some()
        || path.segments.iter().rev().nth(1).is_some_and(|owner| {
            is_type_name(&owner.ident) || owner.ident == "f32" || owner.ident == "f64"
        });
    let arguments = std::mem::replace(&mut last.arguments, PathArguments::None);
    if associated {
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
