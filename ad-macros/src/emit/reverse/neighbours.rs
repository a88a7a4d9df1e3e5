//! How an iteration adds to neighbouring elements of an array.
//!
//! A loop that reads `x[i]` and `x[i + 1]` adds to the cotangents of both, and the reverse sweep counts
//! down: the next iteration adds to `x[i]` as its `x[i + 1]`. So what flows to all but the last of
//! the neighbours is carried to the next iteration in variables, and each iteration changes one element.
//! Where that cannot be done (in an arm, in a loop with a `break`), they are changed in the order of their
//! indices.
//!
//! Turned down: adding to each. The compiler makes a vector of neighbours where it can, of which the iteration
//! before has only just stored a half, and the processor waits for that: differences of neighbours with three
//! branches took ten times as long.

use std::collections::{BTreeMap, HashMap};

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::{BinOp, Expr, ExprRange, Lit};

use super::Sweeper;
use crate::ir::{Block, BlockId, Head, Loop, Operation, Place, Projection, Statement, VarId};

/// What tells the order: the array, the way to the elements, the place among its neighbours.
pub(super) type Position = (VarId, String, i64);

/// The variable of a loop that counts up.
pub(super) struct Counter {
    name: Ident,
    body: BlockId,
    /// Whether the reverse sweep counts down from the same end.
    runs_all: bool,
}

/// An element that has neighbours, read by a block.
pub(super) struct Neighbour {
    pub(super) position: Position,
    /// What it is read into.
    pub(super) var: VarId,
    /// What gives it its cotangent.
    pub(super) reverse: TokenStream,
}

/// What iterations carry to the next of a reverse sweep.
#[derive(Default)]
pub(super) struct Carried {
    /// The definitions before the loop.
    pub(super) before: TokenStream,
    /// What takes the rest after the loop, which ended at the first value of its variable.
    pub(super) after: TokenStream,
}

