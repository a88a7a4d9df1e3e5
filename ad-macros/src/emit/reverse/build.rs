//! The sweeps of an array or a `Vec` that is built element by element.

use quote::quote;

use super::{Sides, Sweeper};
use crate::ir::{Build, BuildSource};

impl Sweeper<'_> {
    pub(super) fn build(&mut self, build: &Build) -> Sides {
        let Build { result, source, body, record, .. } = build;
        let mut sides = Sides::default();
        let is_pulled_back = self.started.contains(result);
        let element_bar = self.names.fresh("element_bar", record.span());
        self.tapes.enter_unknown();
        let mut body = self.block(body, is_pulled_back.then(|| quote!(#element_bar)));
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
        let element = match records {
            true => quote!({ #forward (#value, #saved) }),
            false => quote!({ #forward #value }),
        };
        let definition = build.definition(self.vars, &element, records.then_some(record));
        sides.forward.extend(definition);
        sides.forward.extend(self.space_definition(*result));
        sides.defines.extend(self.names_of(*result));
        if records {
            sides.defines.push(record.clone());
            let (reverse, cotangent) = (&body.reverse, &self.vars[*result].cotangent);
            let records = match (is_pulled_back, source) {
                (true, BuildSource::Index { .. }) => {
                    quote!((#saved, #element_bar) in #record.into_iter().zip(#cotangent))
                }
                (true, BuildSource::Items { .. }) => {
                    quote!((#saved, #element_bar) in ::ad::rt::with_cotangents(#record, #cotangent))
                }
                // Only what the block changes is looked at.
                (false, _) => quote!(#saved in #record.into_iter()),
            };
            sides.reverse.extend(quote!(for #records.rev() { #reverse }));
        }
        sides
    }
}
