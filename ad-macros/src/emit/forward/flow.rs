//! Branches, loops and builds.

use proc_macro2::TokenStream;
use quote::quote;

use super::{Tangent, Writer};
use crate::ir::{Branch, Build, Head, Keep, Loop, Operand, Operation, Statement};

impl Writer<'_> {
    pub(super) fn branch(&mut self, branch: &Branch) -> TokenStream {
        let source = branch.source();
        let arms: Vec<_> = branch
            .arms
            .iter()
            .map(|arm| {
                // Positions that count from the end are computed first.
                let is_position = |statement: &Statement| match statement {
                    Statement::Define { var, operation: Operation::Use(operand), .. } => {
                        matches!(operand, Operand::Constant(_)) && !self.lowered.vars[*var].active
                    }
                    _ => false,
                };
                let first = arm.body.statements.iter().take_while(|s| is_position(s)).count();
                let (positions, rest) = arm.body.statements.split_at(first);
                let named = self.named(&arm.bindings);
                let positions = self.statements(positions);
                let ends = self.uses.end_in_arm(arm.body.id);
                let bound = self.bindings(&arm.bindings, source, ends);
                let statements = self.statements(rest);
                quote!(#named #positions #bound #statements)
            })
            .collect();
        let result = branch.result;
        let moves = result.is_some_and(|result| self.lowered.vars[result].active)
            && branch.arms.iter().any(|arm| !self.is_still(&arm.body.value));
        let bodies = branch.arms.iter().zip(arms).map(|(arm, statements)| {
            let value = match (result, moves) {
                (None, _) => TokenStream::new(),
                (Some(_), true) => self.pair(&arm.body),
                (Some(_), false) => self.tokens(&arm.body.value),
            };
            quote!({ #statements #value })
        });
        let choice = branch.choose(bodies);
        match result {
            None => choice,
            Some(result) if moves => {
                let ident = self.ident(result).clone();
                let dot = self.new_dot(result, Tangent::OwnedTarget);
                quote!(let (#ident, #dot) = #choice;)
            }
            Some(result) => {
                let ident = self.ident(result);
                quote!(let #ident = #choice;)
            }
        }
    }

    pub(super) fn a_loop(&mut self, a_loop: &Loop) -> TokenStream {
        let Loop { head, body, natural_end, .. } = a_loop;
        let statements = self.block(body);
        let value = self.tokens(&body.value);
        let flow = match &body.value {
            Operand::Var(flow) if !self.is_still(&body.value) => Some(*flow),
            _ => None,
        };
        let result = a_loop.result.map(|result| self.ident(result).clone());
        let moves = a_loop.result.zip(flow);
        // A body that always leaves does not tell the type of `Continue`.
        let content = quote!(::core::ops::ControlFlow::<_, ()>::Break(content));
        let exit = match (a_loop.breaks, &result, head, moves) {
            (false, ..) => None,
            (true, _, Head::Loop, Some((_, flow))) => {
                let dot = self.dot(flow);
                Some(quote!(if let #content = #value { break (content, #dot.0); }))
            }
            (true, _, Head::Loop, None) => {
                Some(quote!(if let #content = #value { break content; }))
            }
            (true, None, ..) => {
                Some(quote!(if ::core::ops::ControlFlow::<_, ()>::is_break(&#value) { break; }))
            }
            (true, Some(result), _, Some((target, flow))) => {
                let (dot, from) = (self.dot(target), self.dot(flow));
                Some(quote! {
                    if let #content = #value {
                        #result = content;
                        #dot = #from.0;
                        break;
                    }
                })
            }
            (true, Some(result), _, None) => {
                Some(quote!(if let #content = #value { #result = content; break; }))
            }
        };
        let iteration = quote!({ #statements #exit });
        let dot = moves.map(|(target, _)| self.new_dot(target, Tangent::OwnedTarget));
        match (head, result, dot) {
            (Head::Loop, Some(result), Some(dot)) => {
                quote!(let (#result, #dot) = loop #iteration;)
            }
            (Head::Loop, Some(result), None) => quote!(let #result = loop #iteration;),
            (Head::Loop, None, _) => quote!(loop #iteration),
            (head, result, dot) => {
                let result = result.map(|result| match &dot {
                    Some(dot) => quote! {
                        let (mut #result, mut #dot) = ::ad::rt::with_zero(#natural_end);
                    },
                    None => quote!(let mut #result = #natural_end;),
                });
                let head = match head {
                    Head::For { pattern, iterator, .. } => quote!(for #pattern in #iterator),
                    Head::While(condition) => quote!(while #condition),
                    Head::Loop => unreachable!("handled above"),
                };
                quote!(#result #head #iteration)
            }
        }
    }

    pub(super) fn build(&mut self, build: &Build) -> TokenStream {
        let Build { result, body, .. } = build;
        let statements = self.block(body);
        let moves = self.lowered.vars[*result].active && !self.is_still(&body.value);
        let element = match moves {
            true => self.pair(body),
            false => self.tokens(&body.value),
        };
        let element = quote!({ #statements #element });
        let dot = moves.then(|| self.new_dot(*result, Tangent::Owned));
        build.definition(&self.lowered.vars, &element, dot.as_ref())
    }

    /// What ways keep moves with its tangent.
    pub(super) fn keep(&mut self, keep: &Keep) -> TokenStream {
        keep.statements(&self.lowered.vars, |var| {
            let ident = self.ident(var).clone();
            match self.tangents[var] {
                Tangent::Still => quote!(#ident),
                _ => {
                    let dot = self.dot(var);
                    quote!((#ident, #dot))
                }
            }
        })
    }
}
