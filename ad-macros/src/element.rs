//! Elements of one's own types: `#[differentiable]` on `impl Index<(usize, usize)> for Matrix`.
//!
//! The blocks stay as they are. Where the index is a tuple, beside `index` stands a method that returns a
//! copy of the element, and beside `index_mut` one that replaces it, both differentiated like any
//! others: `m[(i, j)]` and `m[(i, j)] = x` in a differentiable function call them. That a type has its
//! own `Index` the tuple tells, for arrays and `Vec`s have none by tuples. Any other index leads to a
//! [`part`] of the tangent.

mod part;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};
use syn::{
    Expr, ExprIndex, FnArg, GenericArgument, ImplItem, ImplItemFn, ItemImpl, PathArguments, Stmt,
    Type, parse_quote,
};

/// Whether a trait is `Index` or `IndexMut`.
pub fn is_index(path: &syn::Path) -> bool {
    path.segments.last().is_some_and(|last| last.ident == "Index" || last.ident == "IndexMut")
}

/// Whether an expression is an element of a type that is no array and no `Vec`.
pub fn is_element(index: &ExprIndex) -> bool {
    matches!(&*index.index, Expr::Tuple(_))
}

/// The method that returns an element.
pub fn getter() -> Ident {
    Ident::new("element_at_index", Span::call_site())
}

/// The method that replaces an element.
pub fn setter() -> Ident {
    Ident::new("set_element_at_index", Span::call_site())
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

/// The element as a call.
pub fn read(index: &ExprIndex) -> syn::ExprMethodCall {
    let (whole, position, getter) = (&index.expr, &index.index, getter());
    parse_quote!(#whole.#getter(#position))
}

/// The assignment to an element as a call.
pub fn replaced(index: &ExprIndex, value: &Expr) -> TokenStream {
    let (whole, position, setter) = (&index.expr, &index.index, setter());
    quote!(#whole.#setter(#position, #value))
}