impl Sweeper<'_> {
    /// The variable of a loop that counts up.
    pub(super) fn counter(&self, a_loop: &Loop) -> Option<Counter> {
        let Head::For { iterator, defines, .. } = &a_loop.head else { return None };
        let [counter] = &defines[..] else { return None };
        if !self.facts.counts_up(iterator) {
            return None;
        }
        let name = self.vars[*counter].ident.clone();
        Some(Counter { name, body: a_loop.body.id, runs_all: self.runs_all(a_loop) })
    }

    /// Where a block reads elements that have neighbours among those it reads.
    pub(super) fn positions(
        &self,
        block: &Block,
        earlier: &HashMap<VarId, VarId>,
    ) -> HashMap<VarId, Position> {
        let mut elements: HashMap<_, Vec<_>> = HashMap::new();
        for statement in &block.statements {
            if let Statement::Define { var, operation: Operation::Read(place), .. } = statement
                && !earlier.contains_key(var)
                && let Some((root, way, offset)) = self.position(block, place)
            {
                elements.entry((root, way)).or_default().push((*var, offset));
            }
        }
        let neighbours = elements.into_iter().filter(|(_, elements)| elements.len() > 1);
        neighbours
            .flat_map(|((root, way), elements)| {
                elements.into_iter().map(move |(var, offset)| (var, (root, way.clone(), offset)))
            })
            .collect()
    }

    /// Writes how a block adds to neighbours, at its end.
    pub(super) fn neighbours(
        &mut self,
        block: &Block,
        mut neighbours: Vec<Neighbour>,
        reverse: &mut TokenStream,
    ) -> Carried {
        neighbours.sort_by(|one, other| one.position.cmp(&other.position));
        let mut carried = Carried::default();
        let array = |neighbour: &Neighbour| (neighbour.position.0, neighbour.position.1.clone());
        for group in neighbours.chunk_by(|one, other| array(one) == array(other)) {
            match self.elements(block, group) {
                Some(elements) => self.carry(elements, reverse, &mut carried),
                None => reverse.extend(group.iter().map(|neighbour| neighbour.reverse.clone())),
            }
        }
        carried
    }

    /// The variables that the neighbours are read into, in the order of their indices, if an iteration
    /// can carry what flows to them to the next.
    fn elements(&self, block: &Block, group: &[Neighbour]) -> Option<Vec<Vec<VarId>>> {
        let counter = self.counters.last()?.as_ref()?;
        if !counter.runs_all || counter.body != block.id {
            return None;
        }
        let mut elements: BTreeMap<i64, Vec<VarId>> = BTreeMap::new();
        for Neighbour { position: (_, _, offset), var, .. } in group {
            self.numbers.number(*var)?;
            elements.entry(*offset).or_default().push(*var);
        }
        let (first, last) = (*elements.keys().next()?, *elements.keys().next_back()?);
        let are_neighbours = last - first == elements.len() as i64 - 1 && elements.len() > 1;
        are_neighbours.then(|| elements.into_values().collect())
    }

    /// Adds to the last of `elements`, and carries the others to the next iteration.
    fn carry(
        &mut self,
        elements: Vec<Vec<VarId>>,
        reverse: &mut TokenStream,
        carried: &mut Carried,
    ) {
        let mut carries: Vec<Ident> = Vec::new();
        for element in &elements[..elements.len() - 1] {
            let ident = &self.vars[element[0]].ident;
            carries.push(self.names.fresh(&format!("{ident}_carried"), ident.span()));
        }
        for (index, element) in elements.iter().enumerate().rev() {
            let from_before = index.checked_sub(1).map(|before| &carries[before]);
            let cotangents = element.iter().map(|&var| &self.vars[var].cotangent);
            let sum: Vec<_> = cotangents.chain(from_before).collect();
            let Some(Operation::Read(place)) = self.facts.operation(element[0]) else {
                unreachable!("elements are read");
            };
            let Some(carry) = carries.get(index) else {
                let target = self.number_at(place.root, &place.path);
                reverse.extend(quote!(#target += #(#sum)+*;));
                continue;
            };
            reverse.extend(quote!(#carry = #(#sum)+*;));
            let zero = self.zero(element[0]);
            carried.before.extend(quote!(let mut #carry = #zero;));
            let target = self.behind_loop(place);
            carried.after.extend(quote!(#target += #carry;));
        }
    }

    /// The cotangent of an element, which is a number, where only the variable of the loop is known.
    fn behind_loop(&self, place: &Place) -> TokenStream {
        let path = place.path.iter().map(|step| match step {
            Projection::Index(index) => Projection::Index(self.facts.index(index)),
            step => step.clone(),
        });
        self.number_at(place.root, &path.collect::<Vec<_>>())
    }

    /// The place of an element among its neighbours, in an array from outside that stays as it is.
    fn position(&self, block: &Block, place: &Place) -> Option<Position> {
        let Some(Some(Counter { name: counter, .. })) = self.counters.last() else { return None };
        let root = &self.vars[place.root];
        if root.block == block.id || root.mutable || root.exclusive {
            return None;
        }
        let (Projection::Index(index), mut way) = place.path.split_last()? else { return None };
        let mut index = self.facts.index(index);
        // An element of a window, which begins at the counter.
        if let Some((Projection::Index(window), around)) = way.split_last()
            && let Ok(ExprRange { start: Some(start), .. }) = syn::parse2(window.clone())
        {
            (index, way) = (quote!(#start + #index), around);
        }
        let offset = offset(&index, counter)?;
        let is_fixed = way.iter().all(|step| match step {
            Projection::Index(index) => self.is_outside(block, &self.facts.index(index)),
            _ => true,
        });
        let (root, way) = self.facts.key(&Place { root: place.root, path: way.to_vec() });
        is_fixed.then_some((root, way, offset))
    }

    /// Whether an index is the same each time that a block runs.
    fn is_outside(&self, block: &Block, index: &TokenStream) -> bool {
        let is_outside = |var: VarId| self.vars[var].block != block.id && !self.vars[var].mutable;
        self.facts.uses(index).into_iter().all(is_outside)
    }
}

/// By how much an index differs from a counter.
fn offset(index: &TokenStream, counter: &Ident) -> Option<i64> {
    let is_counter = |expr: &Expr| matches!(expr, Expr::Path(path) if path.path.is_ident(counter));
    match syn::parse2::<Expr>(index.clone()).ok()? {
        Expr::Binary(sum) if is_counter(&sum.left) => {
            let Expr::Lit(literal) = &*sum.right else { return None };
            let Lit::Int(literal) = &literal.lit else { return None };
            let by: i64 = literal.base10_parse().ok()?;
            match sum.op {
                BinOp::Add(_) => Some(by),
                BinOp::Sub(_) => Some(-by),
                _ => None,
            }
        }
        expr => is_counter(&expr).then_some(0),
    }
}
