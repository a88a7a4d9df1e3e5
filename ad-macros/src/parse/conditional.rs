//! `#[cfg(..)]` and `#[cfg_attr(..)]` within an item.
//!
//! The compiler answers the conditions on an item before it runs the attributes of the item, but those
//! within it only afterwards. So the item is written twice, once for each answer to the first condition
//! within it: `#[cfg(c)] #[differentiable] ..` and `#[cfg(not(c))] #[differentiable] ..`. The attribute
//! is run for the one that the compiler leaves, which has a condition less.

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::parse::{Parse, ParseStream, Parser};
use syn::punctuated::Punctuated;
use syn::visit_mut::{self, VisitMut};
use syn::{Attribute, Block, Expr, FnArg, Item, Meta, Token, parse_quote};

/// The item for both answers to the first condition within it; `None` if there is no condition.
pub fn split(arguments: &TokenStream, item: TokenStream) -> syn::Result<Option<TokenStream>> {
    if condition_in(item.clone()).is_none() {
        return Ok(None);
    }
    let Ok(without) = syn::parse2::<Item>(item) else { return Ok(None) };
    let answered = |mut item: Item, condition, holds| {
        let mut answering = Answering { condition, holds, in_macro: None };
        visit_mut::visit_item_mut(&mut answering, &mut item);
        (item, answering)
    };
    let (with, answering) = answered(without.clone(), None, true);
    let Some(condition) = answering.condition else {
        let error = answering.in_macro.map(|span| {
            syn::Error::new(span, "what a macro is given cannot be conditional here: give the value a name before, in one `let` for each condition")
        });
        return error.map_or(Ok(None), Err);
    };
    let (without, _) = answered(without, Some(condition.clone()), false);
    Ok(Some(quote! {
        #[cfg(#condition)]
        #[::ad::differentiable(#arguments)]
        #with
        #[cfg(not(#condition))]
        #[::ad::differentiable(#arguments)]
        #without
    }))
}

/// Where the first condition stands in tokens.
fn condition_in(tokens: TokenStream) -> Option<Span> {
    tokens.into_iter().find_map(|token| match token {
        TokenTree::Group(group) => {
            let first = group.stream().into_iter().next();
            match first {
                Some(TokenTree::Ident(name))
                    if group.delimiter() == Delimiter::Bracket
                        && (name == "cfg" || name == "cfg_attr") =>
                {
                    Some(name.span())
                }
                _ => condition_in(group.stream()),
            }
        }
        _ => None,
    })
}

/// Takes one condition out of an item.
struct Answering {
    /// The condition; before the first is met, `None`.
    condition: Option<TokenStream>,
    holds: bool,
    /// Where one stands in a macro, which nobody takes out.
    in_macro: Option<Span>,
}

impl Answering {
    /// The attributes that stay; `None` where what bears them does not.
    fn attributes(&mut self, attributes: Vec<Attribute>) -> Option<Vec<Attribute>> {
        let mut left = Vec::new();
        for attribute in attributes {
            let Some((condition, conditional)) = taken_apart(&attribute) else {
                left.push(attribute);
                continue;
            };
            let asked = self.condition.get_or_insert_with(|| condition.clone());
            match conditional {
                _ if asked.to_string() != condition.to_string() => left.push(attribute),
                None if !self.holds => return None,
                Some(attributes) if self.holds => left.extend(attributes),
                _ => {}
            }
        }
        Some(left)
    }

