//! The sweeps of a loop: what an iteration saves goes on a tape, which the reverse sweep reads
//! backwards.
//!
//! A loop from which nothing is saved (see [`recompute`](crate::emit::reverse::recompute)) has no tape: the reverse
//! sweep counts down the range.

use std::collections::HashSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::neighbours::Carried;
use super::{Sides, Sweeper, Written};
use crate::ir::{Head, Loop};
use crate::names;

/// What the reverse sweep of a loop runs over.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Backwards {
    /// Nothing: no derivative flows back.
    Nothing,
    /// The range that the forward sweep ran over.
    Range,
    /// What the iterations saved.
    Tape,
    /// Both.
    RangeAndTape,
}

impl Sweeper<'_> {
    pub(super) fn a_loop(&mut self, a_loop: &Loop) -> Sides {
        let mut sides = Sides::default();
        // Only the last iteration left the loop: the others find nothing.
        let seed = a_loop.result.filter(|result| self.started.contains(result)).map(|result| {
            let cotangent = &self.vars[result].cotangent;
            quote!((::ad::rt::take(&mut #cotangent), ()))
        });
        self.loop_depth += 1;
        self.enter_loop(a_loop);
        self.counters.push(self.counter(a_loop));
        let mut body = self.block(&a_loop.body, seed);
        self.counters.pop();
        self.tapes.leave();
        self.loop_depth -= 1;
        self.leave(&mut sides.reverse, &body.outer);

        let backwards = self.backwards(a_loop, &mut body);
        let saved = body.saved();
        let tape = matches!(backwards, Backwards::Tape | Backwards::RangeAndTape)
            .then(|| self.tape(a_loop, &mut sides));
        let range = matches!(backwards, Backwards::Range | Backwards::RangeAndTape)
            .then(|| self.range(a_loop, &mut sides));
        let record = &a_loop.record;
        let push = tape.is_some().then(|| quote!(#record.push(#saved);));
        let tests = self.tests_after(a_loop);
        if self.loop_depth == 0 {
            self.nested_tapes(&mut sides);
        }
        let items = self.tapes.items.take();
        let items = items.map(|items| quote!(#items));
        let items = range.as_ref().map(|range| quote!(#range.clone())).or(items);
        sides.forward.extend(self.iterations(a_loop, &body, push, items));
        sides.forward.extend(tests);
        if let Some(result) = a_loop.result {
            sides.forward.extend(self.space_definition(result));
            sides.defines.extend(self.names_of(result));
        }

        let (reverse, Carried { before, after }) = (&body.reverse, &body.carried);
        sides.reverse.extend(match (&a_loop.head, range, tape) {
            (Head::For { pattern, .. }, Some(range), tape) => {
                let after = (!after.is_empty())
                    .then(|| quote!(if let Some(#pattern) = #range.clone().next() { #after }));
                let (pattern, items) = match tape {
                    Some(tape) => {
                        (quote!((#pattern, #saved)), quote!(#range.clone().rev().zip(#tape)))
                    }
                    None => (pattern.clone(), quote!(#range.clone().rev())),
                };
                quote!(#before for #pattern in #items { #reverse } #after)
            }
            (_, _, Some(tape)) => quote!(for #saved in #tape { #reverse }),
            (_, _, None) => TokenStream::new(),
        });
        sides
    }

    /// Finds out what the reverse sweep runs over. The variables of a loop come from its range, if
    /// that is known to the end, else they have to be saved.
    fn backwards(&self, a_loop: &Loop, body: &mut Written) -> Backwards {
        let mut named = HashSet::new();
        names::collect_variables(body.reverse.clone(), &mut named);
        // What is carried goes to the first elements in the end.
        let mut names_variable = !body.carried.after.is_empty();
        let runs_all = self.runs_all(a_loop);
        if let Head::For { defines, .. } = &a_loop.head {
            let variables = defines.iter().map(|&var| self.vars[var].ident.clone());
            let variables: Vec<_> = variables.collect();
            names_variable |= variables.iter().any(|name| named.contains(&name.to_string()));
            if !runs_all {
                body.defines.splice(0..0, variables);
            }
        }
        match body.saved_names().is_empty() {
            _ if body.reverse.is_empty() => Backwards::Nothing,
            true if runs_all => Backwards::Range,
            false if runs_all && names_variable => Backwards::RangeAndTape,
            _ => Backwards::Tape,
        }
    }

    /// Whether the loop runs over the whole of a range that can be written once more.
    pub(super) fn runs_all(&self, a_loop: &Loop) -> bool {
        !a_loop.breaks
            && matches!(&a_loop.head, Head::For { iterator, reversible: true, .. } if self.facts.is_range(iterator))
    }

    /// The loop in the forward sweep.
    fn iterations(
        &self,
        a_loop: &Loop,
        body: &Written,
        push: Option<TokenStream>,
        items: Option<TokenStream>,
    ) -> TokenStream {
        let Loop { head, natural_end, .. } = a_loop;
        let (forward, value) = (&body.forward, &body.value);
        let result = a_loop.result.map(|result| &self.vars[result].ident);
        // A body that always leaves does not tell the type of `Continue`.
        let content = quote!(::core::ops::ControlFlow::<_, ()>::Break(content));
        let exit = match (a_loop.breaks, result, head) {
            (false, ..) => None,
            (true, _, Head::Loop) => Some(quote!(if let #content = #value { break content; })),
            (true, None, _) => {
                Some(quote!(if ::core::ops::ControlFlow::<_, ()>::is_break(&#value) { break; }))
            }
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
                    Head::For { pattern, iterator, .. } => {
                        let items = items.unwrap_or_else(|| iterator.clone());
                        quote!(for #pattern in #items)
                    }
                    Head::While(condition) => quote!(while #condition),
                    Head::Loop => unreachable!("handled above"),
                };
                quote!(#result #head #iteration)
            }
        }
    }

    /// Gives the range a name, so that both sweeps run over the same integers.
    fn range(&mut self, a_loop: &Loop, sides: &mut Sides) -> Ident {
        let record = &a_loop.record;
        let range = self.names.fresh("range", record.span());
        let Head::For { iterator, .. } = &a_loop.head else {
            unreachable!("other loops have no range");
        };
        let definition = quote!(let #range = #iterator;);
        if self.facts.is_known_at_start(iterator) {
            self.top.extend(definition);
        } else {
            sides.forward.extend(definition);
            sides.defines.push(range.clone());
            self.ranges.insert(record.to_string(), range.clone());
        }
        range
    }
}
