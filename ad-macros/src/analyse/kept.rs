//! Tells which variables the ways from a fork keep (see [`Keep`]).
//!
//! Lowering notes where ways begin and end. A way keeps a variable that may be used after it, if another way
//! of the same fork does not, and may have moved it: what is used later has its value there, or the compiler
//! would have refused the function itself. So live variables are looked for (as in
//! [`uses`](super::uses), Aho, Lam, Sethi and Ullman, "Compilers", 9.2.5), with each jump led to where
//! it arrives. Nothing is kept of what certainly is `Copy`.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};

use super::numbers::Numbers;
use crate::ir::primal::Primal;
use crate::ir::{
    Action, Argument, Binding, Block, BranchKind, BuildSource, Head, Keep, Kept, Loop, Operand,
    Operation, Place, Projection, Statement, Target, Var, VarId, Way,
};
use crate::lower::Lowered;
use crate::names::Names;
use crate::parse::signature::Parameter;

/// Gives the ways what they keep, and takes away the notes of those that keep nothing.
pub fn fill(lowered: &mut Lowered, parameters: &[Parameter], names: &mut Names) {
    let kept = {
        let numbers = Numbers::new(lowered, parameters);
        let references: HashSet<VarId> = lowered.references.iter().map(|(var, _)| *var).collect();
        let vars = &lowered.vars;
        let movable = (0..vars.len()).filter(|&var| {
            let Var { ref ident, exclusive, reference, is_function, active, mutable, .. } =
                vars[var];
            let may_move = match active {
                true => !numbers.is_copy(var),
                false => lowered.movable.contains(&var),
            };
            // What has another value from here on is another variable, which `self` cannot be.
            let can_begin = mutable || ident != "self";
            let is_lent = exclusive || reference || references.contains(&var);
            may_move && can_begin && !is_lent && !is_function
        });
        let movable = movable.map(|var| (vars[var].ident.to_string(), var)).collect();
        let mut ways = Ways::new(vars, &numbers, movable);
        ways.block(&lowered.body, &mut BTreeSet::new());
        let parameters = lowered.parameters.iter().map(|parameter| parameter.var);
        ways.look_for_moves(&lowered.body, parameters.collect());
        ways.kept(names)
    };
    write(&mut lowered.body, &kept, names);
}

/// The slots of the forks, and the variables that each way keeps.
#[derive(Default)]
struct Slots {
    forks: HashMap<usize, BTreeMap<VarId, Ident>>,
    ways: HashMap<Way, BTreeSet<VarId>>,
}

/// Writes what is kept down in a block.
fn write(block: &mut Block, slots: &Slots, names: &mut Names) {
    for statement in &mut block.statements {
        match statement {
            Statement::Keep(Keep { action, way, kept }) => {
                let all = slots.forks.get(&way.fork).into_iter().flatten();
                let is_kept = |var: &VarId| {
                    *action == Action::Declare
                        || slots.ways.get(way).is_some_and(|vars| vars.contains(var))
                };
                kept.extend(all.filter(|(var, _)| is_kept(var)).map(|(&var, slot)| {
                    let slot = slot.clone();
                    Kept { var, slot }
                }));
            }
            Statement::Define { operation: Operation::Closure(closure), .. } => {
                fill(&mut closure.function, &closure.parameters, names);
            }
            statement => {
                statement.blocks_mut().into_iter().for_each(|block| write(block, slots, names));
            }
        }
    }
    let is_empty =
        |statement: &Statement| matches!(statement, Statement::Keep(keep) if keep.kept.is_empty());
    block.statements.retain(|statement| !is_empty(statement));
}

/// What the ways of a function find.
struct Ways<'a> {
    vars: &'a [Var],
    numbers: &'a Numbers<'a>,
    /// The variables that may move, by their names.
    movable: HashMap<String, VarId>,
    /// What is live where ways arrive.
    arrivals: HashMap<Way, BTreeSet<VarId>>,
    /// The ways that are gone.
    gone: HashSet<Way>,
    /// What is moved on the ways of a fork, and whether that is certain.
    moved: HashMap<usize, BTreeMap<VarId, bool>>,
}

