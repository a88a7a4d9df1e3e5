//! What a call calls, and where its derivatives stand.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote};

use crate::rules;

/// A function or a method that is called.
#[derive(Clone)]
pub struct Callee {
    /// What stands before the parenthesis, for a method behind the receiver.
    pub primal: TokenStream,
    /// Its derivative.
    pub derivative: Derivative,
    /// Whether it is a method, whose receiver is the first argument.
    pub is_method: bool,
    /// Whether it may be a method of numbers, vectors or sequences, whose rule is in `ad`.
    pub may_have_rule: bool,
}

impl Callee {
    /// A function of `ad` with a twin.
    pub fn of_ad(path: TokenStream) -> Self {
        Self {
            derivative: Derivative::Twin {
                ty: path.clone(),
                turbofish: None,
                is_of_attribute: false,
            },
            primal: path,
            is_method: false,
            may_have_rule: false,
        }
    }

    /// A method.
    pub fn method(name: &Ident, turbofish: Option<TokenStream>) -> Self {
        Self {
            primal: quote!(#name #turbofish),
            derivative: Derivative::Sibling {
                owner: TokenStream::new(),
                name: name.clone(),
                turbofish,
            },
            is_method: true,
            may_have_rule: rules::is_method(&name.to_string()),
        }
    }

    /// The name of a method or of an associated function.
    pub fn name(&self) -> Option<&Ident> {
        match &self.derivative {
            Derivative::Sibling { name, .. } => Some(name),
            Derivative::Twin { .. } => None,
        }
    }

    /// The name of a method.
    pub fn method_name(&self) -> Option<&Ident> {
        match &self.derivative {
            Derivative::Sibling { name, .. } if self.is_method => Some(name),
            _ => None,
        }
    }
}

/// The derivatives of a function, in all modes.
#[derive(Clone)]
pub enum Derivative {
    /// Those of a type that bears the name of the function: `f::vjp`.
    Twin {
        /// The type.
        ty: TokenStream,
        /// The type arguments of the function.
        turbofish: Option<TokenStream>,
        /// Whether it was written by the attribute, or has the form of one that was.
        is_of_attribute: bool,
    },
    /// Functions or methods beside it: `Type::f_vjp`.
    Sibling {
        /// What stands before the name.
        owner: TokenStream,
        /// The name of the function.
        name: Ident,
        /// The type arguments of the function.
        turbofish: Option<TokenStream>,
    },
}

impl Derivative {
    /// The function for value and pullback.
    pub fn vjp(&self) -> TokenStream {
        self.in_mode("vjp")
    }

    /// The function of forward mode.
    pub fn jvp(&self) -> TokenStream {
        self.in_mode("jvp")
    }

    /// The function for value and a pullback that accumulates in place, if there is one.
    pub fn vjp_onto(&self) -> Option<TokenStream> {
        match self {
            Self::Twin { is_of_attribute: true, .. } => Some(self.in_mode("vjp_onto")),
            _ => None,
        }
    }

    /// The function that tells the path of the function that was differentiated.
    pub fn path(&self) -> Option<TokenStream> {
        match self {
            Self::Twin { ty, is_of_attribute: true, .. } => {
                let named = Ident::new("named", last_span(ty));
                Some(quote!(#ty::#named))
            }
            _ => None,
        }
    }

    fn in_mode(&self, mode: &str) -> TokenStream {
        match self {
            Self::Twin { ty, turbofish, .. } => {
                // What is missing there is missing at the name of the function.
                let mode = Ident::new(mode, last_span(ty));
                quote!(#ty::#mode #turbofish)
            }
            Self::Sibling { owner, name, turbofish } => {
                let name = format_ident!("{name}_{mode}", span = name.span());
                quote!(#owner #name #turbofish)
            }
        }
    }
}

fn last_span(tokens: &TokenStream) -> Span {
    tokens.to_token_stream().into_iter().last().map_or_else(Span::call_site, |token| token.span())
}
