//! Where control goes from the end of a block.
//!
//! A lowered block has no jumps: each jump is the end of a block, and the [`End`] of the block
//! says where control may go from there. Where there is one way only, the value of the block is
//! what the user wrote. Else it is a `ControlFlow`: `Continue` with the value of the block that
//! ran to its end, `Break` with that of a jump. With several targets the `Break` holds a chain:
//! `Break(a)` for the first, `Continue(Break(b))` for the second, and so on; the last needs no
//! `Break`.
//!
//! Turned down: real jumps in the forward sweep (each would have to push what the blocks around it
//! saved before it leaves; ends need that in one place only), and an enum for each number of
//! targets (a second sum type beside `ControlFlow`, for code that is rare).

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{Lifetime, Member, Pat};

use crate::ir::{
    Action, Arm, Binding, Block, BranchKind, Keep, Operand, Operation, Place, Projection, Shape,
    Statement, Target, Way,
};
use crate::lower::Lowerer;
use crate::lower::rewrite::exits::Exit;
use crate::lower::state::{Fork, Jump, JumpId, JumpKind};
use crate::lower::syntax;

/// What the end of a block means.
#[derive(Clone, Default)]
pub struct End {
    /// The targets to which the end of the block leads by itself.
    pub here: Vec<Target>,
    /// The targets of its other jumps.
    pub exits: Vec<Target>,
    /// What the block runs in that tells by a `ControlFlow` how it ended.
    pub fork: Fork,
    /// The same for its other jumps.
    pub exit_fork: Fork,
}

