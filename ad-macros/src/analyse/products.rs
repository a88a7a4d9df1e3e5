//! Where the pullback of a product may be a plain product.
//!
//! A cotangent of zero has to annihilate a partial derivative that is infinite or NaN (the arm that
//! a `select` did not take), so the pullback of `a * b` compares each cotangent with zero. That
//! costs up to half of a reverse sweep, and is needed only if a factor is not finite. The forward
//! sweep therefore finds out whether all factors of all products were finite, and there are two
//! reverse sweeps: with plain products, and, out of line, with the comparison. They are written out
//! where they are small, and else written once and compiled twice, which takes the compiler less
//! time to check and more to optimise well (a gradient of a mixture model: 1.10 times the other).
//!
//! The same holds for quotients of numbers, whose general rule tells a zero denominator apart.
//!
//! Few values need to be tested: what is not finite stays so in sums, differences, products and
//! negations, so if the result of such an operation is finite, all that entered it in the same
//! block was. Tested are the results that enter no other such operation; and a variable that a loop
//! changes by such operations alone is tested once, after the loop.
//!
//! Where all of them enter the value of the function itself, a number, by such operations, nothing is
//! tested: with a cotangent other than zero the value is what is asked for, and it is finite or no
//! gradient is. Only a cotangent of zero takes the comparisons then.
//!
//! Turned down: leaving out the comparison where no `select` is in sight (an overflow vanishes in
//! `1 / (1 + exp(-x))` too, and a caller may drop a result); searching the gradient for NaN and
//! computing it once more (a pullback can run only once); a branch at each product (it would keep
//! loops from being vectorised).

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use proc_macro2::Ident;

use super::facts::{Facts, is_element};
use super::numbers::Numbers;
use crate::ir::{BinaryOperator, Block, Loop, Operand, Operation, Place, Statement, Var, VarId};
use crate::lower::Lowered;
use crate::names::Names;

/// Of fewer products the tests would cost what they save. One in a loop counts for several.
const MANY_PRODUCTS: usize = 12;
const WEIGHT_IN_LOOP: usize = 2;

/// Up to so many products both reverse sweeps are written out.
const FEW_PRODUCTS: usize = 32;

/// Of more products a second reverse sweep, and the comparisons in it, would cost more at compile
/// time than they are worth: the sweep is compiled once, and the rules are called.
const TOO_MANY_PRODUCTS: usize = 200;

/// So many make a pullback that is too large to be inlined on the compiler's own account, and what
/// it captures would go through memory, which takes the compiler as long as all else: it is told to.
/// More in one body than this would take it longer still.
const MOST_INLINED_PRODUCTS: usize = 600;

/// How a reverse sweep comes by its rules of products.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Rules {
    /// There are two sweeps.
    WrittenTwice,
    /// The sweep is compiled twice.
    CompiledTwice,
    /// There is one sweep, which calls them.
    Called,
}

impl Rules {
    /// Those for a function of so many products.
    fn of(count: usize) -> Self {
        match count {
            _ if count <= FEW_PRODUCTS => Self::WrittenTwice,
            _ if count <= TOO_MANY_PRODUCTS => Self::CompiledTwice,
            _ => Self::Called,
        }
    }
}

/// The products of a function with plain pullbacks.
pub struct Products {
    /// How the sweep comes by its rules.
    pub rules: Rules,
    /// Whether the pullback is to be inlined wherever it is called.
    pub is_inlined: bool,
    /// The results to be tested.
    pub tested: HashSet<VarId>,
    /// The variables to be tested after loops, by the names of the tapes.
    pub tested_after: HashMap<String, Vec<VarId>>,
    /// Whether the value of the function tells of all of them.
    pub are_told: bool,
    /// The name of what is 0 as long as all were finite.
    pub irregular: Ident,
    /// The name of the rules of products.
    pub name: Ident,
}

impl Products {
    /// Finds the results to be tested; `None` where there are too few products.
    pub fn new(
        lowered: &Lowered,
        facts: &Facts<'_>,
        numbers: &Numbers<'_>,
        names: &mut Names,
    ) -> Option<Self> {
        let searched = |takes_sums| {
            let mut search = Search {
                vars: &lowered.vars,
                facts,
                numbers,
                takes_sums,
                count: 0,
                tested: HashSet::new(),
                tested_after: HashMap::new(),
                weight: 0,
            };
            search.block(&lowered.body, 1);
            search
        };
        let mut search = searched(true);
        // Those of a few products outside of loops are not worth a second sweep.
        let are_told = search.weight > search.count && search.enter_value(lowered);
        if !are_told {
            search = searched(false);
        }
        (are_told || search.weight >= MANY_PRODUCTS).then(|| Self {
            rules: match Rules::of(search.count) {
                Rules::WrittenTwice if are_told => Rules::CompiledTwice,
                rules => rules,
            },
            are_told,
            is_inlined: (TOO_MANY_PRODUCTS + 1..=MOST_INLINED_PRODUCTS).contains(&search.count),
            tested: search.tested,
            tested_after: search.tested_after,
            irregular: names.fresh("irregular", proc_macro2::Span::call_site()),
            name: names.fresh("products", proc_macro2::Span::call_site()),
        })
    }

