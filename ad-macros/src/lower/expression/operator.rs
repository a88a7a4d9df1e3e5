//! Operators between what is borrowed, `&a * &b`, and those of types that are not `Copy`.
//!
//! The operators of numbers use copies of their operands, which the reverse sweep names once more.
//! Whether a type is `Copy` the macro does not see. So an operator is called as a function of
//! references (`ad::rules::borrowed`) where an operand is written as one, or where what is written
//! down tells a type of one's own: a declared type, a constructor, `clone()`, another such operator.

use proc_macro2::Ident;
use quote::quote_spanned;
use syn::spanned::Spanned;
use syn::{Expr, ExprBinary, Path, Type, UnOp, parse_quote};

use crate::ir::VarId;
use crate::ir::{Argument, BinaryOperator, Callee, Operand, Place};
use crate::lower::Lowerer;
use crate::lower::syntax::{is_transparent, is_type_name, outcome, strip_parens};
use crate::types::{is_discrete, pointee};

impl Lowerer<'_> {
    /// Whether an expression is a reference, or of a type that may not be `Copy`.
    pub fn is_borrowed_or_own(&self, expr: &Expr) -> bool {
        match strip_parens(expr) {
            Expr::Reference(reference) => {
                reference.mutability.is_none() && !is_literal(&reference.expr)
            }
            Expr::Path(path) => self.variable(path).is_some_and(|var| self.is_of_own_type(var)),
            Expr::Binary(binary) => {
                BinaryOperator::of(&binary.op).is_some()
                    && (self.is_borrowed_or_own(&binary.left)
                        || self.is_borrowed_or_own(&binary.right))
            }
            Expr::Unary(unary) => {
                matches!(unary.op, UnOp::Neg(_)) && self.is_borrowed_or_own(&unary.expr)
            }
            Expr::MethodCall(call) => call.method == "clone" && call.args.is_empty(),
            Expr::Call(call) => {
                matches!(&*call.func, Expr::Path(function)
                    if constructs(&function.path, &self.scalars) || self.is_tuple_struct(&function.path))
            }
            Expr::Struct(_) => true,
            _ => false,
        }
    }

    /// `Polynomial(..)`
    pub fn is_tuple_struct(&self, function: &Path) -> bool {
        let last = function.segments.last();
        last.is_some_and(|last| is_type_name(&last.ident) && is_own_name(&last.ident))
            && !is_transparent(function)
            && outcome(function).is_none()
            && self.variant(function).is_none()
    }

    fn is_of_own_type(&self, var: VarId) -> bool {
        self.own.contains(&var)
            || self.aliases.get(&var).is_some_and(|alias| {
                alias.place.path.is_empty() && self.own.contains(&alias.place.root)
            })
    }

    /// `a * b` as a call, if an operand is borrowed or of a type of one's own.
    pub(super) fn borrowed_operator(
        &mut self,
        operator: BinaryOperator,
        binary: &ExprBinary,
        hint: &str,
    ) -> Option<Operand> {
        if !self.is_borrowed_or_own(&binary.left) && !self.is_borrowed_or_own(&binary.right) {
            return None;
        }
        self.or_undone(|lowerer| {
            let left = lowerer.borrowed(&binary.left);
            let left = lowerer.argument_in_turn(left, &binary.left, [&*binary.right]);
            let operands = [left, lowerer.borrowed(&binary.right)];
            lowerer.call_of_operator(operator.method(), operands.into(), hint, binary)
        })
    }

    /// `-a` as a call.
    pub(super) fn borrowed_negation(
        &mut self,
        inner: &Expr,
        hint: &str,
        whole: &Expr,
    ) -> Option<Operand> {
        if !self.is_borrowed_or_own(inner) {
            return None;
        }
        self.or_undone(|lowerer| {
            let operand = lowerer.borrowed(inner);
            lowerer.call_of_operator("neg", vec![operand], hint, whole)
        })
    }

    /// `a += b` as a call; says whether it is one.
    pub fn borrowed_update(&mut self, operator: BinaryOperator, update: &ExprBinary) -> bool {
        let left = match strip_parens(&update.left) {
            Expr::Unary(unary) if matches!(unary.op, UnOp::Deref(_)) => &unary.expr,
            left => left,
        };
        if !self.is_borrowed_or_own(left) && !self.is_borrowed_or_own(&update.right) {
            return false;
        }
        let Some(place) = self.active_place(&update.left) else { return false };
        if !self.can_be_assigned(&update.left, &place) {
            return true;
        }
        let right = self.borrowed(&update.right);
        let operands = vec![Argument::Exclusive(place), right];
        let function = format!("{}_assign", operator.method());
        self.call_of_operator(&function, operands, "changed", update);
        true
    }

    fn call_of_operator(
        &mut self,
        function: &str,
        operands: Vec<Argument>,
        hint: &str,
        at: &impl quote::ToTokens,
    ) -> Option<Operand> {
        // Of constants it is whatever their types say.
        let is_constant =
            |operand: &Argument| matches!(operand, Argument::Value(Operand::Constant(_)));
        if operands.iter().all(is_constant) {
            return None;
        }
        let span = at.span();
        let function = Ident::new(function, span);
        let path = quote_spanned!(span=> ::ad::rules::borrowed::#function);
        let value = self.finish_call(Callee::of_ad(path), operands, hint, span);
        if let Operand::Var(var) = value {
            self.own.insert(var);
        }
        Some(value)
    }

    /// An operand as a reference.
    fn borrowed(&mut self, expr: &Expr) -> Argument {
        let expr = strip_parens(expr);
        if matches!(expr, Expr::Reference(_)) || self.is_reference(expr) {
            return self.argument(expr);
        }
        let is_reference = match expr {
            Expr::Path(path) => self.variable(path).is_some_and(|var| self.vars[var].reference),
            _ => false,
        };
        if is_reference {
            return self.argument(&parse_quote!(&*#expr));
        }
        // What may be changed is taken as it is now.
        let mut may_change = false;
        self.place_if(expr, |lowerer, place| {
            let root = &lowerer.vars[place.root];
            may_change = root.active && root.mutable;
            false
        });
        if may_change && let Operand::Var(root) = self.operand(expr, "operand") {
            return Argument::Borrow(Place::of(root));
        }
        // In parentheses: what follows `&` may be another operator.
        self.argument(&parse_quote!(&(#expr)))
    }
}

fn is_literal(expr: &Expr) -> bool {
    matches!(strip_parens(expr), Expr::Lit(_))
}

/// Whether a function by its name makes a value of the type to which it belongs, `Matrix::zeros`;
/// `scalars` are type parameters bounded by `Real`.
pub fn constructs(function: &Path, scalars: &[Ident]) -> bool {
    let mut segments = function.segments.iter().rev();
    let (Some(name), Some(owner)) = (segments.next(), segments.next()) else { return false };
    let name = name.ident.to_string();
    let is_constructor = ["new", "zero", "zeros", "one", "ones", "identity", "eye", "default"]
        .iter()
        .any(|known| name == *known);
    (is_constructor || name.starts_with("from_"))
        && is_type_name(&owner.ident)
        && is_own_name(&owner.ident)
        && !scalars.contains(&owner.ident)
}

/// Whether a variable declared with this type may be of a type that is not `Copy`; `scalars` are type
/// parameters bounded by `Real`.
pub fn is_own_type(ty: &Type, scalars: &[Ident]) -> bool {
    match pointee(ty) {
        Type::Path(path) => path.path.segments.last().is_some_and(|last| {
            is_type_name(&last.ident)
                && is_own_name(&last.ident)
                && !is_discrete(ty)
                && !path.path.get_ident().is_some_and(|name| scalars.contains(name))
        }),
        _ => false,
    }
}

/// Whether this is not known as the name of numbers, of vectors of them, or of a type that has no
/// operators.
pub fn is_own_name(name: &Ident) -> bool {
    const KNOWN: [&str; 10] =
        ["Box", "Float", "Num", "Number", "Option", "Quat", "Real", "Result", "Scalar", "Vec"];
    let name = name.to_string();
    let plain = name.trim_start_matches(['D', 'I', 'U']);
    let numbered = |start: &str| {
        plain.strip_prefix(start).is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
    };
    !KNOWN.contains(&plain) && !numbered("Vec") && !numbered("Mat")
}