impl Lowerer<'_> {
    /// Runs `fill` where jumps may lead out of `kind`.
    pub fn jump<R>(
        &mut self,
        kind: JumpKind,
        label: Option<Lifetime>,
        fill: impl FnOnce(&mut Self, JumpId) -> R,
    ) -> R {
        let id = self.jump_count;
        self.jump_count += 1;
        self.jumps.push(Jump { id, label, kind });
        let result = fill(self, id);
        self.jumps.pop();
        result
    }

    /// Where a jump leads from here. `None` is not Rust, which the compiler says of the function.
    pub(super) fn led_to(&self, exit: &Exit) -> Option<Target> {
        let mut jumps = self.jumps.iter().rev();
        let reached = match exit {
            Exit::Return => jumps.find(|jump| jump.kind == JumpKind::Function),
            Exit::Break(None) | Exit::Continue(None) => {
                jumps.find(|jump| jump.kind == JumpKind::Loop)
            }
            Exit::Break(label) | Exit::Continue(label) => jumps.find(|jump| jump.label == *label),
        };
        reached.map(|jump| match exit {
            Exit::Return | Exit::Break(_) => Target::Leave(jump.id),
            Exit::Continue(_) => Target::Again(jump.id),
        })
    }

    pub(super) fn targets(&self, exits: &[Exit]) -> Vec<Target> {
        let mut targets = Vec::new();
        for target in exits.iter().filter_map(|exit| self.led_to(exit)) {
            if !targets.contains(&target) {
                targets.push(target);
            }
        }
        targets
    }

    /// The value of a block that runs to its end.
    pub fn normal_end(&mut self, value: Operand, end: &End) -> Operand {
        match end.exits.is_empty() {
            true => value,
            false => {
                let flow = self.control_flow(Side::Continue, value);
                let again = end.here.iter().find(|target| matches!(target, Target::Again(_)));
                self.way(Action::Store, Way { fork: end.fork, target: again.copied() });
                flow
            }
        }
    }

    /// A new fork, of which the variables are declared here that one of its ways keeps.
    pub(super) fn fork(&mut self) -> Fork {
        self.fork_count += 1;
        let fork = self.fork_count;
        self.way(Action::Declare, Way { fork, target: None });
        fork
    }

    /// Notes that a way begins or ends here; [`kept`](crate::analyse::kept) tells of which variables.
    pub(super) fn way(&mut self, action: Action, way: Way) {
        self.push(Statement::Keep(Keep { action, way, kept: Vec::new() }));
    }

    /// The value of a block whose end jumps to `target`.
    pub fn exit(&mut self, target: Target, value: Operand, end: &End) -> Operand {
        if end.here.contains(&target) {
            return self.normal_end(value, end);
        }
        let position = end.exits.iter().position(|exit| *exit == target);
        let position = position.expect("exits have been looked for");
        let link = self.link(value, position, end.exits.len());
        let flow = self.control_flow(Side::Break, link);
        self.way(Action::Store, Way { fork: end.exit_fork, target: Some(target) });
        flow
    }

    /// A value as number `position` of a chain of `count`.
    pub(super) fn link(&mut self, value: Operand, position: usize, count: usize) -> Operand {
        if count <= 1 {
            return value;
        }
        if position == 0 {
            return self.control_flow(Side::Break, value);
        }
        let rest = self.link(value, position - 1, count - 1);
        self.control_flow(Side::Continue, rest)
    }

    fn control_flow(&mut self, side: Side, value: Operand) -> Operand {
        let tokens = self.tokens(&value);
        let expression = side.of(&tokens);
        let Operand::Var(var) = value else {
            return Operand::Constant(expression);
        };
        let span = self.ident(var).span();
        Operand::Var(self.define(
            "flow",
            span,
            true,
            Operation::Aggregate {
                expression,
                shape: Shape::Flow,
                parts: vec![(side.member(), Operand::Var(var))],
            },
        ))
    }

    /// Ends a block with a chain of jumps to `targets`. At the target `here` control goes on
    /// instead: with what `go_on` lowers.
    pub(super) fn dispatch(
        &mut self,
        (fork, chain): (Fork, Operand),
        targets: &[Target],
        here: Option<Target>,
        go_on: &mut dyn FnMut(&mut Self, Operand) -> Operand,
        end: &End,
    ) -> Operand {
        let [first, others @ ..] = targets else { return Self::unit() };
        let mut arrive = |lowerer: &mut Self, value: Operand, target: Target| {
            lowerer.way(Action::Restore, Way { fork, target: Some(target) });
            match here {
                Some(here) if here == target => go_on(lowerer, value),
                _ => lowerer.exit(target, value, end),
            }
        };
        if others.is_empty() {
            return arrive(self, chain, *first);
        }
        let (flow, active) = self.split(chain);
        let left =
            self.side(flow, active, Side::Break, |lowerer, value| arrive(lowerer, value, *first));
        let right = self.side(flow, active, Side::Continue, |lowerer, value| {
            lowerer.dispatch((fork, value), others, here, go_on, end)
        });
        self.merge(flow, active, [left, right])
    }

    /// What the end of a block means that may leave what stands around it by `exits`, or go on.
    pub(super) fn within(&mut self, exits: Vec<Target>, end: &End) -> End {
        let fork = self.fork();
        // The same jumps pass through.
        let exit_fork = if exits == end.exits { end.exit_fork } else { fork };
        End { here: Vec::new(), exits, fork, exit_fork }
    }

    /// Jumps with the content of a `Break`, or goes on with that of a `Continue`: as it ended `within`.
    pub(super) fn go_on(
        &mut self,
        flow: Operand,
        within: &End,
        end: &End,
        rest: impl FnOnce(&mut Self, Operand) -> Operand,
    ) -> Operand {
        let (flow, active) = self.split(flow);
        let left = self.side(flow, active, Side::Break, |lowerer, value| {
            if within.exits == end.exits {
                return lowerer.control_flow(Side::Break, value);
            }
            let nowhere = &mut |_: &mut Self, _| unreachable!("every target is an exit");
            lowerer.dispatch((within.fork, value), &within.exits, None, nowhere, end)
        });
        let right = self.side(flow, active, Side::Continue, |lowerer, value| {
            lowerer.way(Action::Restore, Way { fork: within.fork, target: None });
            rest(lowerer, value)
        });
        self.merge(flow, active, [left, right])
    }

    /// Names what is about to be matched; says whether a derivative flows through it.
    fn split(&mut self, flow: Operand) -> (usize, bool) {
        let span = match &flow {
            Operand::Var(var) => self.ident(*var).span(),
            Operand::Constant(_) => proc_macro2::Span::call_site(),
        };
        let flow = self.named(flow, "flow", span);
        (flow, self.vars[flow].active)
    }

    fn side(
        &mut self,
        flow: usize,
        active: bool,
        side: Side,
        fill: impl FnOnce(&mut Self, Operand) -> Operand,
    ) -> Arm {
        let span = self.ident(flow).span();
        let mut head = None;
        let body: Block = self.block(|lowerer| {
            let ident = lowerer.names.fresh("content", span);
            let var = lowerer.var(ident.clone(), false, active);
            let binding = Binding::new(var, vec![Projection::Field(side.member())]);
            head = Some((side.of(&quote!(#ident)), binding));
            let value = lowerer.operand_of(var);
            fill(lowerer, value)
        });
        let (pattern, binding) = head.expect("set by the block");
        Arm { pattern, guard: None, bindings: vec![binding], body }
    }

    fn merge(&mut self, flow: usize, active: bool, arms: [Arm; 2]) -> Operand {
        let ident = self.ident(flow).clone();
        let source = active.then(|| Place::of(flow));
        self.branch(BranchKind::Match(quote!(#ident), source), arms.into(), true, ident.span())
    }

    /// Goes on with `rest` under the name that `pat` gives to a value.
    pub(super) fn bind_rest(&mut self, pat: Option<&Pat>, value: Operand) {
        match pat {
            Some(pat) => {
                let (pat, ty) = syntax::split_type(pat);
                self.bind_pattern(pat, ty, value);
            }
            None => self.discard(value),
        }
    }
}

/// A side of a `ControlFlow`.
#[derive(Clone, Copy, Debug)]
enum Side {
    Break,
    Continue,
}

impl Side {
    fn of(self, content: &TokenStream) -> TokenStream {
        let variant = format_ident!("{self:?}");
        quote!(::core::ops::ControlFlow::#variant(#content))
    }

    /// The number of the side in the cotangent of a `ControlFlow`.
    fn member(self) -> Member {
        Member::from(match self {
            Self::Break => 0,
            Self::Continue => 1,
        })
    }
}
