//! `p.scale(2.0).shift(1.0);`, where each method returns its receiver (see [`itself`](crate::parse::itself)).
//!
//! What the last method changes is the receiver of the first, since nobody uses what it returns. So each
//! is called on that receiver, and what those before the last return is checked to be no other.

use quote::quote_spanned;
use syn::{Expr, ExprMethodCall, parse_quote};

use super::is_predicate;
use crate::lower::Lowerer;
use crate::lower::iterate::chain::is_chain;
use crate::lower::syntax::strip_parens;
use crate::rules;

impl Lowerer<'_> {
    /// The methods of such a statement, the last one first.
    pub fn links<'e>(&self, call: &'e ExprMethodCall) -> Option<Vec<&'e ExprMethodCall>> {
        let mut links = vec![call];
        let mut place = strip_parens(&call.receiver);
        while let Expr::MethodCall(inner) = place
            && !self.is_lent_element(place)
        {
            let name = inner.method.to_string();
            if is_chain(place) || rules::is_method(&name) || is_predicate(&name) {
                return None;
            }
            links.push(inner);
            place = strip_parens(&inner.receiver);
        }
        // What is lent beside the receiver may be what is changed.
        let lends = |link: &&ExprMethodCall| {
            link.args.iter().any(|argument| self.is_lent_exclusively(argument))
        };
        let can_change = self.can_change(place) || self.is_lent_element(place);
        (links.len() > 1 && can_change && !links.iter().any(lends)).then_some(links)
    }

    /// Calls methods on the receiver of the first.
    pub fn called_in_turn(&mut self, mut links: Vec<&ExprMethodCall>) {
        let Some(first) = links.pop() else { return };
        // An argument may change what an index of the receiver reads, which is evaluated before.
        let mut place = strip_parens(&first.receiver).clone();
        if !matches!(place, Expr::Path(_)) {
            let name = self.names.unwritten("receiver");
            let target = match self.is_lent_element(&place) {
                true => parse_quote!(*#place),
                false => place,
            };
            self.exclusive_alias(&name, &target);
            place = parse_quote!(#name);
        }
        let mut link = first;
        loop {
            let receiver = Box::new(place.clone());
            let call = Expr::MethodCall(ExprMethodCall { receiver, ..link.clone() });
            let value = self.operand(&call, "value");
            let Some(next) = links.pop() else { return self.discard(value) };
            let value = self.tokens(&value);
            let code = quote_spanned!(link.method.span()=> ::ad::rt::returned_itself(&#value););
            self.push_plain(code);
            link = next;
        }
    }
}
