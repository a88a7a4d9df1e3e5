//! Where tangents are used last, and may be moved instead of copied.

use std::collections::{BTreeSet, HashMap, HashSet};

use crate::ir::{
    Argument, Block, BlockId, BranchKind, Operand, Operation, Place, Statement, VarId,
};
use crate::lower::Lowered;

/// Identifies the innermost loop around a block; 0 is none.
type LoopId = usize;

/// How often, and where, variables are used.
pub struct Uses {
    counts: Vec<usize>,
    /// The number of the last statement that uses a variable.
    last: Vec<usize>,
    loops: HashMap<BlockId, LoopId>,
    ends: Ends,
}

/// Where values end, that of a variable which lives on among them: it is assigned to before it is used
/// again, in this iteration of a loop or the next.
#[derive(Default)]
struct Ends {
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
    pub fn of(lowered: &Lowered) -> Self {
        let count = lowered.vars.len();
        let uses = Self {
            counts: vec![0; count],
            last: vec![0; count],
            loops: HashMap::new(),
            ends: Liveness::of(lowered),
        };
        let mut walk = Walk { lowered, uses, position: 0, current: 0, loop_count: 0 };
        walk.block(&lowered.body);
        walk.uses
    }

    /// Whether the only use of a variable may take its tangent: it is not used in a loop that it
    /// does not live in.
    pub fn may_move(&self, var: VarId) -> bool {
        self.counts[var] <= 1
    }

    /// Whether nothing uses a variable after statement number `position`.
    pub fn ends(&self, var: VarId, position: usize) -> bool {
        self.last[var] <= position
    }

    /// Whether statement number `position` uses the value of a variable, and nothing after it does.
    pub fn ends_with(&self, var: VarId, position: usize) -> bool {
        self.ends.statements.get(&position).is_some_and(|vars| vars.contains(&var))
    }

    /// The same of a variable that lives in the block of the statement.
    pub fn ends_at_home(&self, var: VarId, block: BlockId, position: usize) -> bool {
        self.ends_with(var, position) && self.ends.blocks.get(&position) == Some(&block)
    }

    /// Whether nothing uses the value of a variable after a block of which it is the value.
    pub fn ends_as_value(&self, block: BlockId) -> bool {
        self.ends.values.contains(&block)
    }

    /// Whether nothing uses the matched value but what the pattern of an arm with this body binds.
    pub fn ends_in_arm(&self, body: BlockId) -> bool {
        self.ends.arms.contains(&body)
    }
}

struct Walk<'a> {
    lowered: &'a Lowered,
    uses: Uses,
    position: usize,
    current: LoopId,
    loop_count: usize,
}

impl Walk<'_> {
    fn block(&mut self, block: &Block) {
        self.uses.loops.insert(block.id, self.current);
        for statement in &block.statements {
            self.statement(statement);
        }
        operand(&block.value).for_each(|var| self.var(var));
    }

    /// A block that runs several times.
    fn repeated(&mut self, block: &Block) {
        let outer = self.current;
        self.loop_count += 1;
        self.current = self.loop_count;
        self.block(block);
        self.current = outer;
    }

    fn var(&mut self, var: VarId) {
        let block = self.lowered.vars[var].block;
        // What lives outside is used by every iteration, so that none of its uses is the last.
        if self.uses.loops.get(&block) == Some(&self.current) {
            self.uses.counts[var] += 1;
            self.uses.last[var] = self.uses.last[var].max(self.position);
        } else {
            self.uses.counts[var] += 2;
            self.uses.last[var] = usize::MAX;
        }
    }

    fn statement(&mut self, statement: &Statement) {
        self.position += 1;
        if let Statement::Assign { place, .. } = statement {
            self.var(place.root);
        }
        used(statement).into_iter().for_each(|var| self.var(var));
        if let Statement::Branch(branch) = statement {
            // Each arm takes its own parts.
            if branch.arms.iter().filter(|arm| !arm.bindings.is_empty()).count() > 1 {
                branch.source().into_iter().for_each(|place| self.var(place.root));
            }
        }
        match statement {
            Statement::Loop(a_loop) => self.repeated(&a_loop.body),
            Statement::Build(build) => self.repeated(&build.body),
            statement => blocks(statement).into_iter().for_each(|block| self.block(block)),
        }
    }
}

/// Follows values backwards from where they are used to where they are assigned.
struct Liveness {
    /// For each variable those that it may refer to.
    lenders: Vec<BTreeSet<VarId>>,
    ends: Ends,
}

impl Liveness {
    fn of(lowered: &Lowered) -> Ends {
        let lenders = vec![BTreeSet::new(); lowered.vars.len()];
        let mut liveness = Self { lenders, ends: Ends::default() };
        // A reference may be assigned to a variable before what it refers to is.
        while liveness.refer(&lowered.body) {}
        liveness.block(&lowered.body, 1, &mut BTreeSet::new());
        liveness.ends
    }

    /// Whether a value is used that a variable has or lends.
    fn is_used(&self, var: VarId, live: &BTreeSet<VarId>) -> bool {
        live.iter().any(|of| *of == var || self.lenders[*of].contains(&var))
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
                Statement::Plain { .. } | Statement::Update { .. } => continue,
            };
            let inner = blocks(statement);
            for block in &inner {
                is_new |= self.refer(block);
            }
            let values = inner.iter().flat_map(|block| operand(&block.value));
            let moved = used(statement).into_iter().chain(values);
            let moved = moved.flat_map(|var| self.lenders[var].iter().copied());
            let lenders: BTreeSet<VarId> = moved.chain(lent(statement)).collect();
            for var in defined {
                let before = self.lenders[var].len();
                self.lenders[var].extend(lenders.iter().filter(|&&lender| lender != var));
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
        Statement::Plain { .. } | Statement::Loop(_) | Statement::Build(_) => Vec::new(),
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
            let of_argument = |argument: &Argument| match argument {
                Argument::Borrow(place)
                | Argument::Exclusive(place)
                | Argument::Reborrow(place)
                | Argument::Receiver(place) => Some(place.root),
                _ => None,
            };
            arguments.iter().filter_map(of_argument).collect()
        }
        Statement::Destructure { .. } | Statement::Branch(_) => used(statement),
        _ => Vec::new(),
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
                Argument::Borrow(place)
                | Argument::Exclusive(place)
                | Argument::Reborrow(place)
                | Argument::Receiver(place) => Some(place.root),
                Argument::Function(_) | Argument::Callee(_) | Argument::PassedOn(..) => None,
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
