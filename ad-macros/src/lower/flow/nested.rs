//! Blocks within blocks.
//!
//! The statements of a block that is evaluated whenever what stands around it is, become part of that:
//! fewer blocks are fewer things to save. But a value that its block drops may have an effect when it
//! is dropped (it unlocks, it pops what it pushed), so a block that may hold such a value stays one.

use proc_macro2::Ident;
use quote::quote;
use syn::{Expr, ExprPath, Type};

use crate::floats;
use crate::ir::{Arm, Block, BranchKind, Operand, Operation, Statement};
use crate::lower::Lowerer;
use crate::lower::call;
use crate::lower::call::callee::is_associated;
use crate::lower::expression::operator::is_own_name;
use crate::lower::syntax::is_type_name;
use crate::types::is_discrete;

impl Lowerer<'_> {
    /// A block whose value is that of `fill`, in a scope of names of its own.
    pub fn nested(&mut self, fill: impl FnOnce(&mut Self) -> Operand) -> Operand {
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

    /// Whether a variable of the block may have an effect when it is dropped: one that holds what a call made
    /// which is not known to return a number.
    fn may_hold_guard(&self, block: &Block) -> bool {
        block.statements.iter().any(|statement| match statement {
            Statement::Define { var, .. } if self.temporaries.contains(var) => true,
            Statement::Define { var, ty, operation: Operation::Use(value) } => {
                self.vars[*var].is_binding
                    && !ty.as_ref().is_some_and(is_number)
                    && self.may_be_guard(value, &[block])
            }
            Statement::Assign { place, value } => {
                let root = &self.vars[place.root];
                root.block == block.id && !root.active && self.may_be_guard(value, &[block])
            }
            Statement::Plain { defines, .. } => {
                !defines.is_empty() && self.may_define_guard(statement, &[block])
            }
            _ => false,
        })
    }

    /// Whether an operand, which stands in the innermost of `blocks`, may be or hold such a value.
    fn may_be_guard(&self, operand: &Operand, blocks: &[&Block]) -> bool {
        match operand {
            Operand::Constant(code) => {
                syn::parse2(code.clone()).is_ok_and(|code| self.may_make_guard(&code, blocks))
            }
            Operand::Var(_) => false,
        }
    }

    /// Whether a statement, which stands in the innermost of `blocks`, gives such a value to a variable.
    fn may_define_guard(&self, statement: &Statement, blocks: &[&Block]) -> bool {
        match statement {
            Statement::Define { operation: Operation::Use(value), .. } => {
                self.may_be_guard(value, blocks)
            }
            Statement::Plain { code, .. } => match syn::parse2(code.clone()) {
                Ok(syn::Stmt::Local(syn::Local { init: Some(init), .. })) => {
                    self.may_make_guard(&init.expr, blocks)
                }
                _ => false,
            },
            Statement::Branch(branch) => branch.arms.iter().any(|arm| {
                let blocks = [blocks, &[&arm.body]].concat();
                self.may_be_guard(&arm.body.value, &blocks)
            }),
            Statement::Loop(_) => true,
            _ => false,
        }
    }

    fn may_make_guard(&self, expr: &Expr, blocks: &[&Block]) -> bool {
        let is_guard = |part: &Expr| self.may_make_guard(part, blocks);
        match expr {
            Expr::Paren(inner) => is_guard(&inner.expr),
            Expr::Reference(reference) => is_guard(&reference.expr),
            Expr::Field(field) => is_guard(&field.base),
            Expr::Index(index) => is_guard(&index.expr),
            Expr::Unary(unary) => is_guard(&unary.expr),
            Expr::Path(path) if self.may_be_unit_guard(path) => true,
            Expr::Path(path) => path.path.get_ident().is_some_and(|name| {
                let open = self.open_blocks.iter().flat_map(|(_, statements)| statements);
                let mut statements = blocks.iter().flat_map(|block| &block.statements).chain(open);
                let definition =
                    statements.find(|statement| self.defines(statement).any(|var| var == name));
                definition.is_some_and(|definition| self.may_define_guard(definition, blocks))
            }),
            Expr::Call(call) => match &*call.func {
                Expr::Path(function) if is_associated(function) => {
                    let owner = function.path.segments.iter().rev().nth(1);
                    owner.is_none_or(|owner| self.may_end_as(&owner.ident))
                        || call.args.iter().any(is_guard)
                }
                _ => true,
            },
            Expr::MethodCall(call) => {
                let name = call.method.to_string();
                !floats::takes_number(&name) && !call::is_predicate(&name)
            }
            Expr::Tuple(tuple) => tuple.elems.iter().any(is_guard),
            Expr::Array(array) => array.elems.iter().any(is_guard),
            Expr::Macro(_) | Expr::Struct(_) => true,
            _ => false,
        }
    }

    /// Whether a path is a unit struct, `Leave`, or an associated constant, `Leave::NEW`.
    fn may_be_unit_guard(&self, path: &ExprPath) -> bool {
        let mut names = path.path.segments.iter().rev().map(|segment| &segment.ident);
        match (names.next(), names.next()) {
            (Some(name), None) => {
                is_type_name(name) && name.to_string().contains(char::is_lowercase)
            }
            (Some(_), Some(owner)) => is_type_name(owner) && self.may_end_as(owner),
            (None, _) => false,
        }
    }

    /// The variables that a statement defines, by their names.
    fn defines<'s>(&'s self, statement: &'s Statement) -> impl Iterator<Item = &'s Ident> {
        let vars = match statement {
            Statement::Define { var, .. } => std::slice::from_ref(var),
            Statement::Plain { defines, .. } => defines,
            Statement::Branch(branch) => branch.result.as_slice(),
            Statement::Loop(a_loop) => a_loop.result.as_slice(),
            _ => &[],
        };
        vars.iter().map(|&var| self.ident(var))
    }

    /// Whether a type of this name may have an effect when its values are dropped, not counting what they hold.
    pub(super) fn may_end_as(&self, ty: &Ident) -> bool {
        is_own_name(ty) && !self.scalars.contains(ty)
    }
}

fn is_number(ty: &Type) -> bool {
    let is_float = |path: &syn::TypePath| path.path.is_ident("f32") || path.path.is_ident("f64");
    is_discrete(ty) || matches!(ty, Type::Path(path) if is_float(path))
}
