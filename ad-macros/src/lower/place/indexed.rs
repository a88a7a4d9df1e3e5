//! Elements of one's own types that a tuple tells, `m[(i, j)]`: each is a call of the methods that stand
//! beside `Index` and `IndexMut` (see [`element`](crate::impls::element)).

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::{Expr, ExprIndex, parse_quote};

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