    /// Whether the forward sweep finds out which rules the reverse sweep takes.
    pub fn are_chosen(&self) -> bool {
        self.rules != Rules::Called
    }
}

struct Search<'a> {
    vars: &'a [Var],
    facts: &'a Facts<'a>,
    numbers: &'a Numbers<'a>,
    /// Whether a mere sum is tested, instead of its terms.
    takes_sums: bool,
    pub tested: HashSet<VarId>,
    pub tested_after: HashMap<String, Vec<VarId>>,
    /// How many products were seen.
    count: usize,
    weight: usize,
}

/// How a loop changes a variable.
#[derive(Default)]
struct Changes {
    /// The results that enter it.
    results: Vec<VarId>,
    /// Whether something takes its place.
    overwrites: bool,
    /// How often it is read.
    reads: usize,
}

impl Search<'_> {
    fn block(&mut self, block: &Block, weight: usize) {
        for statement in &block.statements {
            match statement {
                Statement::Define { var, operation, .. } => self.define(*var, operation, weight),
                Statement::Branch(branch) => {
                    branch.arms.iter().for_each(|arm| self.block(&arm.body, weight));
                }
                Statement::Loop(a_loop) => {
                    self.block(&a_loop.body, weight * WEIGHT_IN_LOOP);
                    if !a_loop.checkpoint {
                        self.after(a_loop, block);
                    }
                }
                Statement::Build(build) => self.block(&build.body, weight * WEIGHT_IN_LOOP),
                Statement::Plain { .. }
                | Statement::Destructure { .. }
                | Statement::Assign { .. }
                | Statement::Update { .. }
                | Statement::Keep(_) => {}
            }
        }
    }

    fn define(&mut self, var: VarId, operation: &Operation, weight: usize) {
        let (operands, is_tested) = match operation {
            // The partial derivative of a product with a literal is finite.
            Operation::Binary(BinaryOperator::Mul, left, right)
                if ![left, right]
                    .iter()
                    .any(|factor| self.numbers.is_regular_constant(**factor)) =>
            {
                self.count += 1;
                self.weight += weight;
                (vec![*left, *right], true)
            }
            Operation::Binary(
                BinaryOperator::Add | BinaryOperator::Sub | BinaryOperator::Mul,
                left,
                right,
            ) => (vec![*left, *right], false),
            Operation::Negate(value) => (vec![*value], false),
            // A denominator of zero, too, shows in the quotient; an infinite one does not, and does
            // no harm here, but may do so in a product.
            operation if self.is_quotient(operation) => (Vec::new(), true),
            _ => return,
        };
        // A test of this result tells of the operands too, unless they were computed in a block
        // that may run without this one.
        let mut tells = is_tested;
        for operand in operands {
            if self.vars[operand].block == self.vars[var].block {
                tells |= self.tested.remove(&operand);
            }
        }
        if tells {
            self.tested.insert(var);
        }
    }

    /// Whether an operation is a quotient of numbers with a pullback of its own for finite ones.
    fn is_quotient(&self, operation: &Operation) -> bool {
        matches!(operation, Operation::Binary(BinaryOperator::Div, left, right)
            if self.numbers.are_numbers([*left, *right])
                && !self.numbers.is_regular_constant(*right))
    }

    /// Finds the variables of `block` that are tested after a loop in it instead of within.
    fn after(&mut self, a_loop: &Loop, block: &Block) {
        let mut changes = BTreeMap::new();
        self.changes(&a_loop.body, &mut changes);
        let mut tested = Vec::new();
        for (var, Changes { results, overwrites, reads }) in changes {
            if overwrites || self.vars[var].block != block.id {
                continue;
            }
            let assignments = results.len();
            let results: BTreeSet<_> = results.into_iter().collect();
            let results: Vec<_> =
                results.into_iter().filter(|result| self.tested.remove(result)).collect();
            match reads > assignments {
                // The loop goes on with it.
                true if !results.is_empty() => tested.push(var),
                true => {}
                false if self.takes_sums => {
                    if !results.is_empty() {
                        tested.push(var);
                    }
                }
                // A mere sum: it may not be asked for, and its terms can be tested side by side.
                false => results.into_iter().for_each(|result| self.test_terms(var, result)),
            }
        }
        self.tested_after.insert(a_loop.record.to_string(), tested);
    }

    /// Whether all that is to be tested enters the value of the function, a number, so that this is not
    /// finite where one of them is not.
    fn enter_value(&self, lowered: &Lowered) -> bool {
        let body = &lowered.body;
        let Operand::Var(value) = body.value else { return false };
        let changes_argument =
            lowered.parameters.iter().any(|parameter| self.vars[parameter.var].exclusive);
        if changes_argument || !self.numbers.are_numbers([value, value]) {
            return false;
        }
        let mut open = self.tested.clone();
        let mut open_after: HashSet<_> = self.tested_after.values().flatten().copied().collect();
        let mut entering = vec![value];
        while let Some(var) = entering.pop() {
            if self.vars[var].block != body.id {
                continue;
            }
            open.remove(&var);
            match self.facts.operation(var) {
                Some(Operation::Read(place))
                    if place.path.is_empty() && self.is_read_behind_loop(var, place.root, body) =>
                {
                    open_after.remove(&place.root);
                }
                Some(Operation::Use(Operand::Var(inner)) | Operation::Negate(inner)) => {
                    entering.push(*inner);
                }
                Some(Operation::Binary(
                    BinaryOperator::Add | BinaryOperator::Sub | BinaryOperator::Mul,
                    left,
                    right,
                )) => entering.extend([*left, *right]),
                _ => {}
            }
        }
        open.is_empty() && open_after.is_empty()
    }

    /// Whether `read` is what `var` holds after the only loop that it is tested after.
    fn is_read_behind_loop(&self, read: VarId, var: VarId, block: &Block) -> bool {
        let is_tested_after = |statement: &Statement| match statement {
            Statement::Loop(a_loop) => {
                let tested = self.tested_after.get(&a_loop.record.to_string());
                tested.is_some_and(|tested| tested.contains(&var))
            }
            _ => false,
        };
        let mut behind =
            block.statements.iter().skip_while(|statement| !is_tested_after(statement));
        if behind.next().is_none() {
            return false;
        }
        for statement in behind {
            let mut assigned = HashSet::new();
            self.facts.assigned(statement, &mut assigned);
            match statement {
                Statement::Define { var, .. } if *var == read => return true,
                _ if assigned.contains(&var) => return false,
                _ => {}
            }
        }
        false
    }

    /// Tests the terms that were added to what was read from `sum`.
    fn test_terms(&mut self, sum: VarId, result: VarId) {
        match self.facts.operation(result) {
            Some(Operation::Read(place)) if place.root == sum => {}
            Some(Operation::Negate(inner)) => self.test_terms(sum, *inner),
            Some(Operation::Binary(BinaryOperator::Add | BinaryOperator::Sub, left, right)) => {
                self.test_terms(sum, *left);
                self.test_terms(sum, *right);
            }
            Some(Operation::Binary(BinaryOperator::Mul, ..)) => {
                self.tested.insert(result);
            }
            Some(operation) if self.is_quotient(operation) => {
                self.tested.insert(result);
            }
            _ => {}
        }
    }

    /// Collects what is assigned to in a block, at any depth.
    fn changes(&self, block: &Block, into: &mut BTreeMap<VarId, Changes>) {
        // What was read from places in this block and has not been overwritten.
        let mut current: HashMap<VarId, &Place> = HashMap::new();
        for statement in &block.statements {
            if let Statement::Define { var, operation: Operation::Read(place), .. } = statement {
                current.insert(*var, place);
                into.entry(place.root).or_default().reads += 1;
            }
            let mut assigned = HashSet::new();
            self.facts.assigned(statement, &mut assigned);
            match statement {
                Statement::Assign { place, value } => {
                    let result = match value {
                        Operand::Var(value) if self.enters(&current, place, *value) => Some(*value),
                        _ => None,
                    };
                    self.change(place, result, into);
                }
                Statement::Update { place, operator, value, .. } => {
                    let enters = !matches!(operator, BinaryOperator::Div | BinaryOperator::Rem);
                    self.change(place, enters.then_some(*value), into);
                }
                Statement::Branch(_) | Statement::Loop(_) | Statement::Build(_) => {
                    statement.blocks().into_iter().for_each(|block| self.changes(block, into));
                }
                Statement::Destructure { source, .. } => {
                    into.entry(source.root).or_default().reads += 1;
                }
                Statement::Define { .. } | Statement::Plain { .. } => {
                    for &var in &assigned {
                        into.entry(var).or_default().overwrites = true;
                    }
                }
                Statement::Keep(_) => {}
            }
            current.retain(|_, place| !assigned.contains(&place.root));
        }
    }

    /// A change of a place; `result` has entered it.
    fn change(&self, place: &Place, result: Option<VarId>, into: &mut BTreeMap<VarId, Changes>) {
        let is_number = place.path.is_empty()
            || (is_element(&place.path) && self.facts.array(place.root) == Some(false));
        let changes = into.entry(place.root).or_default();
        changes.overwrites |= result.is_none() || !is_number;
        changes.results.extend(result);
        // An array is no mere sum.
        changes.reads += usize::from(!place.path.is_empty());
    }

    /// Whether `value` is made of what `place` held by operations that keep what is not finite.
    fn enters(&self, current: &HashMap<VarId, &Place>, place: &Place, value: VarId) -> bool {
        match self.facts.operation(value) {
            Some(Operation::Read(_)) => current
                .get(&value)
                .is_some_and(|read| self.facts.key(read) == self.facts.key(place)),
            Some(Operation::Negate(inner)) => self.enters(current, place, *inner),
            Some(Operation::Binary(
                BinaryOperator::Add | BinaryOperator::Sub | BinaryOperator::Mul,
                left,
                right,
            )) => self.enters(current, place, *left) || self.enters(current, place, *right),
            _ => false,
        }
    }
}
