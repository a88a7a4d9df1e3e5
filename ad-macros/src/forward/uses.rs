//! Where values are used last, so that their tangents may be moved instead of copied: a variable may live
//! on, if it is assigned to before it is used again, in this iteration of a loop or the next.
//!
//! The analysis is that of live variables (Aho, Lam, Sethi and Ullman, "Compilers", 9.2.5), backwards over the
//! blocks, in loops twice. A variable that may be a reference keeps alive what it may refer to: what is
//! borrowed does not move, and the value of a `Copy` type may go on to be borrowed.

use std::collections::{BTreeSet, HashMap, HashSet};

use crate::ir::{
    Action, Argument, Block, BlockId, BranchKind, Keep, Operand, Operation, Place, Statement, Var,
    VarId,
};
use crate::lower::Lowered;
use crate::numbers::Numbers;

/// Where values end.
#[derive(Default)]
pub struct Uses {
    /// For each statement the variables that it uses, once, and no other after it.
    statements: HashMap<usize, HashSet<VarId>>,
    /// The block of each statement.
    blocks: HashMap<usize, BlockId>,
    /// The blocks whose value is a variable that is not used after the block.
    values: HashSet<BlockId>,
    /// The arms that bind parts of a place which neither they nor anything after the branch uses.
    arms: HashSet<BlockId>,
}

impl Uses {
    /// Looks through a function.
    pub fn of(lowered: &Lowered, numbers: &Numbers<'_>) -> Self {
        let lenders = vec![BTreeSet::new(); lowered.vars.len()];
        let vars = &lowered.vars;
        let borrowers = vec![Vec::new(); vars.len()];
        let mut liveness = Liveness { vars, numbers, lenders, borrowers, ends: Self::default() };
        // A reference may be assigned to a variable before what it refers to is.
        while liveness.refer(&lowered.body) {}
        for (var, lenders) in liveness.lenders.iter().enumerate() {
            lenders.iter().for_each(|&lender| liveness.borrowers[lender].push(var));
        }
        liveness.block(&lowered.body, 1, &mut BTreeSet::new());
        liveness.ends
    }

    /// Whether statement number `position` uses the value of a variable, and nothing after it does.
    pub fn end_with(&self, var: VarId, position: usize) -> bool {
        self.statements.get(&position).is_some_and(|vars| vars.contains(&var))
    }

    /// The same of a variable that lives in the block of the statement.
    pub fn end_at_home(&self, var: VarId, block: BlockId, position: usize) -> bool {
        self.end_with(var, position) && self.blocks.get(&position) == Some(&block)
    }

    /// Whether nothing uses the value of a variable after a block of which it is the value.
    pub fn end_as_value(&self, block: BlockId) -> bool {
        self.values.contains(&block)
    }

    /// Whether nothing uses the matched value but what the pattern of an arm with this body binds.
    pub fn end_in_arm(&self, body: BlockId) -> bool {
        self.arms.contains(&body)
    }
}

/// Follows values backwards from where they are used to where they are assigned.
struct Liveness<'a> {
    vars: &'a [Var],
    numbers: &'a Numbers<'a>,
    /// For each variable those that it may refer to.
    lenders: Vec<BTreeSet<VarId>>,
    /// For each variable those that may refer to it.
    borrowers: Vec<Vec<VarId>>,
    ends: Uses,
}

