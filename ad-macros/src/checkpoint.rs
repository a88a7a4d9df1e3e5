//! `#[differentiable(checkpoint)]` on a function: its pullback keeps the arguments and nothing
//! else, and runs the forward sweep again.
//!
//! Time: the function once for its value, and once more for each pullback. Memory: the arguments,
//! until the pullback runs. What a function saves by default is what its operations need, so this
//! pays where a function computes much from little: the steps of an integrator, each of which
//! would else leave its intermediate results on the tape of the loop that calls it.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{ReceiverKind, Signature, Type};

use crate::errors::Errors;
use crate::expand::{Place, turbofish};
use crate::signature::Parameter;

/// The name of the function that holds both sweeps, which the pullback calls.
pub fn stored_name(vjp: &Ident) -> Ident {
    format_ident!("{vjp}_stored")
}

/// Refuses parameters that the function may change: what they were is not kept.
pub fn refuse_exclusive(parameters: &[Parameter], errors: &mut Errors) {
    for parameter in parameters.iter().filter(|parameter| parameter.is_exclusive) {
        errors.at(
            &parameter.ty,
            "a function with checkpoints cannot take `&mut`: take the value and return the changed one",
        );
    }
}

/// The body of a `vjp` whose pullback starts from the arguments; `closure` writes a pullback with
/// a body.
pub fn body(
    place: &Place<'_>,
    vjp: &Ident,
    signature: &Signature,
    parameters: &[Parameter],
    closure: impl FnOnce(TokenStream, &Ident) -> TokenStream,
) -> TokenStream {
    let own = |name: &str| Ident::new(name, Span::mixed_site());
    let (value, pullback, cotangent) = (own("value"), own("pullback"), own("result_bar"));
    let mut keeps = TokenStream::new();
    let mut kept_arguments = Vec::new();
    for (index, parameter) in parameters.iter().enumerate() {
        let ident = &parameter.ident;
        let kept = format_ident!("kept_{index}", span = Span::mixed_site());
        let span = parameter.ty.span();
        let is_reference = match &parameter.pattern {
            Some(_) => matches!(parameter.ty, Type::Reference(_)),
            None => signature
                .receiver()
                .is_some_and(|receiver| matches!(receiver.kind, ReceiverKind::Reference(..))),
        };
        let (keep, argument) = match is_reference {
            true => (
                quote_spanned!(span=> ::std::borrow::ToOwned::to_owned(#ident)),
                quote!(::core::borrow::Borrow::borrow(&#kept)),
            ),
            false => (
                quote_spanned!(span=> ::core::clone::Clone::clone(&#ident)),
                kept.to_token_stream(),
            ),
        };
        keeps.extend(quote!(let #kept = #keep;));
        kept_arguments.push(argument);
    }
    let arguments = parameters.iter().map(|parameter| &parameter.ident);
    let (name, stored, turbofish) = (&signature.ident, stored_name(vjp), turbofish(signature));
    let primal = match place {
        Place::Free => quote!(#name),
        Place::Impl(_) => quote!(Self::#name),
    };
    let again = quote! {
        let (_, #pullback) = Self::#stored #turbofish (#(#kept_arguments),*);
        #pullback(#cotangent)
    };
    let closure = closure(again, &cotangent);
    quote! {
        {
            #keeps
            let #value = #primal #turbofish (#(#arguments),*);
            (#value, #closure)
        }
    }
}
