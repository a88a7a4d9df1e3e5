//! Writes the forward and the reverse sweep of a lowered function.
//!
//! A block is visited backwards. When a statement is reached, all uses of what it defines have
//! been seen: if nothing flowed back, the operation needs no pullback and is written as the user
//! wrote it; else the reverse sweep gets its pullback, and the forward sweep saves what that names.

mod a_loop;
mod build;
mod checkpoint;
mod closure;
mod cut;
mod facts;
mod operation;
mod products;
mod recompute;

use std::collections::{BTreeSet, HashMap, HashSet};

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::ir::{
    Arm, Block, BlockId, Branch, BranchKind, Operand, Place, Projection, Statement, Var, VarId,
};
use crate::lower::{Lowered, LoweredParameter};
use crate::names::{self, Names};
use crate::signature::Parameter;
use facts::Facts;
use products::Products;

/// The sweeps of a function.
pub struct Sweeps {
    /// The statements of the forward sweep.
    pub forward: TokenStream,
    /// The value of the function.
    pub value: TokenStream,
    /// The body of the pullback: the reverse sweep, and the cotangents of the parameters.
    pub pullback: TokenStream,
    /// The names of the cotangents that come in for `&mut` parameters.
    pub incoming: Vec<Ident>,
}

/// Writes both sweeps; `seed` is the name of the cotangent of the result.
pub fn sweep(
    lowered: &Lowered,
    parameters: &[Parameter],
    seed: &Ident,
    names: &mut Names,
) -> Sweeps {
    let facts = Facts::new(lowered, parameters);
    let products = Products::new(lowered, &facts, names);
    let mut sweeper = Sweeper { products, ..Sweeper::new(lowered, facts, names) };
    let exclusive = lowered.parameters.iter().map(|parameter| parameter.var);
    let exclusive: Vec<_> = exclusive.filter(|&var| lowered.vars[var].exclusive).collect();
    sweeper.started.extend(&exclusive);
    let body = sweeper.block(&lowered.body, Some(quote!(#seed)));
    let spaces = lowered.parameters.iter().map(|parameter| sweeper.space_definition(parameter.var));
    let spaces: Vec<_> = spaces.collect();
    let mut shapes = TokenStream::new();
    let cotangents =
        lowered.parameters.iter().map(|&LoweredParameter { var, has_shape, is_box }| {
            let Var { ident, cotangent, active, .. } = &lowered.vars[var];
            let cotangent = match (active, sweeper.started.contains(&var)) {
                (false, _) => return quote!(()),
                (true, true) if is_box => return quote!(::ad::rt::Enter::enter(#cotangent)),
                (true, true) => quote!(#cotangent),
                (true, false) => quote!(::ad::Additive::zero()),
            };
            if !has_shape {
                return cotangent;
            }
            let shape = sweeper.names.fresh(&format!("{ident}_shape"), ident.span());
            shapes.extend(quote!(let #shape = ::ad::rt::shape(&#ident);));
            quote!(::ad::rt::fit(#shape, #cotangent))
        });
    let cotangents = tuple_or_one(&cotangents.collect::<Vec<_>>());
    let pullback = sweeper.choose_products(body.reverse, cotangents);
    let regular = sweeper.products.as_ref().map(|products| &products.regular);
    let regular = regular.map(|regular| quote!(let mut #regular = true;));
    let (top, forward) = (&sweeper.top, body.forward);
    Sweeps {
        forward: quote!(#regular #top #(#spaces)* #shapes #forward),
        value: body.value,
        pullback,
        incoming: exclusive.iter().map(|&var| lowered.vars[var].cotangent.clone()).collect(),
    }
}

/// The statements and the value of a function, as the user wrote them.
pub fn primal(
    lowered: &Lowered,
    parameters: &[Parameter],
    names: &mut Names,
) -> (TokenStream, TokenStream) {
    let facts = Facts::new(lowered, parameters);
    let mut sweeper = Sweeper { is_primal: true, ..Sweeper::new(lowered, facts, names) };
    let Written { forward, value, .. } = sweeper.block(&lowered.body, None);
    let top = &sweeper.top;
    (quote!(#top #forward), value)
}

/// The cotangents of one parameter or of several.
pub fn tuple_or_one(parts: &[TokenStream]) -> TokenStream {
    match parts {
        [part] => part.clone(),
        parts => quote!((#(#parts),*)),
    }
}

/// A place as an expression.
pub fn project(root: TokenStream, path: &[Projection]) -> TokenStream {
    path.iter().fold(root, |place, step| match step {
        Projection::Field(member) => quote!(#place.#member),
        Projection::Index(index) => quote!(#place[#index]),
        Projection::Deref => quote!((*#place)),
    })
}

/// The cotangent of a place, as `&mut`. That of a reference is that of its target.
fn cotangent_of(root: &Ident, path: &[Projection]) -> TokenStream {
    // Before the first element and behind each field it is a place, else a reference.
    let (place, is_reference) =
        path.iter().fold((quote!(#root), false), |(place, is_reference), step| match step {
            Projection::Field(member) => (quote!(#place.#member), false),
            Projection::Index(index) if is_reference => {
                (quote!(::ad::rt::at(#place, #index)), true)
            }
            Projection::Index(index) => (quote!(::ad::rt::at(&mut #place, #index)), true),
            Projection::Deref => (place, is_reference),
        });
    if is_reference { place } else { quote!(&mut #place) }
}

struct Sweeper<'a> {
    vars: &'a [Var],
    /// The parameters that are references, and the types that they refer to.
    references: &'a [(VarId, syn::Type)],
    /// Whether code is written from which nothing is saved.
    is_primal: bool,
    facts: Facts<'a>,
    /// Where products have plain pullbacks if their factors are finite.
    products: Option<Products>,
    names: &'a mut Names,
    /// The variables whose cotangents have a value at this point of the reverse sweep.
    started: HashSet<VarId>,
    /// The variables whose spaces the reverse sweep names.
    spaces: HashSet<VarId>,
    frames: Vec<Frame>,
    /// In how many loops the block being written lies.
    loop_depth: usize,
    /// Definitions that stand before all others: what loops do not change.
    top: TokenStream,
    /// The copies that the pullback keeps of arrays behind references.
    kept_copies: HashMap<VarId, Ident>,
    /// The names of the ranges of loops, by those of their tapes.
    ranges: HashMap<String, Ident>,
}

/// A block being written.
struct Frame {
    block: BlockId,
    /// Variables of surrounding blocks whose cotangents the block changes.
    outer: BTreeSet<VarId>,
    /// Variables that the statement being written or a later one assigns to.
    assigned_later: HashSet<VarId>,
}

/// What has been written of a block.
struct Written {
    forward: TokenStream,
    value: TokenStream,
    reverse: TokenStream,
    /// The names that the forward sweep defines, in order.
    defines: Vec<Ident>,
    outer: BTreeSet<VarId>,
}

impl Written {
    /// The names that have to outlive the forward sweep of the block.
    fn saved_names(&self) -> Vec<Ident> {
        let mut named = HashSet::new();
        names::collect_variables(self.reverse.clone(), &mut named);
        let saved = self.defines.iter().filter(|name| named.contains(&name.to_string()));
        saved.cloned().collect()
    }

    /// The same as a tuple.
    fn saved(&self) -> TokenStream {
        let saved = self.saved_names();
        quote!((#(#saved,)*))
    }
}

/// Where a cotangent that a pullback returns goes to.
struct Target {
    place: Place,
    /// Whether the argument may have been an array that was passed as a slice.
    is_coerced: bool,
}

impl Target {
    fn whole(root: VarId) -> Self {
        Self { place: Place { root, path: Vec::new() }, is_coerced: false }
    }
}

/// The two sides of a statement.
#[derive(Default)]
struct Sides {
    forward: TokenStream,
    reverse: TokenStream,
    defines: Vec<Ident>,
}

impl Frame {
    fn new(block: BlockId, outer: BTreeSet<VarId>) -> Self {
        Self { block, outer, assigned_later: HashSet::new() }
    }
}

impl<'a> Sweeper<'a> {
    fn new(lowered: &'a Lowered, facts: Facts<'a>, names: &'a mut Names) -> Self {
        Self {
            vars: &lowered.vars,
            references: &lowered.references,
            is_primal: false,
            products: None,
            facts,
            names,
            started: HashSet::new(),
            spaces: HashSet::new(),
            frames: Vec::new(),
            loop_depth: 0,
            top: TokenStream::new(),
            kept_copies: HashMap::new(),
            ranges: HashMap::new(),
        }
    }
}

impl Sweeper<'_> {
    fn block(&mut self, block: &Block, seed: Option<TokenStream>) -> Written {
        self.frames.push(Frame::new(block.id, BTreeSet::new()));
        let mut reverse = TokenStream::new();
        if let (Operand::Var(var), Some(seed)) = (&block.value, seed) {
            self.contribute(&mut reverse, *var, &[], seed);
        }
        let mut forward = Vec::new();
        let mut defines = Vec::new();
        for statement in block.statements.iter().rev() {
            let mut assigned = HashSet::new();
            self.facts.assigned(statement, &mut assigned);
            self.frame().assigned_later.extend(assigned);
            let sides = self.statement(statement);
            forward.push(sides.forward);
            reverse.extend(sides.reverse);
            defines.push(sides.defines);
        }
        let mut written = Written {
            forward: forward.into_iter().rev().collect(),
            value: self.tokens(&block.value),
            reverse,
            defines: defines.into_iter().rev().flatten().collect(),
            outer: BTreeSet::new(),
        };
        if self.loop_depth > 0 {
            self.recompute(block, &mut written);
        }
        written.outer = self.frames.pop().expect("pushed above").outer;
        written
    }

    fn tokens(&self, operand: &Operand) -> TokenStream {
        match operand {
            Operand::Constant(tokens) => tokens.clone(),
            Operand::Var(var) => {
                let ident = &self.vars[*var].ident;
                quote!(#ident)
            }
        }
    }

    fn frame(&mut self) -> &mut Frame {
        self.frames.last_mut().expect("a block is being written")
    }

    /// Names the space of a variable's cotangent, to be defined by the forward sweep.
    fn space(&mut self, var: VarId) -> Ident {
        self.spaces.insert(var);
        self.vars[var].space.clone()
    }

    /// Defines the space of a variable, if the reverse sweep names it.
    fn space_definition(&mut self, var: VarId) -> TokenStream {
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
    fn names_of(&self, var: VarId) -> Vec<Ident> {
        let Var { ident, space, .. } = &self.vars[var];
        match self.loop_depth {
            0 => vec![ident.clone(), space.clone()],
            _ => vec![ident.clone()],
        }
    }

    /// Makes sure that the cotangent of `var` has a value; says whether the variable lives in this
    /// block.
    fn start(&mut self, reverse: &mut TokenStream, var: VarId) {
        if self.vars[var].block != self.frame().block {
            self.frame().outer.insert(var);
        } else if self.started.insert(var) {
            let space = self.space(var);
            let cotangent = &self.vars[var].cotangent;
            reverse.extend(quote!(let mut #cotangent = #space.zero();));
        }
    }

    /// Adds `value` to the cotangent of a place.
    fn contribute(
        &mut self,
        reverse: &mut TokenStream,
        var: VarId,
        path: &[Projection],
        value: TokenStream,
    ) {
        if !self.vars[var].active {
            return;
        }
        let whole = path.iter().all(|step| matches!(step, Projection::Deref));
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

    fn is_unstarted_local(&mut self, var: VarId) -> bool {
        self.vars[var].block == self.frame().block && !self.started.contains(&var)
    }

    /// Adds each part of `value`, a tuple or an array, to the cotangent of its target.
    fn contribute_all(
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
    fn part_name(&mut self, var: VarId) -> Ident {
        let ident = &self.vars[var].ident;
        self.names.fresh(&format!("{ident}_part"), ident.span())
    }

    fn statement(&mut self, statement: &Statement) -> Sides {
        match statement {
            Statement::Define { var, ty, operation } => self.define(*var, ty.as_ref(), operation),
            Statement::Plain { code, defines } => Sides {
                forward: code.clone(),
                reverse: TokenStream::new(),
                defines: defines.iter().map(|&var| self.vars[var].ident.clone()).collect(),
            },
            Statement::Destructure { pattern, ty, source, bindings } => {
                let mut sides = Sides::default();
                let ty = ty.as_ref().map(|ty| quote!(: #ty));
                let ident = &self.vars[*source].ident;
                sides.forward.extend(quote!(let #pattern #ty = #ident;));
                let place = Place { root: *source, path: Vec::new() };
                self.bindings(bindings, Some(&place), &mut sides);
                sides
            }
            Statement::Assign { place, value } => self.assign(place, value),
            Statement::Update { place, operator, previous, value } => {
                self.update(place, *operator, *previous, *value)
            }
            Statement::Branch(branch) => self.branch(branch),
            Statement::Loop(a_loop) if a_loop.checkpoint && !self.is_primal => {
                self.checkpointed_loop(a_loop)
            }
            Statement::Loop(a_loop) => self.a_loop(a_loop),
            Statement::Build(build) => self.build(build),
        }
    }

    /// What a pattern bound flows back to the matched place.
    fn bindings(
        &mut self,
        bindings: &[crate::ir::Binding],
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
            sides.forward.extend(self.space_definition(binding.var));
            sides.defines.extend(self.names_of(binding.var));
        }
    }

    /// Whether anything flows back to a place that is assigned to here.
    fn is_live(&mut self, place: &Place) -> bool {
        !self.is_primal && !self.is_unstarted_local(place.root)
    }

    fn assign(&mut self, place: &Place, value: &Operand) -> Sides {
        let mut sides = Sides::default();
        let root = &self.vars[place.root];
        let target = project(
            {
                let ident = &root.ident;
                quote!(#ident)
            },
            &place.path,
        );
        let tokens = self.tokens(value);
        sides.forward.extend(quote!(#target = #tokens;));
        if !self.is_live(place) {
            return sides;
        }
        self.start(&mut sides.reverse, place.root);
        let cotangent = cotangent_of(&root.cotangent, &place.path);
        let taken = quote!(::ad::rt::take(#cotangent));
        match value {
            Operand::Constant(_) => sides.reverse.extend(quote!(#taken;)),
            Operand::Var(var) => {
                let part = self.part_name(place.root);
                let taken = self.entered(*var, place, taken);
                sides.reverse.extend(quote!(let #part = #taken;));
                self.contribute(&mut sides.reverse, *var, &[], quote!(#part));
            }
        }
        sides
    }

    /// The cotangent of `place`, as that of the variable it was made from: `place` may lie in a
    /// `#[constant]` field or in a box.
    fn entered(&mut self, var: VarId, place: &Place, cotangent: TokenStream) -> TokenStream {
        let is_plain = |step: &Projection| matches!(step, Projection::Index(_));
        if !self.vars[var].active || place.path.iter().all(is_plain) {
            return cotangent;
        }
        let space = self.space(var);
        quote!(#space.enter(#cotangent))
    }

    /// An arm or an iteration changed cotangents of surrounding variables: they have to have a
    /// value before.
    fn leave(&mut self, reverse: &mut TokenStream, outer: &BTreeSet<VarId>) {
        for &var in outer {
            self.start(reverse, var);
        }
    }

    fn branch(&mut self, branch: &Branch) -> Sides {
        let mut sides = Sides::default();
        let seed = branch.result.filter(|result| self.started.contains(result));
        let seed = seed.map(|result| self.vars[result].cotangent.clone());
        let source = match &branch.kind {
            BranchKind::If(_) => None,
            BranchKind::Match(_, source) => source.as_ref(),
        };
        let arms: Vec<_> =
            branch.arms.iter().map(|arm| self.arm(arm, source, seed.as_ref())).collect();
        for arm in &arms {
            self.leave(&mut sides.reverse, &arm.outer);
        }

        // Where nothing flows back through any arm, the path taken need not be known.
        let records = arms.iter().any(|arm| !arm.reverse.is_empty());
        let (record, count) = (&branch.record, arms.len());
        let bodies = arms.iter().enumerate().map(|(index, arm)| {
            let (forward, value, saved) = (&arm.forward, &arm.value, arm.saved());
            let saved = in_variant(count, index, &saved);
            match (branch.result.is_some(), records) {
                (true, true) => quote!({ #forward (#value, #saved) }),
                (true, false) => quote!({ #forward #value }),
                (false, true) => quote!({ #forward #saved }),
                (false, false) => quote!({ #forward }),
            }
        });
        let choice = match &branch.kind {
            BranchKind::If(condition) => {
                let bodies: Vec<_> = bodies.collect();
                let (then, otherwise) = (&bodies[0], &bodies[1]);
                quote!(if #condition #then else #otherwise)
            }
            BranchKind::Match(matched, _) => {
                let arms = branch.arms.iter().zip(bodies).map(|(arm, body)| {
                    let pattern = &arm.pattern;
                    let guard = arm.guard.as_ref().map(|guard| quote!(if #guard));
                    quote!(#pattern #guard => #body)
                });
                quote!(match #matched { #(#arms)* })
            }
        };
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
            let arms = arms.iter().enumerate().map(|(index, arm)| {
                let (saved, reverse) = (in_variant(count, index, &arm.saved()), &arm.reverse);
                quote!(#saved => { #reverse })
            });
            sides.reverse.extend(quote!(match #record { #(#arms)* }));
        }
        sides
    }

    fn arm(&mut self, arm: &Arm, source: Option<&Place>, seed: Option<&Ident>) -> Written {
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
}

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
