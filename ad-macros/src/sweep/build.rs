//! The sweeps of an array that is built element by element.

use quote::quote;

use super::{Sides, Sweeper};
use crate::ir::Build;

impl Sweeper<'_> {
    pub(super) fn build(&mut self, build: &Build) -> Sides {
        let Build { result, index, like, ty, body, record } = build;
        let mut sides = Sides::default();
        let is_pulled_back = self.started.contains(result);
        let element = self.names.fresh("element_bar", record.span());
        let mut body = self.block(body, is_pulled_back.then(|| quote!(#element)));
        self.leave(&mut sides.reverse, &body.outer);
        let index = self.vars[*index].ident.clone();
        body.defines.insert(0, index.clone());

        let records = !body.reverse.is_empty();
        let (forward, value, saved) = (&body.forward, &body.value, body.saved());
        let function = match records {
            true => quote!(|#index: usize| { #forward (#value, #saved) }),
            false => quote!(|#index: usize| { #forward #value }),
        };
        let built = match (like, records) {
            (Some(like), true) => quote!(::ad::rt::record_like(&#like, #function)),
            (Some(like), false) => quote!(::ad::rt::build_like(&#like, #function)),
            (None, true) => quote!(::ad::rt::record(#function)),
            (None, false) => quote!(::core::array::from_fn(#function)),
        };
        let ident = self.vars[*result].ident.clone();
        sides.forward.extend(match (records, ty) {
            (true, Some(ty)) => quote!(let (#ident, #record): (#ty, _) = #built;),
            (true, None) => quote!(let (#ident, #record) = #built;),
            (false, Some(ty)) => quote!(let #ident: #ty = #built;),
            (false, None) => quote!(let #ident = #built;),
        });
        sides.forward.extend(self.space_definition(*result));
        sides.defines.extend([ident, self.vars[*result].space.clone()]);
        if records {
            sides.defines.push(record.clone());
            let reverse = &body.reverse;
            sides.reverse.extend(match is_pulled_back {
                true => {
                    let cotangent = &self.vars[*result].cotangent;
                    quote!(for (#saved, #element) in #record.into_iter().zip(#cotangent).rev() {
                        #reverse
                    })
                }
                // Only what the function changes is looked at.
                false => quote!(for #saved in #record.into_iter().rev() { #reverse }),
            });
        }
        sides
    }
}