impl<'a> Ways<'a> {
    fn new(vars: &'a [Var], numbers: &'a Numbers<'a>, movable: HashMap<String, VarId>) -> Self {
        Self {
            vars,
            numbers,
            movable,
            arrivals: HashMap::new(),
            gone: HashSet::new(),
            moved: HashMap::new(),
        }
    }

    /// What the ways keep.
    fn kept(&self, names: &mut Names) -> Slots {
        let mut slots = Slots::default();
        let mut forks: Vec<_> = self.moved.iter().collect();
        forks.sort_by_key(|(fork, _)| **fork);
        for (&fork, moved) in forks {
            let is_live = |way: &Way, var: &VarId| {
                self.arrivals.get(way).is_some_and(|live| live.contains(var))
            };
            let of_fork = |way: &&Way| way.fork == fork;
            for (&var, &is_certain) in moved {
                let Var { ident, mutable, .. } = &self.vars[var];
                // What never changes the reverse sweep may name, if it is `Copy`.
                let may_move = *mutable || is_certain;
                let differs = self.gone.iter().filter(of_fork).any(|way| !is_live(way, &var))
                    && self.gone.iter().filter(of_fork).any(|way| is_live(way, &var));
                if may_move && differs {
                    let slot = names.fresh(&format!("{ident}_kept"), ident.span());
                    slots.forks.entry(fork).or_default().insert(var, slot);
                    for way in self.arrivals.keys().filter(of_fork).filter(|way| is_live(way, &var))
                    {
                        slots.ways.entry(*way).or_default().insert(var);
                    }
                }
            }
        }
        slots
    }

    /// Goes back from the end of a block to its start.
    fn block(&mut self, block: &Block, live: &mut BTreeSet<VarId>) {
        let value = self.named(Primal(self.vars).tokens(&block.value));
        live.extend(&value);
        for (index, statement) in block.statements.iter().enumerate().rev() {
            match statement {
                Statement::Keep(Keep { action: Action::Restore, way, .. }) => {
                    self.arrivals.entry(*way).or_default().extend(live.iter());
                }
                Statement::Keep(Keep { action: Action::Store, way, .. }) => {
                    if index + 1 == block.statements.len() {
                        self.gone.insert(*way);
                        *live = self.arrivals.get(way).cloned().unwrap_or_default();
                        live.extend(&value);
                    }
                }
                _ => self.statement(statement, live),
            }
        }
    }

    fn statement(&mut self, statement: &Statement, live: &mut BTreeSet<VarId>) {
        match statement {
            Statement::Keep(_) => {}
            Statement::Define { var, operation, .. } => {
                live.remove(var);
                live.extend(self.used_by(operation));
            }
            Statement::Plain { code, defines } => {
                defines.iter().for_each(|var| _ = live.remove(var));
                self.code(code, live);
            }
            Statement::Destructure { source, bindings, .. } => {
                self.bound(bindings, live);
                live.extend(self.of_place(source));
            }
            Statement::Assign { place, value } => {
                match place.path.is_empty() {
                    true => _ = live.remove(&place.root),
                    false => live.extend(self.of_place(place)),
                }
                live.extend(self.named(Primal(self.vars).tokens(value)));
            }
            Statement::Update { place, value, .. } => {
                live.extend(self.of_place(place));
                live.extend(self.movable_var(*value));
            }
            Statement::Branch(branch) => {
                branch.result.iter().for_each(|result| _ = live.remove(result));
                let mut before = BTreeSet::new();
                for arm in &branch.arms {
                    let mut within = live.clone();
                    self.block(&arm.body, &mut within);
                    self.bound(&arm.bindings, &mut within);
                    before.extend(within);
                    before.extend(arm.guard.iter().flat_map(|guard| self.named(guard.clone())));
                }
                let (BranchKind::If(chooses) | BranchKind::Match(chooses, _)) = &branch.kind;
                before.extend(self.named(chooses.clone()));
                *live = before;
            }
            Statement::Loop(a_loop) => self.a_loop(a_loop, live),
            Statement::Build(build) => {
                live.remove(&build.result);
                self.iterations(&build.body, live);
                live.extend(match &build.source {
                    BuildSource::Index { like, .. } => {
                        like.iter().flat_map(|like| self.named(like.clone())).collect()
                    }
                    BuildSource::Items { iterator, .. } => self.named(iterator.clone()),
                });
            }
        }
    }

