//! What flows to a cotangent: its start, and what is added to it.
//!
//! A cotangent begins with the first that flows to it, or with a zero where something flows to a
//! part of it or from another block. What has no known type goes through the traits of `ad::rt`;
//! [numbers](crate::analyse::numbers) are added up as such.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::Sweeper;
use crate::ir::primal::{member_from_end, project, tangent_path};
use crate::ir::{Place, Projection, Var, VarId};
use crate::names;

/// The cotangent of a place, as `&mut`. That of a reference is that of its target.
pub(super) fn cotangent_of(root: &Ident, path: &[Projection]) -> TokenStream {
    // Before the first element and behind each field it is a place, else a reference.
    let (place, is_reference) =
        path.iter().fold((quote!(#root), false), |(place, is_reference), step| match step {
            Projection::Field(member) => (quote!(#place.#member), false),
            Projection::FromEnd(behind) if is_reference => (member_from_end(&place, *behind), true),
            Projection::FromEnd(behind) => (member_from_end(&quote!(&mut #place), *behind), true),
            Projection::Index(index) if is_reference => {
                (quote!(::ad::rt::at(#place, #index)), true)
            }
            Projection::Index(index) => (quote!(::ad::rt::at(&mut #place, #index)), true),
            Projection::Deref | Projection::Behind(_) => (place, is_reference),
        });
    if is_reference { place } else { quote!(&mut #place) }
}

/// Where a cotangent that a pullback returns goes to.
pub(super) struct Target {
    pub(super) place: Place,
    /// Whether the argument may have been an array that was passed as a slice, or a box that was
    /// passed as what it holds.
    pub(super) is_coerced: bool,
}

impl Target {
    pub(super) fn whole(root: VarId) -> Self {
        Self { place: Place::of(root), is_coerced: false }
    }
}

impl Sweeper<'_> {
    /// Names the space of a variable's cotangent, to be defined by the forward sweep.
    pub(super) fn space(&mut self, var: VarId) -> Ident {
        self.spaces.insert(var);
        self.vars[var].space.clone()
    }

    /// Has the compiler check that `var` may be stored where the cotangent is `place`: a `#[constant]`
    /// field, which is named at `span`, takes no more than what such a field held.
    pub(super) fn check_stored(
        &mut self,
        reverse: &mut TokenStream,
        var: VarId,
        place: &TokenStream,
        span: Span,
    ) {
        if !self.vars[var].active {
            return;
        }
        let space = match self.facts.origin(var) {
            Some(Place { root, path }) if self.vars[root].active => {
                let (space, part) = (self.space(root), Ident::new("tangent", Span::mixed_site()));
                match tangent_path(quote!(#part), &path) {
                    Some(projected) => quote!(#space.part(|#part| &#projected)),
                    None => quote!(#space),
                }
            }
            _ => {
                let space = self.space(var);
                quote!(#space)
            }
        };
        reverse.extend(names::located(quote!(#place.accepts_tangents(#space);), span));
    }

    /// Defines the space of a variable, if the reverse sweep names it.
    pub(super) fn space_definition(&mut self, var: VarId) -> TokenStream {
        if !self.spaces.contains(&var) {
            return TokenStream::new();
        }
        let Var { ident, space, .. } = &self.vars[var];
        if self.loop_depth == 0 {
            return quote!(let #space = ::ad::rt::space(&#ident););
        }
        self.top.extend(quote!(let #space = ::ad::rt::Space::of_unknown();));
        quote!(#space.is_of(&#ident);)
    }

    /// The names under which the forward sweep knows a variable and its space. What tells types
    /// alone stands outside of loops.
    pub(super) fn names_of(&self, var: VarId) -> Vec<Ident> {
        let Var { ident, space, .. } = &self.vars[var];
        match self.loop_depth {
            0 => vec![ident.clone(), space.clone()],
            _ => vec![ident.clone()],
        }
    }

    /// Makes sure that the cotangent of `var` has a value; says whether the variable lives in this
    /// block.
    pub(super) fn start(&mut self, reverse: &mut TokenStream, var: VarId) {
        if self.vars[var].block != self.frame().block {
            self.frame().outer.insert(var);
        } else if self.started.insert(var) {
            let start = match self.lender(var) {
                Some(place) => {
                    self.start(reverse, place.root);
                    let lender = cotangent_of(&self.vars[place.root].cotangent, &place.path);
                    let space = self.space(var);
                    quote!(#space.taken(#lender))
                }
                None => self.zero(var),
            };
            let cotangent = &self.vars[var].cotangent;
            reverse.extend(quote!(let mut #cotangent = #start;));
        }
    }

    /// The place that lends its cotangent to a variable, which stands for it and gives the whole back
    /// where it is defined: elements that gathered there before are not added up again. The place never
    /// changes.
    fn lender(&self, var: VarId) -> Option<Place> {
        let place = self.facts.stands_for(var)?;
        let root = &self.vars[place.root];
        let is_list = self.numbers.number(var).is_none();
        let is_around = root.block != self.vars[var].block
            || self.lent.contains(&place.root)
            || self.lender(place.root).is_some();
        (is_list && is_around && root.active && !root.mutable).then(|| place.clone())
    }

    /// The zero of the space of a variable's cotangent.
    pub(super) fn zero(&mut self, var: VarId) -> TokenStream {
        match self.numbers.number(var) {
            Some(number) => number.zero(),
            None => {
                let space = self.space(var);
                quote!(#space.zero())
            }
        }
    }

    /// Adds `value`, which is a number, to the cotangent of a place, which is one too.
    pub(super) fn add(
        &mut self,
        reverse: &mut TokenStream,
        var: VarId,
        path: &[Projection],
        value: TokenStream,
    ) {
        if !self.vars[var].active || (path.is_empty() && self.is_unstarted_local(var)) {
            return self.contribute(reverse, var, path, value);
        }
        self.start(reverse, var);
        let place = self.number_at(var, path);
        reverse.extend(quote!(#place += #value;));
    }

    /// Takes `value` away from the cotangent of a variable; both are numbers.
    pub(super) fn subtract(&mut self, reverse: &mut TokenStream, var: VarId, value: TokenStream) {
        if !self.vars[var].active || self.is_unstarted_local(var) {
            return self.contribute(reverse, var, &[], quote!(-#value));
        }
        self.start(reverse, var);
        let cotangent = &self.vars[var].cotangent;
        reverse.extend(quote!(#cotangent -= #value;));
    }

    /// The cotangent of a place, which is a number.
    pub(super) fn number_at(&self, var: VarId, path: &[Projection]) -> TokenStream {
        let cotangent = &self.vars[var].cotangent;
        let path: Vec<_> = path.iter().filter(|step| step.is_part()).cloned().collect();
        if path.is_empty() || self.numbers.is_in_array(var, &path) {
            return project(quote!(#cotangent), &path);
        }
        let reference = cotangent_of(cotangent, &path);
        quote!(*#reference)
    }

    /// Adds `value` to the cotangent of a place.
    pub(super) fn contribute(
        &mut self,
        reverse: &mut TokenStream,
        var: VarId,
        path: &[Projection],
        value: TokenStream,
    ) {
        if !self.vars[var].active {
            return;
        }
        let whole = !path.iter().any(Projection::is_part);
        if whole && self.is_unstarted_local(var) {
            self.started.insert(var);
            // Behind a `*` may be the content of a box.
            let value = match path.is_empty() {
                true => value,
                false => {
                    let space = self.space(var);
                    quote!(#space.enter(#value))
                }
            };
            let cotangent = &self.vars[var].cotangent;
            reverse.extend(quote!(let mut #cotangent = #value;));
        } else {
            self.start(reverse, var);
            let place = cotangent_of(&self.vars[var].cotangent, path);
            reverse.extend(quote!(::ad::rt::Absorb::absorb(#place, #value);));
        }
    }

    pub(super) fn is_unstarted_local(&mut self, var: VarId) -> bool {
        self.vars[var].block == self.frame().block && !self.started.contains(&var)
    }

    /// Adds each part of `value`, a tuple or an array, to the cotangent of its target.
    pub(super) fn contribute_all(
        &mut self,
        reverse: &mut TokenStream,
        targets: &[Option<Target>],
        value: TokenStream,
        as_array: bool,
    ) {
        let mut elements = Vec::new();
        let mut absorbed = TokenStream::new();
        for target in targets {
            let Some(Target { place: Place { root, path }, is_coerced }) =
                target.as_ref().filter(|target| self.vars[target.place.root].active)
            else {
                elements.push(quote!(_));
                continue;
            };
            let is_first = path.is_empty() && self.is_unstarted_local(*root);
            if is_first && !is_coerced {
                self.started.insert(*root);
                let cotangent = &self.vars[*root].cotangent;
                elements.push(quote!(mut #cotangent));
            } else if is_first {
                let part = self.part_name(*root);
                let space = self.space(*root);
                self.contribute(&mut absorbed, *root, path, quote!(#space.enter(#part)));
                elements.push(quote!(#part));
            } else {
                let part = self.part_name(*root);
                self.contribute(&mut absorbed, *root, path, quote!(#part));
                elements.push(quote!(#part));
            }
        }
        let pattern = match (&elements[..], as_array) {
            ([element], false) => quote!(#element),
            (elements, false) => quote!((#(#elements),*)),
            (elements, true) => quote!([#(#elements),*]),
        };
        reverse.extend(quote!(let #pattern = #value; #absorbed));
    }

    /// A name for one contribution to the cotangent of `var`.
    pub(super) fn part_name(&mut self, var: VarId) -> Ident {
        let ident = &self.vars[var].ident;
        self.names.fresh(&format!("{ident}_part"), ident.span())
    }

    /// An arm or an iteration changed cotangents of surrounding variables: they have to have a
    /// value before.
    pub(super) fn leave(&mut self, reverse: &mut TokenStream, outer: &BTreeSet<VarId>) {
        for &var in outer {
            self.start(reverse, var);
        }
    }
}
