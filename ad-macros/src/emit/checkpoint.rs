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
use syn::{ReceiverKind, Type};

use crate::emit::header::{Header, turbofish};
use crate::parse::function::{Function, Place};
use crate::parse::itself;

/// The name of the function that holds both sweeps, which the pullback calls.
pub fn stored_name(vjp: &Ident) -> Ident {
    format_ident!("{vjp}_stored")
}

/// The body of a `vjp` whose pullback starts from the arguments. What callers lend it lends on.
pub fn body(function: &Function<'_>, vjp: &Ident, header: &Header) -> TokenStream {
    let signature = function.signature;
    let own = |name: &str| Ident::new(name, Span::mixed_site());
    let (value, pullback, cotangent) = (own("value"), own("pullback"), own("result_bar"));
    let (print, again) = (own("print"), own("again"));
    let mut keeps = TokenStream::new();
    let mut kept_arguments = Vec::new();
    let mut incoming = Vec::new();
    for (index, parameter) in header.parameters.iter().enumerate() {
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
            true if parameter.is_exclusive => (
                quote_spanned!(span=> ::std::borrow::ToOwned::to_owned(&*#ident)),
                quote!(::core::borrow::BorrowMut::borrow_mut(&mut #kept)),
            ),
            true => (
                quote_spanned!(span=> ::std::borrow::ToOwned::to_owned(#ident)),
                quote!(::core::borrow::Borrow::borrow(&#kept)),
            ),
            false => (
                quote_spanned!(span=> ::core::clone::Clone::clone(&#ident)),
                kept.to_token_stream(),
            ),
        };
        let mutability = parameter.is_exclusive.then(|| quote!(mut));
        keeps.extend(quote!(let #mutability #kept = #keep;));
        if parameter.is_exclusive {
            incoming.push(format_ident!("{kept}_bar", span = Span::mixed_site()));
        }
        kept_arguments.push(argument);
    }
    let arguments = header.parameters.iter().map(|parameter| &parameter.ident);
    let (name, stored, turbofish) = (&signature.ident, stored_name(vjp), turbofish(signature));
    let primal = match function.place {
        Place::Free => quote!(#name),
        _ => quote!(Self::#name),
    };
    let call = quote!(#primal #turbofish (#(#arguments),*));
    let mark: Type = itself::mark();
    let call = match header.result.to_token_stream().to_string() == quote!(#mark).to_string() {
        true => quote!({ #call; #mark }),
        false => call,
    };
    let lent =
        (0..header.parameters.len()).map(|index| own(&format!("lent_{index}")).to_token_stream());
    let lent: Option<Vec<_>> = header.lends().then(|| lent.collect());
    let offered = lent.as_ref().map(|lent| quote!(, ::ad::rt::Offered((#(#lent,)*))));
    let second_run = quote! {
        let (#again, #pullback) = Self::#stored #turbofish (#(#kept_arguments),*);
        ::ad::rt::same_again(#print, ::ad::fingerprint!(#again));
        #pullback(#cotangent #(, #incoming)* #offered)
    };
    let closure = header.pullback(&cotangent, &incoming, lent.as_deref(), &second_run);
    quote! {
        {
            #keeps
            let #value = #call;
            let #print = ::ad::fingerprint!(#value);
            (#value, #closure)
        }
    }
}
