//! Where tangents are used last, and may be moved instead of copied.

use std::collections::HashMap;

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
}

impl Uses {
    /// Looks through a function.
    pub fn of(lowered: &Lowered) -> Self {
        let count = lowered.vars.len();
        let uses = Self { counts: vec![0; count], last: vec![0; count], loops: HashMap::new() };
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
        self.operand(&block.value);
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

    fn operand(&mut self, operand: &Operand) {
        if let Operand::Var(var) = operand {
            self.var(*var);
        }
    }

    fn place(&mut self, place: &Place) {
        self.var(place.root);
    }

    fn statement(&mut self, statement: &Statement) {
        self.position += 1;
        match statement {
            Statement::Define { operation, .. } => self.operation(operation),
            Statement::Plain { .. } => {}
            Statement::Destructure { source, .. } => self.place(source),
            Statement::Assign { place, value } => {
                self.operand(value);
                self.place(place);
            }
            Statement::Update { place, previous, value, .. } => {
                self.var(*previous);
                self.var(*value);
                self.place(place);
            }
            Statement::Branch(branch) => {
                if let BranchKind::Match(_, Some(place)) = &branch.kind {
                    // Each arm takes its own parts.
                    self.place(place);
                    if branch.arms.iter().filter(|arm| !arm.bindings.is_empty()).count() > 1 {
                        self.place(place);
                    }
                }
                for arm in &branch.arms {
                    self.block(&arm.body);
                }
            }
            Statement::Loop(a_loop) => self.repeated(&a_loop.body),
            Statement::Build(build) => self.repeated(&build.body),
        }
    }

    fn operation(&mut self, operation: &Operation) {
        match operation {
            Operation::Use(operand) => self.operand(operand),
            Operation::Read(place) | Operation::Clone(place) | Operation::Borrow(place) => {
                self.place(place);
            }
            Operation::Value(var) | Operation::Negate(var) | Operation::Cast(var, _) => {
                self.var(*var);
            }
            Operation::Binary(_, left, right) => {
                self.var(*left);
                self.var(*right);
            }
            Operation::Call { arguments, .. } => {
                for argument in arguments {
                    match argument {
                        Argument::Value(operand) => self.operand(operand),
                        Argument::Borrow(place)
                        | Argument::Exclusive(place)
                        | Argument::Reborrow(place)
                        | Argument::Receiver(place) => self.place(place),
                        Argument::Function(_) | Argument::Callee(_) | Argument::PassedOn(..) => {}
                    }
                }
            }
            Operation::Aggregate { parts, .. } => {
                parts.iter().for_each(|(_, part)| self.operand(part));
            }
            Operation::UpdateStruct { parts, rest, .. } => {
                parts.iter().for_each(|(_, part)| self.operand(part));
                self.place(rest);
            }
            Operation::Repeat { value, .. } => self.var(*value),
            // What a closure captures it copies.
            Operation::Closure(closure) => {
                closure.captures.iter().for_each(|(_, place)| self.place(place));
            }
            Operation::Named { .. } => {}
        }
    }
}
