//! Methods that lend one element of a slice to be changed, `last_mut`, `first_mut`, `get_mut`, or the
//! content of an option, `as_mut`.
//!
//! The element has a place, `slice[position]`, and that is what is written. The content has none but
//! the reference, which gets a name.

use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Expr, ExprMatch, ExprMethodCall, Pat, parse_quote};

use super::Lowerer;
use super::syntax::{base, is_transparent, simple_name, simple_path, strip_parens};
use crate::ir::{Arm, BranchKind, Operand, Place, Projection, Statement};

/// The slice, and the position of the element that a method of it lends.
struct Lent<'e> {
    slice: &'e Expr,
    position: Expr,
}

impl<'e> Lent<'e> {
    /// `slice.last_mut()` and its kin.
    fn option(expr: &'e Expr) -> Option<Self> {
        let Expr::MethodCall(ExprMethodCall { receiver, method, args, .. }) = strip_parens(expr)
        else {
            return None;
        };
        // An item of all elements is an element.
        let (slice, method) = match (&**receiver, &*method.to_string()) {
            (Expr::MethodCall(all), name @ ("next" | "last" | "nth"))
                if all.method == "iter_mut" =>
            {
                (&all.receiver, name.to_owned())
            }
            (_, "next" | "last" | "nth") => return None,
            (_, name) => (receiver, name.to_owned()),
        };
        let arguments: Vec<_> = args.iter().collect();
        let position = match (&*method, &arguments[..]) {
            ("first_mut" | "next", []) => parse_quote!(0),
            // Of an empty one the position is too large.
            ("last_mut" | "last", []) => parse_quote!(#slice.len().wrapping_sub(1)),
            // By a range it lends another slice.
            ("get_mut" | "nth", [position]) if !matches!(position, Expr::Range(_)) => {
                parse_quote!(#position)
            }
            _ => return None,
        };
        Some(Self { slice, position })
    }

    /// `slice.last_mut().unwrap()` and its kin.
    fn element(expr: &'e Expr) -> Option<Self> {
        match strip_parens(expr) {
            Expr::MethodCall(call) if call.method == "unwrap" || call.method == "expect" => {
                Self::option(&call.receiver)
            }
            _ => None,
        }
    }
}

/// `option.as_mut()` of `option.as_mut().unwrap()`.
fn lent_content(expr: &Expr) -> Option<&ExprMethodCall> {
    match strip_parens(expr) {
        Expr::MethodCall(call) if call.method == "unwrap" || call.method == "expect" => {
            match strip_parens(&call.receiver) {
                Expr::MethodCall(lent) if lent.method == "as_mut" => Some(lent),
                _ => None,
            }
        }
        _ => None,
    }
}

impl Lowerer<'_> {
    /// Whether an expression is a `&mut` to an element of a slice, or to the content of an option, that has
    /// a place.
    pub(super) fn is_lent_element(&self, expr: &Expr) -> bool {
        let whole = match Lent::element(expr) {
            Some(lent) => Some(lent.slice),
            None => lent_content(expr).map(|lent| &*lent.receiver),
        };
        whole.is_some_and(|whole| match base(whole) {
            lends @ Expr::MethodCall(_) => self.is_lent_element(lends),
            name => simple_path(name).is_some_and(|name| self.lookup(name).is_some()),
        })
    }

    /// The place to which an expression is a `&mut`, if it is one to an element of a slice or to the
    /// content of an option.
    pub(super) fn lent_element(&mut self, expr: &Expr) -> Option<Place> {
        if let Some(lent) = lent_content(expr) {
            return self.content(expr, lent);
        }
        Lent::element(expr)?;
        let expr = self.repeatable_lent(expr);
        let Lent { slice, position } = Lent::element(&expr)?;
        let mut place = self.sequence(slice)?;
        let whole = self.place_tokens(&place);
        let position = self.index(&position, &whole);
        place.path.push(Projection::Index(position));
        Some(place)
    }

    /// The content of an option that `lent` gives, by a name for the reference to it.
    fn content(&mut self, expr: &Expr, lent: &ExprMethodCall) -> Option<Place> {
        let mut place = self.exclusive_scrutinee(&Expr::MethodCall(lent.clone()))?;
        let Expr::MethodCall(taken) = strip_parens(expr) else { return None };
        let name = self.names.fresh("content", expr.span());
        let bound = self.var(name.clone(), false, false);
        let (option, method, message) = (self.place_tokens(&place), &taken.method, &taken.args);
        let code = quote_spanned! {expr.span()=>
            let #name = ::ad::rt::lent_content(#option.as_mut()).#method(#message);
        };
        self.push(Statement::Plain { code, defines: vec![bound] });
        place.path.push(Projection::Behind(bound));
        Some(place)
    }

    /// A method that lends an element, of a slice that can be written more than once.
    fn repeatable_lent(&mut self, expr: &Expr) -> Expr {
        let mut lent = strip_parens(expr).clone();
        if let Expr::MethodCall(call) = &mut lent {
            let receiver = &call.receiver;
            *call.receiver = match **receiver {
                Expr::MethodCall(_) => self.repeatable_lent(receiver),
                _ => self.repeatable(receiver),
            };
        }
        lent
    }

    /// The arms of a `match` on an option of a `&mut` to an element, if it is that.
    pub(super) fn match_on_lent(
        &mut self,
        branch: &ExprMatch,
        lower_arm: &mut dyn FnMut(&mut Self, &Expr) -> Operand,
    ) -> Option<(BranchKind, Vec<Arm>)> {
        Lent::option(&branch.expr)?;
        let lent = self.repeatable_lent(&branch.expr);
        let Lent { slice, position } = Lent::option(&lent)?;
        let content = |pat: &Pat| match pat {
            Pat::TupleStruct(pattern) if is_transparent(&pattern.path) => {
                pattern.elems.first().cloned()
            }
            _ => None,
        };
        let (full, empty) = match &branch.arms.iter().collect::<Vec<_>>()[..] {
            [full, empty] if content(&full.pat).is_some() => (*full, *empty),
            [empty, full] if content(&full.pat).is_some() => (*full, *empty),
            _ => return None,
        };
        let (content, slice) = (content(&full.pat)?, slice.clone());
        let place = self.sequence(&slice)?;
        let name = self.names.unwritten("position");
        self.statement(&parse_quote!(let #name: usize = #position;));
        let (place, position) = (self.place_tokens(&place), self.plain(&parse_quote!(#name)));
        let element: Expr = parse_quote!(#slice[#name]);
        let full = self.block(|lowerer| {
            match simple_name(&content) {
                Some(name) => lowerer.exclusive_alias(name, &element),
                None if matches!(content, Pat::Wild(_)) => {}
                None if lowerer.take_apart_exclusively(&content, &parse_quote!(&mut #element)) => {}
                None => {
                    lowerer.refuse(&content, "give the element a name here, and match on that");
                }
            }
            lower_arm(lowerer, &full.body)
        });
        let empty = self.block(|lowerer| lower_arm(lowerer, &empty.body));
        let arms = [full, empty].map(Arm::plain);
        Some((BranchKind::If(quote!(#position < #place.len())), arms.into()))
    }

    /// A place that is a slice, which is checked: somebody else's type may have methods of these names.
    fn sequence(&mut self, slice: &Expr) -> Option<Place> {
        let place = self.place(slice)?;
        let tokens = self.place_tokens(&place);
        let code = quote_spanned!(slice.span()=> ::ad::rt::is_sequence(&#tokens););
        self.push(Statement::Plain { code, defines: Vec::new() });
        Some(place)
    }
}
