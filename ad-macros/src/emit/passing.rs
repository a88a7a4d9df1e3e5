//! The functions that make objects of closures without types, `f::argument_0` (for a method `m`
//! `m_argument_1`), and those that pass a
//! reference to an object as the function takes it, `f::passed_0`.
//!
//! A closure gets the types of its parameters from a bound on what it is passed to, if the bound is one
//! of `Fn` itself. So a function of functions brings one for each of these, with the types that it
//! states, in each mode.

use std::collections::HashSet;

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};
use syn::{GenericParam, PredicateType, Type, WherePredicate};

use super::forward;
use crate::ir::argument;
use crate::names;
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

/// The generic parameters that the types of a closure's parameters name, with their bounds, and the predicates of
/// these: a call of what a closure is passed to tells no others.
fn telling<'f>(
    function: &Function<'f>,
    arguments: &[Type],
) -> (Vec<&'f GenericParam>, Vec<&'f WherePredicate>) {
    let generics = &function.callables.signature.generics;
    let is_function = |name: &Ident| function.callables.types().any(|function| function == name);
    let clauses = generics.where_clause.iter().flat_map(|clause| &clause.predicates);
    let predicates: Vec<_> =
        clauses.filter(|predicate| !bounded(predicate).is_some_and(is_function)).collect();
    let parameter_of = |name: &Ident| {
        generics.params.iter().find(|parameter| match parameter {
            GenericParam::Type(ty) => ty.ident == *name && !is_function(name),
            GenericParam::Const(number) => number.ident == *name,
            GenericParam::Lifetime(_) => false,
        })
    };
    let mut named: HashSet<Ident> = HashSet::new();
    let mut new = names::identifiers(quote!(#(#arguments),*));
    while let Some(name) = new.pop() {
        let Some(parameter) = parameter_of(&name).filter(|_| named.insert(name.clone())) else {
            continue;
        };
        new.extend(names::identifiers(parameter.to_token_stream()));
        let own = predicates.iter().filter(|predicate| bounded(predicate) == Some(&name));
        new.extend(own.flat_map(|predicate| names::identifiers(predicate.to_token_stream())));
    }
    let is_told = |name: &Ident| parameter_of(name).is_none() || named.contains(name);
    let plain = generics.params.iter().filter(|parameter| match parameter {
        GenericParam::Type(ty) => named.contains(&ty.ident),
        GenericParam::Const(number) => named.contains(&number.ident),
        GenericParam::Lifetime(_) => true,
    });
    let told = |predicate: &&WherePredicate| {
        names::identifiers(predicate.to_token_stream()).iter().all(is_told)
    };
    (plain.collect(), predicates.into_iter().filter(told).collect())
}

/// The type parameter of which a predicate says something.
fn bounded(predicate: &WherePredicate) -> Option<&Ident> {
    match predicate {
        WherePredicate::Type(PredicateType { bounded_ty: Type::Path(path), .. }) => {
            path.path.get_ident()
        }
        _ => None,
    }
}

fn for_parameter(function: &Function<'_>, index: usize, arguments: &[Type]) -> TokenStream {
    let (plain, predicates) = telling(function, arguments);
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
