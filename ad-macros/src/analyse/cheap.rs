//! Code without derivative that costs next to nothing and always has the same value: literals,
//! constants, operators, elements of arrays, ranges of integers. The reverse sweep computes it again in
//! place of keeping its value.
//!
//! Of what is called, only what is certainly known counts: the methods of integers and ranges, and
//! functions that make numbers of numbers.

use proc_macro2::{Ident, TokenStream};
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, ExprCall, ExprIndex, ExprMethodCall, ExprPath, Path};

use super::facts::Facts;
use crate::ir::VarId;
use crate::lower::strip_parens;
use crate::names::is_in;

/// Methods of integers, arrays and ranges, and comparisons of scalars.
const METHODS: [&str; 10] =
    ["len", "min", "max", "rev", "cmpeq", "cmpne", "cmplt", "cmple", "cmpgt", "cmpge"];

/// Methods of ranges of which, beside these, ranges are made.
const OF_RANGES: [&str; 3] = ["skip", "step_by", "take"];

/// What code may be made of.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Use {
    /// It may be computed once more.
    Again,
    /// It tells that a variable is a number: lengths of slices too, which are not computed again.
    Number,
    /// It tells the range of a loop, which is kept: lengths of slices too.
    Range,
}

impl Facts<'_> {
    /// Whether code is cheap.
    pub fn is_cheap(&self, code: &TokenStream) -> bool {
        self.is_cheap_before(code, VarId::MAX, Use::Again)
    }

    /// Whether the code that defines a variable is cheap arithmetic on numbers.
    pub fn is_number_before(&self, code: &TokenStream, defined: VarId) -> bool {
        let Ok(expr) = syn::parse2::<Expr>(code.clone()) else { return false };
        // A constant by its path alone might be anything.
        let is_constant = matches!(&expr, Expr::Path(path) if self.variable(path).is_none());
        !is_constant && Cheap { facts: self, defined, wanted: Use::Number }.holds(&expr)
    }

    /// Whether a call of a method in the code that defines a variable has no effect and gives the same each
    /// time. One's own types may have methods with any name.
    pub fn is_same_again_before(&self, call: &ExprMethodCall, defined: VarId) -> bool {
        Cheap { facts: self, defined, wanted: Use::Number }.holds_method(call)
    }

    /// Whether an iterator is a range of integers, or some of one, that can be run over backwards.
    pub fn is_range(&self, iterator: &TokenStream) -> bool {
        let Ok(expr) = syn::parse2::<Expr>(iterator.clone()) else { return false };
        is_range(&expr)
            && Cheap { facts: self, defined: VarId::MAX, wanted: Use::Range }.holds(&expr)
    }

    /// Whether an iterator gives one integer after the other.
    pub fn counts_up(&self, iterator: &TokenStream) -> bool {
        match syn::parse2(iterator.clone()) {
            Ok(Expr::Range(_)) => true,
            Ok(Expr::Call(call)) => {
                matches!(&*call.func, Expr::Path(path) if is_windows(&path.path))
            }
            _ => false,
        }
    }

    /// Whether a range can be computed where the function begins: it is made of literals and the
    /// lengths of parameters.
    pub fn is_known_at_start(&self, range: &TokenStream) -> bool {
        let uses = self.uses(range);
        // Where a loop is not reached, arithmetic for its range could fail.
        uses.iter().all(|&var| self.is_parameter_with_length(var)) && !may_fail(range)
    }

    /// Whether code is cheap, has the same value wherever it stands, and may stand where it is not reached.
    pub fn is_fixed(&self, code: &TokenStream) -> bool {
        self.is_cheap(code) && self.uses(code).is_empty() && !may_fail(code)
    }

    /// Whether code that defines a variable is cheap. What looks like a later one is a name of the user's.
    fn is_cheap_before(&self, code: &TokenStream, defined: VarId, wanted: Use) -> bool {
        let Ok(expr) = syn::parse2::<Expr>(code.clone()) else { return false };
        Cheap { facts: self, defined, wanted }.holds(&expr)
    }

    /// Whether a type is a scalar, or a vector of `glam`.
    pub fn is_of_scalars(&self, ty: &Ident) -> bool {
        self.is_scalar(ty) || is_in("Vec2 Vec3 Vec4 DVec2 DVec3 DVec4", &ty.to_string())
    }

    /// The variable that a path names.
    fn variable(&self, path: &ExprPath) -> Option<VarId> {
        self.named(path.path.get_ident()?)
    }
}

struct Cheap<'f, 'a> {
    facts: &'f Facts<'a>,
    /// The variable that is defined.
    defined: VarId,
    wanted: Use,
}

