//! Loops: a block, run again and again, whose end says whether to go on.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Expr, Label, Pat, parse_quote};

use super::ends::End;
use crate::ir::Block;
use crate::ir::{Action, Head, Loop, Operand, Statement, Target, Way};
use crate::lower::Lowerer;
use crate::lower::iterate::chain::Chain;
use crate::lower::iterate::item::Item;
use crate::lower::rewrite::exits;
use crate::lower::rewrite::exits::Exit;
use crate::lower::search::has;
use crate::lower::state::{Fork, JumpKind};
use crate::parse::options::own_options;

/// What a loop leaves behind: a chain of the targets where control goes next.
pub(super) struct LoopResult {
    pub fork: Fork,
    pub value: Operand,
    pub targets: Vec<Target>,
    /// The target that is the end of the loop itself, with its value.
    pub own: Option<Target>,
}

/// What makes a loop go on, before its block is open.
enum Driver<'a> {
    Chain(&'a Chain, Option<&'a Pat>),
    While(TokenStream),
    Endless,
}

/// Lowers the body of a loop, for an item.
type Body<'b> = dyn FnMut(&mut Lowerer<'_>, Item, &End) -> Operand + 'b;

impl Lowerer<'_> {
    /// A `for`, `while` or `loop`.
    pub(super) fn a_loop(&mut self, expr: &Expr) -> LoopResult {
        match expr {
            Expr::ForLoop(a_loop) => {
                let chain = self.chain(&a_loop.expr);
                let exits = exits::block_exits(&a_loop.body);
                let driver = Driver::Chain(&chain, Some(&a_loop.pat));
                let result =
                    self.run(a_loop.label.as_ref(), &exits, &driver, &mut |lowerer, item, end| {
                        let mut statements = a_loop.body.stmts.clone();
                        lowerer.bind_item_of(&a_loop.pat, item, &mut statements);
                        lowerer.statements(statements, end)
                    });
                self.keep_checkpoints(expr, &a_loop.attrs);
                result
            }
            Expr::While(a_loop) => {
                let syn::ExprWhile { attrs, label, cond, body, .. } = a_loop;
                // What one iteration keeps for the next is not there between them (see `ir::Keep`).
                let reads_kept = self.is_movable(cond) && !exits::block_exits(body).is_empty();
                if reads_kept || self.is_not_plain(cond) {
                    return self.a_loop(&parse_quote!(
                        #label loop { if #cond #body else { break; } }
                    ));
                }
                let condition = self.plain_in_place(cond);
                let result = self.run_block(label.as_ref(), body, &Driver::While(condition));
                self.keep_checkpoints(expr, attrs);
                result
            }
            Expr::Loop(a_loop) => {
                let result = self.run_block(a_loop.label.as_ref(), &a_loop.body, &Driver::Endless);
                self.keep_checkpoints(expr, &a_loop.attrs);
                result
            }
            other => unreachable!("not a loop: {}", quote!(#other)),
        }
    }

    /// Marks the loop just written as one with checkpoints, if it has the attribute.
    fn keep_checkpoints(&mut self, a_loop: &Expr, attributes: &[syn::Attribute]) {
        if !self.is_checkpointed(attributes) {
            return;
        }
        if self.is_object {
            self.refuse(
                a_loop,
                "a loop with checkpoints cannot stand in a closure that is passed to a function: put it into a function that the closure calls",
            );
        }
        let statements = &mut self.open_blocks.last_mut().expect("a block is open").1;
        if let Some(Statement::Loop(lowered)) = statements.last_mut() {
            lowered.checkpoint = true;
            if lowered.breaks || matches!(lowered.head, Head::Loop) {
                self.refuse(
                    a_loop,
                    "a loop with checkpoints cannot be left early with a value: give it to a variable, or take the attribute off",
                );
            }
        }
    }

    /// Whether a condition cannot be evaluated as it stands before each iteration.
    pub(super) fn is_not_plain(&self, condition: &Expr) -> bool {
        exits::expr_exits(condition)
            || has_let(condition)
            || self.calls_closure(condition, &|_| true)
            || self.changes(condition)
    }

    fn is_checkpointed(&mut self, attributes: &[syn::Attribute]) -> bool {
        let options = own_options(attributes);
        match options.and_then(|options| options.without_rules().map(|()| options)) {
            Ok(options) => options.checkpoint,
            Err(error) => {
                self.errors.add(error);
                false
            }
        }
    }

    /// A loop that is left by its own end only.
    pub(super) fn whole_loop(&mut self, expr: &Expr) -> LoopResult {
        let result = self.a_loop(expr);
        self.way(Action::Restore, Way { fork: result.fork, target: result.own });
        result
    }

    /// The value of a loop that is left by its own end only.
    pub fn loop_value(&mut self, expr: &Expr) -> Operand {
        let result = self.whole_loop(expr);
        match result.own {
            Some(_) => result.value,
            None => {
                self.refuse(expr, "a loop that never ends has no derivative: leave it by `break`")
            }
        }
    }

    /// Runs `body` for each item of an iterator.
    pub fn run_chain(&mut self, chain: &Expr, body: &mut Body<'_>) {
        let chain = self.chain(chain);
        self.run_over(&chain, body);
    }

    /// The same, for a chain that has been read.
    pub fn run_over(&mut self, chain: &Chain, body: &mut Body<'_>) {
        let result = self.run(None, &[], &Driver::Chain(chain, None), body);
        self.way(Action::Restore, Way { fork: result.fork, target: result.own });
    }

    fn run_block(
        &mut self,
        label: Option<&Label>,
        block: &syn::Block,
        driver: &Driver<'_>,
    ) -> LoopResult {
        let exits = exits::block_exits(block);
        self.run(label, &exits, driver, &mut |lowerer, _, end| {
            lowerer.statements(block.stmts.clone(), end)
        })
    }

    /// Lowers a loop whose body may jump by `exits`.
    fn run(
        &mut self,
        label: Option<&Label>,
        exits: &[Exit],
        driver: &Driver<'_>,
        body: &mut Body<'_>,
    ) -> LoopResult {
        let label = label.map(|label| label.name.clone());
        let kind = match driver {
            Driver::Chain(_, None) => JumpKind::Chain,
            _ => JumpKind::Loop,
        };
        self.jump(kind, label, |lowerer, id| {
            let (own, again) = (Target::Leave(id), Target::Again(id));
            let stops = matches!(driver, Driver::Chain(chain, _) if chain.stops());
            let ends_itself = !matches!(driver, Driver::Endless);
            let mut targets = lowerer.targets(exits);
            let breaks = targets.contains(&own) || stops;
            targets.retain(|target| ![own, again].contains(target));
            let leaves = !targets.is_empty();
            if breaks || (leaves && ends_itself) {
                targets.push(own);
            }
            let fork = lowerer.fork();
            let end = End { here: vec![again], exits: targets, fork, exit_fork: fork };
            let next = Way { fork, target: Some(again) };
            lowerer.way(Action::Store, next);

            let mut head = None;
            let block = lowerer.block(|lowerer| {
                lowerer.way(Action::Restore, next);
                let value = match driver {
                    Driver::Chain(chain, pat) => {
                        let items = lowerer.items(chain, *pat);
                        head = Some(Head::For {
                            reversible: items.is_reversible(),
                            pattern: items.pattern,
                            defines: items.defines,
                            iterator: items.iterator,
                            trip_count: chain.length(),
                        });
                        let body =
                            &mut |lowerer: &mut Lowerer<'_>, item: Item| body(lowerer, item, &end);
                        lowerer.run_stages(items.item, &items.stages, own, &end, body)
                    }
                    Driver::While(condition) => {
                        head = Some(Head::While(condition.clone()));
                        body(lowerer, Item::Value(Self::unit()), &end)
                    }
                    Driver::Endless => {
                        head = Some(Head::Loop);
                        body(lowerer, Item::Value(Self::unit()), &end)
                    }
                };
                if !end.exits.is_empty() {
                    return value;
                }
                lowerer.discard(value);
                Self::unit()
            });
            let head = head.expect("set by the block");
            lowerer.finish_loop(head, block, end, own, leaves || !ends_itself)
        })
    }

    fn finish_loop(
        &mut self,
        head: Head,
        body: Block,
        End { exits, fork, .. }: End,
        own: Target,
        has_result: bool,
    ) -> LoopResult {
        let span = proc_macro2::Span::call_site();
        let record = self.names.fresh("tape", span);
        let breaks = !exits.is_empty();
        let targets = match (breaks, &head) {
            (false, Head::For { .. } | Head::While(_)) => vec![own],
            _ => exits,
        };
        let result = has_result.then(|| {
            let ident = self.names.fresh("flow", span);
            self.var(ident, false, matches!(body.value, Operand::Var(_)))
        });
        let count = targets.len();
        let natural_end = self.link(Self::unit(), count.saturating_sub(1), count);
        let natural_end = self.tokens(&natural_end);
        let checkpoint = false;
        self.push(Statement::Loop(Loop {
            head,
            body,
            record,
            breaks,
            result,
            natural_end,
            checkpoint,
        }));
        let value = match result {
            Some(var) => self.operand_of(var),
            None => Self::unit(),
        };
        LoopResult { fork, value, own: targets.contains(&own).then_some(own), targets }
    }
}

/// Whether a condition binds names.
fn has_let(condition: &Expr) -> bool {
    has(condition, |part| match part {
        Expr::Let(_) => Some(true),
        Expr::Binary(_) | Expr::Paren(_) => None,
        _ => Some(false),
    })
}
