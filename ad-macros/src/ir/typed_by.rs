//! Where a closure gets the types of its parameters from: the function that it is passed to has another
//! for each of its own parameters, which tells (`f::argument_0`, which `emit::passing` writes).

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use syn::spanned::Spanned;

/// A parameter of a function that is called.
#[derive(Clone)]
pub struct TypedBy {
    /// The path of the function, or what a method is called on.
    pub function: TokenStream,
    /// The name of the method.
    pub method: Option<Ident>,
    /// The number of the parameter.
    pub index: usize,
}

impl TypedBy {
    /// What makes an object of a closure for reverse mode, as it stands before the parenthesis.
    pub fn reverse(&self) -> TokenStream {
        self.made_by("")
    }

    /// The same for forward mode.
    pub fn forward(&self) -> TokenStream {
        self.made_by("_forward")
    }

    fn made_by(&self, mode: &str) -> TokenStream {
        let Self { function, method, index } = self;
        let mut name = argument(method.as_ref(), *index, mode);
        match method {
            // What is missing there is missing at the name of the method, or of the function.
            Some(method) => {
                name.set_span(name.span().located_at(method.span()));
                quote!(#function.#name)
            }
            None => {
                name.set_span(function.span());
                quote!(#function::#name)
            }
        }
    }

    /// The path of the function that passes what is referred to, or the reference itself.
    pub fn pass(&self) -> TokenStream {
        let Self { function, index, .. } = self;
        let name = format_ident!("passed_{index}", span = function.span());
        quote!(#function::#name)
    }
}

/// The name of what makes an object of a closure: beside a free function, or beside a method.
pub fn argument(method: Option<&Ident>, index: usize, mode: &str) -> Ident {
    match method {
        Some(method) => format_ident!("{method}_argument_{index}{mode}"),
        None => format_ident!("argument_{index}{mode}"),
    }
}
