//! Tuples that are named as a whole and used by their fields alone: `|t| t.0 * t.1` is `|(a, b)| a * b`.
//!
//! Parts of a tuple may be references to places, which names may stand for and fields may not.

use proc_macro2::Ident;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{Block, Expr, ExprField, Macro, Member, PatIdent, Stmt, parse_quote};

use crate::lower::search::Bound;

/// The statements with `names` for the fields of the tuple `whole`; `None` if there are other uses of it.
pub fn named(whole: &Ident, names: &[Ident], stmts: &[Stmt]) -> Option<Vec<Stmt>> {
    let mut stmts = stmts.to_vec();
    let mut writer = Writer { whole, names, are_fields: true };
    writer.visit_statements(&mut stmts);
    writer.are_fields.then_some(stmts)
}

struct Writer<'n> {
    whole: &'n Ident,
    names: &'n [Ident],
    are_fields: bool,
}

impl Writer<'_> {
    /// Up to where another variable has the name.
    fn visit_statements(&mut self, stmts: &mut [Stmt]) {
        for stmt in stmts {
            match stmt {
                Stmt::Local(local) if Bound::has(&local.pat, self.whole) => {
                    if let Some(init) = &mut local.init {
                        visit_mut::visit_local_init_mut(self, init);
                    }
                    return;
                }
                stmt => self.visit_stmt_mut(stmt),
            }
        }
    }

    /// The name of the field that an expression is.
    fn name_of(&self, field: &ExprField) -> Option<Ident> {
        let (Expr::Path(base), Member::Unnamed(index)) = (&*field.base, &field.member) else {
            return None;
        };
        let name = self.names.get(index.index as usize).filter(|_| base.path.is_ident(self.whole));
        let mut name = name?.clone();
        name.set_span(name.span().located_at(field.member.span()));
        Some(name)
    }
}

impl VisitMut for Writer<'_> {
    fn visit_block_mut(&mut self, block: &mut Block) {
        self.visit_statements(&mut block.stmts);
    }

    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        match expr {
            Expr::Field(field) if let Some(name) = self.name_of(field) => {
                *expr = parse_quote!(#name);
            }
            Expr::Path(path) => self.are_fields &= !path.path.is_ident(self.whole),
            Expr::Closure(closure)
                if closure.inputs.iter().any(|input| Bound::has(input, self.whole)) => {}
            _ => visit_mut::visit_expr_mut(self, expr),
        }
    }

    fn visit_pat_ident_mut(&mut self, pat: &mut PatIdent) {
        self.are_fields &= pat.ident != *self.whole;
        visit_mut::visit_pat_ident_mut(self, pat);
    }

    // A message may name it, too.
    fn visit_macro_mut(&mut self, call: &mut Macro) {
        self.are_fields &= !call.tokens.to_string().contains(&self.whole.to_string());
    }
}
