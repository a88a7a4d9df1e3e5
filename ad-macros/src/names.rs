//! Names for generated variables: readable, and each used once.

use std::collections::HashSet;

use proc_macro2::{Ident, Span, TokenStream, TokenTree};

/// Every name that is taken.
pub struct Names(HashSet<String>);

impl Names {
    /// Takes every name that occurs in `tokens`.
    pub fn new(tokens: TokenStream) -> Self {
        let mut taken = HashSet::new();
        collect(tokens, &mut taken);
        Self(taken)
    }

    /// A name that starts with `base`. It cannot be confused with anything of the user's: it is
    /// unique in the function, and its hygiene hides it from the surroundings. Errors that the
    /// compiler finds in what it names point to `span`.
    pub fn fresh(&mut self, base: &str, span: Span) -> Ident {
        // Without its prefix a raw name may be a keyword.
        let (base, is_raw) = match base.strip_prefix("r#") {
            Some(base) => (base, true),
            None => (base, false),
        };
        let mut name = if is_raw { format!("{base}_0") } else { base.to_owned() };
        let mut count = 1;
        while !self.0.insert(name.clone()) {
            name = format!("{base}_{count}");
            count += 1;
        }
        Ident::new(&name, Span::mixed_site().located_at(span))
    }
}

/// Collects the identifiers in `tokens`.
pub fn collect(tokens: TokenStream, into: &mut HashSet<String>) {
    for token in tokens {
        match token {
            TokenTree::Ident(ident) => {
                into.insert(ident.to_string());
            }
            TokenTree::Group(group) => collect(group.stream(), into),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}
