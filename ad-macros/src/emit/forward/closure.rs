//! Closures that are passed to functions: objects that hold the tangents of what they capture (see
//! `ad::function`).

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::Member;

use super::function::tangent_type;
use super::{Forward, Tangent, Writer, forward};
use crate::emit::reverse;
use crate::ir::{Closure, Place};
use crate::parse::signature::Parameter;

impl Writer<'_> {
    /// A closure as an object.
    pub(super) fn object(&mut self, closure: &Closure) -> TokenStream {
        let Closure { captures, parameters, function, typed_by } = closure;
        let names = ["captured", "captured_dots", "dots", "result", "result_dot"];
        let [captured, captured_dots, dots, value, dot] =
            names.map(|name| self.names.fresh(name, Span::mixed_site()));
        let Forward { tangents, statements, result } = forward(function, parameters, self.names);

        let (references, arguments) = parameters.split_at(captures.len());
        let (reference_dots, argument_dots) = tangents.split_at(captures.len());
        let copies = captures.iter().map(|(copy, _)| copy);
        let held = captures.iter().enumerate().map(|(index, (_, place))| {
            let is_active = function.vars[function.parameters[index].var].active;
            match is_active && references[index].arity.is_none() {
                true => self.captured_tangent(&captured, index, place),
                false => quote!(()),
            }
        });
        let held: Vec<_> = held.collect();
        let idents = |parameters: &[Parameter]| -> Vec<Ident> {
            parameters.iter().map(|parameter| parameter.ident.clone()).collect()
        };
        let (references, names) = (idents(references), idents(arguments));
        let types = arguments.iter().map(|argument| &argument.ty);
        let dot_types: Vec<_> = arguments.iter().map(tangent_type).collect();
        let (start, tangent) = match function.passes_functions {
            // A function is passed with its tangents or not at all.
            true => {
                let slots = arguments.iter().map(|_| self.names.fresh("slot", Span::mixed_site()));
                let slots: Vec<_> = slots.collect();
                let is_wanted = self.names.fresh("is_wanted", Span::mixed_site());
                let start = quote! {
                    let #is_wanted = #dots.is_some();
                    #(let mut #slots = ::ad::rt::Slot::new();)*
                    let (#(#argument_dots,)*): (#(#dot_types,)*) = match #dots {
                        ::core::option::Option::Some(dots) => dots,
                        ::core::option::Option::None => {
                            (#(::ad::rt::still(&#names, &mut #slots),)*)
                        }
                    };
                };
                (start, quote!(#is_wanted.then_some(#dot)))
            }
            false => {
                let (plain, plain_value) = reverse::primal(function, parameters, self.names);
                let start = quote! {
                    let ::core::option::Option::Some((#(#argument_dots,)*)) = #dots else {
                        #plain
                        return (#plain_value, ::core::option::Option::None);
                    };
                };
                (start, quote!(::core::option::Option::Some(#dot)))
            }
        };
        let make = match typed_by {
            Some(typed_by) => typed_by.forward(),
            None => quote!(::ad::function::forward),
        };
        quote! {{
            use ::std::borrow::ToOwned as _;
            let #captured = (#(#copies,)*);
            let #captured_dots = (#(#held,)*);
            #make(
                move |(#(#names,)*): (#(#types,)*), #dots: ::core::option::Option<(#(#dot_types,)*)>| {
                    let (#(#references,)*) = &#captured;
                    #start
                    let (#(#reference_dots,)*) = &#captured_dots;
                    #statements
                    let (#value, #dot) = #result;
                    (#value, #tangent)
                },
            )
        }}
    }

    /// The tangent of what is captured, to be owned.
    fn captured_tangent(&mut self, captured: &Ident, index: usize, place: &Place) -> TokenStream {
        let member = Member::from(index);
        if self.tangents[place.root] == Tangent::Still {
            return quote!(::ad::rt::zero_like(&#captured.#member));
        }
        let tangent = self.shared(place);
        quote!(::ad::rt::read(&#captured.#member, #tangent))
    }
}