impl Liveness<'_> {
    /// Whether a value is used that a variable has or lends.
    fn is_used(&self, var: VarId, live: &BTreeSet<VarId>) -> bool {
        live.contains(&var) || self.borrowers[var].iter().any(|of| live.contains(of))
    }

    /// Notes what may refer to what; says whether anything is new.
    fn refer(&mut self, block: &Block) -> bool {
        let mut is_new = false;
        for statement in &block.statements {
            let defined: Vec<VarId> = match statement {
                Statement::Define { var, .. } => vec![*var],
                Statement::Assign { place, .. } => vec![place.root],
                Statement::Destructure { bindings, .. } => {
                    bindings.iter().map(|binding| binding.var).collect()
                }
                Statement::Branch(branch) => {
                    let bindings = branch.arms.iter().flat_map(|arm| &arm.bindings);
                    branch.result.into_iter().chain(bindings.map(|binding| binding.var)).collect()
                }
                Statement::Loop(a_loop) => a_loop.result.into_iter().collect(),
                Statement::Build(build) => vec![build.result],
                Statement::Plain { .. } | Statement::Update { .. } | Statement::Keep(_) => continue,
            };
            let inner = blocks(statement);
            for block in &inner {
                is_new |= self.refer(block);
            }
            let values = inner.iter().flat_map(|block| operand(&block.value));
            let moved = used(statement).into_iter().chain(values);
            let inherited: BTreeSet<VarId> =
                moved.flat_map(|var| self.lenders[var].iter().copied()).collect();
            let takes_apart =
                matches!(statement, Statement::Destructure { .. } | Statement::Branch(_));
            let may_refer = |var: &VarId| self.numbers.number(*var).is_none();
            for var in defined.into_iter().filter(may_refer) {
                let before = self.lenders[var].len();
                // What a pattern binds by value refers to nothing that it was a part of.
                let lent = match takes_apart && !self.vars[var].reference {
                    true => Vec::new(),
                    false => lent(statement),
                };
                let lenders = inherited.iter().copied().chain(lent);
                self.lenders[var].extend(lenders.filter(|&lender| lender != var));
                is_new |= self.lenders[var].len() > before;
            }
        }
        is_new
    }

    /// Goes back from the end of a block, whose first statement has this number, to its start.
    fn block(&mut self, block: &Block, first: usize, live: &mut BTreeSet<VarId>) {
        if let Operand::Var(value) = block.value {
            match self.is_used(value, live) {
                true => self.ends.values.remove(&block.id),
                false => self.ends.values.insert(block.id),
            };
            live.insert(value);
        }
        let mut position = first;
        let numbered = block.statements.iter().map(|statement| {
            let own = position;
            position += count(statement);
            (own, statement)
        });
        for (position, statement) in numbered.collect::<Vec<_>>().into_iter().rev() {
            self.ends.blocks.insert(position, block.id);
            self.statement(statement, position, live);
        }
    }

    fn statement(&mut self, statement: &Statement, position: usize, live: &mut BTreeSet<VarId>) {
        match statement {
            Statement::Define { var, .. } => {
                live.remove(var);
            }
            Statement::Assign { place, .. } if place.path.is_empty() => {
                live.remove(&place.root);
            }
            Statement::Destructure { bindings, .. } => {
                bindings.iter().for_each(|binding| _ = live.remove(&binding.var));
            }
            Statement::Keep(Keep { action: Action::Restore, kept, .. }) => {
                kept.iter().for_each(|kept| _ = live.remove(&kept.var));
            }
            _ => {}
        }
        let used = used(statement);
        match statement {
            Statement::Branch(branch) => {
                branch.result.iter().for_each(|result| _ = live.remove(result));
                let mut first = position + 1;
                let mut before = BTreeSet::new();
                for arm in &branch.arms {
                    let mut within = live.clone();
                    self.block(&arm.body, first, &mut within);
                    arm.bindings.iter().for_each(|binding| _ = within.remove(&binding.var));
                    match branch.source().is_some_and(|place| !self.is_used(place.root, &within)) {
                        true => self.ends.arms.insert(arm.body.id),
                        false => self.ends.arms.remove(&arm.body.id),
                    };
                    before.extend(within);
                    first += length(&arm.body);
                }
                *live = before;
            }
            Statement::Loop(_) | Statement::Build(_) => {
                for body in blocks(statement) {
                    // The second time what an iteration uses that follows is known.
                    for _ in 0..2 {
                        let mut within = live.clone();
                        self.block(body, position + 1, &mut within);
                        live.extend(within);
                    }
                }
            }
            _ => {
                let ends = |var: &VarId| {
                    used.iter().filter(|other| *other == var).count() == 1
                        && !self.is_used(*var, live)
                };
                let ending = used.iter().copied().filter(ends).collect();
                self.ends.statements.insert(position, ending);
            }
        }
        if let Statement::Assign { place, .. } = statement
            && !place.path.is_empty()
        {
            live.insert(place.root);
        }
        live.extend(used);
    }
}

