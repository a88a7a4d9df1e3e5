//! Parameters that are functions: `f: F` with `F: Fn(f64) -> f64`, or `f: impl Fn(f64) -> f64`.
//!
//! The function keeps the signature that the user wrote. Its derivative asks for
//! `F: DifferentiableFn<(Value<f64>,), Output = f64>` instead, its forward mode for `F: ForwardFn<..>`
//! (see `ad::function`).

use std::collections::BTreeMap;

use proc_macro2::{Span, TokenStream};
use quote::{format_ident, quote};
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{
    FnArg, GenericParam, Ident, Pat, Path, PathArguments, ReturnType, Signature, Token, Type,
    TypeParamBound, WherePredicate, parse_quote, parse_quote_spanned,
};

use crate::errors::Errors;
use crate::types::{is_constant_mark, pointee};

/// The largest number of arguments of a function that is passed.
pub const MOST_ARGUMENTS: usize = 4;

/// The signature of a derivative.
pub struct Callables {
    /// The signature, with the bounds of functions replaced, and a type parameter for each
    /// `impl Trait`.
    pub signature: Signature,
    /// The same for forward mode.
    pub forward: Signature,
    /// The types of the arguments of functions, by the names of their types.
    arguments: BTreeMap<Ident, Vec<Type>>,
    /// The numbers of arguments of functions, by the names of their types.
    arities: BTreeMap<Ident, usize>,
    /// What cannot be differentiated.
    refused: Vec<syn::Error>,
}

impl Callables {
    /// Looks for functions among the parameters.
    pub fn new(signature: &Signature) -> Self {
        let mut callables = Self {
            signature: signature.clone(),
            forward: signature.clone(),
            arguments: BTreeMap::new(),
            arities: BTreeMap::new(),
            refused: Vec::new(),
        };
        let mut signature = signature.clone();
        name_impl_traits(&mut signature);
        for parameter in &mut signature.generics.params {
            if let GenericParam::Type(parameter) = parameter {
                callables.bounds(Some(&parameter.ident), &mut parameter.bounds);
            }
        }
        for predicate in signature.generics.where_clause.iter_mut().flat_map(|c| &mut c.predicates)
        {
            if let WherePredicate::Type(predicate) = predicate {
                let name = type_name(&predicate.bounded_ty).cloned();
                callables.bounds(name.as_ref(), &mut predicate.bounds);
            }
        }
        callables.forward = signature.clone();
        Forward.visit_signature_mut(&mut callables.forward);
        callables.signature = signature;
        callables
    }

    /// The types of the arguments of a parameter of this type, if it is a function that is passed.
    pub fn arguments(&self, ty: &Type) -> Option<&[Type]> {
        self.arguments.get(type_name(pointee(ty))?).map(Vec::as_slice)
    }

    /// The number of arguments of a parameter of this type, if it is a function.
    pub fn arity(&self, ty: &Type) -> Option<usize> {
        match pointee(ty) {
            Type::FnPtr(pointer) => Some(pointer.inputs.len()),
            Type::TraitObject(object) => object.bounds.iter().find_map(|bound| match bound {
                TypeParamBound::Trait(bound) => match &bound.path.segments.last()?.arguments {
                    PathArguments::Parenthesized(arguments) => Some(arguments.inputs.len()),
                    _ => None,
                },
                _ => None,
            }),
            ty => self.arities.get(type_name(ty)?).copied(),
        }
    }

    /// Whether there are functions among the parameters.
    pub fn any(&self) -> bool {
        !self.arities.is_empty()
    }

    /// The types of the functions.
    pub fn types(&self) -> impl Iterator<Item = &Ident> {
        self.arities.keys()
    }

    /// Reports what cannot be differentiated.
    pub fn refuse(&self, errors: &mut Errors) {
        self.refused.iter().for_each(|error| errors.add(error.clone()));
    }

