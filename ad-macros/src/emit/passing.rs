//! The functions that make objects of closures without types, `f::argument_0` (for a method `m`
//! `m_argument_1`), and those that pass a
//! reference to an object as the function takes it, `f::passed_0`.
//!
//! A closure gets the types of its parameters from a bound on what it is passed to, if the bound is one
//! of `Fn` itself. So a function of functions brings one for each of these, with the types that it
//! states, in each mode.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};
use syn::{GenericParam, Type, WherePredicate};

use super::forward;
use crate::ir::argument;
use crate::names::own;
use crate::parse::elision;
use crate::parse::function::{Function, Place};
use crate::parse::signature::Parameter;

/// The functions for the parameters of `function` that are functions.
///
/// Methods have those for closures alone; they take `&self`, so that a call tells the type.
pub fn functions(function: &Function<'_>, parameters: &[Parameter]) -> TokenStream {
    let is_free = matches!(function.place, Place::Free);
    if !is_free && function.signature.receiver().is_none() {
        return TokenStream::new();
    }
    let of_parameter = |(index, parameter): (usize, &Parameter)| {
        let arguments = function.callables.arguments(&parameter.ty)?;
        let by_type = for_parameter(function, index, arguments);
        let by_reference = is_free.then(|| for_reference(index, parameter));
        Some(quote!(#by_type #by_reference))
    };
    parameters.iter().enumerate().filter_map(of_parameter).collect()
}

fn for_reference(index: usize, parameter: &Parameter) -> TokenStream {
    let (name, passed) = (format_ident!("passed_{index}"), own("function"));
    let (result, value) = match parameter.is_shared {
        true => (quote!(&__Function), quote!(#passed)),
        false => (quote!(__Function), quote!(::core::clone::Clone::clone(#passed))),
    };
    quote! {
        #[doc(hidden)]
        #[inline(always)]
        pub fn #name<__Function: ::core::clone::Clone>(#passed: &__Function) -> #result {
            #value
        }
    }
}

fn for_parameter(function: &Function<'_>, index: usize, arguments: &[Type]) -> TokenStream {
    let generics = &function.callables.signature.generics;
    let is_function = |name: &Ident| function.callables.types().any(|function| function == name);
    let plain: Vec<_> = generics
        .params
        .iter()
        .filter(|parameter| !matches!(parameter, GenericParam::Type(ty) if is_function(&ty.ident)))
        .collect();
    let predicates = generics.where_clause.iter().flat_map(|clause| &clause.predicates);
    let predicates: Vec<_> = predicates
        .filter(|predicate| match predicate {
            WherePredicate::Type(predicate) => match &predicate.bounded_ty {
                Type::Path(path) => !path.path.get_ident().is_some_and(is_function),
                _ => true,
            },
            _ => true,
        })
        .collect();
    let lifetime = elision::lifetime();
    let types: Vec<_> = arguments.iter().map(|ty| elision::named(ty).0).collect();
    let dots = types.iter().map(forward::tangent_of_type);
    let (method, receiver, visibility) = match function.place {
        Place::Free => (None, None, quote!(pub)),
        // The receiver is the first parameter.
        _ => (
            Some(&function.signature.ident),
            Some(quote!(&self,)),
            function.visibility.to_token_stream(),
        ),
    };
    let [reverse, forward] = ["", "_forward"].map(|mode| argument(method, index, mode));
    let is_sized =
        matches!(function.place, Place::Trait(_)).then(|| quote!(Self: ::core::marker::Sized,));
    let (captured, closure) = (own("captured"), own("closure"));
    let reverse_only = function.options.reverse || function.options.jvp.is_some();
    let forward = (!reverse_only).then(|| {
        quote! {
            #[doc(hidden)]
            // Used where a closure without types is passed.
            #[allow(dead_code)]
            #[inline(always)]
            #visibility fn #forward<#(#plain,)* __Result, __Tangent, __Closure>(
                #receiver
                #closure: __Closure,
            ) -> ::ad::function::ForwardClosure<__Closure>
            where
                #is_sized
                #(#predicates,)*
                __Closure: for<#lifetime> Fn((#(#types,)*), ::core::option::Option<(#(#dots,)*)>)
                    -> (__Result, ::core::option::Option<__Tangent>),
            {
                ::ad::function::forward(#closure)
            }
        }
    });
    quote! {
        #[doc(hidden)]
        // Used where a closure without types is passed.
        #[allow(dead_code)]
        #[inline(always)]
        #visibility fn #reverse<#(#plain,)* __Tangents: ::ad::Additive, __Result, __Pullback, __Closure>(
            #receiver
            #captured: ::ad::function::Captured<__Tangents>,
            #closure: __Closure,
        ) -> ::ad::function::Closure<__Tangents, __Closure>
        where
            #is_sized
            #(#predicates,)*
            __Closure: for<#lifetime> Fn(bool, (#(#types,)*))
                -> (__Result, ::core::option::Option<__Pullback>),
        {
            #captured.closure(#closure)
        }

        #forward
    }
}
