//! Closures that are passed to functions: objects with a derivative (see `ad::function`).
//!
//! The object holds copies of what the closure captures. It is one function that is told whether its
//! pullback is wanted, so that those copies are there once.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};

use super::{Sweeper, Sweeps, primal, sweep};
use crate::emit::header::tuple_or_one;
use crate::ir::Closure;

impl Sweeper<'_> {
    /// A closure as an object.
    pub(super) fn object(&mut self, closure: &Closure) -> TokenStream {
        let Closure { captures, parameters, function, typed_by } = closure;
        let fresh = |sweeper: &mut Self, name: &str| sweeper.names.fresh(name, Span::mixed_site());
        let (captured, seed) = (fresh(self, "captured"), fresh(self, "result_bar"));
        let (pulls_back, result) = (fresh(self, "pulls_back"), fresh(self, "result"));
        let Sweeps { forward, value, pullback, lending_methods, .. } =
            sweep(function, parameters, (None, self.is_alone), &seed, self.names);
        // Said once for the whole function: of two traits none would be chosen.
        self.lending_methods.extend(lending_methods);
        let (plain, plain_value) = primal(function, parameters, self.names);

        let (references, arguments) = parameters.split_at(captures.len());
        let is_active = |index: usize| function.vars[function.parameters[index].var].active;
        let copies = captures.iter().enumerate().map(|(index, (copy, _))| match is_active(index) {
            true => copy.clone(),
            false => quote!(::ad::function::Fixed(#copy)),
        });
        let patterns = references.iter().enumerate().map(|(index, parameter)| {
            let ident = &parameter.ident;
            match is_active(index) {
                true => quote!(#ident),
                false => quote!(::ad::function::Fixed(#ident)),
            }
        });
        let names = arguments.iter().map(|argument| &argument.ident);
        let types = arguments.iter().map(|argument| &argument.ty);
        let bars = parameters.iter().map(|parameter| {
            self.names.fresh(&format!("{}_bar", parameter.ident), Span::mixed_site())
        });
        let bars: Vec<Ident> = bars.collect();
        let all = tuple_or_one(&bars.iter().map(ToTokens::to_token_stream).collect::<Vec<_>>());
        let (captured_bars, argument_bars) = bars.split_at(captures.len());
        let function = quote! {
            move |#pulls_back: bool, (#(#names,)*): (#(#types,)*)| {
                let (#(#patterns,)*) = &#captured;
                if !#pulls_back {
                    #plain
                    return (#plain_value, ::core::option::Option::None);
                }
                #forward
                let #result = #value;
                let pullback = ::ad::function::pullback(&#result, move |#seed| {
                    let #all = { #pullback };
                    ((#(#captured_bars,)*), (#(#argument_bars,)*))
                });
                (#result, pullback)
            }
        };
        let tangents = quote!(::ad::function::Captured::of(&#captured));
        let object = match typed_by {
            Some(typed_by) => {
                let make = typed_by.reverse();
                quote!(#make(#tangents, #function))
            }
            None => quote!(#tangents.closure(#function)),
        };
        quote! {{
            use ::std::borrow::ToOwned as _;
            let #captured = (#(#copies,)*);
            #object
        }}
    }
}
