//! Loops: a block, run again and again, whose end says whether to go on.

use proc_macro2::TokenStream;
use quote::quote;
use syn::visit::{self, Visit};
use syn::{Expr, Label, Lit, Pat, RangeLimits, parse_quote};

use super::ends::{End, JumpKind, Target};
use super::flow::strip_parens;
use super::{Lowerer, exits};
use crate::ir::{Head, Loop, Operand, Statement};

/// What a loop leaves behind: a chain of the targets where control goes next.
pub(super) struct LoopResult {
    pub value: Operand,
    pub targets: Vec<Target>,
    /// The target that is the end of the loop itself, with its value.
    pub own: Option<Target>,
}

impl Lowerer<'_> {
    /// A `for`, `while` or `loop`.
    pub(super) fn a_loop(&mut self, expr: &Expr) -> LoopResult {
        match expr {
            Expr::ForLoop(for_loop) => self.for_loop(for_loop),
            Expr::While(while_loop) => self.while_loop(while_loop),
            Expr::Loop(a_loop) => {
                let head = |_: &mut Self| Head::Loop;
                self.run(a_loop.label.as_ref(), &a_loop.body, head)
            }
            other => unreachable!("not a loop: {}", quote!(#other)),
        }
    }

    /// The value of a loop that is left by its own end only.
    pub(super) fn loop_value(&mut self, expr: &Expr) -> Operand {
        let result = self.a_loop(expr);
        match result.own {
            Some(_) => result.value,
            None => {
                self.refuse(expr, "a loop that never ends has no derivative: leave it by `break`")
            }
        }
    }

    fn while_loop(&mut self, while_loop: &syn::ExprWhile) -> LoopResult {
        let syn::ExprWhile { label, cond, body, .. } = while_loop;
        if exits::expr_exits(cond) || has_let(cond) {
            return self.a_loop(&parse_quote!(#label loop { if #cond #body else { break; } }));
        }
        let condition = self.plain(cond);
        self.run(label.as_ref(), body, |_| Head::While(condition))
    }

    fn for_loop(&mut self, expr: &syn::ExprForLoop) -> LoopResult {
        let Expr::Range(range) = strip_parens(&expr.expr) else {
            return self.refused_loop(
                &expr.expr,
                "only loops over a range `a..b` or `a..=b` can be differentiated: loop over an index",
            );
        };
        let (Some(from), Some(to)) = (&range.start, &range.end) else {
            return self.refused_loop(range, "the range of a differentiable loop needs both ends");
        };
        let trip_count = literal_length(from, to, &range.limits);
        let limits = &range.limits;
        let (from, to) = (self.plain_constant(from), self.plain_constant(to));
        let iterator = quote!(#from #limits #to);

        self.run(expr.label.as_ref(), &expr.body, |lowerer| {
            let mut defines = Vec::new();
            let pattern = match &*expr.pat {
                Pat::Ident(pat) if pat.by_ref.is_none() && pat.mutability.is_none() => {
                    let var = lowerer.bind(&pat.ident, false, false);
                    defines.push(var);
                    let ident = lowerer.ident(var);
                    quote!(#ident)
                }
                Pat::Wild(_) => quote!(_),
                pat => {
                    lowerer.refuse(pat, "name the loop variable: `for i in a..b`");
                    TokenStream::new()
                }
            };
            Head::For { pattern, defines, iterator, trip_count }
        })
    }

    fn refused_loop(&mut self, at: impl quote::ToTokens, message: &str) -> LoopResult {
        LoopResult {
            value: self.refuse(at, message),
            targets: vec![Target::Leave(0)],
            own: Some(Target::Leave(0)),
        }
    }

    /// Lowers a loop; `head`, called inside of the block of its body, binds the loop variables.
    fn run(
        &mut self,
        label: Option<&Label>,
        stmts: &syn::Block,
        head: impl FnOnce(&mut Self) -> Head,
    ) -> LoopResult {
        let label = label.map(|label| label.name.clone());
        self.jump(JumpKind::Loop, label, |lowerer, id| {
            let (own, again) = (Target::Leave(id), Target::Again(id));
            let mut targets = lowerer.targets(&exits::block_exits(stmts));
            let breaks = targets.contains(&own);
            targets.retain(|target| ![own, again].contains(target));
            let leaves = !targets.is_empty();

            let mut loop_head = None;
            let mut end = End { here: vec![again], exits: targets };
            let body = lowerer.block(|lowerer| {
                let head = loop_head.insert(head(lowerer));
                let ends_itself = !matches!(head, Head::Loop);
                if breaks || (leaves && ends_itself) {
                    end.exits.push(own);
                }
                lowerer.statements(stmts.stmts.clone(), &end)
            });
            let head = loop_head.expect("set by the block");
            let ends_itself = !matches!(head, Head::Loop);
            let targets = match end.exits.is_empty() && ends_itself {
                true => vec![own],
                false => end.exits.clone(),
            };

            let span = stmts.brace_token.span.join();
            let record = lowerer.names.fresh("tape", span);
            let result = (leaves || !ends_itself).then(|| {
                let ident = lowerer.names.fresh("flow", span);
                lowerer.var(ident, false, matches!(body.value, Operand::Var(_)))
            });
            let count = targets.len();
            let natural_end = lowerer.link(Self::unit(), count.saturating_sub(1), count);
            let natural_end = lowerer.tokens(&natural_end);
            let breaks = !end.exits.is_empty();
            lowerer.push(Statement::Loop(Loop { head, body, record, breaks, result, natural_end }));
            let value = match result {
                Some(var) if lowerer.vars[var].active => Operand::Var(var),
                Some(var) => {
                    let ident = lowerer.ident(var);
                    Operand::Constant(quote!(#ident))
                }
                None => Self::unit(),
            };
            LoopResult { value, own: targets.contains(&own).then_some(own), targets }
        })
    }
}

/// Whether a condition binds names.
fn has_let(condition: &Expr) -> bool {
    struct Finder(bool);

    impl<'ast> Visit<'ast> for Finder {
        fn visit_expr(&mut self, expr: &'ast Expr) {
            match expr {
                Expr::Let(_) => self.0 = true,
                Expr::Binary(_) | Expr::Paren(_) | Expr::Group(_) => visit::visit_expr(self, expr),
                _ => {}
            }
        }
    }

    let mut finder = Finder(false);
    finder.visit_expr(condition);
    finder.0
}

/// The length of a range between two literals.
fn literal_length(from: &Expr, to: &Expr, limits: &RangeLimits) -> Option<usize> {
    let literal = |expr: &Expr| match strip_parens(expr) {
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(number) => number.base10_parse::<usize>().ok(),
            _ => None,
        },
        _ => None,
    };
    let (from, to) = (literal(from)?, literal(to)?);
    Some(match limits {
        RangeLimits::HalfOpen(_) => to.saturating_sub(from),
        RangeLimits::Closed(_) => (to + 1).saturating_sub(from),
    })
}
