//! What an iteration has to save.
//!
//! All that the reverse sweep of a loop body names would have to go on the tape; but most of it is
//! cheap to compute again from little: the stages of a Runge-Kutta step from the state before it,
//! the elements of arrays from their indices, indices from the loop variable. The least that has to
//! be saved is a minimum vertex cut ([`cut`](crate::analyse::cut)) between what cannot be computed again
//! (results of calls and divisions, variables before they are overwritten) and what the reverse
//! sweep names. Constants move out of the loop, and so do the zero-sized witnesses of types, so that
//! a loop from which nothing is saved needs no tape. Which way a branch went is computed again, too, where
//! its arms save nothing and what chooses between them is cheap.
//!
//! Turned down: saving everything (an inner loop then moves more memory than it computes: the
//! classic mistake); recomputing everything from the start of the iteration (calls would run twice,
//! nested calls four times). The cut counts values, since the macro does not know their sizes, and
//! takes arithmetic to be free next to memory.
//!
//! Outside of loops nothing is computed again: there the values are few, and stay in registers when
//! the pullback is inlined.

use std::collections::{HashMap, HashSet};

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::quote;

use super::{Sweeper, Written};
use crate::analyse::cut::Graph;
use crate::analyse::facts::is_element;
use crate::ir::primal::project;
use crate::ir::{
    Argument, BinaryOperator, Block, Head, Loop, Operand, Operation, Place, Projection, Statement,
    VarId,
};
use crate::names;

/// Methods that cost no more than a few multiplications.
const CHEAP_METHODS: &str = "\
    abs clamp copysign cross distance_squared dot element_sum floor length_squared lerp max min \
    mul_add reflect signum to_degrees to_radians x y z splat";

/// Methods whose pullback does not use their value.
const PULLED_BACK_WITHOUT_VALUE: &str = "acos asin atan cos ln sin";

/// A name that the forward sweep of a block defines.
struct Definition {
    name: Ident,
    /// How to define it again, and the variables that this names; `None` if it has to be saved.
    again: Option<(TokenStream, Vec<Ident>)>,
}