impl Cheap<'_, '_> {
    fn holds(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Lit(_) => true,
            Expr::Path(path) => match self.facts.variable(path) {
                Some(var) => self.is_fixed(var) && self.facts.is_number(var),
                None => true,
            },
            Expr::Paren(inner) => self.holds(&inner.expr),
            Expr::Unary(unary) => self.holds(&unary.expr),
            Expr::Cast(cast) => self.holds(&cast.expr),
            Expr::Binary(binary) => self.holds(&binary.left) && self.holds(&binary.right),
            Expr::Tuple(tuple) => tuple.elems.iter().all(|part| self.holds(part)),
            Expr::Array(array) => array.elems.iter().all(|part| self.holds(part)),
            Expr::Repeat(repeat) => self.holds(&repeat.expr) && self.holds(&repeat.len),
            Expr::Range(range) => {
                range.start.iter().chain(&range.end).all(|bound| self.holds(bound))
            }
            Expr::Index(index) => self.holds_array(&index.expr) && self.holds(&index.index),
            Expr::MethodCall(call) => self.holds_method(call),
            Expr::Call(call) => {
                self.is_known(call) && call.args.iter().all(|argument| self.holds(argument))
            }
            _ => false,
        }
    }

    /// Whether a variable was defined before and does not change.
    fn is_fixed(&self, var: VarId) -> bool {
        var < self.defined && !self.facts.is_mutable(var)
    }

    /// Whether an expression is an array that does not change, or a part of one.
    fn holds_array(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Path(path) => match self.facts.variable(path) {
                Some(var) => self.is_fixed(var) && self.facts.array(var).is_some(),
                None => true,
            },
            Expr::Index(index) => self.holds_array(&index.expr) && self.holds(&index.index),
            Expr::Paren(inner) => self.holds_array(&inner.expr),
            expr => self.holds(expr),
        }
    }

    fn holds_method(&self, call: &ExprMethodCall) -> bool {
        let ExprMethodCall { receiver, method, args, .. } = call;
        // A static, or an element of an array, may be of a type with a method of this name that gives another
        // number each time.
        match strip_parens(receiver) {
            Expr::Path(path) => {
                let Some(var) = self.facts.variable(path) else { return false };
                if method == "len" {
                    // The length of an array never changes.
                    let has_length = self.facts.array(var).is_some()
                        || (self.wanted != Use::Again && self.facts.is_sequence(var));
                    return var < self.defined && has_length;
                }
            }
            Expr::Index(_) => return false,
            _ => {}
        }
        let is_cheap = METHODS.iter().any(|name| method == name)
            || self.wanted == Use::Range && OF_RANGES.iter().any(|name| method == name);
        is_cheap && self.holds(receiver) && args.iter().all(|argument| self.holds(argument))
    }

    /// Whether a function is known to make a number of numbers, or a range.
    fn is_known(&self, call: &ExprCall) -> bool {
        let Expr::Path(ExprPath { path, qself: None, .. }) = &*call.func else { return false };
        let mut segments = path.segments.iter().rev();
        let Some(name) = segments.next().map(|last| &last.ident) else { return false };
        if is_of_ad(path) {
            return name == "constant"
                || is_windows(path)
                || (self.wanted == Use::Range && name == "chunks_exact");
        }
        // That it is the one of `ad` has been checked.
        if name == "stop_gradient" {
            return true;
        }
        let Some(owner) = segments.next().map(|owner| &owner.ident) else { return false };
        (name == "from_f64" || name == "splat") && self.facts.is_of_scalars(owner)
    }
}

/// `::ad::rt::..`
fn is_of_ad(path: &Path) -> bool {
    path.leading_colon.is_some() && path.segments.first().is_some_and(|first| first.ident == "ad")
}

/// `::ad::rt::windows`
fn is_windows(path: &Path) -> bool {
    is_of_ad(path) && path.segments.last().is_some_and(|last| last.ident == "windows")
}

/// Whether an iterator is a range, or made of one, by its form.
fn is_range(iterator: &Expr) -> bool {
    match iterator {
        Expr::Range(_) => true,
        Expr::Paren(inner) => is_range(&inner.expr),
        Expr::MethodCall(call) => is_range(&call.receiver),
        Expr::Call(call) => matches!(&*call.func, Expr::Path(path) if is_of_ad(&path.path)),
        _ => false,
    }
}

/// Whether there is an operation in code without derivative, such as that of a range, that may fail.
fn may_fail(code: &TokenStream) -> bool {
    struct Finder(bool);

    impl<'ast> Visit<'ast> for Finder {
        fn visit_bin_op(&mut self, operator: &'ast BinOp) {
            let is_comparison = matches!(
                operator,
                BinOp::Eq(_)
                    | BinOp::Ne(_)
                    | BinOp::Lt(_)
                    | BinOp::Le(_)
                    | BinOp::Gt(_)
                    | BinOp::Ge(_)
            );
            self.0 |= !is_comparison;
        }

        fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
            // Steps of size zero fail.
            self.0 |= OF_RANGES.iter().any(|name| call.method == name);
            visit::visit_expr_method_call(self, call);
        }

        fn visit_expr_call(&mut self, _: &'ast ExprCall) {
            // So do windows and chunks.
            self.0 = true;
        }

        fn visit_expr_index(&mut self, _: &'ast ExprIndex) {
            self.0 = true;
        }
    }

    let Ok(expr) = syn::parse2::<Expr>(code.clone()) else { return true };
    let mut finder = Finder(false);
    finder.visit_expr(&expr);
    finder.0
}
