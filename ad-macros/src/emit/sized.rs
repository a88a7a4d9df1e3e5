//! Pullbacks around those of other functions, for cotangents of the sizes of values.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use crate::emit::header::{Header, tuple_or_one};
use crate::names::own;

/// Value and pullback of `call`, which gives those of a function with this header. What its pullback
/// returns is brought to the size of each parameter that is `sized`, and, if it `takes_whole` cotangents,
/// what it is given to the size of the value and of what is behind `&mut`. Callers lend it nothing.
pub fn vjp(header: &Header, call: &TokenStream, sized: &[bool], takes_whole: bool) -> TokenStream {
    let [value, pullback, cotangent] = ["value", "pullback", "result_bar"].map(own);
    let nothing = vec![quote!(::ad::rt::Lent::nothing()); header.lent.len()];
    let offered = header.lends().then(|| quote!(, ::ad::rt::Offered((#(#nothing,)*))));
    let (mut before, mut after, mut given) =
        (TokenStream::new(), TokenStream::new(), TokenStream::new());
    if takes_whole && !header.is_hidden {
        let shape = own("shape");
        after.extend(quote!(let #shape = ::ad::rt::shape(&#value);));
        given.extend(quote!(let #cotangent = ::ad::rt::fit(#shape, #cotangent);));
    }
    let (mut incoming, mut parts, mut whole) = (Vec::new(), Vec::new(), Vec::new());
    for (index, (parameter, is_sized)) in header.parameters.iter().zip(sized).enumerate() {
        let [shape, changed, part] =
            ["shape", "changed", "part"].map(|name| own(&format!("{name}_{index}")));
        let ident = &parameter.ident;
        if parameter.is_exclusive {
            let bar = own(&format!("incoming_{}", incoming.len()));
            if takes_whole {
                after.extend(quote!(let #changed = ::ad::rt::shape(&#ident);));
                given.extend(quote!(let #bar = ::ad::rt::fit(#changed, #bar);));
            }
            incoming.push(bar);
        }
        whole.push(match is_sized {
            true => {
                before.extend(quote!(let #shape = ::ad::rt::shape(&#ident);));
                quote!(::ad::rt::fit(#shape, #part))
            }
            false => part.to_token_stream(),
        });
        parts.push(part.to_token_stream());
    }
    let (parts, whole) = (tuple_or_one(&parts), tuple_or_one(&whole));
    let body = quote! {
        #given
        let #parts = #pullback(#cotangent #(, #incoming)* #offered);
        #whole
    };
    let closure = header.pullback(&cotangent, &incoming, None, &body);
    let inline = (!header.boxed).then(|| quote!(#[inline(always)]));
    quote! {
        {
            #before
            let (#value, #pullback) = #call;
            #after
            (#value, #inline #closure)
        }
    }
}