    fn a_loop(&mut self, a_loop: &Loop, live: &mut BTreeSet<VarId>) {
        let Loop { head, body, result, natural_end, .. } = a_loop;
        result.iter().for_each(|result| _ = live.remove(result));
        let ended = self.named(natural_end.clone());
        // Where a loop may end by itself, the way to the next iteration leads there too.
        let condition = match head {
            Head::While(condition) => Some(self.named(condition.clone())),
            Head::For { .. } => Some(Vec::new()),
            Head::Loop => None,
        };
        if let Some(Statement::Keep(Keep { way: next, .. })) = body.statements.first()
            && let (Some(Target::Again(own)), Some(condition)) = (next.target, &condition)
        {
            let own = Way { target: Some(Target::Leave(own)), ..*next };
            let found = self.arrivals.get(&own).cloned().unwrap_or_default();
            let next = self.arrivals.entry(*next).or_default();
            next.extend(found.iter().chain(&ended).chain(condition));
        }
        let mut before = live.clone();
        self.iterations(body, &mut before);
        match condition {
            Some(condition) => live.extend(before.into_iter().chain(ended).chain(condition)),
            None => *live = before,
        }
        if let Head::For { iterator, .. } = head {
            live.extend(self.named(iterator.clone()));
        }
    }

    /// Goes back over the iterations of a body.
    fn iterations(&mut self, body: &Block, live: &mut BTreeSet<VarId>) {
        // The second time what an iteration uses that follows is known.
        for _ in 0..2 {
            let mut within = live.clone();
            self.block(body, &mut within);
            live.extend(within);
        }
    }

    fn bound(&self, bindings: &[Binding], live: &mut BTreeSet<VarId>) {
        bindings.iter().for_each(|binding| _ = live.remove(&binding.var));
    }

    fn movable_var(&self, var: VarId) -> Option<VarId> {
        self.movable.get(&self.vars[var].ident.to_string()).copied()
    }

    /// The variables that code names.
    fn named(&self, code: TokenStream) -> Vec<VarId> {
        self.mentions(code).into_iter().map(|(var, _)| var).collect()
    }

    /// The same, and whether they are named as a whole where nothing refers to them.
    fn mentions(&self, code: TokenStream) -> Vec<(VarId, bool)> {
        let mut found = Vec::new();
        // The signs before a token, as far as they tell what it is.
        let mut before = String::new();
        let mut tokens = code.into_iter().peekable();
        while let Some(token) = tokens.next() {
            let next = tokens.peek();
            before = match token {
                TokenTree::Ident(name) if name == "mut" => before,
                TokenTree::Ident(name) => {
                    let is_called = matches!(next, Some(TokenTree::Group(group))
                        if group.delimiter() == Delimiter::Parenthesis);
                    let is_part = ["::", "."].iter().any(|sign| before.ends_with(sign))
                        && !before.ends_with("..");
                    let is_whole = match next {
                        Some(TokenTree::Punct(next)) => next.as_char() != '.',
                        Some(TokenTree::Group(_)) => false,
                        _ => true,
                    };
                    let var = self.movable.get(&name.to_string()).copied();
                    let var = var.filter(|_| !is_called && !is_part);
                    found.extend(var.map(|var| (var, is_whole && !before.ends_with('&'))));
                    String::new()
                }
                TokenTree::Punct(sign) => before + &sign.as_char().to_string(),
                TokenTree::Group(group) => {
                    found.extend(self.mentions(group.stream()));
                    String::new()
                }
                TokenTree::Literal(_) => String::new(),
            };
        }
        found
    }

