//! Where what loops save is kept.
//!
//! A loop has a tape on the stack if its trip count is a small literal, else one on the heap, with
//! room for all iterations where their number is known before the first. A loop within a loop
//! pushes on one tape for all of its runs, and keeps the place where a run began: a tape for each
//! run would be an allocation for each. Its tape is made before the outermost loop begins, and has
//! room for all runs if those of each loop on the way are known there.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::{Sides, Sweeper};
use crate::ir::{BlockId, Head, Loop, VarId};

/// Up to this number of iterations, what a loop saves is kept on the stack.
const LONGEST_ARRAY_TAPE: usize = 64;

/// See the module.
#[derive(Default)]
pub(super) struct Tapes {
    /// From the outermost loop to the block being written.
    runs: Vec<Runs>,
    /// The tapes that are to be made before the outermost loop, and how.
    nested: Vec<(Ident, TokenStream)>,
    /// The iterator of the loop being written, if that has a name.
    pub(super) items: Option<Ident>,
    /// The blocks around the outermost loop.
    outside: Vec<BlockId>,
}

/// How often a block runs within the one around it.
struct Runs {
    /// The number, if it can be computed before the outermost loop.
    exactly: Option<TokenStream>,
    /// The largest number, where it is a literal.
    at_most: Option<usize>,
}

impl Tapes {
    /// A block begins that may be left out.
    pub(super) fn enter_sometimes(&mut self) {
        self.runs.push(Runs { exactly: None, at_most: Some(1) });
    }

    /// A block begins that runs nobody knows how often.
    pub(super) fn enter_unknown(&mut self) {
        self.runs.push(Runs { exactly: None, at_most: None });
    }

    /// The block ends.
    pub(super) fn leave(&mut self) {
        self.runs.pop();
    }

    /// The expression of a tape for what a block saves that runs so often within the one being
    /// written.
    fn nested(&self, own: Runs) -> TokenStream {
        let runs = || self.runs.iter().chain([&own]);
        let at_most: Option<usize> = runs().map(|runs| runs.at_most).product();
        if let Some(count) = at_most.filter(|&count| count <= LONGEST_ARRAY_TAPE) {
            return quote!(::ad::rt::ArrayTape::<_, #count>::new());
        }
        let exactly: Option<Vec<_>> = runs().map(|runs| runs.exactly.as_ref()).collect();
        match exactly {
            Some(counts) => quote!(::ad::rt::nested_tape([#(#counts),*])),
            None => quote!(::std::vec::Vec::new()),
        }
    }
}

impl Sweeper<'_> {
    /// The body of a loop begins.
    pub(super) fn enter_loop(&mut self, a_loop: &Loop) {
        if self.loop_depth == 1 {
            self.tapes.outside = self.frames.iter().map(|frame| frame.block).collect();
        }
        let runs = self.runs(a_loop);
        self.tapes.runs.push(runs);
    }

    /// How often the body of a loop runs.
    fn runs(&self, a_loop: &Loop) -> Runs {
        let Head::For { iterator, trip_count, .. } = &a_loop.head else {
            return Runs { exactly: None, at_most: None };
        };
        let is_outside = |var: VarId| {
            let var = &self.vars[var];
            !var.mutable && self.tapes.outside.contains(&var.block)
        };
        let is_known =
            self.runs_all(a_loop) && self.facts.uses(iterator).into_iter().all(is_outside);
        let exactly = is_known.then(|| quote!(::ad::rt::iterations(&(#iterator))));
        Runs { exactly, at_most: *trip_count }
    }

    /// Makes a tape; returns what it holds, last to first.
    pub(super) fn tape(&mut self, a_loop: &Loop, sides: &mut Sides) -> TokenStream {
        let record = &a_loop.record;
        if self.loop_depth > 0 {
            let tape = self.tapes.nested(self.runs(a_loop));
            self.tapes.nested.push((record.clone(), tape));
            let start = self.names.fresh(&format!("{record}_start"), record.span());
            sides.forward.extend(quote!(let #start = #record.len();));
            sides.defines.push(start.clone());
            return quote!(#record.drain(#start..).rev());
        }
        let tape = match &a_loop.head {
            Head::For { trip_count: Some(count), .. } if *count <= LONGEST_ARRAY_TAPE => {
                quote!(::ad::rt::ArrayTape::<_, #count>::new())
            }
            Head::For { iterator, .. } if self.runs_all(a_loop) => {
                quote!(::ad::rt::tape(&(#iterator)))
            }
            Head::For { .. } if !a_loop.breaks => {
                let items = self.items(a_loop, sides);
                quote!(::ad::rt::tape(&#items))
            }
            _ => quote!(::std::vec::Vec::new()),
        };
        sides.forward.extend(quote!(let mut #record = #tape;));
        sides.defines.push(record.clone());
        quote!(#record.into_iter().rev())
    }

    /// Names the iterator of a loop, which then tells how many items are left.
    fn items(&mut self, a_loop: &Loop, sides: &mut Sides) -> Ident {
        let Head::For { iterator, .. } = &a_loop.head else {
            unreachable!("other loops have no iterator");
        };
        let items = self.names.fresh("items", a_loop.record.span());
        let definition = quote!(let #items = ::core::iter::IntoIterator::into_iter(#iterator););
        sides.forward.extend(definition);
        self.tapes.items = Some(items.clone());
        items
    }

    /// Makes the tapes of the loops within an outermost loop.
    pub(super) fn nested_tapes(&mut self, sides: &mut Sides) {
        for (record, tape) in std::mem::take(&mut self.tapes.nested) {
            sides.forward.extend(quote!(let mut #record = #tape;));
            // An arm of a branch hands it over.
            sides.reverse.extend(quote!(let mut #record = #record;));
            sides.defines.push(record);
        }
    }
}
