//! The order in which an iteration adds to neighbouring elements of an array.
//!
//! A loop that reads `x[i]` and `x[i + 1]` adds to the cotangents of both, and the reverse sweep counts
//! down: the next iteration adds to `x[i]` as its `x[i + 1]`. The compiler makes vector instructions of
//! that if what an iteration adds to first stands before what the one before it added to last, so the
//! elements come in the order of their indices, at the end of the iteration: twice as fast for
//! Rosenbrock's function.

use std::collections::HashMap;

use proc_macro2::{Ident, TokenStream};
use syn::{BinOp, Expr, ExprRange, Lit};

use super::Sweeper;
use crate::ir::{Block, Head, Loop, Operation, Place, Projection, Statement, VarId};

/// What tells the order: the array, the way to the elements, the place among its neighbours.
pub(super) type Position = (VarId, String, i64);

impl Sweeper<'_> {
    /// The variable of a loop that counts up.
    pub(super) fn counter(&self, a_loop: &Loop) -> Option<Ident> {
        match &a_loop.head {
            Head::For { iterator, defines, .. } => match &defines[..] {
                [counter] if syn::parse2::<ExprRange>(iterator.clone()).is_ok() => {
                    Some(self.vars[*counter].ident.clone())
                }
                _ => None,
            },
            _ => None,
        }
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

    /// The place of an element among its neighbours, in an array from outside that stays as it is.
    fn position(&self, block: &Block, place: &Place) -> Option<Position> {
        let Some(Some(counter)) = self.counters.last() else { return None };
        let root = &self.vars[place.root];
        if root.block == block.id || root.mutable || root.exclusive {
            return None;
        }
        let (Projection::Index(index), way) = place.path.split_last()? else { return None };
        let offset = offset(&self.facts.index(index), counter)?;
        let way = Place { root: place.root, path: way.to_vec() };
        let (root, way) = self.facts.key(&way);
        Some((root, way, offset))
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
