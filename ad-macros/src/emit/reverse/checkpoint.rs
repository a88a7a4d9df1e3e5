//! The sweeps of a loop with checkpoints.
//!
//! The forward sweep runs the loop as the user wrote it, in about as many segments as a segment has
//! iterations (`ad::rt::Checkpoints`), and stores before each the variables that the loop may change,
//! with the iterator. The reverse sweep takes the segments from the last to the first: it runs one
//! again, now with a tape, and then backwards.
//!
//! For n iterations that is √n states and √n records instead of n records, for a second run of
//! the body. Turned down: binomial checkpoints (Griewank & Walther 2000), which store log n states
//! and run the body log n times: √n states of a loop with a million iterations are a thousand, and
//! every further run costs as much as the adjoint itself.

use std::collections::HashSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::{Sides, Sweeper};
use crate::ir::{Block, BlockId, Head, Loop, Statement, VarId};
use crate::names;
use crate::names::own;

impl Sweeper<'_> {
    pub(super) fn checkpointed_loop(&mut self, a_loop: &Loop) -> Sides {
        let mut sides = Sides::default();
        // Tapes of its body that are made before a loop around it are for all of its iterations.
        let is_nested = self.loop_depth > 0;
        if is_nested {
            self.tapes.enter_unknown();
        }
        let mut body = self.block(&a_loop.body, None);
        if is_nested {
            self.tapes.leave();
        }
        self.leave(&mut sides.reverse, &body.outer);
        let primal = self.primal_block(&a_loop.body);
        if body.reverse.is_empty() {
            sides.forward.extend(match &a_loop.head {
                Head::For { pattern, iterator, .. } => {
                    quote!(for #pattern in #iterator { #primal })
                }
                Head::While(condition) => quote!(while #condition { #primal }),
                Head::Loop => unreachable!("is a `while`"),
            });
            return sides;
        }
        if let Head::For { defines, .. } = &a_loop.head {
            let variables = defines.iter().map(|&var| self.vars[var].ident.clone());
            body.defines.splice(0..0, variables);
        }
        let state = self.state(&a_loop.body, &body.forward);
        let references = self.kept_references(&body.forward, &mut sides);
        sides.reverse.extend(references);
        let names = ["items", "checkpoints", "print", "count"];
        let [items, checkpoints, print, count] =
            names.map(|name| self.names.fresh(name, a_loop.record.span()));
        let (record, after, before) = (&a_loop.record, own("after"), own("before"));
        let keep = |items: Option<&Ident>| {
            let items = items.map(|items| quote!(#items.clone(),));
            quote! {
                #checkpoints.begin_iteration(|| (
                    ::ad::fingerprint!(#(#state),*),
                    #items
                    #(::core::clone::Clone::clone(&#state),)*
                ));
            }
        };
        let (segment, items) = match &a_loop.head {
            Head::For { pattern, iterator, .. } => {
                let keep = keep(Some(&items));
                sides.forward.extend(quote! {
                    let mut #items = ::core::iter::IntoIterator::into_iter(#iterator);
                    let mut #checkpoints = ::ad::rt::Checkpoints::expecting(#items.size_hint().0);
                    loop {
                        #keep
                        let ::core::option::Option::Some(#pattern) = #items.next() else { break };
                        #primal
                    }
                });
                (quote!(for #pattern in #items.take(#count)), Some(quote!(#items,)))
            }
            Head::While(condition) => {
                let keep = keep(None);
                sides.forward.extend(quote! {
                    let mut #checkpoints = ::ad::rt::Checkpoints::expecting(0);
                    while #condition {
                        #keep
                        #primal
                    }
                });
                (quote!(for _ in 0..#count), None)
            }
            Head::Loop => unreachable!("is a `while`"),
        };
        sides.forward.extend(quote!(let #print = ::ad::fingerprint!(#(#state),*);));
        let (forward, saved, reverse) = (&body.forward, body.saved(), &body.reverse);
        sides.reverse.extend(quote! {
            let mut #after = #print;
            for (#count, (#before, #items #(mut #state,)*)) in #checkpoints.into_segments() {
                let mut #record = ::std::vec::Vec::with_capacity(#count);
                #segment { #forward #record.push(#saved); }
                ::ad::rt::same_again(#after, ::ad::fingerprint!(#(#state),*));
                #after = #before;
                for #saved in #record.into_iter().rev() { #reverse }
            }
        });
        sides.defines.extend([checkpoints, print]);
        sides
    }

    /// A block as the user wrote it, from which nothing is saved.
    fn primal_block(&mut self, block: &Block) -> TokenStream {
        let started = std::mem::take(&mut self.started);
        let spaces = std::mem::take(&mut self.spaces);
        let was_primal = std::mem::replace(&mut self.is_primal, true);
        let written = self.block(block, None);
        (self.started, self.spaces, self.is_primal) = (started, spaces, was_primal);
        written.forward
    }

    /// The variables that an iteration may leave changed to the next, and those that something
    /// later may change: in any case what the body names of the variables around it.
    fn state(&self, body: &Block, forward: &TokenStream) -> Vec<Ident> {
        let mut inner = HashSet::new();
        blocks(body, &mut inner);
        let mut named = HashSet::new();
        names::collect_variables(forward.clone(), &mut named);
        // A field may have the name of a variable that is not there, or not yet.
        let first = self.vars.iter().position(|var| inner.contains(&var.block));
        let before = &self.vars[..first.unwrap_or(self.vars.len())];
        let is_open = |block| self.frames.iter().any(|frame| frame.block == block);
        let outer = before.iter().filter(|var| var.mutable && is_open(var.block));
        let state = outer.filter(|var| named.contains(&var.ident.to_string()));
        state.map(|var| var.ident.clone()).collect()
    }

    /// Lets the pullback own what the body has by reference; returns the definitions for it.
    fn kept_references(&mut self, forward: &TokenStream, sides: &mut Sides) -> TokenStream {
        let mut named = HashSet::new();
        names::collect(forward.clone(), &mut named);
        let references: Vec<(VarId, syn::Type)> = self.references.to_vec();
        let mut again = TokenStream::new();
        for (var, ty) in references {
            let ident = self.vars[var].ident.clone();
            if !named.contains(&ident.to_string()) {
                continue;
            }
            let kept = self.names.fresh(&format!("{ident}_kept"), ident.span());
            sides.forward.extend(quote!(let #kept = ::std::borrow::ToOwned::to_owned(#ident);));
            sides.defines.push(kept.clone());
            again.extend(quote!(let #ident: &#ty = ::core::borrow::Borrow::borrow(&#kept);));
        }
        again
    }
}

/// Collects a block and the blocks in it.
fn blocks(block: &Block, into: &mut HashSet<BlockId>) {
    into.insert(block.id);
    let inner = block.statements.iter().flat_map(Statement::blocks);
    inner.for_each(|block| blocks(block, into));
}
