//! The functions that users call, around the sweeps: `vjp`, `value_and_grad`, `grad`.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};
use syn::{FnArg, Generics, Signature};

use super::forward::Forward;
use super::{checkpoint, lending, passing};
use crate::emit::header::{Header, lints, turbofish};
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
        let mut bounds = self.bounds(header, &self.callables.signature);
        if header.boxed {
            bounds.extend(self.callables.types().map(|function| quote!(#function: 'static)));
        }
        let vjp = self.vjp(header, &bounds, body);
        let jvp = self.jvp(header, forward);
        if let Place::TraitImpl(..) = self.place {
            return quote!(#vjp #jvp);
        }
        let passing = passing::functions(self, &header.parameters);
        let gradients = self.gradients(header, &bounds);
        let functions = quote!(#vjp #jvp #passing #gradients);
        if !matches!(self.place, Place::Free) {
            return functions;
        }
        let (name, visibility) = (&self.signature.ident, self.visibility);
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

    /// The name of a derivative in this mode.
    pub(super) fn mode_name(&self, mode: &str) -> Ident {
        let name = &self.signature.ident;
        match self.place {
            Place::Free => Ident::new(mode, name.span()),
            _ => format_ident!("{name}_{mode}", span = name.span()),
        }
    }

    /// A derivative that users call: documented, and as visible as the function; `head` stands behind `fn`.
    pub(super) fn derivative_item(
        &self,
        doc: &str,
        head: &TokenStream,
        body: &TokenStream,
    ) -> TokenStream {
        let visibility = match self.place {
            Place::Free => quote!(pub),
            Place::Impl(_) => self.visibility.to_token_stream(),
            Place::Trait(_) | Place::TraitImpl(..) => quote!(),
        };
        let lints = lints();
        quote! {
            #[doc = #doc]
            #lints
            #[inline]
            #visibility fn #head #body
        }
    }

    /// The generic parameters, where there are some.
    fn generics(&self) -> Option<&Generics> {
        Some(&self.callables.signature.generics).filter(|generics| !generics.params.is_empty())
    }

    /// `vjp`, with what is lent cotangents and what a checkpoint calls.
    fn vjp(
        &self,
        header: &Header,
        bounds: &[TokenStream],
        body: Option<&TokenStream>,
    ) -> TokenStream {
        let Header { parameters, exclusive_tangents, .. } = header;
        let name = &self.signature.ident;
        let vjp = self.mode_name("vjp");
        let (generics, inputs) = (self.generics(), self.inputs(parameters));
        let (mut stored, mut checkpointed) = (None, None);
        if let (Some(body), true) = (body, self.options.checkpoint) {
            let name = checkpoint::stored_name(&vjp);
            let stored_type = self.pullback_type(header, header.lends());
            let lints = lints();
            stored = Some(quote! {
                #lints
                fn #name #generics (#inputs) -> #stored_type
                where #(#bounds),*
                #body
            });
            checkpointed = Some(checkpoint::body(self, &vjp, header));
        }
        let body = checkpointed.as_ref().or(body).cloned().unwrap_or_else(|| quote!(;));
        let (body, onto) = match lending::is_asked_for(self, header) {
            true => {
                let functions = lending::Functions::new(self, header, &inputs, bounds);
                functions.vjp_and_onto(&body)
            }
            false => (body, TokenStream::new()),
        };
        let doc = format!(
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
        let pullback_type = self.pullback_type(header, false);
        let head = quote!(#vjp #generics (#inputs) -> #pullback_type where #(#bounds),*);
        let vjp = self.derivative_item(&doc, &head, &body);
        quote!(#stored #onto #vjp)
    }

    /// `value_and_grad` and `grad`.
    fn gradients(&self, header: &Header, bounds: &[TokenStream]) -> TokenStream {
        let Header { parameters, result, result_tangent, exclusive_tangents, gradient, .. } =
            header;
        let signature = &self.callables.signature;
        let (name, vjp) = (&signature.ident, self.mode_name("vjp"));
        let call = match (self.place, signature.receiver()) {
            (Place::Free, _) | (_, None) => quote!(Self::#vjp),
            (_, Some(_)) => quote!(self.#vjp),
        };
        let arguments = parameters.iter().filter_map(|p| p.pattern.as_ref().map(|_| &p.ident));
        let turbofish = turbofish(signature);
        let call = quote!(#call #turbofish (#(#arguments),*));
        let zeros = vec![quote!(::ad::Additive::zero()); exclusive_tangents.len()];
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
        let (generics, inputs) = (self.generics(), self.inputs(parameters));
        let item = |mode: &str, doc: String, output: TokenStream, returned: TokenStream| {
            let mode = self.mode_name(mode);
            let head = quote! {
                #mode #generics (#inputs) -> #output
                where
                    #(#bounds,)*
                    #is_scalar,
            };
            let body = quote! {
                {
                    let (value, pullback) = #call;
                    let one = <#result as ::ad::rt::ScalarResult<'_, #result_tangent>>::one();
                    let gradient = pullback(one #(, #zeros)*);
                    #returned
                }
            };
            self.derivative_item(&doc, &head, &body)
        };
        let value_and_grad = item(
            "value_and_grad",
            format!("The value of `{name}` and its gradient."),
            quote!((#result, #gradient)),
            quote!((value, gradient)),
        );
        let grad =
            item("grad", format!("The gradient of `{name}`."), gradient.clone(), quote!(gradient));
        quote!(#value_and_grad #grad)
    }

    /// The parameters as the derivatives take them: each under one name.
    fn inputs(&self, parameters: &[Parameter]) -> TokenStream {
        let inputs = self.callables.signature.inputs.iter().zip(parameters);
        let inputs = inputs.map(|(input, parameter)| match input {
            FnArg::Receiver(receiver) => signature::bare(receiver).into_token_stream(),
            FnArg::Typed(typed) => {
                let (ident, ty) = (&parameter.ident, &typed.ty);
                quote!(#ident: #ty)
            }
        });
        quote!(#(#inputs),*)
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
