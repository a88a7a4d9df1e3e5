//! `#[derive(Fields)]`: the numbers of a struct that is generic over its scalar, one by one.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use syn::{Data, DeriveInput, Fields, GenericParam, Type};

/// The impls for the struct and for its tangent.
pub fn expand(item: TokenStream) -> syn::Result<TokenStream> {
    let input: DeriveInput = syn::parse2(item)?;
    let Data::Struct(data) = &input.data else {
        return Err(syn::Error::new_spanned(&input.ident, "`Fields` is for structs"));
    };
    let Fields::Named(named) = &data.fields else {
        return Err(syn::Error::new_spanned(&input.ident, "`Fields` is for structs with names"));
    };
    let parameters: Vec<_> = input.generics.params.iter().collect();
    let [GenericParam::Type(scalar)] = parameters[..] else {
        return Err(syn::Error::new_spanned(
            &input.ident,
            "a struct with `Fields` has one parameter, its scalar: `struct Name<S: Real>`",
        ));
    };
    let fields: Vec<(&Ident, &Type)> =
        named.named.iter().filter_map(|field| Some((field.ident.as_ref()?, &field.ty))).collect();
    let tangents: Vec<Type> =
        fields.iter().map(|(_, ty)| syn::parse_quote!(::ad::Tangent<#ty>)).collect();
    let of_tangent: Vec<_> =
        fields.iter().zip(&tangents).map(|((name, _), ty)| (*name, ty)).collect();
    let tangent = format_ident!("{}Tangent", input.ident);
    let value = implementation(&input.ident, &scalar.ident, &fields);
    let tangent = implementation(&tangent, &scalar.ident, &of_tangent);
    Ok(quote!(#value #tangent))
}

fn implementation(name: &Ident, scalar: &Ident, fields: &[(&Ident, &Type)]) -> TokenStream {
    let names: Vec<&Ident> = fields.iter().map(|(name, _)| *name).collect();
    let lengths: Vec<TokenStream> =
        fields.iter().map(|(_, ty)| quote!(<#ty as ::ad::Fields<#scalar>>::LEN)).collect();
    // Where the numbers of each field begin.
    let starts: Vec<TokenStream> = (0..fields.len()).map(|count| sum(&lengths[..count])).collect();
    let total = sum(&lengths);
    quote! {
        #[automatically_derived]
        impl<#scalar: ::ad::Real> ::ad::Fields<#scalar> for #name<#scalar> {
            type With<__T: ::ad::Real> = #name<__T>;

            const LEN: usize = #total;
            const FIELDS: &'static [::ad::Field] =
                &[#(::ad::Field { name: stringify!(#names), len: #lengths }),*];

            #[inline(always)]
            fn number(&self, index: usize) -> #scalar {
                #(
                    if index < #starts + #lengths {
                        return ::ad::Fields::<#scalar>::number(&self.#names, index - (#starts));
                    }
                )*
                panic!("no number {index} among {}", <Self as ::ad::Fields<#scalar>>::LEN)
            }

            #[inline(always)]
            fn from_fn(f: &mut impl FnMut(usize) -> #scalar) -> Self {
                Self {
                    #(#names: ::ad::Fields::<#scalar>::from_fn(
                        &mut |index| f(#starts + index),
                    )),*
                }
            }

            #[inline(always)]
            fn visit(&self, f: &mut impl FnMut(usize, #scalar)) {
                #(::ad::Fields::<#scalar>::visit(
                    &self.#names,
                    &mut |index, number| f(#starts + index, number),
                );)*
            }
        }
    }
}

fn sum(lengths: &[TokenStream]) -> TokenStream {
    quote!(0 #(+ #lengths)*)
}
