//! Whose methods are called: those of the standard library, or those of a type of the user's.
//!
//! `get`, `first`, `map` and their kin are written out where slices, options and iterators have them. A user's
//! type may have methods of these names. What tells it is a name of a type: of a parameter or a variable, of
//! `Self`, of what is constructed. There the method is called as any other, and the compiler finds it and its
//! derivative; behind an alias of a slice that is a rule (`ad::rules::PartRules`). Elsewhere the macro does not
//! see the type, takes it for one of the standard library, and has the compiler check that (`ad::rt::is_sequence`,
//! `ad::rules::attempt`).

use syn::{Expr, GenericArgument, Ident, PathArguments, Type};

use crate::ir::VarId;
use crate::lower::Lowerer;
use crate::lower::expression::operator::constructs;
use crate::lower::syntax::{is_type_name, strip_parens};
use crate::names::is_in;
use crate::types::{is_discrete, pointee};

/// Types of the standard library whose methods are written out, or have methods of what they hold.
const STANDARD: &str = "\
    Arc BTreeMap BTreeSet BinaryHeap Box Cell Cow HashMap HashSet Option Range Rc RefCell Result \
    String Vec VecDeque Wrapping";

/// Whether a type is a user's by its name, or a box of one; of `Self` the caller knows.
pub fn has_own_methods(ty: &Type, of_self: bool) -> bool {
    let Type::Path(path) = pointee(ty) else { return false };
    let Some(last) = path.path.segments.last() else { return false };
    match (&*last.ident.to_string(), &last.arguments) {
        ("Self", _) if path.path.segments.len() == 1 => of_self,
        ("Arc" | "Box" | "Rc", PathArguments::AngleBracketed(arguments)) => {
            matches!(arguments.args.first(), Some(GenericArgument::Type(ty)) if has_own_methods(ty, of_self))
        }
        (name, _) => is_type_name(&last.ident) && !is_in(STANDARD, name) && !is_discrete(ty),
    }
}

impl Lowerer<'_> {
    /// Whether the methods of an expression are those of a user's type, as far as names of types tell.
    pub fn calls_own_methods(&self, receiver: &Expr) -> bool {
        let is_own =
            |ty: &Ident| !is_in(STANDARD, &ty.to_string()) && (ty != "Self" || self.self_is_own);
        match strip_parens(receiver) {
            Expr::Path(path) => self.variable(path).is_some_and(|var| self.is_of_own_methods(var)),
            Expr::Reference(reference) => self.calls_own_methods(&reference.expr),
            Expr::Unary(unary) if matches!(unary.op, syn::UnOp::Deref(_)) => {
                self.calls_own_methods(&unary.expr)
            }
            Expr::Struct(literal) => {
                literal.path.segments.last().is_some_and(|last| is_own(&last.ident))
            }
            Expr::Call(call) => match strip_parens(&call.func) {
                Expr::Path(function) if constructs(&function.path, &self.scalars) => function
                    .path
                    .segments
                    .iter()
                    .rev()
                    .nth(1)
                    .is_some_and(|owner| is_own(&owner.ident)),
                Expr::Path(function) => self.is_tuple_struct(&function.path),
                _ => false,
            },
            _ => false,
        }
    }

    /// Whether they are, and no alias can stand behind the name: `self` in an `impl` of one's own, and constructors.
    pub(super) fn certainly_calls_own_methods(&self, receiver: &Expr) -> bool {
        let is_self =
            matches!(strip_parens(receiver), Expr::Path(path) if path.path.is_ident("self"));
        match strip_parens(receiver) {
            Expr::Path(_) => is_self && self.calls_own_methods(receiver),
            receiver => self.calls_own_methods(receiver),
        }
    }

    fn is_of_own_methods(&self, var: VarId) -> bool {
        self.own_methods.contains(&var)
            || self.aliases.get(&var).is_some_and(|alias| {
                alias.place.path.is_empty() && self.own_methods.contains(&alias.place.root)
            })
    }
}
