//! Elements of one's own types: `#[differentiable]` on `impl Index<(usize, usize)> for Matrix`.
//!
//! The blocks stay as they are. Where the index is a tuple, beside `index` stands a method that returns a
//! copy of the element, and beside `index_mut` one that replaces it, both differentiated like any
//! others: `m[(i, j)]` and `m[(i, j)] = x` in a differentiable function call them. That a type has its
//! own `Index` the tuple tells, for arrays and `Vec`s have none by tuples. Any other index leads to a
//! [`part`] of the tangent.

mod part;

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{
    Expr, FnArg, GenericArgument, ImplItem, ImplItemFn, ItemImpl, PathArguments, Stmt, Type,
    parse_quote,
};

use crate::lower::{getter, setter};

/// Whether a trait is `Index` or `IndexMut`.
pub fn is_index(path: &syn::Path) -> bool {
    path.segments.last().is_some_and(|last| last.ident == "Index" || last.ident == "IndexMut")
}

/// What stands beside an `impl` of `Index` or `IndexMut`; nothing if there is no method, of which the
/// compiler complains. `differentiated` gives the derivatives of another `impl`.
pub fn beside(
    path: &syn::Path,
    block: &ItemImpl,
    differentiated: impl FnOnce(ItemImpl) -> TokenStream,
) -> syn::Result<TokenStream> {
    let method = block.items.iter().find_map(|item| match item {
        ImplItem::Fn(method) => Some(method),
        _ => None,
    });
    let Some(method) = method else { return Ok(TokenStream::new()) };
    let is_tuple = path.segments.last().is_some_and(|last| match &last.arguments {
        PathArguments::AngleBracketed(arguments) => {
            matches!(arguments.args.first(), Some(GenericArgument::Type(Type::Tuple(_))))
        }
        _ => false,
    });
    match is_tuple {
        true => by_tuple(block, method).map(differentiated),
        false => part::of_tangent(block, method),
    }
}

/// The method beside `index` or `index_mut`, in a block of its own.
fn by_tuple(block: &ItemImpl, method: &ImplItemFn) -> syn::Result<ItemImpl> {
    let (place, before) = match method.block.stmts.split_last() {
        Some((Stmt::Expr(Expr::Reference(reference), None), before)) => (&reference.expr, before),
        Some((last, _)) => return Err(not_a_reference(last)),
        None => return Err(not_a_reference(&method.block)),
    };
    let (getter, setter) = (getter(), setter());
    let inputs: Vec<_> = method.sig.inputs.iter().collect();
    let [receiver, FnArg::Typed(typed)] = &inputs[..] else {
        return Err(not_a_reference(&method.sig));
    };
    let (index, index_type) = (&typed.pat, &typed.ty);
    let attributes = quote!(#[doc(hidden)] #[allow(missing_docs, private_interfaces)] #[inline]);
    let output: Type = parse_quote!(<Self as ::core::ops::Index<#index_type>>::Output);
    let (generics, _, bounds) = block.generics.split_for_impl();
    let self_ty = &block.self_ty;
    let method = match method.sig.ident == "index" {
        true => quote! {
            #attributes
            pub fn #getter(#receiver, #index: #index_type) -> #output {
                #(#before)*
                #place
            }
        },
        false => quote! {
            #attributes
            pub fn #setter(#receiver, #index: #index_type, element: #output) {
                #(#before)*
                #place = element;
            }
        },
    };
    Ok(parse_quote!(impl #generics #self_ty #bounds { #method }))
}

fn not_a_reference(at: impl ToTokens) -> syn::Error {
    syn::Error::new_spanned(
        at,
        "what an index leads to has to stand at the end, as `&self.data[..]`: compute the position before",
    )
}
