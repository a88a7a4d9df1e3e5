//! What a function calls, so that the compiler says in words which of it has no derivative.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::argument;
use crate::names::Names;

/// The functions and methods that are called.
#[derive(Default)]
pub struct Called {
    twins: Vec<Twin>,
    /// Methods, and which of their arguments are functions.
    methods: BTreeMap<Ident, BTreeSet<usize>>,
}

/// The type that has the derivatives of a function.
struct Twin {
    /// The path of the function.
    path: TokenStream,
    /// The name of the type in generated code.
    alias: Ident,
    /// What the type is if none has the name of the function.
    otherwise: TokenStream,
}

/// Whether a function of this name may be one of glam that makes a vector, or `drop`. Where no other
/// derivative has the name, that of this function is taken.
pub fn may_be_known(name: &str) -> bool {
    ["vec2", "vec3", "vec4", "dvec2", "dvec3", "dvec4", "drop"].contains(&name)
}

/// The type for a function without a type of its own.
fn otherwise(name: &str) -> TokenStream {
    if may_be_known(name) {
        let function = format_ident!("{name}");
        return quote!(::ad::rules::#function);
    }
    quote!(::ad::rt::FunctionWithoutDerivative)
}

/// The rule of a method that may be a swizzle of glam's vectors: its name consists of names of elements.
fn swizzle(method: &Ident) -> Option<TokenStream> {
    let name = method.to_string();
    let elements: Vec<_> =
        name.chars().map(|element| "xyzw".find(element)).collect::<Option<_>>()?;
    let (2..=4, Some(last)) = (elements.len(), elements.iter().max()) else { return None };
    let [rules, vjp, jvp] = ["of_vectors", "vjp", "jvp"].map(|of| format_ident!("{name}_{of}"));
    let made = format_ident!("V{}", elements.len());
    let elements = name.chars().map(|element| format_ident!("{element}"));
    let size = Literal::usize_unsuffixed(1 + (*last).max(1));
    Some(quote!(::ad::swizzle!(#rules #vjp #jvp #made (#(#elements)*) #size);))
}

impl Called {
    /// The name in generated code of the type that has the derivatives of the function at `path`,
    /// whose last name is `name`.
    pub fn twin(&mut self, path: TokenStream, name: &Ident, names: &mut Names) -> TokenStream {
        let is_known = |known: &&Twin| known.path.to_string() == path.to_string();
        let mut alias = match self.twins.iter().find(is_known) {
            Some(known) => known.alias.clone(),
            None => {
                let plain = name.to_string();
                let plain = plain.trim_start_matches("r#");
                let alias = names.unwritten(&format!("{plain}_derivative"));
                self.twins.push(Twin { path, alias: alias.clone(), otherwise: otherwise(plain) });
                alias
            }
        };
        // What is missing there is missing at the name of the function.
        alias.set_span(alias.span().located_at(name.span()));
        alias.to_token_stream()
    }

    /// Notes a method, or a function of a type, whose derivative stands beside it, and which of its
    /// arguments are functions.
    pub fn method(&mut self, name: &Ident, functions: impl IntoIterator<Item = usize>) {
        self.methods.entry(name.clone()).or_default().extend(functions);
    }

    /// What yields to the derivatives that are there. An import takes whatever has a name, a function
    /// or a type; for a function without derivative the type comes from a module. For a method without
    /// derivative there is a trait, which nothing satisfies. Its methods take `&mut self`: `&mut T` is
    /// invariant in `T`, so that `T` is the type of the receiver to the letter, lifetimes included, where that
    /// is a reference; else the compiler does not take it for the type that lacks the trait, and leaves out
    /// what the trait says about that.
    pub fn stand_ins(&self) -> TokenStream {
        let methods = self.methods.iter().map(|(name, functions)| {
            let modes = ["vjp", "jvp"].map(|mode| format_ident!("{name}_{mode}"));
            let passing = functions.iter().flat_map(|&index| {
                ["", "_forward"].map(|mode| argument(Some(name), index, mode))
            });
            let called = modes.into_iter().chain(passing);
            let derivatives = format_ident!("{name}_derivatives");
            let swizzle = swizzle(name);
            quote! {
                #swizzle
                trait #derivatives {
                    #(fn #called(&mut self) {})*
                }
                impl<T: ?::core::marker::Sized + ::ad::rt::MethodWithDerivative> #derivatives for T {}
            }
        });
        let functions = (!self.twins.is_empty()).then(|| {
            let imports =
                self.twins.iter().map(|Twin { path, alias, .. }| quote!(use #path as #alias;));
            let types = self
                .twins
                .iter()
                .map(|Twin { alias, otherwise, .. }| quote!(pub type #alias = #otherwise;));
            quote! {
                #(#imports)*
                mod without_derivative {
                    #(#types)*
                }
                use without_derivative::*;
            }
        });
        quote!(#(#methods)* #functions)
    }
}
