//! Iterators, as people write them: a source, then adapters.
//!
//! What carries a derivative is not iterated over itself: its place in the source is. For
//! `xs.iter().zip(&ys).rev()` generated code runs `(0..xs.len()).zip(0..ys.len()).rev()`, and the
//! items are the places `xs[i]` and `ys[j]`. So the adapters that only choose and order are the
//! standard library's own, and a cotangent is added to the element it belongs to, in place.
//! Closures of `map` and `filter` become part of the loop's body.
//!
//! Turned down: pullbacks of the adapters themselves (each item would need a cotangent of its own,
//! gathered into a vector for each adapter), and references as items of generated loops (the tape
//! would borrow from variables that the pullback owns).

use proc_macro2::TokenStream;
use syn::{Expr, ExprCall, ExprMethodCall, ExprPath, Ident, Lit, Path, parse_quote};

use super::item::Access;
use crate::ir::{Place, VarId};
use crate::lower::syntax::strip_parens;
use crate::names::is_in;

/// An iterator, before its items have names.
pub enum Chain {
    /// Items without derivative.
    Constant { iterator: TokenStream, length: Option<usize>, is_range: bool },
    /// Elements of a place, by their index.
    Elements { place: Place, access: Access, length: Option<usize> },
    /// Runs of elements, by the index of the first.
    Runs {
        place: Place,
        iterator: TokenStream,
        size: TokenStream,
        cut_short: bool,
        is_exclusive: bool,
    },
    /// `.enumerate()`
    Enumerate(Box<Chain>),
    /// `.zip(other)`
    Zip(Box<Chain>, Box<Chain>),
    /// An adapter that chooses items or changes their order, or repeats them.
    Order { inner: Box<Chain>, adapter: TokenStream, limit: Option<usize>, repeats: bool },
    /// `.copied()`, or `.cloned()` of what need not be `Copy`.
    Copied { inner: Box<Chain>, clones: bool },
    /// `.map(function)`
    Map(Box<Chain>, Expr),
    /// `.chain(other)`
    Chained(Box<Chain>, Box<Chain>),
    /// `.filter_map(function)`; with `stops` `.map_while(function)`, and with a variable that the function
    /// may change `.scan(state, function)`.
    FilterMap { inner: Box<Chain>, state: Option<VarId>, function: Expr, stops: bool },
    /// `.flat_map(function)`, `.flatten()`
    Flat { inner: Box<Chain>, function: Option<Expr>, method: Ident },
    /// `.filter(predicate)`; what follows runs only where it holds.
    Filter(Box<Chain>, Expr),
    /// `.take_while(predicate)`
    TakeWhile(Box<Chain>, Expr),
    /// `.skip_while(predicate)`, with a variable that tells whether it goes on.
    SkipWhile(Box<Chain>, Expr, VarId),
    /// `.enumerate()` behind a filter: with a variable that counts.
    Count(Box<Chain>, VarId),
    /// `.skip(n)`, `.step_by(n)`, `.take(n)` where every item has to be made: with a variable that
    /// counts, and `n`.
    Counted { inner: Box<Chain>, counter: VarId, choice: Choice, count: TokenStream },
    /// Has been refused.
    Refused,
}

/// Which items pass, by their number.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Choice {
    /// Those from the n-th on.
    Skip,
    /// Every n-th.
    StepBy,
    /// Those before the n-th.
    Take,
}

impl Chain {
    /// The largest number of items, where it is known.
    pub fn length(&self) -> Option<usize> {
        match self {
            Self::Constant { length, .. } | Self::Elements { length, .. } => *length,
            Self::Runs { .. } | Self::Refused | Self::Flat { .. } => None,
            Self::Chained(left, right) => Some(left.length()? + right.length()?),
            Self::FilterMap { inner, .. } => inner.length(),
            Self::Enumerate(inner)
            | Self::Copied { inner, .. }
            | Self::Map(inner, _)
            | Self::Filter(inner, _)
            | Self::TakeWhile(inner, _)
            | Self::SkipWhile(inner, ..)
            | Self::Count(inner, _)
            | Self::Counted { inner, .. } => inner.length(),
            Self::Zip(left, right) => smaller(left.length(), right.length()),
            Self::Order { limit, repeats: true, .. } => *limit,
            Self::Order { inner, limit, .. } => smaller(inner.length(), *limit),
        }
    }

    /// The functions that items go through.
    pub fn functions(&self) -> Vec<&Expr> {
        match self {
            Self::Map(inner, function)
            | Self::FilterMap { inner, function, .. }
            | Self::Flat { inner, function: Some(function), .. }
            | Self::Filter(inner, function)
            | Self::TakeWhile(inner, function)
            | Self::SkipWhile(inner, function, _) => {
                let mut functions = inner.functions();
                functions.push(function);
                functions
            }
            Self::Enumerate(inner)
            | Self::Copied { inner, .. }
            | Self::Count(inner, _)
            | Self::Counted { inner, .. }
            | Self::Flat { inner, function: None, .. }
            | Self::Order { inner, .. } => inner.functions(),
            Self::Zip(left, right) | Self::Chained(left, right) => {
                [left.functions(), right.functions()].concat()
            }
            Self::Constant { .. } | Self::Elements { .. } | Self::Runs { .. } | Self::Refused => {
                Vec::new()
            }
        }
    }

