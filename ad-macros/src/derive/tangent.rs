//! The struct that is a tangent.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::{Generics, Member, Visibility};

/// A struct to be generated, of tangents.
pub struct TangentStruct<'a> {
    pub name: Ident,
    pub doc: String,
    pub visibility: &'a Visibility,
    pub generics: &'a Generics,
    pub is_tuple: bool,
    pub fields: Vec<TangentField>,
}

/// One of its fields.
pub struct TangentField {
    pub member: Member,
    pub ty: TokenStream,
    pub visibility: TokenStream,
    pub doc: String,
}

impl TangentStruct<'_> {
    /// The struct, as something that can be accumulated.
    pub fn expand(&self) -> TokenStream {
        let Self { name, generics, fields, .. } = self;
        let definition = self.definition();
        let (impl_generics, type_generics, where_clause) = generics.split_for_impl();
        let bounds: Vec<_> = where_clause.iter().flat_map(|clause| &clause.predicates).collect();
        let members: Vec<_> = fields.iter().map(|field| &field.member).collect();
        let types: Vec<_> = fields.iter().map(|field| &field.ty).collect();
        let indices = 0..fields.len();
        let tangent_name = name.to_string();
        let member_names = members.iter().map(|member| match member {
            Member::Named(ident) => ident.to_string(),
            Member::Unnamed(index) => index.index.to_string(),
        });
        quote! {
            #definition

            #[automatically_derived]
            impl #impl_generics ::ad::Additive for #name #type_generics #where_clause {
                #[inline]
                fn zero() -> Self {
                    Self { #(#members: ::ad::Additive::zero()),* }
                }

                #[inline]
                fn accumulate(&mut self, other: Self) {
                    #(::ad::Additive::accumulate(&mut self.#members, other.#members);)*
                }
            }

            #[automatically_derived]
            impl #impl_generics ::core::clone::Clone for #name #type_generics #where_clause {
                #[inline]
                fn clone(&self) -> Self {
                    Self { #(#members: ::core::clone::Clone::clone(&self.#members)),* }
                }
            }

            #[automatically_derived]
            impl #impl_generics ::core::marker::Copy for #name #type_generics
            where
                #(#bounds,)*
                #(for<'__copy> #types: ::ad::rt::CopyIf<'__copy, #indices>,)*
            {
            }

            #[automatically_derived]
            impl #impl_generics ::core::fmt::Debug for #name #type_generics #where_clause {
                fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                    f.debug_struct(#tangent_name)
                        #(.field(#member_names, &self.#members))*
                        .finish()
                }
            }
        }
    }

    fn definition(&self) -> TokenStream {
        let Self { name, doc, visibility, generics, .. } = self;
        let (impl_generics, _, where_clause) = generics.split_for_impl();
        let fields = self.fields.iter().map(|TangentField { member, ty, visibility, doc }| {
            match self.is_tuple {
                true => quote!(#[doc = #doc] #visibility #ty),
                false => quote!(#[doc = #doc] #visibility #member: #ty),
            }
        });
        match self.is_tuple {
            true => quote! {
                #[doc = #doc]
                #visibility struct #name #impl_generics (#(#fields),*) #where_clause;
            },
            false => quote! {
                #[doc = #doc]
                #[allow(non_snake_case)]
                #visibility struct #name #impl_generics #where_clause { #(#fields),* }
            },
        }
    }
}
