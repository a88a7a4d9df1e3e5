//! The function `jvp` around the forward mode.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{FnArg, ReceiverKind, Type};

use super::Tangent;
use crate::emit::header::tuple_or_one;
use crate::parse::elision;
use crate::parse::function::Function;
use crate::parse::signature::{Parameter, bare};
use crate::types::{is_discrete, pointee};

/// What the tangent of a parameter is.
pub(super) fn tangent_of_parameter(parameter: &Parameter) -> Tangent {
    match parameter {
        _ if parameter.is_constant || is_still(&parameter.ty) => Tangent::Still,
        // A function holds its own tangents.
        Parameter { arity: Some(_), .. } => Tangent::Still,
        Parameter { is_exclusive: true, .. } => Tangent::Exclusive,
        Parameter { is_shared: true, .. } => Tangent::Shared,
        _ => Tangent::Owned,
    }
}

/// Whether a value of this type, or each of its elements, certainly has no derivative.
fn is_still(ty: &Type) -> bool {
    match pointee(ty) {
        Type::Array(array) => is_still(&array.elem),
        Type::Slice(slice) => is_still(&slice.elem),
        ty => is_discrete(ty) || element_of_vec(ty).is_some_and(is_still),
    }
}

/// Whether the type is that of a number, which may be one of `scalars`, or a vector.
pub(super) fn is_number(ty: &Type, scalars: &[Ident]) -> bool {
    const NUMBERS: [&str; 8] = ["f32", "f64", "Vec2", "Vec3", "Vec4", "DVec2", "DVec3", "DVec4"];
    let is_number = |name| NUMBERS.iter().any(|number| name == number) || scalars.contains(name);
    matches!(ty, Type::Path(path) if path.path.get_ident().is_some_and(is_number))
}

/// Whether the type is that of a sequence of numbers, or a reference to one.
pub(super) fn is_made_of_numbers(ty: &Type, scalars: &[Ident]) -> bool {
    match pointee(ty) {
        Type::Array(array) => is_number(&array.elem, scalars),
        Type::Slice(slice) => is_number(&slice.elem, scalars),
        ty => element_of_vec(ty).is_some_and(|element| is_number(element, scalars)),
    }
}

/// `T` of `Vec<T>`
fn element_of_vec(ty: &Type) -> Option<&Type> {
    let Type::Path(path) = ty else { return None };
    let last = path.path.segments.last().filter(|last| last.ident == "Vec")?;
    let syn::PathArguments::AngleBracketed(arguments) = &last.arguments else { return None };
    match arguments.args.first()? {
        syn::GenericArgument::Type(element) => Some(element),
        _ => None,
    }
}

/// Whether the type is that of a slice or a `Vec`, or a reference to one.
pub(super) fn has_length(ty: &Type) -> bool {
    let ty = pointee(ty);
    matches!(ty, Type::Slice(_)) || element_of_vec(ty).is_some()
}

