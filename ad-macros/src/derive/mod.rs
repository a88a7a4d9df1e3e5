//! `#[derive(Differentiable)]`: tangents for structs and enums.
//!
//! The tangent of a struct is a struct of the tangents of its fields. That of an enum is a struct
//! too, with a field for each variant that holds data: the tangents of all variants side by side,
//! of which those of the variants that the value is not stay zero. Turned down: an enum of the
//! tangents of its variants. It would have to know the variant to make a zero, and two of different
//! variants could not be added; with all side by side the cotangent of a field is a place, known
//! when the code is written, and the compiler drops those that nothing flows to.

pub mod fields;
mod itself;
mod shape;
mod tangent;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::visit::Visit;
use syn::{
    Attribute, Data, DeriveInput, Field, Fields, Generics, Member, Type, Variant, Visibility,
    parse_quote,
};

use crate::names;
use crate::parse::groups;
use tangent::{TangentField, TangentStruct};

/// The tangent and the impls that make it one.
pub fn expand(item: TokenStream) -> syn::Result<TokenStream> {
    let mut input: DeriveInput = syn::parse2(groups::explicit(item))?;
    itself::name(&mut input);
    let name = &input.ident;
    let is_constant = is_constant(&input.attrs);
    // What it holds can be named in generated code: it has the tangent of a type whose fields are all `#[constant]`.
    let fields = |of: &Fields| {
        let mut fields = fields(of);
        fields.iter_mut().for_each(|field| field.active &= !is_constant);
        fields
    };
    let variants: Vec<_> = match &input.data {
        Data::Struct(data) if is_constant && data.fields.is_empty() => {
            return Ok(without_derivative(name, &input.generics));
        }
        Data::Struct(data) => {
            let fields = fields(&data.fields);
            input.generics = bounded(&input.generics, &fields);
            let tangent = format_ident!("{name}Tangent");
            let definition = TangentStruct {
                name: tangent.clone(),
                doc: format!("The tangent of [`{name}`]."),
                visibility: &input.vis,
                generics: &input.generics,
                is_tuple: matches!(data.fields, Fields::Unnamed(_)),
                fields: fields.iter().map(ActiveField::tangent).collect(),
            };
            let definition = definition.expand();
            let shape = shape::of_struct(name, &tangent, &input.generics, &fields);
            let parts = parts(name, &input.generics, &data.fields);
            let operand = operand(name, &input.generics);
            let kind = match is_constant {
                true => constant(name, &tangent, &input.generics),
                false => without_drop(name, &input.generics),
            };
            return Ok(quote!(#definition #shape #parts #operand #kind));
        }
        Data::Enum(data) => data.variants.iter().collect(),
        Data::Union(data) => {
            return Err(syn::Error::new_spanned(
                data.union_token,
                "a `union` has no derivative: use a struct or an enum",
            ));
        }
    };
    if variants.iter().all(|variant| variant.fields.is_empty()) {
        return Ok(without_derivative(name, &input.generics));
    }

    let variants: Vec<_> =
        variants.into_iter().map(|variant| (variant, fields(&variant.fields))).collect();
    let all: Vec<_> = variants.iter().flat_map(|(_, fields)| fields).cloned().collect();
    let generics = bounded(&input.generics, &all);
    let (_, type_generics, _) = generics.split_for_impl();
    let mut definitions = TokenStream::new();
    let mut variant_fields = Vec::new();
    for (variant, fields) in variants.iter().filter(|(_, fields)| !fields.is_empty()) {
        let ident = &variant.ident;
        let tangent = format_ident!("{}Tangent{}", name, ident, span = Span::call_site());
        // Each holds what it says of the parameters in types of fields; not every variant does.
        let visibility = &input.vis;
        // What a variant holds is as visible as the enum.
        let as_visible =
            |field| TangentField { visibility: quote!(#visibility), ..ActiveField::tangent(field) };
        let mut fields: Vec<_> = fields.iter().map(as_visible).collect();
        let unused = unused_parameters(&generics, &fields);
        if let Some(unused) = unused {
            fields.push(TangentField {
                member: match variant.fields {
                    Fields::Named(_) => Member::Named(format_ident!("__parameters")),
                    _ => Member::from(fields.len()),
                },
                ty: quote!(::ad::NoTangent<#unused>),
                visibility: quote!(),
                doc: "Names the other parameters.".to_owned(),
            });
        }
        let definition = TangentStruct {
            name: tangent.clone(),
            doc: format!("The tangent of [`{name}::{ident}`]."),
            visibility: &input.vis,
            generics: &generics,
            is_tuple: matches!(variant.fields, Fields::Unnamed(_)),
            fields,
        };
        definitions.extend(definition.expand());
        let visibility = &input.vis;
        variant_fields.push(TangentField {
            member: Member::Named(ident.clone()),
            ty: quote!(#tangent #type_generics),
            visibility: quote!(#visibility),
            doc: format!("The tangent of the variant `{ident}`."),
        });
    }
    let tangent = format_ident!("{name}Tangent");
    let definition = TangentStruct {
        name: tangent.clone(),
        doc: format!("The tangent of [`{name}`]: those of its variants, side by side."),
        visibility: &input.vis,
        generics: &generics,
        is_tuple: false,
        fields: variant_fields,
    };
    definitions.extend(definition.expand());
    definitions.extend(shape::of_enum(name, &tangent, &generics, &variants));
    definitions.extend(operand(name, &generics));
    definitions.extend(parts_of_enum(name, &input.generics, &input.vis, &variants));
    definitions.extend(match is_constant {
        true => constant(name, &tangent, &generics),
        false => without_drop(name, &generics),
    });
    Ok(definitions)
}

/// A field, and whether it carries a derivative.
#[derive(Clone)]
struct ActiveField {
    field: Field,
    member: Member,
    active: bool,
}

impl ActiveField {
    fn tangent(&self) -> TangentField {
        let (ty, visibility, member) = (&self.field.ty, &self.field.vis, &self.member);
        let name = match member {
            Member::Named(ident) => ident.to_string(),
            Member::Unnamed(index) => index.index.to_string(),
        };
        TangentField {
            member: member.clone(),
            ty: match self.active {
                true => quote_spanned!(ty.span()=> ::ad::Tangent<#ty>),
                false => quote!(::ad::NoTangent<#ty>),
            },
            visibility: quote!(#visibility),
            doc: format!("The tangent of `{name}`."),
        }
    }
}

fn fields(fields: &Fields) -> Vec<ActiveField> {
    let field = |(field, member): (&Field, Member)| ActiveField {
        field: field.clone(),
        member,
        active: !is_constant(&field.attrs),
    };
    fields.iter().zip(fields.members()).map(field).collect()
}

fn is_constant(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| attribute.path().is_ident("constant"))
}

/// The parts of a `#[constant]` field of the type.
fn parts(name: &Ident, generics: &Generics, fields: &Fields) -> TokenStream {
    let (impl_generics, _, where_clause) = generics.split_for_impl();
    let types = fields.iter().map(|field| {
        let (visibility, ident, ty) = (&field.vis, &field.ident, &field.ty);
        let colon = &field.colon_token;
        quote!(#visibility #ident #colon ::ad::NoTangent<#ty>)
    });
    let definition = match fields {
        Fields::Named(_) => quote! {
            pub struct __TangentParts #impl_generics #where_clause { #(#types),* }
        },
        Fields::Unnamed(_) => quote! {
            pub struct __TangentParts #impl_generics (#(#types),*) #where_clause;
        },
        Fields::Unit => quote! {
            pub struct __TangentParts #impl_generics #where_clause {}
        },
    };
    let members = fields.members();
    let values = quote!(#(#members: ::ad::NoTangent::new()),*);
    with_parts(name, generics, &definition, &values)
}

/// Defines `__TangentParts`, of which the fields have these values, as the parts of a type.
fn with_parts(
    name: &Ident,
    generics: &Generics,
    definition: &TokenStream,
    values: &TokenStream,
) -> TokenStream {
    let (impl_generics, type_generics, where_clause) = generics.split_for_impl();
    quote! {
        #[allow(non_snake_case, non_camel_case_types)]
        const _: () = {
            #definition

            #[automatically_derived]
            impl #impl_generics ::ad::rt::Parts for #name #type_generics #where_clause {
                type Parts = __TangentParts #type_generics;

                #[inline(always)]
                fn parts() -> Self::Parts {
                    __TangentParts { #values }
                }
            }
        };
    }
}

/// The parts of a `#[constant]` field of an enum: for each variant with data a tuple, or a struct, of its parts.
fn parts_of_enum(
    name: &Ident,
    generics: &Generics,
    visibility: &Visibility,
    variants: &[(&Variant, Vec<ActiveField>)],
) -> TokenStream {
    let (impl_generics, type_generics, where_clause) = generics.split_for_impl();
    let mut structs = TokenStream::new();
    let (mut fields, mut values) = (Vec::new(), Vec::new());
    for (Variant { ident, fields: data, .. }, _) in variants.iter().filter(|(_, of)| !of.is_empty())
    {
        let (members, types): (Vec<_>, Vec<_>) =
            data.iter().map(|field| (&field.ident, &field.ty)).unzip();
        let zeros = types.iter().map(|_| quote!(::ad::NoTangent::new()));
        let (ty, value) = match data {
            Fields::Named(_) => {
                let parts = format_ident!("__{}Parts", ident, span = Span::call_site());
                structs.extend(quote! {
                    pub struct #parts #impl_generics #where_clause {
                        #(#visibility #members: ::ad::NoTangent<#types>,)*
                        __parameters: ::ad::NoTangent<#name #type_generics>,
                    }
                });
                let value = quote! {
                    #parts { #(#members: #zeros,)* __parameters: ::ad::NoTangent::new() }
                };
                (quote!(#parts #type_generics), value)
            }
            _ => (quote!((#(::ad::NoTangent<#types>,)*)), quote!((#(#zeros,)*))),
        };
        fields.push(quote!(#visibility #ident: #ty));
        values.push(quote!(#ident: #value));
    }
    let definition = quote! {
        #structs

        pub struct __TangentParts #impl_generics #where_clause {
            #(#fields,)*
            __parameters: ::ad::NoTangent<#name #type_generics>,
        }
    };
    let values = quote!(#(#values,)* __parameters: ::ad::NoTangent::new());
    with_parts(name, generics, &definition, &values)
}

/// Lets an operator take what a reference to the type refers to, if that can be copied.
fn operand(name: &Ident, generics: &Generics) -> TokenStream {
    let (impl_generics, type_generics, where_clause) = generics.split_for_impl();
    let bounds: Vec<_> = where_clause.iter().flat_map(|clause| &clause.predicates).collect();
    quote! {
        #[automatically_derived]
        impl #impl_generics ::ad::rt::ByValue for #name #type_generics
        where
            #(#bounds,)*
            #name #type_generics: for<'__copy> ::ad::rt::CopyIf<'__copy>,
        {
            type Value = Self;

            #[inline(always)]
            fn by_value(self) -> Self {
                self
            }
        }
    }
}

/// Has the compiler refuse an `impl Drop`: a pullback may keep a value longer than the function does. The
/// name of the trait is what it says.
fn without_drop(name: &Ident, generics: &Generics) -> TokenStream {
    let (impl_generics, type_generics, where_clause) = generics.split_for_impl();
    quote! {
        const _: () = {
            trait TakeDropOffWhatHasADerivative {}

            #[allow(drop_bounds)]
            impl<T: ::core::ops::Drop> TakeDropOffWhatHasADerivative for T {}

            impl #impl_generics TakeDropOffWhatHasADerivative for #name #type_generics #where_clause {}
        };
    }
}

/// What holds no data to differentiate by is like an integer.
fn without_derivative(name: &Ident, generics: &Generics) -> TokenStream {
    let (impl_generics, type_generics, where_clause) = generics.split_for_impl();
    let (operand, no_derivative) = (operand(name, generics), no_derivative(name, generics));
    quote! {
        #[automatically_derived]
        impl #impl_generics ::ad::Differentiable for #name #type_generics #where_clause {
            type Tangent = ();
            type Shape = ();

            #[inline(always)]
            fn shape(&self) {}
        }

        #no_derivative
        #operand
    }
}

/// The same of a type that holds data, which has a tangent.
fn constant(name: &Ident, tangent: &Ident, generics: &Generics) -> TokenStream {
    let (impl_generics, type_generics, where_clause) = generics.split_for_impl();
    let no_derivative = no_derivative(name, generics);
    quote! {
        #[automatically_derived]
        impl #impl_generics ::ad::rt::Vanishing for #tangent #type_generics #where_clause {}

        #no_derivative
    }
}

/// Says that nothing flows to the type.
fn no_derivative(name: &Ident, generics: &Generics) -> TokenStream {
    let (impl_generics, type_generics, where_clause) = generics.split_for_impl();
    quote! {
        #[automatically_derived]
        impl #impl_generics ::ad::NoDerivative for #name #type_generics #where_clause {}
    }
}

/// The generics, with the type parameters that a derivative flows through made `Differentiable`.
fn bounded(generics: &Generics, fields: &[ActiveField]) -> Generics {
    let mut named = Named::default();
    for field in fields.iter().filter(|field| field.active && !is_phantom(&field.field.ty)) {
        named.visit_type(&field.field.ty);
    }
    let mut generics = generics.clone();
    let parameters: Vec<_> = generics.type_params().map(|ty| ty.ident.clone()).collect();
    let active: Vec<_> = parameters.into_iter().filter(|ty| named.0.contains(ty)).collect();
    if !active.is_empty() {
        let clause = generics.make_where_clause();
        for ty in active {
            clause.predicates.push(parse_quote!(#ty: ::ad::Differentiable));
        }
    }
    generics
}

fn is_phantom(ty: &Type) -> bool {
    matches!(ty, Type::Path(path)
        if path.path.segments.last().is_some_and(|last| last.ident == "PhantomData"))
}

/// A type that names the parameters that none of the fields names.
fn unused_parameters(generics: &Generics, fields: &[TangentField]) -> Option<TokenStream> {
    let mut named = std::collections::HashSet::new();
    for field in fields {
        names::collect(field.ty.clone(), &mut named);
    }
    let types = generics.type_params().map(|ty| &ty.ident);
    let types: Vec<_> = types.filter(|ty| !named.contains(&ty.to_string())).collect();
    let lifetimes = generics.lifetimes().map(|lifetime| &lifetime.lifetime);
    let lifetimes: Vec<_> =
        lifetimes.filter(|lifetime| !named.contains(&lifetime.ident.to_string())).collect();
    if types.is_empty() && lifetimes.is_empty() {
        return None;
    }
    Some(quote!((#(::core::marker::PhantomData<#types>,)* #(&#lifetimes (),)*)))
}

/// The identifiers in a type.
#[derive(Default)]
struct Named(Vec<Ident>);

impl<'ast> Visit<'ast> for Named {
    fn visit_ident(&mut self, ident: &'ast Ident) {
        self.0.push(ident.clone());
    }
}