/// The number of statements in a statement, with itself.
fn count(statement: &Statement) -> usize {
    1 + blocks(statement).into_iter().map(length).sum::<usize>()
}

fn length(block: &Block) -> usize {
    block.statements.iter().map(count).sum()
}

/// The blocks in a statement.
fn blocks(statement: &Statement) -> Vec<&Block> {
    match statement {
        Statement::Branch(branch) => branch.arms.iter().map(|arm| &arm.body).collect(),
        Statement::Loop(a_loop) => vec![&a_loop.body],
        Statement::Build(build) => vec![&build.body],
        _ => Vec::new(),
    }
}

fn operand(operand: &Operand) -> impl Iterator<Item = VarId> + use<> {
    match operand {
        Operand::Var(var) => Some(*var),
        Operand::Constant(_) => None,
    }
    .into_iter()
}

/// The variables that a statement itself uses, as often as it does; not that to which it assigns.
fn used(statement: &Statement) -> Vec<VarId> {
    match statement {
        Statement::Define { operation, .. } => used_by(operation),
        Statement::Destructure { source, .. } => vec![source.root],
        Statement::Assign { value, .. } => operand(value).collect(),
        Statement::Update { place, previous, value, .. } => vec![*previous, *value, place.root],
        Statement::Branch(branch) => match &branch.kind {
            BranchKind::Match(_, Some(Place { root, .. })) => vec![*root],
            _ => Vec::new(),
        },
        Statement::Keep(Keep { action: Action::Store, kept, .. }) => {
            kept.iter().map(|kept| kept.var).collect()
        }
        Statement::Plain { .. } | Statement::Loop(_) | Statement::Build(_) | Statement::Keep(_) => {
            Vec::new()
        }
    }
}

/// The variables to which what a statement defines may refer.
fn lent(statement: &Statement) -> Vec<VarId> {
    match statement {
        Statement::Define { operation: Operation::Borrow(place), .. } => vec![place.root],
        Statement::Define { operation: operation @ Operation::Closure(_), .. } => {
            used_by(operation)
        }
        Statement::Define { operation: Operation::Call { arguments, .. }, .. } => {
            arguments.iter().filter_map(lent_to_call).collect()
        }
        Statement::Destructure { .. } | Statement::Branch(_) => used(statement),
        _ => Vec::new(),
    }
}

/// The variable of which a call gets a reference.
fn lent_to_call(argument: &Argument) -> Option<VarId> {
    match argument {
        Argument::Borrow(place)
        | Argument::Exclusive(place)
        | Argument::Reborrow(place)
        | Argument::Receiver(place) => Some(place.root),
        Argument::Value(_)
        | Argument::Function(_)
        | Argument::Callee(_)
        | Argument::PassedOn(..) => None,
    }
}

fn used_by(operation: &Operation) -> Vec<VarId> {
    match operation {
        Operation::Use(value) => operand(value).collect(),
        Operation::Read(place) | Operation::Clone(place) | Operation::Borrow(place) => {
            vec![place.root]
        }
        Operation::Value(var) | Operation::Negate(var) | Operation::Cast(var, _) => vec![*var],
        Operation::Binary(_, left, right) => vec![*left, *right],
        Operation::Call { arguments, .. } => {
            let of_argument = |argument: &Argument| match argument {
                Argument::Value(value) => operand(value).next(),
                argument => lent_to_call(argument),
            };
            arguments.iter().filter_map(of_argument).collect()
        }
        Operation::Aggregate { parts, .. } => {
            parts.iter().flat_map(|(_, part)| operand(part)).collect()
        }
        Operation::UpdateStruct { parts, rest, .. } => {
            parts.iter().flat_map(|(_, part)| operand(part)).chain([rest.root]).collect()
        }
        Operation::Repeat { value, .. } => vec![*value],
        // What a closure captures it copies.
        Operation::Closure(closure) => {
            closure.captures.iter().map(|(_, place)| place.root).collect()
        }
        Operation::Named { .. } => Vec::new(),
    }
}
