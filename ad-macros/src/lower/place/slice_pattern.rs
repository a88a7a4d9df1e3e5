//! Patterns of slices and arrays: `[first, .., last]`, `[head, tail @ ..]`.
//!
//! What stands behind `..` is counted from the end, so its position is known when the program runs:
//! the length of what is matched gets a name, and each such position another.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::{Pat, PatSlice};

use super::pattern::Matched;
use crate::ir::{Binding, Place, Projection, VarId};
use crate::lower::Lowerer;

impl Lowerer<'_> {
    /// The length of what is matched, if one of the patterns counts elements from its end.
    pub fn length_for<'p>(
        &mut self,
        patterns: impl IntoIterator<Item = &'p Pat>,
        matched: &TokenStream,
    ) -> Option<VarId> {
        let counts = patterns.into_iter().find(|pat| counts_from_end(pat))?;
        Some(self.define_constant("length", counts.span(), quote!((#matched).len())))
    }

    /// The elements of the pattern of a slice.
    pub(super) fn slice_pattern(
        &mut self,
        slice: &PatSlice,
        path: &[Projection],
        matched: Matched,
        bindings: &mut Vec<Binding>,
    ) -> Vec<TokenStream> {
        let count = slice.elems.len();
        let rest = slice.elems.iter().position(is_rest).unwrap_or(count);
        // An inner slice has another length.
        let whole = matched.exclusive.map_or(0, |(_, steps)| steps);
        let length = matched.length.filter(|_| path.len() == whole);
        let inner = Matched { length: None, ..matched };
        let mut elements = Vec::new();
        for (index, element) in slice.elems.iter().enumerate() {
            let from_end = count - index;
            let position = match index < rest {
                true => {
                    let index = syn::Index::from(index);
                    quote!(#index)
                }
                false if matches!(element, Pat::Rest(_)) => {
                    elements.push(element.to_token_stream());
                    continue;
                }
                false if !matched.active => quote!(0),
                false => {
                    let Some(length) = length else {
                        self.refuse(
                            element,
                            "what stands behind `..`, or is bound to it, is supported in a pattern for a whole slice only: take the inner one apart with `let`",
                        );
                        continue;
                    };
                    match index == rest {
                        true => {
                            let end = self.position(length, from_end - 1, element);
                            let start = syn::Index::from(index);
                            quote!(#start..#end)
                        }
                        false => self.position(length, from_end, element),
                    }
                }
            };
            let path = [path, &[Projection::Index(position)]].concat();
            elements.push(match (index == rest, element) {
                (true, Pat::Ident(name)) if let Some((root, _)) = matched.exclusive => {
                    let name = syn::PatIdent { subpat: None, ..name.clone() };
                    let name = self.exclusive_name(&name, Place { root, path });
                    quote!(#name @ ..)
                }
                (true, Pat::Ident(name)) => {
                    let var = self.bind(&name.ident, false, matched.active);
                    self.vars[var].reference = matched.reference || name.by_ref.is_some();
                    bindings.push(Binding::new(var, path));
                    let (by_ref, ident) = (&name.by_ref, self.ident(var));
                    quote!(#by_ref #ident @ ..)
                }
                _ => self.subpattern(element, &path, inner, bindings),
            });
        }
        elements
    }

    /// The name of a position, counted from the end. It may be there for another arm.
    fn position(&mut self, length: VarId, from_end: usize, at: &Pat) -> TokenStream {
        let length = self.ident(length);
        let position = quote!(#length.wrapping_sub(#from_end));
        self.named_tokens("position", at.span(), position)
    }
}

/// `..` or `name @ ..`
fn is_rest(pat: &Pat) -> bool {
    match pat {
        Pat::Rest(_) => true,
        Pat::Ident(name) => {
            name.subpat.as_ref().is_some_and(|(_, inner)| matches!(**inner, Pat::Rest(_)))
        }
        _ => false,
    }
}

/// Whether the pattern of a slice names what stands at `..` or behind it.
fn counts_from_end(pat: &Pat) -> bool {
    match pat {
        Pat::Slice(slice) => match slice.elems.iter().position(is_rest) {
            Some(rest) => {
                rest + 1 < slice.elems.len() || matches!(slice.elems[rest], Pat::Ident(_))
            }
            None => false,
        },
        Pat::Paren(inner) => counts_from_end(&inner.pat),
        Pat::Reference(inner) => counts_from_end(&inner.pat),
        Pat::Guard(guarded) => counts_from_end(&guarded.pat),
        Pat::Or(or) => or.cases.iter().any(counts_from_end),
        _ => false,
    }
}
