//! The types in the derivatives of a function: of parameters, result, cotangents and pullback.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::{GenericParam, Signature, Type};

use crate::parse::signature::Parameter;

/// What the functions around a derivative say of themselves.
pub struct Header {
    pub parameters: Vec<Parameter>,
    pub result: Type,
    /// Whether the result is of a type that does not tell what it is.
    pub is_hidden: bool,
    /// The type of the cotangent of the result.
    pub result_tangent: TokenStream,
    /// The types of the cotangents that the pullback takes for `&mut` parameters.
    pub exclusive_tangents: Vec<TokenStream>,
    /// For each parameter the type of its cotangent, if callers lend theirs (see [`lending`](super::lending)).
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

/// What derivatives may be without a warning.
pub fn lints() -> TokenStream {
    quote! {
        #[allow(unused, non_snake_case, refining_impl_trait, clippy::all, clippy::pedantic, clippy::nursery)]
    }
}
