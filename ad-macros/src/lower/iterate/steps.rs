//! Iterators that have a name, and are asked for one item after the other: `let mut it = xs.iter();`,
//! `while let Some(x) = it.next()`.
//!
//! Such an iterator is a position in what it runs over, which it lends: `it.next()` is the element there,
//! as `get` and `get_mut` lend it, and what uses the rest up runs over the elements from there on.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{Expr, Item, Local, Macro, PatIdent, Stmt, parse_quote, parse_quote_spanned};

use super::chain::is_adapter;
use crate::lower::Lowerer;
use crate::lower::scopes::Name;
use crate::lower::state::Alias;
use crate::lower::syntax::{simple_name, strip_parens};
use crate::names;

impl Lowerer<'_> {
    /// `let mut it = xs.iter(); rest` as `rest` with a position in the place of the iterator.
    pub fn stepped(&mut self, stmt: &Stmt, rest: &[Stmt]) -> Option<Vec<Stmt>> {
        let Stmt::Local(Local { pat, init: Some(init), .. }) = stmt else { return None };
        let name = simple_name(pat)?;
        let (source, copied) = match strip_parens(&init.expr) {
            Expr::MethodCall(call) if call.method == "copied" || call.method == "cloned" => {
                (strip_parens(&call.receiver), Some(&call.method))
            }
            value => (value, None),
        };
        let Expr::MethodCall(source) = source else { return None };
        let is_exclusive = source.method == "iter_mut";
        if !(is_exclusive || source.method == "iter") || !source.args.is_empty() {
            return None;
        }
        let place = self.active_place(&source.receiver)?;
        let [elements, position] = ["elements", "position"].map(|name| self.names.unwritten(name));
        let alias = match is_exclusive {
            true => Alias::exclusive(place),
            false => Alias { depth: 0, ..Alias::shared(place) },
        };
        self.alias_place(&elements, alias);
        let mut steps = Steps {
            name: Name::of(name),
            elements,
            position: position.clone(),
            is_exclusive,
            copied: copied.map(|method| quote!(.#method())),
            other: None,
        };
        let mut rest = rest.to_vec();
        rest.iter_mut().for_each(|stmt| steps.visit_stmt_mut(stmt));
        if let Some(other) = steps.other {
            self.refuse(
                other,
                "an iterator that has a name is asked for its `next()` or used up, by a `for` loop, `sum`, `fold`: write one of these here, and give nothing else its name",
            );
            self.bind(name, true, false);
        }
        rest.insert(0, parse_quote!(let mut #position: usize = 0;));
        Some(rest)
    }
}

/// Puts a position in the place of an iterator.
struct Steps {
    name: Name,
    elements: Ident,
    position: Ident,
    /// Whether the elements may be changed.
    is_exclusive: bool,
    /// `.copied()`
    copied: Option<TokenStream>,
    /// Another use of the name.
    other: Option<Ident>,
}

impl Steps {
    fn is_named(&self, expr: &Expr) -> bool {
        matches!(strip_parens(expr), Expr::Path(path)
            if path.path.get_ident().is_some_and(|name| Name::of(name) == self.name))
    }

    /// `it.by_ref()`, `&mut it`
    fn is_lent(&self, expr: &Expr) -> bool {
        match strip_parens(expr) {
            Expr::MethodCall(call) => call.method == "by_ref" && self.is_named(&call.receiver),
            Expr::Reference(reference) => {
                reference.mutability.is_some() && self.is_named(&reference.expr)
            }
            _ => false,
        }
    }

    /// The next element.
    fn next(&self, span: Span) -> Expr {
        let Self { elements, position, copied, .. } = self;
        let lent = Ident::new(if self.is_exclusive { "get_mut" } else { "get" }, span);
        parse_quote_spanned!(span=> #elements.#lent(::ad::rt::advance(&mut #position))#copied)
    }

    /// What has not been asked for yet.
    fn remaining(&self, span: Span) -> Box<Expr> {
        let Self { elements, position, copied, .. } = self;
        let lent = Ident::new(if self.is_exclusive { "iter_mut" } else { "iter" }, span);
        parse_quote_spanned! {span=>
            #elements[#position.min(#elements.len())..].#lent()#copied
        }
    }

    fn note(&mut self, name: &Ident) {
        if Name::of(name) == self.name {
            self.other.get_or_insert_with(|| name.clone());
        }
    }
}

/// Whether a method takes the iterator that it is called on.
fn uses_up(method: &Ident) -> bool {
    const METHODS: [&str; 8] =
        ["collect", "count", "fold", "for_each", "last", "product", "reduce", "sum"];
    is_adapter(method) || METHODS.iter().any(|name| method == name)
}

impl VisitMut for Steps {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        match expr {
            Expr::MethodCall(call) if self.is_named(&call.receiver) => {
                if call.method == "next" && call.args.is_empty() {
                    *expr = self.next(call.span());
                    return;
                }
                if uses_up(&call.method) {
                    call.receiver = self.remaining(call.receiver.span());
                }
            }
            Expr::ForLoop(a_loop) if self.is_named(&a_loop.expr) => {
                a_loop.expr = self.remaining(a_loop.expr.span());
            }
            Expr::ForLoop(a_loop) if self.is_lent(&a_loop.expr) => {
                let next = self.next(a_loop.expr.span());
                let syn::ExprForLoop { attrs, label, pat, body, .. } = a_loop;
                *expr = parse_quote! {
                    #(#attrs)* #label while let ::core::option::Option::Some(#pat) = #next #body
                };
            }
            Expr::Path(path) => {
                if let Some(name) = path.path.get_ident() {
                    self.note(name);
                }
            }
            _ => {}
        }
        visit_mut::visit_expr_mut(self, expr);
    }

    fn visit_pat_ident_mut(&mut self, pat: &mut PatIdent) {
        self.note(&pat.ident);
        visit_mut::visit_pat_ident_mut(self, pat);
    }

    fn visit_macro_mut(&mut self, call: &mut Macro) {
        names::identifiers(call.tokens.clone()).iter().for_each(|name| self.note(name));
    }

    fn visit_item_mut(&mut self, _: &mut Item) {}
}
