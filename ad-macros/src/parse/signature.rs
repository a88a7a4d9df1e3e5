//! What a function says of itself before its body: parameters, result, generics.

use proc_macro2::{Span, TokenStream};
use quote::{format_ident, quote};
use syn::visit::{self, Visit};
use syn::{
    FnArg, GenericParam, Generics, Ident, Lifetime, Pat, Receiver, ReceiverKind, ReturnType,
    Safety, Signature, Type, TypeReference,
};

use super::callable::Callables;
use super::refused;
use crate::errors::Errors;
use crate::types::{is_constant_mark, pointee};

/// A parameter.
#[derive(Clone)]
pub struct Parameter {
    /// Its name in the generated signature.
    pub ident: Ident,
    /// The pattern the user wrote, `None` for the receiver.
    pub pattern: Option<Pat>,
    /// Its type.
    pub ty: Type,
    /// Whether it is a `&mut`: its cotangent comes in and goes out.
    pub is_exclusive: bool,
    /// Whether it is a `&`.
    pub is_shared: bool,
    /// Whether it is `mut self`.
    pub is_mutable_receiver: bool,
    /// The number of its arguments, if it is a function.
    pub arity: Option<usize>,
    /// Whether it is marked `#[constant]`: no derivative is asked for.
    pub is_constant: bool,
}

/// Whether the type is `&mut T`.
fn is_exclusive(ty: &Type) -> bool {
    match ty {
        Type::Reference(reference) => reference.mutability.is_some(),
        Type::Paren(paren) => is_exclusive(&paren.elem),
        _ => false,
    }
}

/// Whether the function has a `&mut` parameter.
fn changes_something(signature: &Signature) -> bool {
    signature.inputs.iter().any(|input| match input {
        FnArg::Receiver(receiver) => {
            matches!(receiver.kind, ReceiverKind::Reference(_, _, Some(_)))
        }
        FnArg::Typed(typed) => is_exclusive(&typed.ty),
    })
}

/// A receiver without its attributes.
pub fn bare(receiver: &Receiver) -> Receiver {
    Receiver { attrs: Vec::new(), ..receiver.clone() }
}

/// The parameters, in order. Refuses what has no derivative.
pub fn parameters(callables: &Callables, errors: &mut Errors) -> Vec<Parameter> {
    let signature = &callables.signature;
    callables.refuse(errors);
    if let Some(token) = &signature.asyncness {
        errors.at(token, "an `async fn` has no derivative: differentiate the computation apart from waiting for its input");
    }
    if let Safety::Unsafe(token) = &signature.safety {
        errors.at(token, "an `unsafe fn` cannot be differentiated: wrap it in a safe function");
    }
    if let Some(variadic) = &signature.variadic {
        errors.at(variadic, "a variadic function has no derivative: pass an array");
    }
    if signature.inputs.is_empty() {
        errors
            .at(&signature.ident, "a function without parameters has nothing to differentiate by: take the attribute off it");
    }

    let parameters = signature.inputs.iter().enumerate().map(|(index, input)| match input {
        FnArg::Receiver(receiver) => {
            if let ReceiverKind::Typed(..) = receiver.kind {
                errors.at(receiver, "write `self` or `&self`: other receivers are not supported");
            }
            let is_exclusive = matches!(receiver.kind, ReceiverKind::Reference(_, _, Some(_)));
            let is_constant = receiver.attrs.iter().any(is_constant_mark);
            Parameter {
                ident: Ident::new("self", receiver.self_token.span),
                pattern: None,
                ty: syn::parse_quote!(Self),
                is_exclusive,
                is_shared: matches!(receiver.kind, ReceiverKind::Reference(_, _, None)),
                is_mutable_receiver: matches!(receiver.kind, ReceiverKind::Value)
                    && receiver.mutability.is_some(),
                arity: None,
                is_constant,
            }
        }
        FnArg::Typed(typed) => {
            let is_exclusive = is_exclusive(&typed.ty);
            let is_constant = typed.attrs.iter().any(is_constant_mark);
            if !is_constant {
                refused::parameter(&typed.ty, errors);
            }
            let ident = match &*typed.pat {
                Pat::Ident(pat) if pat.by_ref.is_none() && pat.subpat.is_none() => {
                    pat.ident.clone()
                }
                _ => format_ident!("parameter_{index}", span = Span::mixed_site()),
            };
            let is_named = matches!(&*typed.pat, Pat::Ident(pat)
                if pat.by_ref.is_none() && pat.mutability.is_none() && pat.subpat.is_none());
            if is_exclusive && !is_named {
                errors.at(
                    &typed.pat,
                    "a `&mut` parameter needs a plain name: take it apart in the body",
                );
            }
            let arity = callables.arity(&typed.ty);
            if arity.is_some() && is_exclusive {
                errors.at(
                    &typed.ty,
                    "a function that is passed cannot be behind a `&mut`: take it by value, `mut f: F`, and let callers pass `|x| f(x)`",
                );
            }
            let mut pattern = (*typed.pat).clone();
            // An object with a derivative is called by reference, a `FnMut` too.
            if let (Pat::Ident(pat), Some(_)) = (&mut pattern, arity) {
                pat.mutability = None;
            }
            let is_shared = !is_exclusive && matches!(&*typed.ty, Type::Reference(_));
            Parameter {
                ident,
                pattern: Some(pattern),
                ty: (*typed.ty).clone(),
                is_exclusive,
                is_shared,
                is_mutable_receiver: false,
                arity,
                is_constant,
            }
        }
    });
    parameters.collect()
}

