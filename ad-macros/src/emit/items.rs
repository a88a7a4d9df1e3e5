//! The functions that users call, around the sweeps: `vjp`, `value_and_grad`, `grad`.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};
use syn::{FnArg, Signature};

use super::forward::Forward;
use super::{checkpoint, lending, passing};
use crate::emit::header::{Header, turbofish};
use crate::names;
use crate::parse::elision;
use crate::parse::function::{Function, Place};
use crate::parse::signature;
use crate::parse::signature::Parameter;
use crate::types;

impl Function<'_> {
    /// All of them; without a body what a trait requires.
    pub(super) fn functions(
        &self,
        header: &Header,
        body: Option<&TokenStream>,
        forward: Option<&Forward>,
    ) -> TokenStream {
        let Self { place, visibility, .. } = self;
        let signature = &self.callables.signature;
        let Header { parameters, result, result_tangent, exclusive_tangents, gradient, .. } =
            header;
        let name = &signature.ident;
        let (vjp, value_and_grad, grad) = match place {
            Place::Free => (
                Ident::new("vjp", name.span()),
                Ident::new("value_and_grad", name.span()),
                Ident::new("grad", name.span()),
            ),
            _ => (
                format_ident!("{name}_vjp", span = name.span()),
                format_ident!("{name}_value_and_grad", span = name.span()),
                format_ident!("{name}_grad", span = name.span()),
            ),
        };
        let call_vjp = match (place, signature.receiver()) {
            (Place::Free, _) | (_, None) => quote!(Self::#vjp),
            (_, Some(_)) => quote!(self.#vjp),
        };
        let inputs = inputs(signature, parameters);
        let arguments = parameters.iter().filter_map(|p| p.pattern.as_ref().map(|_| &p.ident));
        let turbofish = turbofish(signature);
        let call_vjp = quote!(#call_vjp #turbofish (#(#arguments),*));

        let zeros = vec![quote!(::ad::Additive::zero()); exclusive_tangents.len()];
        let (generics, _, _) = signature.generics.split_for_impl();
        let generics = generics.to_token_stream();
        let generics = if generics.is_empty() { None } else { Some(&signature.generics) };
        let mut bounds = self.bounds(header, signature);
        if header.boxed {
            bounds.extend(self.callables.types().map(|function| quote!(#function: 'static)));
        }

        let vjp_doc = format!(
            "The value of `{name}`, and its pullback: from the cotangent of the value{} to {}.",
            match exclusive_tangents.is_empty() {
                true => "",
                false => " and those of what the `&mut` parameters hold afterwards",
            },
            match parameters.len() {
                1 => "that of the parameter",
                _ => "those of the parameters, in order",
            }
        );
        let value_and_grad_doc = format!("The value of `{name}` and its gradient.");
        let grad_doc = format!("The gradient of `{name}`.");
        let lints = quote! {
            #[allow(unused, non_snake_case, refining_impl_trait, clippy::all, clippy::pedantic, clippy::nursery)]
        };
        let derivative_visibility = match place {
            Place::Free => quote!(pub),
            Place::Impl(_) => quote!(#visibility),
            Place::Trait(_) | Place::TraitImpl(..) => quote!(),
        };
        let pullback_type = self.pullback_type(header, false);
        let (mut stored, mut checkpointed) = (None, None);
        if let (Some(body), true) = (body, self.options.checkpoint) {
            let name = checkpoint::stored_name(&vjp);
            let stored_type = self.pullback_type(header, header.lends());
            stored = Some(quote! {
                #lints
                fn #name #generics (#inputs) -> #stored_type
                where #(#bounds),*
                #body
            });
            checkpointed = Some(checkpoint::body(self, &vjp, header));
        }
        let body = match (checkpointed.as_ref().or(body), place) {
            (Some(body), _) => body.clone(),
            (None, _) => quote!(;),
        };
        let (body, onto) = match lending::is_asked_for(self, header) {
            true => {
                let functions = lending::Functions::new(self, header, &inputs, &bounds);
                functions.vjp_and_onto(&body)
            }
            false => (body, TokenStream::new()),
        };
        let vjp = quote! {
            #stored

            #onto

            #[doc = #vjp_doc]
            #lints
            #[inline]
            #derivative_visibility fn #vjp #generics (#inputs) -> #pullback_type
            where #(#bounds),*
            #body
        };
        let jvp = self.jvp(header, forward);
        if let Place::TraitImpl(..) = place {
            return quote!(#vjp #jvp);
        }
        // Bounds do not let lifetimes be left out.
        let is_scalar = match elision::named(result) {
            (_, false) => quote! {
                for<'__scalar> #result: ::ad::rt::ScalarResult<'__scalar, #result_tangent>
            },
            (named, true) => {
                let lifetime = elision::lifetime();
                quote! {
                    for<'__scalar, #lifetime> #named:
                        ::ad::rt::ScalarResult<'__scalar, #result_tangent>
                }
            }
        };
        let passing = passing::functions(self, parameters);
        let functions = quote! {
            #vjp

            #jvp

            #passing

            #[doc = #value_and_grad_doc]
            #lints
            #[inline]
            #derivative_visibility fn #value_and_grad #generics (#inputs) -> (#result, #gradient)
            where
                #(#bounds,)*
                #is_scalar,
            {
                let (value, pullback) = #call_vjp;
                let one = <#result as ::ad::rt::ScalarResult<'_, #result_tangent>>::one();
                (value, pullback(one #(, #zeros)*))
            }

            #[doc = #grad_doc]
            #lints
            #[inline]
            #derivative_visibility fn #grad #generics (#inputs) -> #gradient
            where
                #(#bounds,)*
                #is_scalar,
            {
                let (_, pullback) = #call_vjp;
                let one = <#result as ::ad::rt::ScalarResult<'_, #result_tangent>>::one();
                pullback(one #(, #zeros)*)
            }
        };
        if !matches!(place, Place::Free) {
            return functions;
        }
        let doc = format!("The derivatives of the function `{name}`.");
        quote! {
            #[doc = #doc]
            #[allow(non_camel_case_types)]
            #visibility enum #name {}

            impl #name {
                /// The path of the function.
                #[doc(hidden)]
                pub fn named() -> &'static str {
                    ::core::any::type_name::<Self>()
                }

                #functions
            }
        }
    }

    /// The type of what `vjp` returns.
    pub fn pullback_type(&self, header: &Header, takes_lent: bool) -> TokenStream {
        let Header { result, result_tangent, exclusive_tangents, gradient, .. } = header;
        let lent = takes_lent.then(|| header.lent_types());
        let lent = lent.into_iter();
        let outer = match self.place {
            Place::Free => None,
            Place::Impl(generics) | Place::Trait(generics) | Place::TraitImpl(generics, _) => {
                Some(generics)
            }
        };
        let signature::Captured { lifetimes, mut others } =
            signature::captured(&self.callables.signature, outer, self.options.borrows);
        let closure = quote! {
            ::core::ops::FnOnce(#result_tangent #(, #exclusive_tangents)* #(, #lent)*) -> #gradient
        };
        if header.boxed {
            return quote!((#result, ::std::boxed::Box<dyn #closure #(+ #lifetimes)*>));
        }
        if let Place::Trait(_) = self.place {
            others.insert(0, quote!(Self));
        }
        quote!((#result, impl #closure + use<#(#lifetimes,)* #(#others),*>))
    }

    /// What a derivative with this signature asks of types.
    pub(super) fn bounds(&self, header: &Header, signature: &Signature) -> Vec<TokenStream> {
        let bounds = signature.generics.where_clause.iter().flat_map(|clause| &clause.predicates);
        let mut bounds: Vec<_> = bounds.map(ToTokens::to_token_stream).collect();
        if let Place::Trait(generics) = self.place {
            // A parameter of the trait may be anything where no derivative is asked for.
            let mut named = std::collections::HashSet::new();
            let types =
                header.parameters.iter().map(|parameter| &parameter.ty).chain([&header.result]);
            types.for_each(|ty| names::collect(quote!(#ty), &mut named));
            let parameters = generics.type_params().map(|parameter| &parameter.ident);
            let parameters = parameters.filter(|name| named.contains(&name.to_string()));
            bounds.extend(parameters.map(|name| quote!(#name: ::ad::Differentiable)));
            // The trait stays fit for `dyn`, and for types that no derivative flows through.
            bounds.push(quote!(Self: ::core::marker::Sized));
            if header.parameters.iter().any(|p| types::names_self(&p.ty))
                || types::names_self(&header.result)
            {
                bounds.push(quote!(Self: ::ad::Differentiable));
            }
        }
        bounds
    }
}

/// The parameters as the generated functions take them: each under one name.
fn inputs(signature: &Signature, parameters: &[Parameter]) -> TokenStream {
    let inputs = signature.inputs.iter().zip(parameters).map(|(input, parameter)| match input {
        FnArg::Receiver(receiver) => signature::bare(receiver).into_token_stream(),
        FnArg::Typed(typed) => {
            let (ident, ty) = (&parameter.ident, &typed.ty);
            quote!(#ident: #ty)
        }
    });
    quote!(#(#inputs),*)
}
