//! Wraps the sweeps into what users call: `f::vjp`, `f::value_and_grad`, `f::grad`.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Attribute, FnArg, GenericParam, Generics, Signature, Type, Visibility};

use crate::attribute::Options;
use crate::checkpoint;
use crate::errors::Errors;
use crate::lower;
use crate::names::Names;
use crate::signature::{self, Parameter, pointee};
use crate::sweep::{self, tuple_or_one};

/// Where the function stands.
pub enum Place<'a> {
    /// Outside of an `impl`: the derivative is the associated function `vjp` of a type that has the
    /// function's name.
    Free,
    /// In an `impl` with these generics: the derivative is the sibling `name_vjp`.
    Impl(&'a Generics),
}

/// The derivative of a function: items to put beside it.
pub fn derivative(
    place: &Place<'_>,
    attributes: &[Attribute],
    visibility: &Visibility,
    signature: &Signature,
    body: &syn::Block,
    options: Options,
) -> syn::Result<TokenStream> {
    let mut errors = Errors::default();
    let parameters = signature::parameters(signature, &mut errors);
    let result = signature::result(signature, &mut errors);

    let idents = parameters.iter().map(|parameter| parameter.ident.clone());
    let mut names = Names::new(quote!(#signature #body), idents);
    let lowered =
        lower::lower(&signature.ident, &parameters, &result, body, &mut names, &mut errors);
    signature::refuse_cfg(signature, body, &mut errors);
    if options.checkpoint {
        checkpoint::refuse_exclusive(&parameters, &mut errors);
    }
    errors.finish()?;

    let seed = names.fresh("result_bar", Span::call_site());
    let sweeps = sweep::sweep(&lowered, &parameters, &seed, &mut names);
    let sweep::Sweeps { forward, value, pullback, incoming } = sweeps;
    let (result_tangent, gradient) = (tangent(&result), gradient(&parameters));
    let exclusive_tangents = exclusive_tangents(&parameters);
    let body = quote! {
        {
            #[allow(unused_imports)]
            use ::ad::rt::methods::*;
            #forward
            (#value, move |#seed: #result_tangent #(, mut #incoming: #exclusive_tangents)*| -> #gradient {
                #pullback
            })
        }
    };
    Ok(functions(place, attributes, visibility, signature, &parameters, &result, &body, options))
}

/// What stands in for the derivative of a function that was refused, so that its callers do not
/// add errors of their own.
pub fn stub(place: &Place<'_>, visibility: &Visibility, signature: &Signature) -> TokenStream {
    let mut errors = Errors::default();
    let parameters = signature::parameters(signature, &mut errors);
    let result = signature::result(signature, &mut errors);
    if errors.finish().is_err() {
        return TokenStream::new();
    }
    let (result_tangent, gradient) = (tangent(&result), gradient(&parameters));
    let exclusive_tangents = exclusive_tangents(&parameters);
    let body = quote! {
        {
            fn refused<T>() -> T {
                ::core::unreachable!()
            }
            (refused(), |_: #result_tangent #(, _: #exclusive_tangents)*| -> #gradient { refused() })
        }
    };
    let options = Options::default();
    functions(place, &[], visibility, signature, &parameters, &result, &body, options)
}

fn tangent(ty: &Type) -> TokenStream {
    let ty = pointee(ty);
    quote_spanned!(ty.span()=> ::ad::Tangent<#ty>)
}

/// The type of what the pullback returns.
fn gradient(parameters: &[Parameter]) -> TokenStream {
    let tangents: Vec<_> = parameters.iter().map(|parameter| tangent(&parameter.ty)).collect();
    tuple_or_one(&tangents)
}

/// The types of the cotangents that the pullback takes for `&mut` parameters.
fn exclusive_tangents(parameters: &[Parameter]) -> Vec<TokenStream> {
    let exclusive = parameters.iter().filter(|parameter| parameter.is_exclusive);
    exclusive.map(|parameter| tangent(&parameter.ty)).collect()
}

#[allow(clippy::too_many_arguments, reason = "they are the parts of one function")]
fn functions(
    place: &Place<'_>,
    attributes: &[Attribute],
    visibility: &Visibility,
    signature: &Signature,
    parameters: &[Parameter],
    result: &Type,
    body: &TokenStream,
    options: Options,
) -> TokenStream {
    let name = &signature.ident;
    let (vjp, value_and_grad, grad) = match place {
        Place::Free => (
            Ident::new("vjp", name.span()),
            Ident::new("value_and_grad", name.span()),
            Ident::new("grad", name.span()),
        ),
        Place::Impl(_) => (
            format_ident!("{name}_vjp"),
            format_ident!("{name}_value_and_grad"),
            format_ident!("{name}_grad"),
        ),
    };
    let call_vjp = match (place, &signature.inputs.first()) {
        (Place::Impl(_), Some(FnArg::Receiver(_))) => quote!(self.#vjp),
        _ => quote!(Self::#vjp),
    };
    let inputs = inputs(signature, parameters);
    let arguments = parameters.iter().filter_map(|p| p.pattern.as_ref().map(|_| &p.ident));
    let turbofish = turbofish(signature);
    let call_vjp = quote!(#call_vjp #turbofish (#(#arguments),*));

    let outer = match place {
        Place::Free => None,
        Place::Impl(generics) => Some(*generics),
    };
    let captured = signature::captured(signature, outer);
    let (result_tangent, gradient) = (tangent(result), gradient(parameters));
    let exclusive_tangents = exclusive_tangents(parameters);
    let zeros = vec![quote!(::ad::Additive::zero()); exclusive_tangents.len()];
    let (generics, _, where_clause) = signature.generics.split_for_impl();
    let generics = generics.to_token_stream();
    let generics = if generics.is_empty() { None } else { Some(&signature.generics) };
    let bounds = where_clause.map(|clause| &clause.predicates).into_iter().flatten();
    let bounds: Vec<_> = bounds.collect();
    let cfgs: Vec<_> = attributes.iter().filter(|a| a.path().is_ident("cfg")).collect();

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
        #[allow(unused, non_snake_case, clippy::all, clippy::pedantic, clippy::nursery)]
    };
    let derivative_visibility = match place {
        Place::Free => quote!(pub),
        Place::Impl(_) => quote!(#visibility),
    };
    let pullback_type = quote! {
        (#result, impl ::core::ops::FnOnce(#result_tangent #(, #exclusive_tangents)*) -> #gradient + #captured)
    };
    let (stored, checkpointed);
    let (stored, body) = match options.checkpoint {
        false => (None, body),
        true => {
            let name = checkpoint::stored_name(&vjp);
            stored = quote! {
                #(#cfgs)*
                #lints
                fn #name #generics (#inputs) -> #pullback_type
                where #(#bounds),*
                #body
            };
            let closure = |body, cotangent: &Ident| quote!(move |#cotangent: #result_tangent| -> #gradient { #body });
            checkpointed = checkpoint::body(place, &vjp, signature, parameters, closure);
            (Some(&stored), &checkpointed)
        }
    };
    let functions = quote! {
        #stored

        #(#cfgs)*
        #[doc = #vjp_doc]
        #lints
        #[inline]
        #derivative_visibility fn #vjp #generics (#inputs) -> #pullback_type
        where #(#bounds),*
        #body

        #(#cfgs)*
        #[doc = #value_and_grad_doc]
        #lints
        #[inline]
        #derivative_visibility fn #value_and_grad #generics (#inputs) -> (#result, #gradient)
        where
            #(#bounds,)*
            for<'__scalar> #result: ::ad::rt::ScalarResult<'__scalar, #result_tangent>,
        {
            let (value, pullback) = #call_vjp;
            let one = <#result as ::ad::rt::ScalarResult<'_, #result_tangent>>::one();
            (value, pullback(one #(, #zeros)*))
        }

        #(#cfgs)*
        #[doc = #grad_doc]
        #lints
        #[inline]
        #derivative_visibility fn #grad #generics (#inputs) -> #gradient
        where
            #(#bounds,)*
            for<'__scalar> #result: ::ad::rt::ScalarResult<'__scalar, #result_tangent>,
        {
            let (_, pullback) = #call_vjp;
            let one = <#result as ::ad::rt::ScalarResult<'_, #result_tangent>>::one();
            pullback(one #(, #zeros)*)
        }
    };
    match place {
        Place::Impl(_) => functions,
        Place::Free => {
            let doc = format!("The derivatives of the function `{name}`.");
            quote! {
                #(#cfgs)*
                #[doc = #doc]
                #[allow(non_camel_case_types)]
                #visibility enum #name {}

                #(#cfgs)*
                impl #name {
                    #functions
                }
            }
        }
    }
}

/// The type arguments of a call of the function itself. The types of the parameters need not tell
/// them: `Vec3<S>` does not tell `S`.
pub fn turbofish(signature: &Signature) -> TokenStream {
    let arguments = signature.generics.params.iter().filter_map(|parameter| match parameter {
        GenericParam::Lifetime(_) => None,
        GenericParam::Type(ty) => Some(&ty.ident),
        GenericParam::Const(constant) => Some(&constant.ident),
    });
    quote!(::<#(#arguments),*>)
}

/// The parameters as the generated functions take them: each under one name.
fn inputs(signature: &Signature, parameters: &[Parameter]) -> TokenStream {
    let inputs = signature.inputs.iter().zip(parameters).map(|(input, parameter)| match input {
        FnArg::Receiver(receiver) => quote!(#receiver),
        FnArg::Typed(typed) => {
            let (ident, ty) = (&parameter.ident, &typed.ty);
            quote!(#ident: #ty)
        }
    });
    quote!(#(#inputs),*)
}
