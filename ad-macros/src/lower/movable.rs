//! Which variables are of types that are known not to be `Copy`, as far as declarations tell.

use proc_macro2::Ident;
use syn::{Expr, GenericArgument, Pat, PathArguments, Type, parse_quote};

use super::Lowerer;
use super::expression::operator::is_own_type;
use super::syntax::{is_transparent, standard_macro, strip_parens};
use crate::types::pointee;

impl Lowerer<'_> {
    /// Whether a value is made of variables whose values may not be `Copy`.
    pub(super) fn is_movable(&self, value: &Expr) -> bool {
        self.names_variable(value, |var| self.movable.contains(&var) || self.own.contains(&var))
    }

    /// Notes the variables of a declaration whose values may not be `Copy`, as far as it tells.
    pub(super) fn note_movable(&mut self, pat: &Pat, ty: Option<&Type>, value: &Expr) {
        let name = match (pat, strip_parens(value)) {
            (Pat::Ident(name), _) => &name.ident,
            (Pat::Tuple(names), Expr::Tuple(values)) if names.elems.len() == values.elems.len() => {
                for (name, value) in names.elems.iter().zip(&values.elems) {
                    self.note_movable(name, None, value);
                }
                return;
            }
            _ => return,
        };
        let is_movable = match ty {
            Some(ty) => may_move(pointee(ty), &self.scalars),
            None => self.makes_movable(value),
        };
        if let Some(var) = self.lookup(name).filter(|_| is_movable) {
            self.movable.insert(var);
        }
    }

    /// Whether an expression makes a new `Vec` or the like.
    fn makes_movable(&self, value: &Expr) -> bool {
        let makes_movable = |part: &Expr| self.makes_movable(part);
        match strip_parens(value) {
            Expr::Macro(call) => {
                matches!(standard_macro(&call.mac.path).as_deref(), Some("vec" | "format"))
            }
            Expr::MethodCall(call) => ["clone", "collect", "to_vec", "to_owned", "to_string"]
                .iter()
                .any(|name| call.method == name),
            Expr::Call(call) => match &*call.func {
                Expr::Path(path) if is_transparent(&path.path) => {
                    call.args.iter().any(makes_movable)
                }
                // `Type::function(..)` mostly makes one of these.
                Expr::Path(path) => path
                    .path
                    .segments
                    .iter()
                    .rev()
                    .nth(1)
                    .is_some_and(|owner| may_move(&parse_quote!(#owner), &self.scalars)),
                _ => false,
            },
            Expr::Tuple(tuple) => tuple.elems.iter().any(makes_movable),
            Expr::Array(array) => array.elems.iter().any(makes_movable),
            Expr::Struct(_) => self.scalars.is_empty(),
            value @ Expr::Path(_) => self.is_movable(value),
            _ => false,
        }
    }
}

/// Whether a type is known not to be `Copy`, as far as can be seen. Where `scalars` are type parameters
/// bounded by `Real`, a type of one's own is taken for one that is generic over them, and made of numbers.
pub fn may_move(ty: &Type, scalars: &[Ident]) -> bool {
    match ty {
        Type::Paren(paren) => may_move(&paren.elem, scalars),
        Type::Array(array) => may_move(&array.elem, scalars),
        Type::Tuple(tuple) => tuple.elems.iter().any(|ty| may_move(ty, scalars)),
        Type::Path(path) => path.path.segments.last().is_some_and(|last| {
            let is_one_of = |names: &[&str]| names.iter().any(|name| last.ident == *name);
            match &last.arguments {
                _ if is_one_of(&["Vec", "VecDeque", "Box", "String"]) => true,
                PathArguments::AngleBracketed(arguments) if is_one_of(&["Option", "Result"]) => {
                    arguments.args.iter().any(|argument| {
                        matches!(argument, GenericArgument::Type(ty) if may_move(ty, scalars))
                    })
                }
                _ => scalars.is_empty() && is_own_type(ty, scalars),
            }
        }),
        _ => false,
    }
}