    /// Tokens that begin with attributes.
    fn tokens(&mut self, tokens: TokenStream) -> Option<TokenStream> {
        let parser = |input: ParseStream<'_>| {
            Ok((input.call(Attribute::parse_outer)?, input.parse::<TokenStream>()?))
        };
        let (attributes, rest) = parser.parse2(tokens).expect("attributes, and anything");
        let attributes = self.attributes(attributes)?;
        Some(quote!(#(#attributes)* #rest))
    }

    fn element<T: Parse + ToTokens>(&mut self, element: &T) -> Option<T> {
        let tokens = self.tokens(element.to_token_stream())?;
        Some(syn::parse2(tokens).expect("what was parsed before, without an attribute"))
    }

    fn elements<T: Parse + ToTokens, P: Default>(&mut self, elements: &mut Punctuated<T, P>) {
        let all = std::mem::take(elements).into_iter();
        *elements = all.filter_map(|element| self.element(&element)).collect();
    }

    fn members<T: Parse + ToTokens>(&mut self, members: &mut Vec<T>) {
        let all = std::mem::take(members).into_iter();
        *members = all.filter_map(|member| self.element(&member)).collect();
    }
}

/// The condition of an attribute, and the attributes that depend on it, if it is not what bears it that does.
fn taken_apart(attribute: &Attribute) -> Option<(TokenStream, Option<Vec<Attribute>>)> {
    let Meta::List(list) = &attribute.meta else { return None };
    if list.path.is_ident("cfg") {
        return Some((list.tokens.clone(), None));
    }
    if !list.path.is_ident("cfg_attr") {
        return None;
    }
    let parser = Punctuated::<Meta, Token![,]>::parse_terminated;
    let mut metas = parser.parse2(list.tokens.clone()).ok()?.into_iter();
    let condition = metas.next()?.to_token_stream();
    Some((condition, Some(metas.map(|meta| parse_quote!(#[#meta])).collect())))
}

impl VisitMut for Answering {
    /// One within a function is answered by the compiler, or by the attribute of its own.
    fn visit_item_mut(&mut self, _: &mut Item) {}

    fn visit_macro_mut(&mut self, call: &mut syn::Macro) {
        self.in_macro = self.in_macro.or_else(|| condition_in(call.tokens.clone()));
    }

    fn visit_item_impl_mut(&mut self, block: &mut syn::ItemImpl) {
        self.members(&mut block.items);
        visit_mut::visit_item_impl_mut(self, block);
    }

    fn visit_item_trait_mut(&mut self, definition: &mut syn::ItemTrait) {
        self.members(&mut definition.items);
        visit_mut::visit_item_trait_mut(self, definition);
    }

    fn visit_signature_mut(&mut self, signature: &mut syn::Signature) {
        self.elements::<FnArg, _>(&mut signature.inputs);
        visit_mut::visit_signature_mut(self, signature);
    }

    fn visit_block_mut(&mut self, block: &mut Block) {
        let all = std::mem::take(&mut block.stmts).into_iter();
        let left = all.filter_map(|stmt| {
            let tokens = self.tokens(stmt.to_token_stream())?;
            Some(Block::parse_within.parse2(tokens).expect("a statement, without an attribute"))
        });
        block.stmts = left.flatten().collect();
        visit_mut::visit_block_mut(self, block);
    }

    fn visit_expr_match_mut(&mut self, branch: &mut syn::ExprMatch) {
        self.members(&mut branch.arms);
        visit_mut::visit_expr_match_mut(self, branch);
    }

    fn visit_expr_array_mut(&mut self, array: &mut syn::ExprArray) {
        self.elements::<Expr, _>(&mut array.elems);
        visit_mut::visit_expr_array_mut(self, array);
    }

    fn visit_expr_tuple_mut(&mut self, tuple: &mut syn::ExprTuple) {
        self.elements::<Expr, _>(&mut tuple.elems);
        visit_mut::visit_expr_tuple_mut(self, tuple);
    }

    fn visit_expr_call_mut(&mut self, call: &mut syn::ExprCall) {
        self.elements::<Expr, _>(&mut call.args);
        visit_mut::visit_expr_call_mut(self, call);
    }

    fn visit_expr_method_call_mut(&mut self, call: &mut syn::ExprMethodCall) {
        self.elements::<Expr, _>(&mut call.args);
        visit_mut::visit_expr_method_call_mut(self, call);
    }

    fn visit_expr_struct_mut(&mut self, value: &mut syn::ExprStruct) {
        self.elements(&mut value.fields);
        visit_mut::visit_expr_struct_mut(self, value);
    }

    fn visit_pat_struct_mut(&mut self, pattern: &mut syn::PatStruct) {
        let left = std::mem::take(&mut pattern.fields).into_iter().filter_map(|mut field| {
            field.attrs = self.attributes(std::mem::take(&mut field.attrs))?;
            Some(field)
        });
        pattern.fields = left.collect();
        visit_mut::visit_pat_struct_mut(self, pattern);
    }
}