    fn of_place(&self, place: &Place) -> Vec<VarId> {
        self.named(Primal(self.vars).place(place))
    }

    /// Goes back over code without derivative.
    fn code(&self, code: &TokenStream, live: &mut BTreeSet<VarId>) {
        match assignment(code) {
            Some((target, value)) => {
                self.movable.get(&target).into_iter().for_each(|var| _ = live.remove(var));
                live.extend(self.named(value));
            }
            None => live.extend(self.named(code.clone())),
        }
    }

    fn used_by(&self, operation: &Operation) -> Vec<VarId> {
        match operation {
            Operation::Closure(closure) => {
                let captures = closure.captures.iter();
                captures.flat_map(|(copy, _)| self.named(copy.clone())).collect()
            }
            Operation::Call { arguments, .. } => {
                let arguments = arguments.iter().map(|it| Primal(self.vars).argument(it));
                arguments.flat_map(|argument| self.named(argument)).collect()
            }
            operation => self.named(Primal(self.vars).operation(operation, Span::call_site())),
        }
    }

    /// Finds what is moved on the ways of the forks of a block, of the variables of these names and those
    /// that the block defines before.
    fn look_for_moves(&mut self, block: &Block, mut known: BTreeSet<VarId>) {
        let mut open = Vec::new();
        for statement in &block.statements {
            match statement {
                Statement::Keep(Keep { action: Action::Declare, way, .. }) => open.push(way.fork),
                Statement::Branch(_) | Statement::Loop(_) => {
                    let mut moves = Moves::default();
                    moves.add_statement(self, statement);
                    moves.vars.retain(|var, _| known.contains(var));
                    for &fork in open.iter().filter(|&fork| moves.forks.contains(fork)) {
                        self.moved.insert(fork, moves.vars.clone());
                    }
                    open.retain(|fork| !moves.forks.contains(fork));
                }
                _ => {}
            }
            for (block, bindings) in blocks(statement) {
                let bound = bindings.iter().map(|binding| binding.var);
                self.look_for_moves(block, known.iter().copied().chain(bound).collect());
            }
            match statement {
                Statement::Define { var, .. } => _ = known.insert(*var),
                Statement::Plain { defines, .. } => known.extend(defines),
                Statement::Destructure { bindings, .. } => {
                    known.extend(bindings.iter().map(|binding| binding.var));
                }
                Statement::Branch(branch) => known.extend(branch.result),
                Statement::Loop(a_loop) => known.extend(a_loop.result),
                Statement::Build(build) => _ = known.insert(build.result),
                Statement::Assign { .. } | Statement::Update { .. } | Statement::Keep(_) => {}
            }
        }
    }
}

/// What is moved in some statements.
#[derive(Default)]
struct Moves {
    /// The variables, and whether it is certain that they are if they are not `Copy`.
    vars: BTreeMap<VarId, bool>,
    /// The forks of which a way begins in them.
    forks: HashSet<usize>,
}

impl Moves {
    fn add(&mut self, var: Option<VarId>, is_certain: bool) {
        if let Some(var) = var {
            *self.vars.entry(var).or_default() |= is_certain;
        }
    }

    fn add_statement(&mut self, ways: &Ways<'_>, statement: &Statement) {
        match statement {
            Statement::Define { var, operation, .. } => {
                let is_number = ways.numbers.is_copy(*var);
                self.add_operation(ways, operation, is_number);
            }
            Statement::Plain { code, .. } => self.add_code(ways, code),
            Statement::Destructure { source, .. } => self.add_place(ways, source, false),
            Statement::Assign { value, .. } => self.add_operand(ways, value),
            Statement::Branch(branch) => {
                if let BranchKind::Match(code, source) = &branch.kind {
                    match source {
                        Some(source) => self.add_place(ways, source, false),
                        None => self.add_code(ways, code),
                    }
                }
            }
            Statement::Keep(Keep { action: Action::Store, way, .. }) => {
                _ = self.forks.insert(way.fork)
            }
            Statement::Loop(Loop { head: Head::For { iterator, .. }, .. }) => {
                self.add_code(ways, iterator);
            }
            Statement::Keep(_)
            | Statement::Update { .. }
            | Statement::Loop(_)
            | Statement::Build(_) => {}
        }
        for (block, _) in blocks(statement) {
            block.statements.iter().for_each(|statement| self.add_statement(ways, statement));
            self.add_operand(ways, &block.value);
        }
    }

