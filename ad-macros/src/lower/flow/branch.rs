//! `if` and `match`.

use proc_macro2::TokenStream;
use quote::quote;
use syn::spanned::Spanned;
use syn::{Expr, Pat, parse_quote};

use crate::ir::{Arm, Binding, Branch, BranchKind, Operand, Statement};
use crate::lower::Lowerer;
use crate::lower::place::pattern::Matched;
use crate::lower::rewrite::desugar;
use crate::lower::syntax::strip_parens;
use crate::names;

impl Lowerer<'_> {
    /// An `if` or `match`; `lower_arm` gives the value of each arm's body.
    pub fn branch_value(
        &mut self,
        expr: &Expr,
        lower_arm: &mut dyn FnMut(&mut Self, &Expr) -> Operand,
    ) -> Operand {
        let (kind, arms) = self.branch_arms(expr, lower_arm);
        self.branch(kind, arms, true, expr.span())
    }

    /// An `if` or `match` whose value nobody asks for.
    pub(super) fn branch_statement(
        &mut self,
        expr: &Expr,
        lower_arm: &mut dyn FnMut(&mut Self, &Expr) -> Operand,
    ) {
        let (kind, arms) = self.branch_arms(expr, lower_arm);
        self.branch(kind, arms, false, expr.span());
    }

    pub fn branch(
        &mut self,
        kind: BranchKind,
        arms: Vec<Arm>,
        wants_value: bool,
        span: proc_macro2::Span,
    ) -> Operand {
        let record = self.names.fresh("path", span);
        let result = wants_value.then(|| {
            let active = arms.iter().any(|arm| matches!(arm.body.value, Operand::Var(_)));
            let may_refer =
                |arm: &Arm| matches!(&arm.body.value, Operand::Var(var) if self.may_refer(*var));
            let reference = arms.iter().any(may_refer);
            let ident = self.names.fresh("value", span);
            let var = self.var(ident, false, active);
            self.vars[var].reference = reference;
            var
        });
        self.push(Statement::Branch(Branch { result, record, kind, arms }));
        match result {
            Some(var) => self.operand_of(var),
            None => Self::unit(),
        }
    }

    /// A guard, which sees the names that the pattern has.
    fn as_written(&self, guard: TokenStream, bindings: &[Binding]) -> TokenStream {
        bindings.iter().fold(guard, |guard, binding| match &binding.written {
            Some(written) => names::renamed(guard, self.ident(binding.var), written),
            None => guard,
        })
    }

    fn branch_arms(
        &mut self,
        expr: &Expr,
        lower_arm: &mut dyn FnMut(&mut Self, &Expr) -> Operand,
    ) -> (BranchKind, Vec<Arm>) {
        match &desugar::branch(expr.clone()) {
            Expr::If(branch) => {
                let then = &branch.then_branch;
                let then: Expr = parse_quote!(#then);
                let otherwise = desugar::otherwise(branch);
                if let Expr::Let(condition) = strip_parens(&branch.cond) {
                    let (pat, matched) = (&condition.pat, &condition.expr);
                    let as_match: Expr =
                        parse_quote!(match #matched { #pat => #then, _ => #otherwise });
                    return self.branch_arms(&as_match, lower_arm);
                }
                let condition = self.condition(&branch.cond);
                let arms = [then, otherwise]
                    .map(|body| Arm::plain(self.block(|lowerer| lower_arm(lowerer, &body))));
                (BranchKind::If(condition), arms.into())
            }
            Expr::Match(branch) => {
                if let Some(lent) = self.match_on_lent(branch, lower_arm) {
                    return lent;
                }
                if let Some(by_reference) = self.option_by_reference(branch) {
                    return self.branch_arms(&by_reference, lower_arm);
                }
                let exclusive = self.exclusive_scrutinee(&branch.expr);
                let (matched, source) = match &exclusive {
                    Some(place) => {
                        let place = self.place_tokens(place);
                        (quote!(&mut #place), None)
                    }
                    None => self.scrutinee(&branch.expr),
                };
                let way = exclusive.as_ref().map_or(&[][..], |place| &place.path);
                let reference = match &source {
                    _ if matches!(*branch.expr, Expr::Reference(_)) => true,
                    _ if self.depth(&branch.expr) > 0 => true,
                    Some(place) => place.path.is_empty() && self.may_refer(place.root),
                    None => false,
                };
                let patterns = branch.arms.iter().map(|arm| &arm.pat);
                let length = self.length_for(patterns, &matched);
                let active = source.is_some() || exclusive.is_some();
                let exclusive = exclusive.as_ref().map(|place| (place.root, way.len()));
                let arms = branch.arms.iter().map(|arm| {
                    let (pat, guard) = match &arm.pat {
                        Pat::Guard(guarded) => (&*guarded.pat, Some(&guarded.guard)),
                        pat => (pat, None),
                    };
                    let active = active || self.may_carry(pat, &arm.body);
                    let matched_value =
                        Matched { active, refutable: true, reference, length, exclusive };
                    let mut pattern = TokenStream::new();
                    let mut bindings = Vec::new();
                    let mut guard_tokens = None;
                    let body = self.block(|lowerer| {
                        let first = lowerer.vars.len();
                        pattern = lowerer.subpattern(pat, way, matched_value, &mut bindings);
                        if !active {
                            let bound = first..lowerer.vars.len();
                            lowerer.parts_of.extend(bound.map(|var| (var, matched.clone())));
                        }
                        guard_tokens = guard.map(|guard| {
                            let guard = lowerer.plain_in_place(guard);
                            lowerer.as_written(guard, &bindings)
                        });
                        lower_arm(lowerer, &arm.body)
                    });
                    Arm { pattern, guard: guard_tokens, bindings, body }
                });
                let arms = arms.collect();
                (BranchKind::Match(matched, source), arms)
            }
            other => unreachable!("not a branch: {}", quote!(#other)),
        }
    }
}
