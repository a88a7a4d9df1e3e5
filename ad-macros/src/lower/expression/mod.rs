//! Expressions: names every intermediate result through which a derivative flows.

pub mod construct;
pub mod operator;
pub mod option;
pub mod order;
pub mod sequence;

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{BinOp, Expr, ExprBinary, Member, UnOp};

use self::construct::numbered;
use super::Lowerer;
use super::flow::ends::End;
use super::place::indexed;
use super::syntax::{makes_value, strip_parens};
use crate::ir::VarId;
use crate::ir::primal;
use crate::ir::{BinaryOperator, Operand, Operation, Place, Projection, Shape};
use crate::types::{is_discrete, is_float};

impl Lowerer<'_> {
    /// Evaluates an expression. A new variable for the result, if one is needed, is named after
    /// `hint`.
    pub(super) fn operand(&mut self, expr: &Expr, hint: &str) -> Operand {
        match expr {
            Expr::Lit(literal) => Operand::Constant(quote!(#literal)),
            Expr::Paren(inner) => self.operand(&inner.expr, hint),
            Expr::Index(index) if indexed::is_element(index) => {
                self.method_call(&indexed::read(index), hint)
            }
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
            Expr::If(_) | Expr::Match(_) => match self.if_let_apart(expr) {
                Some(block) => self.operand(&block, hint),
                None => self.branch_value(expr, &mut |lowerer, body| {
                    lowerer.scope(|lowerer| lowerer.operand(body, "value"))
                }),
            },
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
        self.operands_before(exprs, None, "value")
    }

    /// The values of parts that are evaluated before `last`.
    pub(super) fn operands_before<'e>(
        &mut self,
        exprs: impl IntoIterator<Item = &'e Expr>,
        last: Option<&'e Expr>,
        hint: &str,
    ) -> Vec<Operand> {
        let exprs: Vec<_> = exprs.into_iter().collect();
        let operand = |(index, &expr): (usize, &&'e Expr)| {
            let operand = self.operand(expr, hint);
            let following = exprs[index + 1..].iter().copied().chain(last);
            self.in_turn(operand, expr, following)
        };
        exprs.iter().enumerate().map(operand).collect()
    }

    fn negate(&mut self, inner: &Expr, hint: &str, whole: &Expr) -> Operand {
        if let Some(value) = self.borrowed_negation(inner, hint, whole) {
            return value;
        }
        match self.scalar(inner, "value") {
            Operand::Constant(tokens) => Operand::Constant(quote!((-#tokens))),
            Operand::Var(var) => {
                let var = self.number(var);
                Operand::Var(self.define(hint, whole.span(), true, Operation::Negate(var)))
            }
        }
    }

    fn binary(&mut self, binary: &ExprBinary, hint: &str) -> Operand {
        let Some(operator) = BinaryOperator::of(&binary.op) else {
            return self.without_rule(binary);
        };
        let hint = if hint == "value" { operator.result() } else { hint };
        if let Some(value) = self.borrowed_operator(operator, binary, hint) {
            return value;
        }
        let left = self.scalar(&binary.left, "value");
        let left = self.in_turn(left, &binary.left, [&*binary.right]);
        let right = self.scalar(&binary.right, "value");
        let token = &binary.op;
        if let (Operand::Constant(left), Operand::Constant(right)) = (&left, &right) {
            return Operand::Constant(quote!((#left #token #right)));
        }
        let left = self.named(left, "constant", binary.left.span());
        let right = self.named(right, "constant", binary.right.span());
        let (left, right) = (self.number(left), self.number(right));
        let operation = Operation::Binary(operator, left, right);
        Operand::Var(self.define(hint, binary.span(), true, operation))
    }

    /// A comparison, an operator on bits, or one that changes what stands to its left.
    fn without_rule(&mut self, binary: &ExprBinary) -> Operand {
        let expr = Expr::Binary(binary.clone());
        match binary.op {
            BinOp::Eq(_)
            | BinOp::Ne(_)
            | BinOp::Lt(_)
            | BinOp::Le(_)
            | BinOp::Gt(_)
            | BinOp::Ge(_)
            | BinOp::And(_)
            | BinOp::Or(_) => {
                let tokens = self.plain(&expr);
                self.settled(&expr, quote!((#tokens)))
            }
            BinOp::BitAnd(_)
            | BinOp::BitOr(_)
            | BinOp::BitXor(_)
            | BinOp::Shl(_)
            | BinOp::Shr(_) => self.discrete(&expr),
            _ => self.unit_expression(&expr),
        }
    }

    /// The operand of an operator. Of a reference the pullback would need the number, and may not
    /// hold on to the reference.
    pub(super) fn number(&mut self, var: VarId) -> VarId {
        if !self.may_refer(var) {
            return var;
        }
        let ident = self.ident(var).clone();
        self.define(&ident.to_string(), ident.span(), true, Operation::Value(var))
    }

    /// A cast to a float has a pullback; any other must not cut a derivative.
    fn cast(&mut self, cast: &syn::ExprCast, hint: &str) -> Operand {
        let ty = &cast.ty;
        // What a name stands for that is none of the language's, its type tells.
        let (is_known, to_float) = (is_float(ty) || is_discrete(ty), !is_discrete(ty));
        match self.operand(&cast.expr, "value") {
            Operand::Var(var) if to_float => {
                if !is_known {
                    let ident = self.ident_at(var, cast.expr.span());
                    let code = quote_spanned!(cast.span()=>
                        let _ = ::ad::rules::castable::<_, #ty>(#ident););
                    self.push_plain(code);
                }
                let operation = Operation::Cast(var, (**ty).clone());
                Operand::Var(self.define(hint, cast.span(), true, operation))
            }
            value => {
                let checked = self.stored(&value, cast.expr.span());
                Operand::Constant(quote!((#checked as #ty)))
            }
        }
    }

    /// A copy of a place, or what is not a place.
    fn read(&mut self, expr: &Expr, hint: &str) -> Operand {
        if self.depth(expr) > 0 {
            let place = self.place(expr).expect("a reference to a place");
            return self.borrow_place(place);
        }
        if let Some(function) = self.function_of_name(expr) {
            return Operand::Constant(quote!(#function));
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
            Expr::Field(_) | Expr::Index(_) | Expr::Unary(_) => match self.part(expr) {
                Ok(place) => {
                    Operand::Var(self.define(hint, expr.span(), true, Operation::Read(place)))
                }
                Err(constant) => constant,
            },
            other => self.refuse_expression(other),
        }
    }

    /// The place of a part of a value that has none of its own; the part if no derivative flows through it. A part of a
    /// part is taken out of the value itself.
    fn part(&mut self, expr: &Expr) -> Result<Place, Operand> {
        let (base, member) = match expr {
            Expr::Field(field) => (&*field.base, Some(&field.member)),
            Expr::Index(index) => (&*index.expr, None),
            Expr::Unary(unary) => (&*unary.expr, None),
            other => return Err(self.refuse_expression(other)),
        };
        let whole = match is_part_of_value(base) {
            true => self.part(strip_parens(base)),
            false => {
                let value = self.operand(base, "whole");
                match self.kept(value, base) {
                    Operand::Var(root) => Ok(Place::of(root)),
                    constant => Err(constant),
                }
            }
        };
        let step = |lowerer: &mut Self, whole: &TokenStream| match (expr, member) {
            (Expr::Index(index), _) => Projection::Index(lowerer.index(&index.index, whole)),
            (_, Some(member)) => Projection::Field(member.clone()),
            (_, None) => Projection::Deref,
        };
        match whole {
            Ok(mut place) => {
                let whole = self.place_tokens(&place);
                place.path.push(step(self, &whole));
                Ok(place)
            }
            Err(constant) => {
                let after = match expr {
                    Expr::Index(index) => Some(&*index.index),
                    _ => None,
                };
                let whole = self.in_turn(constant, base, after);
                let whole = self.tokens(&whole);
                let step = step(self, &whole);
                Err(Operand::Constant(primal::project(whole, &[step])))
            }
        }
    }
}

/// Whether an expression is a part of a value that it makes.
fn is_part_of_value(expr: &Expr) -> bool {
    let base = match strip_parens(expr) {
        Expr::Field(field) => &field.base,
        Expr::Index(index) if !indexed::is_element(index) => &index.expr,
        _ => return false,
    };
    makes_value(base) || is_part_of_value(base)
}
