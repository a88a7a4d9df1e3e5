//! Where values are used last, so that their tangents may be moved instead of copied: a variable may live
//! on, if it is assigned to before it is used again, in this iteration of a loop or the next.
//!
//! The analysis is that of live variables (Aho, Lam, Sethi and Ullman, "Compilers", 9.2.5), backwards over the
//! blocks, in loops twice. A variable that may be a reference keeps alive what it may refer to: what is
//! borrowed does not move, and the value of a `Copy` type may go on to be borrowed.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use quote::quote;

use super::numbers::Numbers;
use crate::ir::{
    Action, Argument, Binding, Block, BlockId, BranchKind, Keep, Operand, Operation, Place,
    Projection, Statement, Var, VarId,
};
use crate::lower::Lowered;

/// Where values end.
#[derive(Default)]
pub struct Uses {
    /// For each statement the variables of which it uses a part, or all, once, and no other uses that after it.
    statements: HashMap<usize, HashSet<VarId>>,
    /// The block of each statement.
    blocks: HashMap<usize, BlockId>,
    /// The blocks whose value is a variable that is not used after the block.
    values: HashSet<BlockId>,
    /// The arms that bind parts of a place which neither they nor anything after the branch uses.
    arms: HashSet<BlockId>,
    /// The calls of methods on variables of which references to parts are used later.
    shared: HashSet<usize>,
}

