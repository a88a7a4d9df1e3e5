//! Writes the forward and the reverse sweep of a lowered function.
//!
//! A block is visited backwards. When a statement is reached, all uses of what it defines have
//! been seen: if nothing flowed back, the operation needs no pullback and is written as the user
//! wrote it; else the reverse sweep gets its pullback, and the forward sweep saves what that names.

mod a_loop;
mod arithmetic;
mod assign;
mod branch;
mod build;
mod checkpoint;
mod closure;
mod contribute;
mod neighbours;
mod operation;
mod products;
mod recompute;
mod taken;
mod tape;

use std::collections::{BTreeSet, HashMap, HashSet};

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::lending::Method;
use crate::analyse::facts::Facts;
use crate::analyse::numbers::Numbers;
use crate::analyse::products::Products;
use crate::emit::header::{Header, tuple_or_one};
use crate::ir::primal::Primal;
use crate::ir::{Block, BlockId, Operand, Operation, Statement, Var, VarId};
use crate::lower::{Lowered, LoweredParameter};
use crate::names;
use crate::names::Names;
use crate::parse::signature::Parameter;
use neighbours::{Carried, Counter, Neighbour};
use tape::Tapes;

/// The sweeps of a function.
pub struct Sweeps {
    /// The statements of the forward sweep.
    pub forward: TokenStream,
    /// The value of the function.
    pub value: TokenStream,
    /// The body of the pullback: the reverse sweep, and the cotangents of the parameters.
    pub pullback: TokenStream,
    /// Whether the pullback is to be inlined wherever it is called.
    pub is_inlined: bool,
    /// The names of the cotangents that come in for `&mut` parameters.
    pub incoming: Vec<Ident>,
    /// For each parameter the pattern that takes its cotangent so far, where callers lend it.
    pub lent: Vec<TokenStream>,
    /// The methods that are called which may be lent cotangents.
    pub lending_methods: BTreeSet<Method>,
}

