//! The shape of a struct or an enum: that of the parts whose tangents may differ in size; and its
//! zero tangent, made of those of the parts.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use syn::{Generics, Index, Variant};

use super::ActiveField;

/// `impl Differentiable` for a struct.
pub fn of_struct(
    name: &Ident,
    tangent: &Ident,
    generics: &Generics,
    fields: &[ActiveField],
) -> TokenStream {
    let types = fields.iter().map(shape_type);
    let values = fields.iter().map(|field| {
        let member = &field.member;
        shape_value(field, &quote!(&self.#member))
    });
    let fits = fields.iter().enumerate().map(|(index, field)| {
        let (index, member) = (Index::from(index), &field.member);
        quote!(::ad::Shape::fit(self.#index, &mut _tangent.#member);)
    });
    let zeros = fields.iter().map(|field| {
        let member = &field.member;
        zero_part(field, &quote!(&self.#member), &quote!(#member))
    });
    implementation(
        name,
        tangent,
        generics,
        &quote!((#(#types),*)),
        &quote!(__TangentShape(#(#values),*)),
        &quote!(#(#fits)*),
        &quote!(#(#zeros)*),
    )
}

/// `impl Differentiable` for an enum: the shape has an option for each variant with data.
pub fn of_enum(
    name: &Ident,
    tangent: &Ident,
    generics: &Generics,
    variants: &[(&Variant, Vec<ActiveField>)],
) -> TokenStream {
    let with_data: Vec<_> = variants.iter().filter(|(_, fields)| !fields.is_empty()).collect();
    let types = with_data.iter().map(|(_, fields)| {
        let types = fields.iter().map(shape_type);
        quote!(::core::option::Option<(#(#types,)*)>)
    });
    let arms = variants.iter().map(|(variant, fields)| {
        let ident = &variant.ident;
        let names = names(fields);
        let values =
            fields.iter().zip(&names).map(|(field, name)| shape_value(field, &quote!(#name)));
        let own = quote!(::core::option::Option::Some((#(#values,)*)));
        let options = with_data.iter().map(|(other, _)| match other.ident == *ident {
            true => own.clone(),
            false => quote!(::core::option::Option::None),
        });
        let pattern = pattern(fields);
        quote!(#name::#ident #pattern => __TangentShape(#(#options),*),)
    });
    let zeros = variants.iter().map(|(variant, fields)| {
        let ident = &variant.ident;
        let zeros = fields.iter().zip(names(fields)).map(|(field, name)| {
            let member = &field.member;
            zero_part(field, &quote!(#name), &quote!(#ident.#member))
        });
        let pattern = pattern(fields);
        quote!(#name::#ident #pattern => { #(#zeros)* })
    });
    let fits = with_data.iter().enumerate().map(|(index, (variant, fields))| {
        let (index, ident) = (Index::from(index), &variant.ident);
        let fits = fields.iter().enumerate().map(|(index, field)| {
            let (index, member) = (Index::from(index), &field.member);
            quote!(::ad::Shape::fit(fields.#index, &mut _tangent.#ident.#member);)
        });
        quote!(if let ::core::option::Option::Some(fields) = self.#index { #(#fits)* })
    });
    implementation(
        name,
        tangent,
        generics,
        &quote!((#(#types),*)),
        &quote!(match self { #(#arms)* }),
        &quote!(#(#fits)*),
        &quote!(match self { #(#zeros)* }),
    )
}

/// The names that the pattern of a variant gives to the fields.
fn names(fields: &[ActiveField]) -> Vec<Ident> {
    (0..fields.len()).map(|index| format_ident!("field_{index}")).collect()
}

/// The pattern of a variant, behind its name.
fn pattern(fields: &[ActiveField]) -> TokenStream {
    let (members, names) = (fields.iter().map(|field| &field.member), names(fields));
    quote!({ #(#members: #names),* })
}

fn shape_type(field: &ActiveField) -> TokenStream {
    let ty = &field.field.ty;
    match field.active {
        true => quote!(<#ty as ::ad::Differentiable>::Shape),
        false => quote!(::core::marker::PhantomData<fn() -> #ty>),
    }
}

fn shape_value(field: &ActiveField, reference: &TokenStream) -> TokenStream {
    let ty = &field.field.ty;
    match field.active {
        true => quote!(<#ty as ::ad::Differentiable>::shape(#reference)),
        false => quote!(::core::marker::PhantomData),
    }
}

/// Gives the zero tangent its part `place`, if that carries a derivative.
fn zero_part(
    field: &ActiveField,
    reference: &TokenStream,
    place: &TokenStream,
) -> Option<TokenStream> {
    field.active.then(|| quote!(zero.#place = ::ad::rt::zero_like(#reference);))
}

fn implementation(
    name: &Ident,
    tangent: &Ident,
    generics: &Generics,
    fields: &TokenStream,
    value: &TokenStream,
    fits: &TokenStream,
    zeros: &TokenStream,
) -> TokenStream {
    let (impl_generics, type_generics, where_clause) = generics.split_for_impl();
    quote! {
        const _: () = {
            // Named only through the trait: it may hold the shapes of private types. It must not
            // hide a type that a field has.
            pub struct __TangentShape #impl_generics #fields #where_clause;

            #[automatically_derived]
            impl #impl_generics ::ad::Differentiable for #name #type_generics #where_clause {
                type Tangent = #tangent #type_generics;
                type Shape = __TangentShape #type_generics;

                #[inline]
                #[allow(unused_variables)]
                fn shape(&self) -> __TangentShape #type_generics {
                    #value
                }

                #[inline]
                #[allow(unused_mut, unused_variables)]
                fn zero_tangent(&self) -> #tangent #type_generics {
                    let mut zero: #tangent #type_generics = ::ad::Additive::zero();
                    #zeros
                    zero
                }
            }

            #[automatically_derived]
            impl #impl_generics ::ad::Shape<#tangent #type_generics> for __TangentShape #type_generics
            #where_clause
            {
                #[inline]
                #[allow(unused_variables)]
                fn fit(self, _tangent: &mut #tangent #type_generics) {
                    #fits
                }
            }
        };
    }
}
