//! The sweeps of a loop: what an iteration saves goes on a tape, which the reverse sweep reads
//! backwards.

use proc_macro2::TokenStream;
use quote::quote;

use super::{Sides, Sweeper, Written};
use crate::ir::{Head, Loop};

/// Up to this number of iterations, what a loop saves is kept on the stack.
const LONGEST_ARRAY_TAPE: usize = 64;

impl Sweeper<'_> {
    pub(super) fn a_loop(&mut self, a_loop: &Loop) -> Sides {
        let mut sides = Sides::default();
        let result = a_loop.result.map(|result| &self.vars[result]);
        // Only the last iteration left the loop: the others find nothing.
        let seed = a_loop.result.filter(|result| self.started.contains(result)).map(|result| {
            let cotangent = &self.vars[result].cotangent;
            quote!((::ad::rt::take(&mut #cotangent), ()))
        });
        let mut body = self.block(&a_loop.body, seed);
        self.leave(&mut sides.reverse, &body.outer);
        if let Head::For { defines, .. } = &a_loop.head {
            let defined = defines.iter().map(|&var| self.vars[var].ident.clone());
            body.defines.splice(0..0, defined);
        }

        let record = &a_loop.record;
        let records = !body.reverse.is_empty();
        if records {
            let tape = new_tape(&a_loop.head);
            sides.forward.extend(quote!(let mut #record = #tape;));
        }
        sides.forward.extend(self.iterations(a_loop, &body));
        if let Some(result) = a_loop.result {
            sides.forward.extend(self.space_definition(result));
        }
        sides.defines.extend(result.into_iter().flat_map(|v| [v.ident.clone(), v.space.clone()]));
        if records {
            sides.defines.push(record.clone());
            let (saved, reverse) = (body.saved(), &body.reverse);
            sides.reverse.extend(quote!(for #saved in #record.into_iter().rev() { #reverse }));
        }
        sides
    }

    /// The loop in the forward sweep.
    fn iterations(&self, a_loop: &Loop, body: &Written) -> TokenStream {
        let Loop { head, record, natural_end, .. } = a_loop;
        let (forward, value, saved) = (&body.forward, &body.value, body.saved());
        let push = (!body.reverse.is_empty()).then(|| quote!(#record.push(#saved);));
        let result = a_loop.result.map(|result| &self.vars[result].ident);
        // A body that always leaves does not tell the type of `Continue`.
        let content = quote!(::core::ops::ControlFlow::<_, ()>::Break(content));
        let exit = match (a_loop.breaks, result, head) {
            (false, ..) => None,
            (true, _, Head::Loop) => Some(quote!(if let #content = #value { break content; })),
            (true, None, _) => Some(quote!(if #value.is_break() { break; })),
            (true, Some(result), _) => {
                Some(quote!(if let #content = #value { #result = content; break; }))
            }
        };
        let iteration = quote!({ #forward #push #exit });
        match (head, result) {
            (Head::Loop, Some(result)) => quote!(let #result = loop #iteration;),
            (Head::Loop, None) => quote!(loop #iteration),
            (head, result) => {
                let result = result.map(|result| quote!(let mut #result = #natural_end;));
                let head = match head {
                    Head::For { pattern, iterator, .. } => quote!(for #pattern in #iterator),
                    Head::While(condition) => quote!(while #condition),
                    Head::Loop => unreachable!("handled above"),
                };
                quote!(#result #head #iteration)
            }
        }
    }
}

fn new_tape(head: &Head) -> TokenStream {
    match head {
        Head::For { trip_count: Some(count), .. } if *count <= LONGEST_ARRAY_TAPE => {
            quote!(::ad::rt::ArrayTape::<_, #count>::new())
        }
        _ => quote!(::std::vec::Vec::new()),
    }
}