impl Uses {
    /// Looks through a function.
    pub fn of(lowered: &Lowered, numbers: &Numbers<'_>) -> Self {
        let lenders = vec![BTreeSet::new(); lowered.vars.len()];
        let vars = &lowered.vars;
        let borrowers = vec![Vec::new(); vars.len()];
        let named = HashMap::new();
        let mut liveness =
            Liveness { vars, numbers, lenders, borrowers, named, ends: Self::default() };
        // A reference may be assigned to a variable before what it refers to is.
        while liveness.refer(&lowered.body) {}
        for (var, lenders) in liveness.lenders.iter().enumerate() {
            lenders.iter().for_each(|&lender| liveness.borrowers[lender].push(var));
        }
        liveness.block(&lowered.body, 1, &mut Live::default());
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

    /// Whether statement number `position` calls a method by `&self`, for a reference to a part of what it is
    /// called on lives on.
    pub fn share_receiver(&self, position: usize) -> bool {
        self.shared.contains(&position)
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

/// The fields that lead to a part of a variable: what follows an index or a `*` counts as all of it.
type Fields = Vec<String>;

/// A variable and a part of it.
type Part = (VarId, Fields);

/// The variables that are used later.
#[derive(Clone, Default)]
struct Live(BTreeMap<VarId, BTreeSet<Use>>);

/// How a variable is used later.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Use {
    /// A part is read, but for those of its parts that are given another value before.
    Read { part: Fields, but: BTreeSet<Fields> },
    /// A part is given another value, for which the rest of what it is a part of has to be there.
    Assigned(Fields),
}

impl Live {
    fn add(&mut self, (var, part): Part) {
        self.0.entry(var).or_default().insert(Use::Read { part, but: BTreeSet::new() });
    }

    /// What is used on one way or another.
    fn join(&mut self, other: Self) {
        other.0.into_iter().for_each(|(var, uses)| self.0.entry(var).or_default().extend(uses));
    }

    fn extend(&mut self, parts: impl IntoIterator<Item = Part>) {
        parts.into_iter().for_each(|part| self.add(part));
    }

    /// Goes back over what gives a variable its value.
    fn remove(&mut self, var: VarId) {
        self.0.remove(&var);
    }

    /// Goes back over what gives a part another value.
    fn assign(&mut self, (var, fields): Part) {
        if fields.is_empty() {
            return self.remove(var);
        }
        let uses = self.0.remove(&var).unwrap_or_default();
        let others = uses.into_iter().filter_map(|later| match later {
            Use::Read { part, .. } if part.starts_with(&fields) => None,
            Use::Assigned(part) if part.starts_with(&fields) => None,
            Use::Read { part, mut but } if fields.starts_with(&part) => {
                but.insert(fields.clone());
                Some(Use::Read { part, but })
            }
            later => Some(later),
        });
        let mut uses: BTreeSet<Use> = others.collect();
        uses.insert(Use::Assigned(fields));
        self.0.insert(var, uses);
    }

    /// Whether a part of a variable is used, or what it is a part of.
    fn contains(&self, var: VarId, fields: &[String]) -> bool {
        let is_of_part = |later: &Use| match later {
            Use::Read { part, but } => {
                (part.starts_with(fields) || fields.starts_with(part))
                    && !but.iter().any(|part| fields.starts_with(part))
            }
            Use::Assigned(part) => part.starts_with(fields) && part.len() > fields.len(),
        };
        self.0.get(&var).is_some_and(|uses| uses.iter().any(is_of_part))
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
    /// The references to variables or parts of them, and those variables.
    named: HashMap<VarId, VarId>,
    ends: Uses,
}

impl Liveness<'_> {
    /// Whether a value is used that a variable or a part of it has or lends.
    fn is_used(&self, (var, fields): &Part, live: &Live) -> bool {
        live.contains(*var, fields) || self.borrowers[*var].iter().any(|&of| live.contains(of, &[]))
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
            self.name_parts(statement);
            let inner = statement.blocks();
            for block in &inner {
                is_new |= self.refer(block);
            }
            let values = inner.iter().flat_map(|block| operand(&block.value));
            let moved = used(statement).into_iter().chain(values);
            let inherited: BTreeSet<VarId> =
                moved.flat_map(|(var, _)| self.lenders[var].iter().copied()).collect();
            let takes_apart =
                matches!(statement, Statement::Destructure { .. } | Statement::Branch(_));
            let may_refer = |var: &VarId| self.numbers.number(*var).is_none();
            for var in defined.into_iter().filter(may_refer) {
                let before = self.lenders[var].len();
                // What a pattern binds by value refers to nothing that it was a part of.
                let lent = match takes_apart && !self.vars[var].reference {
                    true => Vec::new(),
                    false => lent(statement).into_iter().map(|(var, _)| var).collect(),
                };
                let lenders = inherited.iter().copied().chain(lent);
                self.lenders[var].extend(lenders.filter(|&lender| lender != var));
                is_new |= self.lenders[var].len() > before;
            }
        }
        is_new
    }

    /// Notes of which variable a statement names parts by reference.
    fn name_parts(&mut self, statement: &Statement) {
        let of_pattern = |bindings: &[Binding]| -> Vec<VarId> {
            let bound = bindings.iter().map(|binding| binding.var);
            bound.filter(|&var| self.vars[var].reference).collect()
        };
        let (source, references) = match statement {
            Statement::Define { var, operation: Operation::Borrow(place), .. } => {
                (Some(place), vec![*var])
            }
            Statement::Destructure { source, bindings, .. } => (Some(source), of_pattern(bindings)),
            Statement::Branch(branch) => {
                let arms = branch.arms.iter();
                (branch.source(), arms.flat_map(|arm| of_pattern(&arm.bindings)).collect())
            }
            _ => return,
        };
        let Some(source) = source else { return };
        let of = self.named.get(&source.root).copied().unwrap_or(source.root);
        self.named.extend(references.into_iter().map(|var| (var, of)));
    }

    /// Whether a statement calls a method on a variable of which a reference to a part is used in that call or later.
    fn shares_receiver(&self, statement: &Statement, used: &[Part], live: &Live) -> bool {
        let Statement::Define { operation: Operation::Call { arguments, .. }, .. } = statement
        else {
            return false;
        };
        let Some(Argument::Receiver(receiver)) = arguments.first() else { return false };
        let is_used = |var: VarId| {
            live.contains(var, &[]) || used.iter().any(|(argument, _)| *argument == var)
        };
        self.named.iter().any(|(&var, &of)| of == receiver.root && is_used(var))
    }

    /// Goes back from the end of a block, whose first statement has this number, to its start.
    fn block(&mut self, block: &Block, first: usize, live: &mut Live) {
        if let Operand::Var(value) = block.value {
            let value = (value, Fields::new());
            match self.is_used(&value, live) {
                true => self.ends.values.remove(&block.id),
                false => self.ends.values.insert(block.id),
            };
            live.add(value);
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

    fn statement(&mut self, statement: &Statement, position: usize, live: &mut Live) {
        match statement {
            Statement::Define { var, .. } => live.remove(*var),
            Statement::Assign { place, .. } if is_part_of_value(place) => live.assign(part(place)),
            Statement::Destructure { bindings, .. } => {
                bindings.iter().for_each(|binding| live.remove(binding.var));
            }
            Statement::Keep(Keep { action: Action::Restore, kept, .. }) => {
                kept.iter().for_each(|kept| live.remove(kept.var));
            }
            _ => {}
        }
        let used = used(statement);
        match statement {
            Statement::Branch(branch) => {
                branch.result.iter().for_each(|&result| live.remove(result));
                let mut first = position + 1;
                let mut before = Live::default();
                for arm in &branch.arms {
                    let mut within = live.clone();
                    self.block(&arm.body, first, &mut within);
                    arm.bindings.iter().for_each(|binding| within.remove(binding.var));
                    match branch.source().is_some_and(|place| !self.is_used(&part(place), &within))
                    {
                        true => self.ends.arms.insert(arm.body.id),
                        false => self.ends.arms.remove(&arm.body.id),
                    };
                    before.join(within);
                    first += length(&arm.body);
                }
                *live = before;
            }
            Statement::Loop(_) | Statement::Build(_) => {
                for body in statement.blocks() {
                    // The second time what an iteration uses that follows is known.
                    for _ in 0..2 {
                        let mut within = live.clone();
                        self.block(body, position + 1, &mut within);
                        live.join(within);
                    }
                }
            }
            _ => {
                let ends = |part: &&Part| {
                    used.iter().filter(|(other, _)| *other == part.0).count() == 1
                        && !self.is_used(part, live)
                };
                let ending = used.iter().filter(ends).map(|(var, _)| *var).collect();
                self.ends.statements.insert(position, ending);
                if self.shares_receiver(statement, &used, live) {
                    self.ends.shared.insert(position);
                }
            }
        }
        if let Statement::Assign { place, .. } = statement
            && !is_part_of_value(place)
        {
            live.add((place.root, Fields::new()));
        }
        live.extend(used);
    }
}

/// The number of statements in a statement, with itself.
fn count(statement: &Statement) -> usize {
    1 + statement.blocks().into_iter().map(length).sum::<usize>()
}

fn length(block: &Block) -> usize {
    block.statements.iter().map(count).sum()
}

/// Whether a place is a variable, or a part of one to which fields alone lead.
pub fn is_part_of_value(place: &Place) -> bool {
    place.path.iter().all(|step| matches!(step, Projection::Field(_)))
}

/// The part of a variable in which a place lies.
fn part(place: &Place) -> Part {
    let fields = place.path.iter().map_while(|step| match step {
        Projection::Field(member) => Some(quote!(#member).to_string()),
        _ => None,
    });
    (place.root, fields.collect())
}

fn whole(var: VarId) -> Part {
    (var, Fields::new())
}

fn operand(operand: &Operand) -> impl Iterator<Item = Part> + use<> {
    match operand {
        Operand::Var(var) => Some(whole(*var)),
        Operand::Constant(_) => None,
    }
    .into_iter()
}

/// What a statement itself uses, as often as it does; not that to which it assigns.
fn used(statement: &Statement) -> Vec<Part> {
    match statement {
        Statement::Define { operation, .. } => used_by(operation),
        Statement::Destructure { source, .. } => vec![part(source)],
        Statement::Assign { value, .. } => operand(value).collect(),
        Statement::Update { place, previous, value, .. } => {
            vec![whole(*previous), whole(*value), part(place)]
        }
        Statement::Branch(branch) => match &branch.kind {
            BranchKind::Match(_, Some(place)) => vec![part(place)],
            _ => Vec::new(),
        },
        Statement::Keep(Keep { action: Action::Store, kept, .. }) => {
            kept.iter().map(|kept| whole(kept.var)).collect()
        }
        Statement::Plain { .. } | Statement::Loop(_) | Statement::Build(_) | Statement::Keep(_) => {
            Vec::new()
        }
    }
}

/// That to which what a statement defines may refer.
fn lent(statement: &Statement) -> Vec<Part> {
    match statement {
        Statement::Define { operation: Operation::Borrow(place), .. } => vec![part(place)],
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

/// That of which a call gets a reference.
fn lent_to_call(argument: &Argument) -> Option<Part> {
    match argument {
        Argument::Borrow(place) => Some(part(place)),
        argument => argument.changeable().map(part),
    }
}

fn used_by(operation: &Operation) -> Vec<Part> {
    match operation {
        Operation::Use(value) => operand(value).collect(),
        Operation::Read(place) | Operation::Clone(place, _) | Operation::Borrow(place) => {
            vec![part(place)]
        }
        Operation::Value(var) | Operation::Negate(var) | Operation::Cast(var, _) => {
            vec![whole(*var)]
        }
        Operation::Binary(_, left, right) => vec![whole(*left), whole(*right)],
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
            parts.iter().flat_map(|(_, part)| operand(part)).chain([part(rest)]).collect()
        }
        Operation::Repeat { value, .. } => vec![whole(*value)],
        // What a closure captures it copies.
        Operation::Closure(closure) => {
            closure.captures.iter().map(|(_, place)| part(place)).collect()
        }
        Operation::Named { .. } => Vec::new(),
    }
}
