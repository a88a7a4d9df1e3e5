//! `#[derive(Differentiable)]`: a tangent for a struct.

use proc_macro2::TokenStream;
use quote::{format_ident, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Data, DeriveInput, Field, Fields};

/// The tangent struct and the impls that make it one.
pub fn expand(item: TokenStream) -> syn::Result<TokenStream> {
    let input: DeriveInput = syn::parse2(item)?;
    let Data::Struct(data) = &input.data else {
        return Err(syn::Error::new_spanned(
            &input.ident,
            "only a struct can be differentiable: give an enum's data to a struct of its own",
        ));
    };
    let (name, visibility) = (&input.ident, &input.vis);
    let tangent = format_ident!("{name}Tangent");
    let (impl_generics, type_generics, where_clause) = input.generics.split_for_impl();
    let bounds: Vec<_> = where_clause.iter().flat_map(|clause| &clause.predicates).collect();

    let fields: Vec<_> = data.fields.iter().collect();
    let members: Vec<_> = data.fields.members().collect();
    let types: Vec<_> = fields.iter().map(|field| tangent_type(field)).collect();
    let doc = format!("The tangent of [`{name}`].");
    let definition = match &data.fields {
        Fields::Named(_) => {
            let fields = fields.iter().zip(&types).map(|(field, ty)| {
                let (visibility, ident) = (&field.vis, &field.ident);
                let doc = format!("The tangent of `{}`.", ident.as_ref().expect("it is named"));
                quote!(#[doc = #doc] #visibility #ident: #ty)
            });
            quote!(#visibility struct #tangent #impl_generics #where_clause { #(#fields),* })
        }
        Fields::Unnamed(_) => {
            let fields = fields.iter().zip(&types).map(|(field, ty)| {
                let visibility = &field.vis;
                quote!(#visibility #ty)
            });
            quote!(#visibility struct #tangent #impl_generics (#(#fields),*) #where_clause;)
        }
        Fields::Unit => {
            quote!(#visibility struct #tangent #impl_generics #where_clause {})
        }
    };
    let tangent_name = tangent.to_string();
    let member_names = members.iter().map(|member| match member {
        syn::Member::Named(ident) => ident.to_string(),
        syn::Member::Unnamed(index) => index.index.to_string(),
    });

    let shapes: Vec<_> = fields.iter().map(|field| shape_type(field)).collect();
    let shape_values = fields.iter().zip(&members).map(|(field, member)| {
        let ty = &field.ty;
        match is_constant(field) {
            true => quote!(::core::marker::PhantomData),
            false => quote!(<#ty as ::ad::Differentiable>::shape(&self.#member)),
        }
    });
    let fits = members.iter().enumerate().map(|(index, member)| {
        let index = syn::Index::from(index);
        quote!(::ad::Shape::fit(self.#index, &mut _tangent.#member);)
    });

    Ok(quote! {
        #[doc = #doc]
        #definition

        const _: () = {
            // Named only through the trait: it may hold the shapes of private types.
            pub struct Shape #impl_generics (#(#shapes),*) #where_clause;

            #[automatically_derived]
            impl #impl_generics ::ad::Differentiable for #name #type_generics #where_clause {
                type Tangent = #tangent #type_generics;
                type Shape = Shape #type_generics;

                #[inline]
                fn shape(&self) -> Self::Shape {
                    Shape(#(#shape_values),*)
                }
            }

            #[automatically_derived]
            impl #impl_generics ::ad::Shape<#tangent #type_generics> for Shape #type_generics
            #where_clause
            {
                #[inline]
                fn fit(self, _tangent: &mut #tangent #type_generics) {
                    #(#fits)*
                }
            }
        };

        #[automatically_derived]
        impl #impl_generics ::ad::Additive for #tangent #type_generics #where_clause {
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
        impl #impl_generics ::core::clone::Clone for #tangent #type_generics #where_clause {
            #[inline]
            fn clone(&self) -> Self {
                Self { #(#members: ::core::clone::Clone::clone(&self.#members)),* }
            }
        }

        #[automatically_derived]
        impl #impl_generics ::core::marker::Copy for #tangent #type_generics
        where
            #(#bounds,)*
            #(for<'__copy> #types: ::ad::rt::CopyIf<'__copy>,)*
        {
        }

        #[automatically_derived]
        impl #impl_generics ::core::fmt::Debug for #tangent #type_generics #where_clause {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                f.debug_struct(#tangent_name)
                    #(.field(#member_names, &self.#members))*
                    .finish()
            }
        }
    })
}

fn is_constant(field: &Field) -> bool {
    field.attrs.iter().any(|attribute| attribute.path().is_ident("constant"))
}

fn tangent_type(field: &Field) -> TokenStream {
    let ty = &field.ty;
    match is_constant(field) {
        true => quote!(::ad::NoTangent<#ty>),
        false => quote_spanned!(ty.span()=> ::ad::Tangent<#ty>),
    }
}

fn shape_type(field: &Field) -> TokenStream {
    let ty = &field.ty;
    match is_constant(field) {
        true => quote!(::core::marker::PhantomData<fn() -> #ty>),
        false => quote!(<#ty as ::ad::Differentiable>::Shape),
    }
}