    /// Whether the body of the loop decides which items there are.
    pub fn is_filtered(&self) -> bool {
        match self {
            Self::Filter(..)
            | Self::FilterMap { .. }
            | Self::Flat { .. }
            | Self::TakeWhile(..)
            | Self::SkipWhile(..)
            | Self::Count(..)
            | Self::Counted { .. } => true,
            Self::Map(inner, _) | Self::Copied { inner, .. } => inner.is_filtered(),
            _ => false,
        }
    }

    /// Whether the loop may end before its iterator does.
    pub fn stops(&self) -> bool {
        match self {
            Self::TakeWhile(..)
            | Self::FilterMap { stops: true, .. }
            | Self::Counted { choice: Choice::Take, .. } => true,
            Self::FilterMap { inner, .. }
            | Self::Flat { inner, .. }
            | Self::Filter(inner, _)
            | Self::SkipWhile(inner, ..)
            | Self::Count(inner, _)
            | Self::Counted { inner, .. }
            | Self::Map(inner, _)
            | Self::Copied { inner, .. } => inner.stops(),
            _ => false,
        }
    }
}

fn smaller(a: Option<usize>, b: Option<usize>) -> Option<usize> {
    a.into_iter().chain(b).min()
}

/// Whether an expression is an iterator, as far as its form tells.
pub fn is_chain(expr: &Expr) -> bool {
    match strip_parens(expr) {
        Expr::Range(_) => true,
        Expr::Call(call) => of_one(call).is_some(),
        Expr::MethodCall(call) => {
            is_source(&call.method)
                || is_of_text(call)
                || is_adapter(&call.method)
                    && (!is_of_options(&call.method) || is_chain(&call.receiver))
        }
        _ => false,
    }
}

/// Whether a call gives an iterator over a text: by its name or, as slices can be split too, by its argument.
fn is_of_text(call: &ExprMethodCall) -> bool {
    const OF_TEXT: [&str; 6] =
        ["bytes", "chars", "char_indices", "lines", "split_ascii_whitespace", "split_whitespace"];
    let is_one_of = |names: &[&str]| names.iter().any(|name| call.method == name);
    let is_text = |argument: &Expr| match argument {
        Expr::Lit(literal) => matches!(literal.lit, Lit::Str(_) | Lit::Char(_)),
        _ => false,
    };
    is_one_of(&OF_TEXT)
        || is_one_of(&["split", "split_terminator", "rsplit"])
            && call.args.first().is_some_and(is_text)
}

/// Whether options have the method of an adapter, too.
fn is_of_options(adapter: &Ident) -> bool {
    is_in("zip take copied cloned map filter flatten inspect", &adapter.to_string())
}

/// `iter::once(x)`, `iter::repeat(x)` and `iter::repeat_n(x, n)`, as the iterator of an array.
pub(super) fn of_one(call: &ExprCall) -> Option<(&Path, Expr)> {
    let Expr::Path(ExprPath { path, .. }) = strip_parens(&call.func) else { return None };
    let mut names = path.segments.iter().rev().map(|segment| segment.ident.to_string());
    let (name, module) = (names.next()?, names.next()?);
    let arguments: Vec<_> = call.args.iter().collect();
    let iterator = match (&*module, &*name, &arguments[..]) {
        ("iter", "once", [item]) => parse_quote!([#item].into_iter()),
        ("iter", "repeat", [item]) => parse_quote!([#item].into_iter().cycle()),
        ("iter", "repeat_n", [item, count]) => {
            parse_quote!([#item].into_iter().cycle().take(#count))
        }
        _ => return None,
    };
    Some((path, iterator))
}

pub fn is_source(method: &Ident) -> bool {
    const SOURCES: &str = "\
        drain iter iter_mut into_iter windows chunks chunks_mut chunks_exact chunks_exact_mut";
    is_in(SOURCES, &method.to_string())
}

pub fn is_adapter(method: &Ident) -> bool {
    const ADAPTERS: &str = "\
        enumerate zip rev step_by take skip cycle copied cloned map filter take_while skip_while \
        chain filter_map flat_map flatten scan inspect fuse peekable map_while";
    is_in(ADAPTERS, &method.to_string())
}

pub fn literal(expr: &Expr) -> Option<usize> {
    match strip_parens(expr) {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(number) => number.base10_parse::<usize>().ok(),
            _ => None,
        },
        _ => None,
    }
}

/// The length of an array that is written out.
pub fn array_length(expr: &Expr) -> Option<usize> {
    match strip_parens(expr) {
        Expr::Array(array) => Some(array.elems.len()),
        Expr::Repeat(repeat) => literal(&repeat.len),
        _ => None,
    }
}

/// The length of a range between two literals.
pub(super) fn literal_length(from: &Expr, to: &Expr, limits: &syn::RangeLimits) -> Option<usize> {
    let (from, to) = (literal(from)?, literal(to)?);
    Some(match limits {
        syn::RangeLimits::HalfOpen(_) => to.saturating_sub(from),
        syn::RangeLimits::Closed(_) => (to + 1).saturating_sub(from),
    })
}
