//! Adapters that make one iterator of several, or several items of one: `chain`, `filter_map`,
//! `flat_map`.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{quote, quote_spanned};
use syn::{Expr, Pat, Stmt};

use super::chain::{Chain, is_chain};
use super::item::{Access, Item};
use super::stage::{Items, Rest, Reversal};
use crate::ir::{Arm, Binding, BranchKind, Operand, Place, Target};
use crate::lower::Lowerer;
use crate::lower::flow::ends::End;
use crate::lower::syntax::{as_statements, strip_parens};

impl Lowerer<'_> {
    /// `left.chain(right)`: each item comes with the side that it is from.
    pub(super) fn chained(&mut self, left: &Chain, right: &Chain, pat: Option<&Pat>) -> Items {
        let side = self.names.fresh("side", Span::call_site());
        let side_var = self.var(side.clone(), false, false);
        // Each side gives its items on under a name, even where nobody uses them.
        let pat = pat.filter(|pat| !matches!(pat, Pat::Wild(_)));
        let mut sources = Vec::new();
        let arms = [(left, quote!(Left)), (right, quote!(Right))].map(|(chain, variant)| {
            let mut pattern = TokenStream::new();
            let mut bindings = Vec::new();
            let body = self.block(|lowerer| {
                let mut items = lowerer.items(chain, pat);
                let bound = items.defines.iter();
                bindings.extend(bound.map(|&var| Binding::new(var, Vec::new())));
                let stages = std::mem::take(&mut items.stages);
                let item = lowerer.staged(items.item.clone(), stages);
                let inner = &items.pattern;
                pattern = quote!(::ad::rt::Side::#variant(#inner));
                items.adapt(&quote!(.map(::ad::rt::Side::#variant)));
                sources.push((items.iterator, item.refers()));
                lowerer.item_value(item)
            });
            Arm { pattern, guard: None, bindings, body }
        });
        let refers = sources.iter().any(|(_, refers)| *refers);
        let value = self.branch(
            BranchKind::Match(quote!(#side), None),
            arms.into(),
            true,
            Span::call_site(),
        );
        if let (Operand::Var(var), true) = (&value, refers) {
            self.vars[*var].reference = true;
        }
        let [(left, _), (right, _)] = &sources[..] else { unreachable!("there are two sides") };
        Items {
            iterator: quote!(#left.chain(#right)),
            is_range: false,
            reversal: Reversal::No,
            pattern: quote!(#side),
            defines: vec![side_var],
            item: Item::Value(value),
            stages: Vec::new(),
        }
    }

    /// Goes on with the content of an option; without one the item is dropped, or the loop ends.
    pub(super) fn run_some(
        &mut self,
        content: Operand,
        stops: bool,
        own: Target,
        end: &End,
        rest: &mut Rest<'_>,
    ) -> Operand {
        let span = Span::call_site();
        let option = self.named(content, "option", span);
        let (ident, active) = (self.ident(option).clone(), self.vars[option].active);
        let mut binding = None;
        let mut pattern = TokenStream::new();
        let passes = self.block(|lowerer| {
            let ident = lowerer.names.fresh("content", span);
            let var = lowerer.var(ident.clone(), false, active);
            binding = Some(Binding::new(var, Vec::new()));
            pattern = quote!(::core::option::Option::Some(#ident));
            let item = match active {
                true => Item::Value(Operand::Var(var)),
                false => Item::Constant(var),
            };
            rest(lowerer, item)
        });
        let drops = self.block(|lowerer| match stops {
            true => lowerer.exit(own, Self::unit(), end),
            false => lowerer.normal_end(Self::unit(), end),
        });
        let arms = vec![
            Arm { pattern, guard: None, bindings: binding.into_iter().collect(), body: passes },
            Arm { pattern: quote!(_), guard: None, bindings: Vec::new(), body: drops },
        ];
        let source = active.then(|| Place::of(option));
        self.branch(BranchKind::Match(quote!(#ident), source), arms, true, span)
    }

    /// Runs a loop over the items of an iterator for each item.
    pub(super) fn run_flat(
        &mut self,
        item: Item,
        function: Option<&Expr>,
        method: &Ident,
        end: &End,
        rest: &mut Rest<'_>,
    ) -> Operand {
        if !end.exits.is_empty() {
            return self.refuse(
                method,
                format!(
                    "a loop over `{method}` cannot be left early: write two loops, one in the other"
                ),
            );
        }
        let outside = self.scopes.clone();
        let mut body = |lowerer: &mut Lowerer<'_>, item: Item, end: &End| {
            // What follows does not see the names of the closure.
            let inside = std::mem::replace(&mut lowerer.scopes, outside.clone());
            lowerer.scopes.open();
            let value = rest(lowerer, item);
            lowerer.scopes = inside;
            lowerer.normal_end(value, end)
        };
        let Some(function) = function else {
            let chain = self.chain_of(item, method);
            self.run_over(&chain, &mut body);
            return Self::unit();
        };
        let named = self.named_closure(function);
        let closure = match (&named, strip_parens(function)) {
            (Some(named), _) => {
                self.scopes.clone_from(&named.scopes);
                &named.body
            }
            (None, Expr::Closure(closure)) => closure,
            _ => return self.refuse(function, "write a closure here, whose value is an iterator"),
        };
        let statements = as_statements(&closure.body);
        let inner = match &statements[..] {
            [Stmt::Expr(inner, None)] if is_chain(inner) || is_list(inner) => inner,
            _ => {
                self.scopes.clone_from(&outside);
                return self.refuse(
                    &closure.body,
                    "the value of this closure has to be an iterator or an array, in one expression: write two loops, one in the other",
                );
            }
        };
        self.scope(|lowerer| {
            if let [pat] = &closure.inputs.iter().collect::<Vec<_>>()[..] {
                lowerer.bind_item(pat, item);
            }
            lowerer.run_chain(inner, &mut body);
        });
        self.scopes.clone_from(&outside);
        Self::unit()
    }

    /// The elements of an item.
    fn chain_of(&mut self, item: Item, method: &Ident) -> Chain {
        let (place, access) = match item {
            Item::Reference(alias) if alias.is_exclusive => (alias.place, Access::Exclusive),
            Item::Reference(alias) => (alias.place, Access::Shared),
            Item::Copy(place) | Item::Moved(place) => (place, Access::Value),
            item => {
                let value = self.item_value(item);
                match value {
                    Operand::Var(root) => {
                        let access = match self.may_refer(root) {
                            true => Access::Shared,
                            false => Access::Value,
                        };
                        (Place::of(root), access)
                    }
                    Operand::Constant(tokens) => {
                        let root = self.define_constant("items", Span::call_site(), tokens);
                        (Place::of(root), Access::Value)
                    }
                }
            }
        };
        let tokens = self.place_tokens(&place);
        match access {
            _ if self.vars[place.root].active => {}
            Access::Value => {
                return Chain::Constant { iterator: tokens, length: None, is_range: false };
            }
            Access::Shared => {
                let list = quote_spanned!(method.span()=> ::ad::rt::Flat::list(&#tokens));
                let root = self.define_constant("items", Span::call_site(), list);
                let place = Place::of(root);
                return Chain::Elements { place, access, length: None };
            }
            Access::Exclusive => {}
        }
        // What is flattened may be an option, which has no elements.
        let code = quote_spanned!(method.span()=> ::ad::rt::is_sequence(&#tokens););
        self.push_plain(code);
        Chain::Elements { place, access, length: None }
    }
}

/// Whether this is an array or a `vec!`, written down.
fn is_list(expr: &Expr) -> bool {
    match strip_parens(expr) {
        Expr::Array(_) | Expr::Repeat(_) => true,
        Expr::Macro(call) => call.mac.path.is_ident("vec"),
        _ => false,
    }
}
