//! `#[differentiable]` on a function or on an `impl` block.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::visit_mut::{self, VisitMut};
use syn::{
    Attribute, Expr, ExprForLoop, ExprLoop, ExprWhile, FnArg, ImplItem, ItemFn, ItemImpl, Meta,
    Token, parse_quote,
};

use crate::expand::{Place, derivative, stub};

/// What stands in the parentheses of the attribute.
#[derive(Clone, Copy, Default)]
pub struct Options {
    /// `checkpoint`: the pullback keeps the arguments alone.
    pub checkpoint: bool,
}

impl Parse for Options {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut options = Self::default();
        for option in Punctuated::<Ident, Token![,]>::parse_terminated(input)? {
            match option == "checkpoint" {
                true => options.checkpoint = true,
                false => {
                    return Err(syn::Error::new_spanned(
                        option,
                        "the arguments of `#[differentiable]` are: `checkpoint`",
                    ));
                }
            }
        }
        Ok(options)
    }
}

/// Whether an attribute is this crate's.
pub fn is_own(attribute: &Attribute) -> bool {
    attribute.path().segments.last().is_some_and(|last| last.ident == "differentiable")
}

/// What this crate's attributes say among those of a method or a loop.
pub fn own_options(attributes: &[Attribute]) -> syn::Result<Options> {
    let mut options = Options::default();
    for attribute in attributes.iter().filter(|attribute| is_own(attribute)) {
        if let Meta::List(list) = &attribute.meta {
            options.checkpoint |= list.parse_args::<Options>()?.checkpoint;
        }
    }
    Ok(options)
}

/// Takes this crate's attributes off the loops in a body: the compiler knows none there.
struct Clean;

impl VisitMut for Clean {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        if let Expr::ForLoop(ExprForLoop { attrs, .. })
        | Expr::While(ExprWhile { attrs, .. })
        | Expr::Loop(ExprLoop { attrs, .. }) = expr
        {
            attrs.retain(|attribute| !is_own(attribute));
        }
        visit_mut::visit_expr_mut(self, expr);
    }
}

/// Expands the attribute. The item itself stays as it is, but for a lint.
pub fn expand(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let options = match syn::parse2::<Options>(arguments) {
        Ok(options) => options,
        Err(error) => {
            let error = error.into_compile_error();
            return quote!(#item #error);
        }
    };
    if let Ok(function) = syn::parse2::<ItemFn>(item.clone()) {
        return function_derivative(&function, options);
    }
    match syn::parse2::<ItemImpl>(item.clone()) {
        Ok(block) if block.trait_.is_none() => impl_derivatives(block, options),
        Ok(block) => {
            let error = syn::Error::new_spanned(
                block.trait_.map(|(path, _)| path),
                "`impl` of a trait is not supported: put the computation into an inherent method, and call that",
            );
            let error = error.into_compile_error();
            quote!(#item #error)
        }
        Err(_) => {
            let error = syn::Error::new(
                proc_macro2::Span::call_site(),
                "`#[differentiable]` goes on a function with a body or on an `impl` block of a type",
            );
            let error = error.into_compile_error();
            quote!(#item #error)
        }
    }
}

fn function_derivative(function: &ItemFn, options: Options) -> TokenStream {
    if let Some(FnArg::Receiver(receiver)) = function.sig.inputs.first() {
        let error = syn::Error::new_spanned(
            receiver,
            "put `#[differentiable]` on the `impl` block, not on the method",
        );
        let error = error.into_compile_error();
        return quote!(#function #error);
    }
    let derivatives = derivative(
        &Place::Free,
        &function.attrs,
        &function.vis,
        &function.sig,
        &function.block,
        options,
    )
    .unwrap_or_else(|error| {
        let stub = stub(&Place::Free, &function.vis, &function.sig);
        let error = error.into_compile_error();
        quote!(#error #stub)
    });
    let mut function = function.clone();
    Clean.visit_block_mut(&mut function.block);
    quote! {
        // Its gradient may be all that is used of it.
        #[allow(dead_code)]
        #function
        #derivatives
    }
}

fn impl_derivatives(mut block: ItemImpl, options: Options) -> TokenStream {
    let generics = block.generics.clone();
    let place = Place::Impl(&generics);
    let mut siblings = Vec::new();
    for item in &mut block.items {
        let ImplItem::Fn(method) = item else { continue };
        // What is made from nothing is a constant to whoever calls it.
        if method.sig.inputs.is_empty() {
            continue;
        }
        let sibling = own_options(&method.attrs)
            .and_then(|own| {
                method.attrs.retain(|attribute| !is_own(attribute));
                let options = Options { checkpoint: options.checkpoint || own.checkpoint };
                derivative(&place, &method.attrs, &method.vis, &method.sig, &method.block, options)
            })
            .unwrap_or_else(|error| {
                let stub = stub(&place, &method.vis, &method.sig);
                let error = error.into_compile_error();
                quote!(#error #stub)
            });
        siblings.push(ImplItem::Verbatim(sibling));
        Clean.visit_block_mut(&mut method.block);
        // Its gradient may be all that is used of it.
        method.attrs.push(parse_quote!(#[allow(dead_code)]));
    }
    block.items.extend(siblings);
    quote!(#block)
}