    fn bounds(&mut self, name: Option<&Ident>, bounds: &mut Punctuated<TypeParamBound, Token![+]>) {
        for bound in bounds {
            let TypeParamBound::Trait(function) = bound else { continue };
            let Some(kind) = function_trait(&function.path) else { continue };
            let Some(last) = function.path.segments.last() else { continue };
            let PathArguments::Parenthesized(arguments) = &last.arguments else { continue };
            self.arities.extend(name.map(|name| (name.clone(), arguments.inputs.len())));
            // A closure that changes what it captures is refused where it is passed.
            if !matches!(&*kind, "Fn" | "FnMut" | "FnOnce") {
                self.refused.push(syn::Error::new_spanned(
                    &function.path,
                    format!("this function has no derivative here: write `Fn` instead of `{kind}`"),
                ));
                continue;
            }
            if arguments.inputs.len() > MOST_ARGUMENTS {
                self.refused.push(syn::Error::new_spanned(
                    &function.path,
                    format!("functions of up to {MOST_ARGUMENTS} arguments can be passed: put some into a tuple or a struct"),
                ));
                continue;
            }
            let types = arguments.inputs.iter().map(|input| input.ty.clone()).collect();
            self.arguments.extend(name.map(|name| (name.clone(), types)));
            let parameters: Vec<_> =
                arguments.inputs.iter().map(|i| self.parameter(&i.ty)).collect();
            let output = match &arguments.output {
                ReturnType::Default => quote!(()),
                ReturnType::Type(_, ty) => quote!(#ty),
            };
            let span = function.path.span();
            *bound = parse_quote_spanned! {span=>
                ::ad::DifferentiableFn<(#(#parameters,)*), Output = #output>
            };
        }
    }

    /// How a parameter of a function is passed.
    fn parameter(&mut self, ty: &Type) -> TokenStream {
        match ty {
            Type::Reference(reference) if reference.mutability.is_some() => {
                self.refused.push(syn::Error::new_spanned(
                    ty,
                    "a function that is passed cannot take a `&mut`: let it return what it computes",
                ));
                quote!(::ad::function::Value<()>)
            }
            Type::Reference(reference) => {
                let target = &reference.elem;
                quote!(::ad::function::Reference<#target>)
            }
            ty => quote!(::ad::function::Value<#ty>),
        }
    }
}

/// Puts the bounds of forward mode in place of those of reverse mode.
struct Forward;

impl VisitMut for Forward {
    fn visit_path_mut(&mut self, path: &mut Path) {
        let is_own = path.segments.first().is_some_and(|first| first.ident == "ad");
        if let Some(last) = path.segments.last_mut()
            && is_own
            && last.ident == "DifferentiableFn"
        {
            last.ident = Ident::new("ForwardFn", last.ident.span());
        }
        visit_mut::visit_path_mut(self, path);
    }
}

/// `Fn`, `FnMut`, `FnOnce`
fn function_trait(path: &Path) -> Option<String> {
    let last = path.segments.last()?;
    let is_function = matches!(last.arguments, PathArguments::Parenthesized(_));
    is_function.then(|| last.ident.to_string())
}

fn type_name(ty: &Type) -> Option<&Ident> {
    match ty {
        Type::Path(path) if path.qself.is_none() => path.path.get_ident(),
        Type::Paren(inner) => type_name(&inner.elem),
        _ => None,
    }
}

/// The name of the type of a parameter, which messages of the compiler show: `TypeOfCurve0` of `curve`.
fn type_of(pat: &Pat, index: usize, span: Span) -> Ident {
    let name = match pat {
        Pat::Ident(name) => name.ident.to_string(),
        _ => String::new(),
    };
    let words = name.trim_start_matches("r#").split('_').map(|word| {
        let mut letters = word.chars();
        letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect::<String>()
    });
    let words: String = words.collect();
    format_ident!("TypeOf{words}{index}", span = span)
}

/// Gives names to the types of `impl Trait` parameters: a derivative names their tangents.
fn name_impl_traits(signature: &mut Signature) {
    let mut named: Vec<GenericParam> = Vec::new();
    for (index, input) in signature.inputs.iter_mut().enumerate() {
        let FnArg::Typed(typed) = input else { continue };
        let mut ty = &mut *typed.ty;
        while let Type::Reference(reference) = ty {
            ty = &mut reference.elem;
        }
        if let Type::ImplTrait(anonymous) = ty {
            let name = type_of(&typed.pat, index, anonymous.span());
            let bounds = &anonymous.bounds;
            // Users cannot ask for it of a type without a name.
            let is_function = |bound: &TypeParamBound| matches!(bound, TypeParamBound::Trait(bound) if function_trait(&bound.path).is_some());
            let is_constant = typed.attrs.iter().any(is_constant_mark);
            let differentiable = match is_constant || bounds.iter().any(is_function) {
                true => None,
                false => Some(quote!(+ ::ad::Differentiable)),
            };
            named.push(parse_quote!(#name: #bounds #differentiable));
            *ty = parse_quote!(#name);
        }
    }
    signature.generics.params.extend(named);
}
