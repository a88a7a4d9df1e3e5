//! Calls that add to the cotangents of their caller in place.
//!
//! A pullback returns the cotangents of its parameters. For a slice that is a vector of the length
//! of the slice, made of zeros and added to that of the caller: a loop that calls a function of a
//! slice n times would take n² steps. So beside `vjp` stands `vjp_onto`, which callers take when
//! they pass references: its pullback takes one more argument, a tuple with a member for each
//! parameter. What is behind a reference to a slice, a `Vec` or a type of its own is lent: the
//! caller moves the cotangent that it has so far into the tuple, the reverse sweep starts from that
//! instead of zero, and the result is the whole, which moves back. All other members are
//! `ad::rt::NotLent`. Where nothing is lent `vjp_onto` is `vjp`, and so it is for a function that
//! was imported with a rule. What is lent, the types tell (`ad::rt::PullbackOnto`): the macro that
//! writes the call does not know the signature of what it calls.
//!
//! Turned down: `&mut` in place of moving there and back (a variable may be passed twice, and what
//! is an array here may be a slice there); sparse cotangents (an indirection for each element in
//! all other uses). Arrays are not lent, for moving them costs as much as adding them up. Methods
//! have no `vjp_onto`: rules of other crates need not have one, and a trait would have to ask for it.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::Type;

use crate::expand::{Function, Header, Place, turbofish};
use crate::signature::{Parameter, has_fixed_size, is_box, pointee};
use crate::sweep::tuple_or_one;

/// Whether callers may lend cotangents to the function: its reverse sweep is written here.
pub fn is_possible(function: &Function<'_>) -> bool {
    matches!(function.place, Place::Free)
        && function.options.vjp.is_none()
        && !function.options.checkpoint
        && !function.callables.any()
}

/// Whether callers lend the cotangent of a parameter.
pub fn is_lent(parameter: &Parameter) -> bool {
    let may_be_large = match pointee(&parameter.ty) {
        Type::Slice(_) => true,
        Type::Path(_) => !has_fixed_size(&parameter.ty) && !is_box(&parameter.ty),
        _ => false,
    };
    parameter.is_shared && !parameter.is_constant && may_be_large
}

/// Whether there has to be a `vjp_onto`: some parameter may take a reference.
pub fn is_asked_for(function: &Function<'_>, header: &Header) -> bool {
    let may_be_reference = |parameter: &Parameter| match &parameter.ty {
        Type::Reference(_) => true,
        ty => !has_fixed_size(ty),
    };
    matches!(function.place, Place::Free) && header.parameters.iter().any(may_be_reference)
}

/// Writes the two functions.
pub struct Functions<'a> {
    function: &'a Function<'a>,
    header: &'a Header,
    inputs: &'a TokenStream,
    bounds: &'a [TokenStream],
}

impl<'a> Functions<'a> {
    /// For a function with these generated parameters and bounds.
    pub fn new(
        function: &'a Function<'a>,
        header: &'a Header,
        inputs: &'a TokenStream,
        bounds: &'a [TokenStream],
    ) -> Self {
        Self { function, header, inputs, bounds }
    }

    /// The body of `vjp`, and `vjp_onto`. One of them has the sweeps in it, the other calls it.
    pub fn vjp_and_onto(&self, sweeps: &TokenStream) -> (TokenStream, TokenStream) {
        match self.header.lends() {
            true => (self.vjp_by_onto(), self.onto(sweeps)),
            false => {
                let vjp = self.call(&quote!(vjp));
                (sweeps.clone(), self.onto(&quote!({ #vjp })))
            }
        }
    }

    fn onto(&self, body: &TokenStream) -> TokenStream {
        let Self { function, header, inputs, bounds } = self;
        let generics = &function.callables.signature.generics;
        let generics = (!generics.params.is_empty()).then_some(generics);
        let pullback = function.pullback_type(header, header.lends());
        let cfgs = function.attributes.iter().filter(|a| a.path().is_ident("cfg"));
        quote! {
            #(#cfgs)*
            #[doc(hidden)]
            #[allow(unused, non_snake_case, clippy::all, clippy::pedantic, clippy::nursery)]
            #[inline]
            pub fn vjp_onto #generics (#inputs) -> #pullback
            where #(#bounds),*
            #body
        }
    }

    /// Lends zeros, and brings what comes back to the size of the parameters.
    fn vjp_by_onto(&self) -> TokenStream {
        let own = |name: &str| Ident::new(name, Span::mixed_site());
        let (value, pullback, cotangent) = (own("value"), own("pullback"), own("result_bar"));
        let count = self.header.exclusive_tangents.len();
        let incoming: Vec<_> = (0..count).map(|index| own(&format!("incoming_{index}"))).collect();
        let zeros = vec![quote!(::ad::rt::Lent::nothing()); self.header.lent.len()];
        let (mut shapes, mut parts, mut whole) = (TokenStream::new(), Vec::new(), Vec::new());
        let parameters = self.header.parameters.iter().zip(&self.header.lent);
        for (index, (Parameter { ident, .. }, lent)) in parameters.enumerate() {
            let part = own(&format!("part_{index}"));
            let shape = own(&format!("shape_{index}"));
            whole.push(match lent {
                Some(_) => {
                    shapes.extend(quote!(let #shape = ::ad::rt::shape(&#ident);));
                    quote!(::ad::rt::fit(#shape, #part))
                }
                None => quote!(#part),
            });
            parts.push(quote!(#part));
        }
        let (parts, whole) = (tuple_or_one(&parts), tuple_or_one(&whole));
        let body = quote! {
            let #parts = #pullback(#cotangent #(, #incoming)*, (#(#zeros,)*));
            #whole
        };
        let closure = self.header.pullback(&cotangent, &incoming, None, &body);
        let call = self.call(&quote!(vjp_onto));
        quote! {
            {
                #shapes
                let (#value, #pullback) = #call;
                (#value, #closure)
            }
        }
    }

    /// The call of the other function with the same arguments.
    fn call(&self, other: &TokenStream) -> TokenStream {
        let arguments = self.header.parameters.iter().map(|parameter| &parameter.ident);
        let turbofish = turbofish(&self.function.callables.signature);
        quote!(Self::#other #turbofish (#(#arguments),*))
    }
}