impl Sweeper<'_> {
    /// Lets the reverse sweep of a block compute again what it can, so that less is saved.
    pub(super) fn recompute(
        &mut self,
        block: &Block,
        earlier: &HashMap<VarId, VarId>,
        written: &mut Written,
    ) {
        let definitions = self.definitions(block, earlier, written);
        let mut needed = HashSet::new();
        names::collect_variables(written.reverse.clone(), &mut needed);

        let mut graph = Graph::default();
        let mut indices = HashMap::new();
        for definition in &definitions {
            let name = definition.name.to_string();
            let parents = definition.again.as_ref().map(|(_, uses)| {
                let uses = uses.iter().filter_map(|name| indices.get(&name.to_string()).copied());
                uses.collect()
            });
            let index = graph.add(parents, needed.contains(&name));
            indices.insert(name, index);
        }
        let stored = graph.stored();

        // From the end to the start: what comes later may name what comes before.
        let mut prelude = Vec::new();
        let mut recomputed = HashSet::new();
        for (definition, stored) in definitions.iter().zip(stored).rev() {
            let name = definition.name.to_string();
            let Some((tokens, uses)) = definition.again.as_ref().filter(|_| !stored) else {
                continue;
            };
            if needed.contains(&name) {
                needed.extend(uses.iter().map(Ident::to_string));
                prelude.push(tokens.clone());
                recomputed.insert(name);
            }
        }
        let prelude: TokenStream = prelude.into_iter().rev().collect();
        let reverse = &written.reverse;
        written.reverse = quote!(#prelude #reverse);
        written.defines.retain(|name| !recomputed.contains(&name.to_string()));
    }

    /// What the block defines, in order.
    fn definitions(
        &mut self,
        block: &Block,
        earlier: &HashMap<VarId, VarId>,
        written: &Written,
    ) -> Vec<Definition> {
        let mut again = HashMap::new();
        for statement in &block.statements {
            if let Statement::Define { var, ty, operation } = statement {
                let value = match earlier.get(var).map(|&earlier| self.ident(earlier).clone()) {
                    Some(earlier) => Some((quote!(#earlier), vec![earlier])),
                    None => self.value_again(operation),
                };
                let ident = &self.vars[*var].ident;
                if let Some((value, uses)) = value.filter(|_| !self.vars[*var].mutable) {
                    let ty = ty.as_ref().map(|ty| quote!(: #ty));
                    again.insert(ident.to_string(), (quote!(let #ident #ty = #value;), uses));
                }
                if let Some((pair, uses)) = self.pullback_again(operation) {
                    let record = &self.vars[*var].record;
                    again.insert(record.to_string(), (quote!(let (_, #record) = #pair;), uses));
                }
            }
            if let Statement::Plain { defines, .. } = statement {
                for &var in defines {
                    if let Some(code) = self.facts.member(var).cloned()
                        && !self.facts.names_sequence(&code)
                    {
                        let (code, uses) = self.code_again(&code);
                        let ident = &self.vars[var].ident;
                        again.insert(ident.to_string(), (quote!(let #ident = #code;), uses));
                    }
                }
            }
            if let Statement::Branch(branch) = statement {
                let record = &branch.record;
                if let Some(path) = self.paths.get(&record.to_string()).cloned() {
                    let (path, uses) = self.code_again(&path);
                    again.insert(record.to_string(), (quote!(let #record = #path;), uses));
                }
            }
            if let Statement::Loop(Loop { head: Head::For { iterator, .. }, record, .. }) =
                statement
                && let Some(range) = self.ranges.get(&record.to_string()).cloned()
                && !self.facts.names_sequence(iterator)
            {
                let (iterator, uses) = self.code_again(iterator);
                again.insert(range.to_string(), (quote!(let #range = #iterator;), uses));
            }
        }
        let defines = written.defines.iter();
        defines
            .map(|name| Definition { name: name.clone(), again: again.remove(&name.to_string()) })
            .collect()
    }

    /// A cheap operation, and the variables that it names.
    fn value_again(&mut self, operation: &Operation) -> Option<(TokenStream, Vec<Ident>)> {
        match operation {
            Operation::Use(Operand::Constant(tokens)) => {
                self.facts.is_cheap(tokens).then(|| self.code_again(tokens))
            }
            Operation::Use(Operand::Var(source)) => {
                let ident = self.vars[*source].ident.clone();
                self.facts.is_number(*source).then(|| (quote!(#ident), vec![ident]))
            }
            Operation::Read(place) => self.read_again(place),
            Operation::Negate(value) | Operation::Cast(value, _) => {
                Some((self.primal(operation, self.span(*value)), self.idents(&[*value])))
            }
            Operation::Binary(operator, left, right) => {
                let is_cheap = !matches!(operator, BinaryOperator::Div | BinaryOperator::Rem);
                is_cheap.then(|| {
                    let again = self.primal(operation, self.span(*left));
                    (again, self.idents(&[*left, *right]))
                })
            }
            Operation::Call { callee, arguments } => {
                let method = callee.method_name()?.to_string();
                let is_cheap = names::is_in(CHEAP_METHODS, &method);
                let operands = self.operands(arguments).filter(|_| is_cheap)?;
                Some((self.primal(operation, self.span(operands[0])), self.idents(&operands)))
            }
            _ => None,
        }
    }

    /// A call of a cheap method's sibling, and the variables that it names.
    fn pullback_again(&self, operation: &Operation) -> Option<(TokenStream, Vec<Ident>)> {
        let Operation::Call { callee, arguments } = operation else { return None };
        let name = callee.method_name()?.to_string();
        let is_cheap =
            names::is_in(CHEAP_METHODS, &name) || names::is_in(PULLED_BACK_WITHOUT_VALUE, &name);
        let operands = self.operands(arguments).filter(|_| is_cheap)?;
        Some((self.call(&callee.derivative.vjp(), true, arguments), self.idents(&operands)))
    }

    /// The operands of a call, if they are numbers.
    fn operands(&self, arguments: &[Argument]) -> Option<Vec<VarId>> {
        let operand = |argument: &Argument| match argument {
            Argument::Value(Operand::Var(var)) => Some(*var),
            Argument::Receiver(place) if place.path.is_empty() => Some(place.root),
            _ => None,
        };
        let operands: Option<Vec<_>> = arguments.iter().map(operand).collect();
        operands.filter(|operands| operands.iter().all(|&var| self.facts.is_number(var)))
    }

    /// An element of an array that still is what it was.
    fn read_again(&mut self, place: &Place) -> Option<(TokenStream, Vec<Ident>)> {
        let by_reference = self.facts.array(place.root)?;
        if !is_element(&place.path) || !self.keeps_its_value(place.root) {
            return None;
        }
        let root = match by_reference {
            true => self.kept_copy(place.root),
            false => self.vars[place.root].ident.clone(),
        };
        let mut uses = vec![root.clone()];
        for step in &place.path {
            if let Projection::Index(index) = step {
                uses.extend(self.idents(&self.facts.uses(index)));
            }
        }
        let path: Vec<_> = place.path.iter().filter(|step| step.is_part()).cloned().collect();
        Some((project(quote!(#root), &path), uses))
    }

    /// Whether the reverse sweep finds a variable as it was when the statement being written read it.
    fn keeps_its_value(&self, var: VarId) -> bool {
        let Some(frame) = self.frames.iter().find(|frame| frame.block == self.vars[var].block)
        else {
            return false;
        };
        !self.vars[var].mutable || !frame.assigned_later.contains(&var)
    }

    /// Code without derivative in the reverse sweep, and the variables that it names.
    fn code_again(&mut self, code: &TokenStream) -> (TokenStream, Vec<Ident>) {
        let code = self.with_kept_copies(code.clone());
        let uses = self.facts.uses(&code);
        let idents = self.idents(&uses);
        (code, idents)
    }

    /// Names the copies of arrays behind references.
    fn with_kept_copies(&mut self, code: TokenStream) -> TokenStream {
        let mut after_dot = false;
        let mut renamed = Vec::new();
        for token in code {
            let is_dot = matches!(&token, TokenTree::Punct(punct) if punct.as_char() == '.');
            renamed.push(match token {
                TokenTree::Group(group) => {
                    let inner = self.with_kept_copies(group.stream());
                    let mut renamed = proc_macro2::Group::new(group.delimiter(), inner);
                    renamed.set_span(group.span());
                    TokenTree::Group(renamed)
                }
                TokenTree::Ident(name) if !after_dot => match self.facts.named(&name) {
                    Some(var) if self.facts.array(var) == Some(true) => {
                        TokenTree::Ident(self.kept_copy(var))
                    }
                    _ => TokenTree::Ident(name),
                },
                other => other,
            });
            // `a.b` names a part of `a`, `a..b` names `b`.
            after_dot = is_dot && !after_dot;
        }
        renamed.into_iter().collect()
    }

    /// The copy that the pullback keeps of an array that the function has by reference.
    fn kept_copy(&mut self, var: VarId) -> Ident {
        let ident = &self.vars[var].ident;
        if let Some(kept) = self.kept_copies.get(&var) {
            return kept.clone();
        }
        let kept = self.names.fresh(&format!("{ident}_kept"), ident.span());
        self.top.extend(quote!(let #kept = *#ident;));
        self.kept_copies.insert(var, kept.clone());
        kept
    }

    fn idents(&self, vars: &[VarId]) -> Vec<Ident> {
        vars.iter().map(|&var| self.vars[var].ident.clone()).collect()
    }

    pub(super) fn span(&self, var: VarId) -> proc_macro2::Span {
        self.vars[var].ident.span()
    }
}
