//! A function to be differentiated, as those see it who write code around its derivative.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::{GenericParam, Generics, Signature, Type, Visibility};

use super::callable::Callables;
use super::options::Options;
use super::signature::Parameter;

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

/// What a function says of itself.
pub struct Header {
    pub parameters: Vec<Parameter>,
    pub result: Type,
    /// Whether the result is of a type that does not tell what it is.
    pub is_hidden: bool,
    /// The type of the cotangent of the result.
    pub result_tangent: TokenStream,
    /// The types of the cotangents that the pullback takes for `&mut` parameters.
    pub exclusive_tangents: Vec<TokenStream>,
    /// For each parameter the type of its cotangent, if callers lend theirs (see [`lending`]).
    pub lent: Vec<Option<TokenStream>>,
    /// For each parameter whether `vjp` brings its cotangent to size, and not the reverse sweep.
    pub sized_by_vjp: Vec<bool>,
    /// The type of what the pullback returns.
    pub gradient: TokenStream,
    /// Whether the pullback is a boxed closure.
    pub boxed: bool,
}

impl Header {
    /// A pullback; `lent` are the patterns of the cotangents that callers lend, if it takes such.
    pub fn pullback(
        &self,
        cotangent: &Ident,
        incoming: &[Ident],
        lent: Option<&[TokenStream]>,
        body: &TokenStream,
    ) -> TokenStream {
        let Self { result_tangent, exclusive_tangents, gradient, .. } = self;
        let lent = lent.map(|patterns| {
            let types = self.lent_types();
            quote!(, ::ad::rt::Offered((#(#patterns,)*)): #types)
        });
        let closure = quote! {
            move |#cotangent: #result_tangent #(, mut #incoming: #exclusive_tangents)* #lent| -> #gradient {
                #body
            }
        };
        match self.boxed {
            true => quote!(::std::boxed::Box::new(#closure)),
            false => closure,
        }
    }

    /// Whether callers lend cotangents.
    pub fn lends(&self) -> bool {
        self.lent.iter().any(Option::is_some)
    }

    /// Whether the sweeps stand in `vjp_onto`, which callers take, and not in `vjp`.
    pub fn is_split(&self) -> bool {
        self.sized_by_vjp.contains(&true)
    }

    /// The type of what callers lend, as a tuple with a member for each parameter.
    pub fn lent_types(&self) -> TokenStream {
        let types = self.lent.iter().map(|lent| match lent {
            Some(ty) => ty.clone(),
            None => quote!(::ad::rt::NotLent),
        });
        quote!(::ad::rt::Offered<(#(#types,)*)>)
    }
}

/// The cotangents of one parameter or of several.
pub fn tuple_or_one(parts: &[TokenStream]) -> TokenStream {
    match parts {
        [part] => part.clone(),
        parts => quote!((#(#parts),*)),
    }
}

/// A name that users cannot write.
pub fn own(name: &str) -> Ident {
    Ident::new(name, Span::mixed_site())
}

/// The type arguments of a call of the function itself. The types of the parameters need not tell
/// them: `Vec3<S>` does not tell `S`.
pub fn turbofish(signature: &Signature) -> TokenStream {
    let arguments = signature.generics.params.iter().filter_map(|parameter| match parameter {
        GenericParam::Lifetime(_) => None,
        GenericParam::Type(ty) => Some(&ty.ident),
        GenericParam::Const(constant) => Some(&constant.ident),
    });
    quote!(::<#(#arguments),*>)
}