/// The type of the result. Refuses what has no derivative, and what is hidden, upon which nothing is
/// said of the body.
pub fn result(signature: &Signature, errors: &mut Errors) -> (Type, bool) {
    match &signature.output {
        ReturnType::Default if changes_something(signature) => (syn::parse_quote!(()), false),
        ReturnType::Default => {
            errors.at(
                &signature.ident,
                "a function without a result has no derivative: return what it computes, or write it through a `&mut` parameter",
            );
            (syn::parse_quote!(()), false)
        }
        ReturnType::Type(_, ty) => ((**ty).clone(), refused::result(ty, errors)),
    }
}

/// The generic parameters that a pullback may hold on to: every type and constant, and the
/// lifetimes inside parameter types. The lifetimes of references, to a parameter or in the result, are not
/// among them: pullbacks hold copies, so that a function may call another one on its own local variables.
/// They are where the pullback [borrows](crate::parse::borrowing).
pub fn captured(signature: &Signature, outer: Option<&Generics>, borrows: bool) -> Captured {
    let mut inner_lifetimes = InnerLifetimes::default();
    if let ReturnType::Type(_, ty) = &signature.output {
        inner_lifetimes.of_references = borrows;
        inner_lifetimes.visit_type(pointee(ty));
        inner_lifetimes.of_references = true;
    }
    for input in &signature.inputs {
        match input {
            FnArg::Typed(typed) if is_borrowed(&typed.ty, borrows) => {
                inner_lifetimes.visit_type(&typed.ty);
            }
            FnArg::Typed(typed) => inner_lifetimes.visit_type(pointee(&typed.ty)),
            FnArg::Receiver(receiver) => {
                if let (ReceiverKind::Reference(_, Some(own), None), true) =
                    (&receiver.kind, borrows)
                {
                    inner_lifetimes.visit_lifetime(own);
                }
            }
        }
    }
    let own = signature.generics.params.iter();
    let all = outer.into_iter().flat_map(|generics| &generics.params).map(|p| (p, true));
    let all: Vec<_> = all.chain(own.map(|p| (p, false))).collect();
    let lifetimes = all.iter().filter_map(|(parameter, outer)| match parameter {
        GenericParam::Lifetime(lifetime)
            if *outer || inner_lifetimes.found.contains(&lifetime.lifetime) =>
        {
            let lifetime = &lifetime.lifetime;
            Some(quote!(#lifetime))
        }
        _ => None,
    });
    let others = all.iter().filter_map(|(parameter, _)| match parameter {
        GenericParam::Lifetime(_) => None,
        GenericParam::Type(ty) => {
            let ident = &ty.ident;
            Some(quote!(#ident))
        }
        GenericParam::Const(constant) => {
            let ident = &constant.ident;
            Some(quote!(#ident))
        }
    });
    Captured { lifetimes: lifetimes.collect(), others: others.collect() }
}

/// Whether a pullback may hold on to what a parameter refers to.
fn is_borrowed(ty: &Type, borrows: bool) -> bool {
    borrows && matches!(ty, Type::Reference(reference) if reference.mutability.is_none())
}

/// The generic parameters that a pullback may hold on to.
pub struct Captured {
    pub lifetimes: Vec<TokenStream>,
    /// Types and constants.
    pub others: Vec<TokenStream>,
}

#[derive(Default)]
struct InnerLifetimes {
    found: Vec<Lifetime>,
    /// Whether those of references count.
    of_references: bool,
}

impl<'ast> Visit<'ast> for InnerLifetimes {
    fn visit_type_reference(&mut self, reference: &'ast TypeReference) {
        match self.of_references {
            true => visit::visit_type_reference(self, reference),
            false => self.visit_type(&reference.elem),
        }
    }

    fn visit_lifetime(&mut self, lifetime: &'ast Lifetime) {
        self.found.push(lifetime.clone());
    }
}
