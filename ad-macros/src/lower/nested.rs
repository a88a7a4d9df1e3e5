//! Blocks within blocks.
//!
//! The statements of a block that is evaluated whenever what stands around it is, become part of that:
//! fewer blocks are fewer things to save. But a value that its block drops may have an effect when it
//! is dropped (it unlocks, it pops what it pushed), so a block that may hold such a value stays one.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::{Expr, Type};

use super::Lowerer;
use super::callee::is_associated;
use super::operator::is_own_name;
use crate::floats;
use crate::ir::{Arm, Block, BranchKind, Operand, Operation, Statement};
use crate::types::is_discrete;

impl Lowerer<'_> {
    /// A block whose value is that of `fill`, in a scope of names of its own.
    pub(super) fn nested(&mut self, fill: impl FnOnce(&mut Self) -> Operand) -> Operand {
        let body = self.block(fill);
        if self.may_hold_guard(&body) {
            let (pattern, bindings) = (quote!(_), Vec::new());
            let arms = vec![Arm { pattern, guard: None, bindings, body }];
            let span = proc_macro2::Span::call_site();
            return self.branch(BranchKind::Match(quote!(()), None), arms, true, span);
        }
        let around = self.open_blocks.last().expect("a block is open").0;
        for var in self.vars.iter_mut().filter(|var| var.block == body.id) {
            var.block = around;
        }
        body.statements.into_iter().for_each(|statement| self.push(statement));
        body.value
    }

    /// Whether a variable of the block may have an effect when it is dropped: one that a call made which
    /// is not known to return a number.
    fn may_hold_guard(&self, block: &Block) -> bool {
        block.statements.iter().any(|statement| match statement {
            Statement::Define { var, .. } if self.temporaries.contains(var) => true,
            Statement::Define { var, ty, operation: Operation::Use(Operand::Constant(code)) } => {
                self.vars[*var].is_binding
                    && !ty.as_ref().is_some_and(is_number)
                    && self.may_make_guard(code)
            }
            Statement::Plain { code, defines } if !defines.is_empty() => {
                match syn::parse2(code.clone()) {
                    Ok(syn::Stmt::Local(syn::Local { init: Some(init), .. })) => {
                        may_be_guard(&init.expr, &self.scalars)
                    }
                    _ => false,
                }
            }
            _ => false,
        })
    }

    fn may_make_guard(&self, code: &TokenStream) -> bool {
        syn::parse2(code.clone()).is_ok_and(|expr| may_be_guard(&expr, &self.scalars))
    }
}

fn is_number(ty: &Type) -> bool {
    let is_float = |path: &syn::TypePath| path.path.is_ident("f32") || path.path.is_ident("f64");
    is_discrete(ty) || matches!(ty, Type::Path(path) if is_float(path))
}

fn may_be_guard(expr: &Expr, scalars: &[Ident]) -> bool {
    match expr {
        Expr::Paren(inner) => may_be_guard(&inner.expr, scalars),
        Expr::Call(call) => match &*call.func {
            Expr::Path(function) if is_associated(function) => {
                let owner = function.path.segments.iter().rev().nth(1);
                owner.is_none_or(|owner| {
                    is_own_name(&owner.ident) && !scalars.contains(&owner.ident)
                })
            }
            _ => true,
        },
        Expr::MethodCall(call) => {
            let name = call.method.to_string();
            !floats::takes_number(&name) && !super::call::is_predicate(&name)
        }
        Expr::Tuple(tuple) => tuple.elems.iter().any(|part| may_be_guard(part, scalars)),
        Expr::Array(array) => array.elems.iter().any(|part| may_be_guard(part, scalars)),
        Expr::Macro(_) | Expr::Struct(_) => true,
        _ => false,
    }
}
