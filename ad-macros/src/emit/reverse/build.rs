//! The sweeps of an array or a `Vec` that is built element by element.

use quote::quote;

use super::{Sides, Sweeper};
use crate::ir::{Build, BuildSource};

impl Sweeper<'_> {
    pub(super) fn build(&mut self, build: &Build) -> Sides {
        let Build { result, source, ty, body, record } = build;
        let mut sides = Sides::default();
        let is_pulled_back = self.started.contains(result);
        let element = self.names.fresh("element_bar", record.span());
        self.tapes.enter_unknown();
        let mut body = self.block(body, is_pulled_back.then(|| quote!(#element)));
        self.tapes.leave();
        self.leave(&mut sides.reverse, &body.outer);
        let variables = match source {
            BuildSource::Index { index, .. } => std::slice::from_ref(index),
            BuildSource::Items { defines, .. } => defines,
        };
        let variables = variables.iter().map(|&var| self.vars[var].ident.clone());
        body.defines.splice(0..0, variables);

        let records = !body.reverse.is_empty();
        let (forward, value, saved) = (&body.forward, &body.value, body.saved());
        let element_and_record = match records {
            true => quote!({ #forward (#value, #saved) }),
            false => quote!({ #forward #value }),
        };
        let built = match (source, records) {
            (BuildSource::Index { index, like }, records) => {
                let index = &self.vars[*index].ident;
                let function = quote!(|#index: usize| #element_and_record);
                match (like, records) {
                    (Some(like), true) => quote!(::ad::rt::record_like(&#like, #function)),
                    (Some(like), false) => quote!(::ad::rt::build_like(&#like, #function)),
                    (None, true) => quote!(::ad::rt::record(#function)),
                    (None, false) => quote!(::core::array::from_fn(#function)),
                }
            }
            (BuildSource::Items { pattern, iterator, .. }, true) => {
                quote!((#iterator).map(|#pattern| #element_and_record).unzip())
            }
            (BuildSource::Items { pattern, iterator, .. }, false) => {
                quote!((#iterator).map(|#pattern| #element_and_record).collect())
            }
        };
        let ident = self.vars[*result].ident.clone();
        let ty = match (ty, source) {
            (Some(ty), _) => Some(quote!(#ty)),
            (None, BuildSource::Items { .. }) => Some(quote!(::std::vec::Vec<_>)),
            (None, BuildSource::Index { .. }) => None,
        };
        let (pattern, ty) = match (records, source) {
            (true, BuildSource::Items { .. }) => {
                (quote!((#ident, #record)), Some(quote!((#ty, ::std::vec::Vec<_>))))
            }
            (true, BuildSource::Index { .. }) => {
                (quote!((#ident, #record)), ty.map(|ty| quote!((#ty, _))))
            }
            (false, _) => (quote!(#ident), ty),
        };
        let ty = ty.map(|ty| quote!(: #ty));
        sides.forward.extend(quote!(let #pattern #ty = #built;));
        sides.forward.extend(self.space_definition(*result));
        sides.defines.extend(self.names_of(*result));
        if records {
            sides.defines.push(record.clone());
            let (reverse, cotangent) = (&body.reverse, &self.vars[*result].cotangent);
            let records = match (is_pulled_back, source) {
                (true, BuildSource::Index { .. }) => {
                    quote!((#saved, #element) in #record.into_iter().zip(#cotangent))
                }
                (true, BuildSource::Items { .. }) => {
                    quote!((#saved, #element) in ::ad::rt::with_cotangents(#record, #cotangent))
                }
                // Only what the block changes is looked at.
                (false, _) => quote!(#saved in #record.into_iter()),
            };
            sides.reverse.extend(quote!(for #records.rev() { #reverse }));
        }
        sides
    }
}