/// The type of the tangent of a parameter: a reference where the parameter is one.
pub(super) fn tangent_type(parameter: &Parameter) -> TokenStream {
    let ty = pointee(&parameter.ty);
    if parameter.is_constant {
        return quote_spanned!(ty.span()=> ::ad::NoTangent<#ty>);
    }
    if parameter.arity.is_some() {
        return quote!(());
    }
    let tangent = tangent_of_target(ty);
    match parameter {
        Parameter { is_exclusive: true, .. } => quote!(&mut #tangent),
        Parameter { is_shared: true, .. } => quote!(&#tangent),
        _ => tangent,
    }
}

/// The type of the tangent of what is no reference itself.
fn tangent_of_target(ty: &Type) -> TokenStream {
    let span = ty.span();
    match ty {
        Type::Infer(_) => quote!(_),
        Type::Slice(slice) => {
            let element = &slice.elem;
            quote_spanned!(span=> [::ad::Tangent<#element>])
        }
        ty => quote_spanned!(span=> ::ad::Tangent<#ty>),
    }
}

/// The type of the tangent that is passed for an argument of this type.
pub fn tangent_of_type(ty: &Type) -> TokenStream {
    match ty {
        Type::Reference(reference) => {
            let (lifetime, target) = (&reference.lifetime, tangent_of_target(&reference.elem));
            quote!(&#lifetime #target)
        }
        ty => tangent_of_target(ty),
    }
}

/// Names for the tangents of parameters, where no body tells of any.
pub fn names_of_tangents(parameters: &[Parameter]) -> Vec<Ident> {
    let taken = |name: &Ident| parameters.iter().any(|parameter| parameter.ident == *name);
    let name = |parameter: &Parameter| {
        let mut dot = format_ident!("{}_dot", parameter.ident, span = Span::mixed_site());
        while taken(&dot) {
            dot = format_ident!("{dot}_", span = Span::mixed_site());
        }
        dot
    };
    parameters.iter().map(name).collect()
}

/// The forward mode of a function as a rule written by hand gives it: as `jvp` itself, or by way of
/// the pullback.
pub fn delegated(function: &Function<'_>, parameters: &[Parameter]) -> Option<TokenStream> {
    let arguments = parameters.iter().map(|parameter| &parameter.ident);
    let tangents = names_of_tangents(parameters);
    match (&function.options.jvp, &function.options.vjp) {
        (Some(rule), _) => {
            Some(quote_spanned!(rule.span()=> { #rule(#(#arguments,)* #(#tangents),*) }))
        }
        (None, Some(rule)) => {
            let call = quote_spanned!(rule.span()=> #rule(#(#arguments),*));
            let tangents =
                tuple_or_one(&tangents.iter().map(ToTokens::to_token_stream).collect::<Vec<_>>());
            Some(quote! {
                {
                    #[allow(unused_imports)]
                    use ::ad::rt::{ByPullback as _, WithoutRule as _};
                    let (value, pullback) = #call;
                    (&&::ad::rt::Through::new(value, pullback, #tangents)).push_forward()
                }
            })
        }
        (None, None) => None,
    }
}

/// The forward mode as a function.
pub fn item(
    function: &Function<'_>,
    parameters: &[Parameter],
    result: &Type,
    bounds: &[TokenStream],
    tangents: &[Ident],
    body: Option<&TokenStream>,
) -> TokenStream {
    let signature = &function.callables.forward;
    let jvp = function.mode_name("jvp");
    // What the result leaves out is the lifetime of `&self`, if there is one.
    let borrows_self = signature
        .receiver()
        .is_some_and(|receiver| matches!(receiver.kind, ReceiverKind::Reference(..)));
    let (named_result, borrows) = elision::named(result);
    let is_named = borrows && !borrows_self;
    let inputs = signature.inputs.iter().zip(parameters).map(|(input, parameter)| match input {
        FnArg::Receiver(receiver) => bare(receiver).into_token_stream(),
        FnArg::Typed(typed) => {
            let ident = &parameter.ident;
            let ty = if is_named { elision::named(&typed.ty).0 } else { (*typed.ty).clone() };
            quote!(#ident: #ty)
        }
    });
    let lifetime = is_named.then(elision::lifetime);
    let tangents = tangents.iter().zip(parameters).map(|(ident, parameter)| {
        let ty = tangent_type(parameter);
        let mutability = parameter.is_mutable_receiver.then(|| quote!(mut));
        quote!(#mutability #ident: #ty)
    });
    let parameters = &signature.generics.params;
    let generics = match &lifetime {
        Some(lifetime) => Some(quote!(<#lifetime, #parameters>)),
        None => (!parameters.is_empty()).then(|| quote!(<#parameters>)),
    };
    let returned = if is_named { &named_result } else { result };
    let target = pointee(result);
    let tangent = quote_spanned!(target.span()=> ::ad::Tangent<#target>);
    let doc = format!(
        "The value of `{}` and its derivative along the tangents of the parameters.",
        signature.ident
    );
    let head = quote! {
        #jvp #generics (#(#inputs,)* #(#tangents),*) -> (#returned, #tangent)
        where #(#bounds),*
    };
    let body = body.map_or_else(|| quote!(;), ToTokens::to_token_stream);
    function.derivative_item(&doc, &head, &body)
}
