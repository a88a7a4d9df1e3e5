//! What the form of a type tells.

use crate::names;
use quote::quote;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{GenericArgument, Ident, PathArguments, Type, parse_quote_spanned};

/// Whether an attribute of a parameter says that no derivative by it is asked for.
pub fn is_constant_mark(attribute: &syn::Attribute) -> bool {
    attribute.path().is_ident("constant")
}

/// The type whose tangent is the cotangent of something of type `ty`: that of a reference is that
/// of its target.
pub fn pointee(ty: &Type) -> &Type {
    match ty {
        Type::Reference(reference) => pointee(&reference.elem),
        Type::Paren(paren) => pointee(&paren.elem),
        _ => ty,
    }
}

/// A type without references that has the tangent of `ty`: the result of a closure type cannot leave
/// out lifetimes.
pub fn owned(ty: &Type) -> Type {
    struct Owner;

    impl VisitMut for Owner {
        fn visit_type_mut(&mut self, ty: &mut Type) {
            match ty {
                Type::Reference(reference) => {
                    let target = match &*reference.elem {
                        Type::Slice(slice) => {
                            let element = &slice.elem;
                            parse_quote_spanned!(element.span()=> ::std::vec::Vec<#element>)
                        }
                        Type::Path(path) if path.path.is_ident("str") => {
                            parse_quote_spanned!(path.span()=> ::std::string::String)
                        }
                        target => target.clone(),
                    };
                    *ty = target;
                    self.visit_type_mut(ty);
                }
                Type::Path(path)
                    if !path.path.segments.last().is_some_and(|last| {
                        ["Option", "Result", "Vec", "Box"].iter().any(|name| last.ident == name)
                    }) => {}
                ty => visit_mut::visit_type_mut(self, ty),
            }
        }
    }

    let mut ty = pointee(ty).clone();
    Owner.visit_type_mut(&mut ty);
    ty
}

/// Whether a value of this type certainly has no derivative.
pub fn is_discrete(ty: &Type) -> bool {
    const DISCRETE: [&str; 16] = [
        "bool", "char", "str", "String", "i8", "i16", "i32", "i64", "i128", "isize", "u8", "u16",
        "u32", "u64", "u128", "usize",
    ];
    matches!(pointee(ty), Type::Path(path)
        if path.qself.is_none() && DISCRETE.iter().any(|name| path.path.is_ident(name)))
}

/// Whether this certainly is a number with a derivative.
pub fn is_float(ty: &Type) -> bool {
    matches!(ty, Type::Path(path) if path.path.is_ident("f32") || path.path.is_ident("f64"))
}

/// Whether the type is a box or a reference to one.
pub fn is_box(ty: &Type) -> bool {
    matches!(pointee(ty), Type::Path(path)
        if path.path.segments.last().is_some_and(|last| last.ident == "Box"))
}

/// Whether all tangents of the type, in which `scalars` are type parameters bounded by `Real`,
/// certainly have one size.
pub fn has_fixed_size(ty: &Type, scalars: &[Ident]) -> bool {
    match pointee(ty) {
        Type::Array(array) => has_fixed_size(&array.elem, scalars),
        Type::Tuple(tuple) => tuple.elems.iter().all(|ty| has_fixed_size(ty, scalars)),
        Type::Path(path) => {
            let is_number = |name: &Ident| name == "f32" || name == "f64" || scalars.contains(name);
            is_discrete(ty) || path.path.get_ident().is_some_and(is_number)
        }
        _ => false,
    }
}

/// Whether a type is or names `Self`.
pub fn names_self(ty: &Type) -> bool {
    let mut named = std::collections::HashSet::new();
    names::collect(quote!(#ty), &mut named);
    named.contains("Self")
}

/// The type of the elements of an array, a slice or a `Vec`.
pub fn element(ty: &Type) -> Option<&Type> {
    match ty {
        Type::Array(array) => Some(&array.elem),
        Type::Slice(slice) => Some(&slice.elem),
        Type::Path(path) => {
            let last = path.path.segments.last().filter(|last| last.ident == "Vec")?;
            let PathArguments::AngleBracketed(arguments) = &last.arguments else { return None };
            match arguments.args.first()? {
                GenericArgument::Type(ty) => Some(ty),
                _ => None,
            }
        }
        _ => None,
    }
}
