//! The sweeps of a branch: what the arm that was taken saved is a variant, whose reverse sweep runs.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::{Frame, Sides, Sweeper, Written, tuple};
use crate::ir::{Arm, Binding, Branch, BranchKind, Keep, Place};

impl Sweeper<'_> {
    /// What a pattern bound flows back to the matched place.
    pub(super) fn bindings(
        &mut self,
        bindings: &[Binding],
        source: Option<&Place>,
        sides: &mut Sides,
    ) {
        for binding in bindings {
            let var = &self.vars[binding.var];
            if let Some(source) = source
                && self.started.contains(&binding.var)
            {
                let path = [&source.path[..], &binding.path].concat();
                let cotangent = &var.cotangent;
                self.contribute(&mut sides.reverse, source.root, &path, quote!(#cotangent));
            }
            let (ident, written) = (&self.vars[binding.var].ident, binding.written.iter());
            sides.forward.extend(quote!(#(let #ident = #written;)*));
            sides.forward.extend(self.space_definition(binding.var));
            sides.defines.extend(self.names_of(binding.var));
        }
    }

    pub(super) fn branch(&mut self, branch: &Branch) -> Sides {
        let mut sides = Sides::default();
        let seed = branch.result.filter(|result| self.started.contains(result));
        let seed = seed.map(|result| self.vars[result].cotangent.clone());
        let source = branch.source();
        self.tapes.enter_sometimes();
        let arms: Vec<_> =
            branch.arms.iter().map(|arm| self.arm(arm, source, seed.as_ref())).collect();
        self.tapes.leave();
        for arm in &arms {
            self.leave(&mut sides.reverse, &arm.outer);
        }

        // Where nothing flows back through any arm, the path taken need not be known.
        let records = arms.iter().any(|arm| !arm.reverse.is_empty());
        let (record, count) = (&branch.record, arms.len());
        let saved: Vec<_> = arms.iter().map(Written::saved_names).collect();
        let some_save_little = saved.iter().any(|saved| saved.len() <= LITTLE);
        let is_boxed = |index: usize| some_save_little && saved[index].len() >= MUCH;
        let bodies = arms.iter().enumerate().map(|(index, arm)| {
            let (forward, value, saved) = (&arm.forward, &arm.value, tuple(&saved[index]));
            let saved = match is_boxed(index) {
                true => quote!(::std::boxed::Box::new(#saved)),
                false => saved,
            };
            let saved = in_variant(count, index, &saved);
            match (branch.result.is_some(), records) {
                (true, true) => quote!({ #forward (#value, #saved) }),
                (true, false) => quote!({ #forward #value }),
                (false, true) => quote!({ #forward #saved }),
                (false, false) => quote!({ #forward }),
            }
        });
        let choice = branch.choose(bodies);
        let result = branch.result.map(|result| &self.vars[result]);
        sides.forward.extend(match (result.map(|var| &var.ident), records) {
            (Some(ident), true) => quote!(let (#ident, #record) = #choice;),
            (Some(ident), false) => quote!(let #ident = #choice;),
            (None, true) => quote!(let #record = #choice;),
            (None, false) => quote!(#choice),
        });
        if let Some(result) = branch.result {
            sides.forward.extend(self.space_definition(result));
            sides.defines.extend(self.names_of(result));
        }

        if records {
            sides.defines.push(record.clone());
            if saved.iter().all(Vec::is_empty) && self.is_chosen_cheaply(branch) {
                let paths = (0..count).map(|index| {
                    let path = in_variant(count, index, &quote!(()));
                    quote!({ #path })
                });
                self.paths.insert(record.to_string(), branch.choose(paths));
            }
            let arms = arms.iter().enumerate().map(|(index, arm)| {
                let (saved, reverse) = (tuple(&saved[index]), &arm.reverse);
                let (saved, opened) = match is_boxed(index) {
                    true => (quote!(saved), quote!(let #saved = *saved;)),
                    false => (saved, TokenStream::new()),
                };
                let saved = in_variant(count, index, &saved);
                quote!(#saved => { #opened #reverse })
            });
            sides.reverse.extend(quote!(match #record { #(#arms)* }));
        }
        sides
    }

    /// Whether it costs next to nothing to find out once more which arm was taken.
    fn is_chosen_cheaply(&self, branch: &Branch) -> bool {
        let (BranchKind::If(chooses) | BranchKind::Match(chooses, _)) = &branch.kind;
        let mut arms = branch.arms.iter();
        self.facts.is_cheap(chooses)
            && arms.all(|Arm { guard, bindings, .. }| {
                bindings.is_empty() && guard.iter().all(|guard| self.facts.is_cheap(guard))
            })
    }

    pub(super) fn arm(
        &mut self,
        arm: &Arm,
        source: Option<&Place>,
        seed: Option<&Ident>,
    ) -> Written {
        let mut written = self.block(&arm.body, seed.map(|seed| quote!(#seed)));
        // The bindings are the first thing the arm does, so the last on the way back.
        self.frames.push(Frame::new(arm.body.id, written.outer));
        let mut sides = Sides::default();
        self.bindings(&arm.bindings, source, &mut sides);
        written.outer = self.frames.pop().expect("pushed above").outer;
        written.reverse.extend(sides.reverse);
        let forward = &written.forward;
        let bound = sides.forward;
        written.forward = quote!(#bound #forward);
        written.defines.splice(0..0, sides.defines);
        written
    }

    /// What ways keep has its cotangent all the while.
    pub(super) fn keep(&self, keep: &Keep) -> Sides {
        let forward = keep.statements(self.vars, |var| self.vars[var].ident.to_token_stream());
        Sides { forward, ..Sides::default() }
    }
}

/// An arm that saves so many values keeps them on the heap, if another saves [little](LITTLE): a branch, and all
/// that keeps it, takes the room of its largest arm, whichever is taken. The map of a ray marcher, where boxes keep
/// rays from most shapes, had 5.5 kB for every step.
const MUCH: usize = 16;
const LITTLE: usize = 3;

/// The largest of the enums `ad::rt::Branch1`, `Branch2`, ..
const MOST_ARMS: usize = 12;

/// What an arm saved, as a variant. Arms beyond those of the largest enum share its last variant.
fn in_variant(arms: usize, index: usize, saved: &TokenStream) -> TokenStream {
    let last = MOST_ARMS - 1;
    let (name, variant, saved) = match arms > MOST_ARMS {
        true if index >= last => (MOST_ARMS, last, in_variant(arms - last, index - last, saved)),
        true => (MOST_ARMS, index, saved.clone()),
        false => (arms, index, saved.clone()),
    };
    let (name, variant) = (format_ident!("Branch{name}"), format_ident!("Arm{variant}"));
    quote!(::ad::rt::#name::#variant(#saved))
}