    fn add_operand(&mut self, ways: &Ways<'_>, operand: &Operand) {
        match operand {
            Operand::Var(var) => self.add(ways.movable_var(*var), true),
            Operand::Constant(code) => self.add_code(ways, code),
        }
    }

    /// Of a part that moves the rest stays.
    fn add_place(&mut self, ways: &Ways<'_>, place: &Place, is_copy: bool) {
        let is_field =
            |step: &Projection| matches!(step, Projection::Field(_) | Projection::FromEnd(_));
        if !is_copy && place.path.iter().all(is_field) {
            self.add(ways.movable_var(place.root), place.path.is_empty());
        }
    }

    fn add_operation(&mut self, ways: &Ways<'_>, operation: &Operation, is_copy: bool) {
        match operation {
            Operation::Use(value) => self.add_operand(ways, value),
            Operation::Read(place) | Operation::Clone(place, _) => {
                self.add_place(ways, place, is_copy)
            }
            Operation::Call { arguments, .. } => {
                for argument in arguments {
                    match argument {
                        Argument::Value(value) => self.add_operand(ways, value),
                        // It may be taken by value.
                        Argument::Receiver(place) if place.path.is_empty() => {
                            self.add(ways.movable_var(place.root), false);
                        }
                        _ => {}
                    }
                }
            }
            Operation::Aggregate { parts, .. } => {
                parts.iter().for_each(|(_, part)| self.add_operand(ways, part));
            }
            Operation::UpdateStruct { parts, rest, .. } => {
                parts.iter().for_each(|(_, part)| self.add_operand(ways, part));
                self.add_place(ways, rest, false);
            }
            Operation::Repeat { value, .. } => self.add(ways.movable_var(*value), true),
            Operation::Value(_)
            | Operation::Borrow(_)
            | Operation::Negate(_)
            | Operation::Binary(..)
            | Operation::Cast(..)
            | Operation::Closure(_)
            | Operation::Named { .. } => {}
        }
    }

    fn add_code(&mut self, ways: &Ways<'_>, code: &TokenStream) {
        let mentions = ways.mentions(code.clone()).into_iter();
        mentions.filter(|(_, is_whole)| *is_whole).for_each(|(var, _)| self.add(Some(var), true));
    }
}

/// The name and the value in `name = value;`.
fn assignment(code: &TokenStream) -> Option<(String, TokenStream)> {
    match syn::parse2(code.clone()) {
        Ok(syn::Stmt::Expr(syn::Expr::Assign(assign), _)) => match &*assign.left {
            syn::Expr::Path(path) => {
                let value = &assign.right;
                Some((path.path.get_ident()?.to_string(), quote::quote!(#value)))
            }
            _ => None,
        },
        _ => None,
    }
}

/// The blocks in a statement, and what binds variables in them.
fn blocks(statement: &Statement) -> impl Iterator<Item = (&Block, &[Binding])> {
    let (arms, body) = match statement {
        Statement::Branch(branch) => (&branch.arms[..], None),
        Statement::Loop(a_loop) => (&[][..], Some(&a_loop.body)),
        Statement::Build(build) => (&[][..], Some(&build.body)),
        _ => (&[][..], None),
    };
    let arms = arms.iter().map(|arm| (&arm.body, &arm.bindings[..]));
    arms.chain(body.map(|body| (body, &[][..])))
}
