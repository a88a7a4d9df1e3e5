//! Methods that lend one element of a slice, to be changed or not, `last_mut`, `first_mut`, `get_mut`, `last`,
//! `first`, `get`, or the content of an option to be changed, `as_mut`.
//!
//! The element has a place, `slice[position]`, and that is what is written. The content has none but
//! the reference, which gets a name.

use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Expr, ExprMatch, ExprMethodCall, Pat, parse_quote};

use crate::ir::{Arm, BranchKind, Operand, Place, Projection, Statement};
use crate::lower::Lowerer;
use crate::lower::iterate::chain::is_chain;
use crate::lower::state::Container;
use crate::lower::syntax::{base, is_transparent, simple_name, simple_path, strip_parens};

/// The slice, and the position of the element that a method of it lends.
struct Lent<'e> {
    slice: &'e Expr,
    position: Expr,
    /// Whether it may be changed.
    is_exclusive: bool,
}

impl<'e> Lent<'e> {
    /// `slice.last_mut()`, `slice.last()` and their kin.
    fn option(expr: &'e Expr) -> Option<Self> {
        let Expr::MethodCall(ExprMethodCall { receiver, method, args, .. }) = strip_parens(expr)
        else {
            return None;
        };
        // An item of all elements is an element.
        let method = method.to_string();
        let (slice, method) = match (&**receiver, &*method) {
            (Expr::MethodCall(all), "next") if all.method == "iter_mut" => {
                (&all.receiver, "first_mut")
            }
            (Expr::MethodCall(all), "last") if all.method == "iter_mut" => {
                (&all.receiver, "last_mut")
            }
            (Expr::MethodCall(all), "nth") if all.method == "iter_mut" => {
                (&all.receiver, "get_mut")
            }
            (_, name) => (receiver, name),
        };
        let arguments: Vec<_> = args.iter().collect();
        let position = match (method, &arguments[..]) {
            ("first_mut" | "first", []) => parse_quote!(0),
            // Of an empty one the position is too large.
            ("last_mut" | "last", []) => parse_quote!(#slice.len().wrapping_sub(1)),
            // By a range it lends another slice.
            ("get_mut" | "get", [position]) if !matches!(position, Expr::Range(_)) => {
                parse_quote!(#position)
            }
            _ => return None,
        };
        Some(Self { slice, position, is_exclusive: method.ends_with("_mut") })
    }

    /// `slice.last_mut().unwrap()`, `slice.last().unwrap()` and their kin.
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
    pub fn is_lent_element(&self, expr: &Expr) -> bool {
        let whole = match Lent::element(expr) {
            Some(lent) => lent.is_exclusive.then_some(lent.slice),
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
        let Lent { slice, position, .. } = Lent::element(&expr)?;
        let place = self.sequence(slice)?;
        let whole = self.place_tokens(&place);
        let position = self.index(&position, &whole);
        Some(Self::element(&place, position))
    }

    /// The content of an option that `lent` gives, by a name for the reference to it.
    fn content(&mut self, expr: &Expr, lent: &ExprMethodCall) -> Option<Place> {
        if matches!(self.container(&lent.receiver), Some(Container::Result)) {
            let instead = "the content of a result is changed by a pattern: `if let Ok(x) = &mut result { .. }`";
            self.refuse(lent, instead);
        }
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

    /// The place to which an expression is a `&`, if it is one to an element of a slice with a derivative.
    pub fn shared_element(&mut self, expr: &Expr) -> Option<Place> {
        let lent = Lent::element(expr).filter(|lent| !lent.is_exclusive)?;
        if !self.is_active_slice(lent.slice) {
            return None;
        }
        self.or_undone(|lowerer| {
            let expr = lowerer.repeatable_lent(expr);
            let Lent { slice, position, .. } = Lent::element(&expr)?;
            let place = lowerer.sequence(slice)?;
            let name = lowerer.names.unwritten("position");
            lowerer.statement(&parse_quote!(let #name: usize = #position;));
            Some(Self::element(&place, lowerer.plain(&parse_quote!(#name))))
        })
    }

    /// Whether an expression is a place with a derivative that may be a slice.
    fn is_active_slice(&self, slice: &Expr) -> bool {
        !is_chain(slice) && !self.calls_own_methods(slice) && self.is_part_of_active(slice)
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
    pub fn match_on_lent(
        &mut self,
        branch: &ExprMatch,
        lower_arm: &mut dyn FnMut(&mut Self, &Expr) -> Operand,
    ) -> Option<(BranchKind, Vec<Arm>)> {
        let Lent { slice, is_exclusive, .. } = Lent::option(&branch.expr)?;
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
        let content = content(&full.pat)?;
        // What is behind a `&` is named, or else a value like any other.
        if !is_exclusive && (simple_name(&content).is_none() || !self.is_active_slice(slice)) {
            return None;
        }
        let lent = self.repeatable_lent(&branch.expr);
        let Lent { slice, position, .. } = Lent::option(&lent)?;
        let (slice, place) = (slice.clone(), self.sequence(slice)?);
        let name = self.names.unwritten("position");
        self.statement(&parse_quote!(let #name: usize = #position;));
        let (place, position) = (self.place_tokens(&place), self.plain(&parse_quote!(#name)));
        let element: Expr = parse_quote!(#slice[#name]);
        let full = self.block(|lowerer| {
            match simple_name(&content) {
                Some(name) if is_exclusive => lowerer.exclusive_alias(name, &element),
                Some(name) => _ = lowerer.shared_alias(name, &element),
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

    /// Whether a place is a part of a variable that has a derivative.
    fn is_part_of_active(&self, place: &Expr) -> bool {
        self.root_of(place).is_some_and(|root| self.vars[root].active)
    }

    /// `match &option { Some(x) => .. }` for `match option.as_ref() { Some(x) => .. }`.
    pub fn option_by_reference(&self, branch: &ExprMatch) -> Option<Expr> {
        let Expr::MethodCall(call) = strip_parens(&branch.expr) else { return None };
        let tells_option =
            |pat: &Pat| matches!(pat, Pat::TupleStruct(pattern) if is_transparent(&pattern.path));
        let is_it = call.method == "as_ref"
            && call.args.is_empty()
            && self.is_part_of_active(&call.receiver)
            && !self.calls_own_methods(&call.receiver)
            && branch.arms.iter().any(|arm| tells_option(&arm.pat));
        let (option, arms) = (&call.receiver, &branch.arms);
        is_it.then(|| parse_quote!(match &#option { #(#arms)* }))
    }

    /// A place that is a slice, which is checked: somebody else's type may have methods of these names.
    fn sequence(&mut self, slice: &Expr) -> Option<Place> {
        let place = self.place(slice)?;
        let tokens = self.place_tokens(&place);
        let code = quote_spanned!(slice.span()=> ::ad::rt::is_sequence(&#tokens););
        self.push_plain(code);
        Some(place)
    }
}
