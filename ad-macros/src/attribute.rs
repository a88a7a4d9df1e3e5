//! `#[differentiable]` on a function or on an `impl` block.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{FnArg, ImplItem, ItemFn, ItemImpl, parse_quote};

use crate::expand::{Place, derivative, stub};

/// Expands the attribute. The item itself stays as it is, but for a lint.
pub fn expand(arguments: TokenStream, item: TokenStream) -> TokenStream {
    if !arguments.is_empty() {
        let error = syn::Error::new_spanned(arguments, "`#[differentiable]` takes no arguments");
        let error = error.into_compile_error();
        return quote!(#item #error);
    }
    if let Ok(function) = syn::parse2::<ItemFn>(item.clone()) {
        return function_derivative(&function);
    }
    match syn::parse2::<ItemImpl>(item.clone()) {
        Ok(block) if block.trait_.is_none() => impl_derivatives(block),
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

fn function_derivative(function: &ItemFn) -> TokenStream {
    if let Some(FnArg::Receiver(receiver)) = function.sig.inputs.first() {
        let error = syn::Error::new_spanned(
            receiver,
            "put `#[differentiable]` on the `impl` block, not on the method",
        );
        let error = error.into_compile_error();
        return quote!(#function #error);
    }
    let derivatives =
        derivative(&Place::Free, &function.attrs, &function.vis, &function.sig, &function.block)
            .unwrap_or_else(|error| {
                let stub = stub(&Place::Free, &function.vis, &function.sig);
                let error = error.into_compile_error();
                quote!(#error #stub)
            });
    quote! {
        // Its gradient may be all that is used of it.
        #[allow(dead_code)]
        #function
        #derivatives
    }
}

fn impl_derivatives(mut block: ItemImpl) -> TokenStream {
    let generics = block.generics.clone();
    let place = Place::Impl(&generics);
    let mut siblings = Vec::new();
    for item in &mut block.items {
        let ImplItem::Fn(method) = item else { continue };
        // What is made from nothing is a constant to whoever calls it.
        if method.sig.inputs.is_empty() {
            continue;
        }
        let sibling = derivative(&place, &method.attrs, &method.vis, &method.sig, &method.block)
            .unwrap_or_else(|error| {
                let stub = stub(&place, &method.vis, &method.sig);
                let error = error.into_compile_error();
                quote!(#error #stub)
            });
        siblings.push(ImplItem::Verbatim(sibling));
        // Its gradient may be all that is used of it.
        method.attrs.push(parse_quote!(#[allow(dead_code)]));
    }
    block.items.extend(siblings);
    quote!(#block)
}