/// Writes both sweeps; `seed` is the name of the cotangent of the result, `header` is that of a
/// function that is no closure, `is_alone` says whether there is no forward mode.
pub fn sweep(
    lowered: &Lowered,
    parameters: &[Parameter],
    (header, is_alone): (Option<&Header>, bool),
    seed: &Ident,
    names: &mut Names,
) -> Sweeps {
    let facts = Facts::new(lowered, parameters);
    let numbers = Numbers::new(lowered, parameters);
    let products = Products::new(lowered, &facts, &numbers, names);
    let mut sweeper =
        Sweeper { products, is_alone, ..Sweeper::new(lowered, facts, numbers, names) };
    let exclusive = lowered.parameters.iter().map(|parameter| parameter.var);
    let exclusive: Vec<_> = exclusive.filter(|&var| lowered.vars[var].exclusive).collect();
    sweeper.started.extend(&exclusive);
    let lent = lowered.parameters.iter().zip(header.into_iter().flat_map(|own| &own.lent));
    let lent =
        lent.filter(|(parameter, lent)| lent.is_some() && lowered.vars[parameter.var].active);
    sweeper.lent = lent.map(|(parameter, _)| parameter.var).collect();
    sweeper.started.extend(&sweeper.lent);
    let body = sweeper.block(&lowered.body, Some(quote!(#seed)));
    let spaces = lowered.parameters.iter().map(|parameter| sweeper.space_definition(parameter.var));
    let spaces: Vec<_> = spaces.collect();
    let mut shapes = TokenStream::new();
    let is_sized_by_vjp = |index: usize| header.is_some_and(|own| own.sized_by_vjp[index]);
    let cotangents = lowered.parameters.iter().enumerate().map(
        |(index, &LoweredParameter { var, has_shape, is_box })| {
            let Var { ident, cotangent, active, .. } = &lowered.vars[var];
            let cotangent = match (active, sweeper.started.contains(&var)) {
                (false, _) => return quote!(()),
                (true, true) if is_box => return quote!(::ad::rt::Enter::enter(#cotangent)),
                (true, true) => quote!(#cotangent),
                (true, false) => quote!(::ad::Additive::zero()),
            };
            if !has_shape || is_sized_by_vjp(index) {
                return cotangent;
            }
            let shape = sweeper.names.fresh(&format!("{ident}_shape"), ident.span());
            shapes.extend(quote!(let #shape = ::ad::rt::shape(&#ident);));
            quote!(::ad::rt::fit(#shape, #cotangent))
        },
    );
    let cotangents = tuple_or_one(&cotangents.collect::<Vec<_>>());
    let pullback = sweeper.choose_products(seed, body.reverse, cotangents);
    let regular = sweeper.start_of_tests();
    let (top, forward) = (&sweeper.top, body.forward);
    let patterns = lowered.parameters.iter().map(|parameter| {
        let cotangent = &lowered.vars[parameter.var].cotangent;
        if sweeper.lent.contains(&parameter.var) { quote!(mut #cotangent) } else { quote!(_) }
    });
    let patterns = patterns.collect();
    Sweeps {
        is_inlined: sweeper.products.as_ref().is_some_and(|products| products.is_inlined),
        lent: patterns,
        lending_methods: std::mem::take(&mut sweeper.lending_methods),
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
    let numbers = Numbers::new(lowered, parameters);
    let mut sweeper = Sweeper { is_primal: true, ..Sweeper::new(lowered, facts, numbers, names) };
    let Written { forward, value, .. } = sweeper.block(&lowered.body, None);
    let top = &sweeper.top;
    (quote!(#top #forward), value)
}

struct Sweeper<'a> {
    vars: &'a [Var],
    /// The parameters that are references, and the types that they refer to.
    references: &'a [(VarId, syn::Type)],
    /// The variables that are known not to be `Copy`.
    movable: &'a HashSet<VarId>,
    /// Whether code is written from which nothing is saved.
    is_primal: bool,
    /// Whether there is no forward mode, in which the compiler would see that all that is called has a derivative.
    is_alone: bool,
    /// The methods that are called which may be lent cotangents.
    lending_methods: BTreeSet<Method>,
    facts: Facts<'a>,
    numbers: Numbers<'a>,
    /// Where products have plain pullbacks if their factors are finite.
    products: Option<Products>,
    names: &'a mut Names,
    /// The variables whose cotangents have a value at this point of the reverse sweep.
    started: HashSet<VarId>,
    /// The parameters whose cotangents callers lend.
    lent: HashSet<VarId>,
    /// The variables whose spaces the reverse sweep names.
    spaces: HashSet<VarId>,
    frames: Vec<Frame>,
    /// In how many loops the block being written lies.
    loop_depth: usize,
    /// The variables of the loops around that count up, innermost last.
    counters: Vec<Option<Counter>>,
    /// Definitions that stand before all others: what loops do not change.
    top: TokenStream,
    /// The copies that the pullback keeps of arrays behind references.
    kept_copies: HashMap<VarId, Ident>,
    /// What tells the paths of branches once more whose arms save nothing, by the name of the record.
    paths: HashMap<String, TokenStream>,
    /// How often the block being written runs, and the tapes of the loops in it.
    tapes: Tapes,
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
    /// What an iteration leaves to the one before it.
    carried: Carried,
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
        tuple(&self.saved_names())
    }
}

/// What a block saves, as a value and as a pattern.
fn tuple(saved: &[Ident]) -> TokenStream {
    quote!((#(#saved,)*))
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
    fn new(
        lowered: &'a Lowered,
        facts: Facts<'a>,
        numbers: Numbers<'a>,
        names: &'a mut Names,
    ) -> Self {
        Self {
            vars: &lowered.vars,
            references: &lowered.references,
            movable: &lowered.movable,
            is_primal: false,
            is_alone: false,
            lending_methods: BTreeSet::new(),
            products: None,
            facts,
            numbers,
            names,
            started: HashSet::new(),
            lent: HashSet::new(),
            spaces: HashSet::new(),
            frames: Vec::new(),
            loop_depth: 0,
            counters: Vec::new(),
            top: TokenStream::new(),
            kept_copies: HashMap::new(),
            paths: HashMap::new(),
            tapes: Tapes::default(),
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
        let mut neighbours = Vec::new();
        let earlier = self.facts.earlier_reads(block);
        let positions = self.positions(block, &earlier);
        for statement in block.statements.iter().rev() {
            let mut assigned = HashSet::new();
            self.facts.assigned(statement, &mut assigned);
            self.frame().assigned_later.extend(assigned);
            let (sides, position) = match statement {
                Statement::Define { var, ty, .. } if earlier.contains_key(var) => {
                    let same = Operation::Use(Operand::Var(earlier[var]));
                    (self.define(*var, ty.as_ref(), &same), None)
                }
                Statement::Define { var, .. } => {
                    (self.statement(statement), positions.get(var).map(|position| (position, *var)))
                }
                statement => (self.statement(statement), None),
            };
            forward.push(sides.forward);
            match position {
                Some((position, var)) if !sides.reverse.is_empty() => {
                    let reverse = sides.reverse;
                    neighbours.push(Neighbour { position: position.clone(), var, reverse });
                }
                _ => reverse.extend(sides.reverse),
            }
            defines.push(sides.defines);
        }
        let carried = self.neighbours(block, neighbours, &mut reverse);
        let mut written = Written {
            forward: forward.into_iter().rev().collect(),
            value: self.tokens(&block.value),
            reverse,
            defines: defines.into_iter().rev().flatten().collect(),
            outer: BTreeSet::new(),
            carried,
        };
        if self.loop_depth > 0 {
            self.recompute(block, &earlier, &mut written);
        }
        written.outer = self.frames.pop().expect("pushed above").outer;
        written
    }

    fn tokens(&self, operand: &Operand) -> TokenStream {
        Primal(self.vars).tokens(operand)
    }

    fn frame(&mut self) -> &mut Frame {
        self.frames.last_mut().expect("a block is being written")
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
                let place = self.place(source);
                sides.forward.extend(quote!(let #pattern #ty = #place;));
                self.bindings(bindings, Some(source), &mut sides);
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
            Statement::Keep(keep) => self.keep(keep),
        }
    }
}
