//! A function to be differentiated, as those see it who write code around its derivative.

use proc_macro2::Ident;
use syn::{Generics, Signature, Type, Visibility};

use super::callable::Callables;
use super::options::Options;

/// Where a function stands.
#[derive(Clone, Copy)]
pub enum Place<'a> {
    /// Outside of an `impl`: the derivative is the associated function `vjp` of a type that has the
    /// function's name.
    Free,
    /// In an `impl` with these generics: the derivative is the sibling `name_vjp`.
    Impl(&'a Generics),
    /// In a trait with these generics.
    Trait(&'a Generics),
    /// In an `impl` of a trait with these generics, for this type.
    TraitImpl(&'a Generics, &'a Type),
}

/// A function to be differentiated.
pub struct Function<'a> {
    pub place: Place<'a>,
    pub visibility: &'a Visibility,
    pub signature: &'a Signature,
    /// The signature for the derivative, which is the same but for functions among the parameters.
    pub callables: &'a Callables,
    /// The methods of its block that take `&mut self`.
    pub exclusive_methods: &'a [Ident],
    /// `None` for a method that a trait requires.
    pub body: Option<&'a syn::Block>,
    pub options: Options,
}
