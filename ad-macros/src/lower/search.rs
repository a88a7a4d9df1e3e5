//! Searches in expressions, for parts of a form and for the names that patterns bind.

use syn::visit::{self, Visit};
use syn::{Block, Expr, ExprMacro, Ident, Pat, PatIdent, StmtMacro};

/// Whether an expression has a part that is looked for, or is one itself. `look` is asked from outside in:
/// `None` sends it on to the parts of a part.
pub(super) fn has(expr: &Expr, look: impl FnMut(&Expr) -> Option<bool>) -> bool {
    let mut search = Search { look, found: false };
    search.visit_expr(expr);
    search.found
}

/// The same for the statements of a block.
pub(super) fn block_has(block: &Block, look: impl FnMut(&Expr) -> Option<bool>) -> bool {
    let mut search = Search { look, found: false };
    search.visit_block(block);
    search.found
}

struct Search<L> {
    look: L,
    found: bool,
}

impl<'ast, L: FnMut(&Expr) -> Option<bool>> Visit<'ast> for Search<L> {
    fn visit_expr(&mut self, expr: &'ast Expr) {
        match (self.look)(expr) {
            Some(found) => self.found |= found,
            None => visit::visit_expr(self, expr),
        }
    }

    fn visit_stmt_macro(&mut self, call: &'ast StmtMacro) {
        let expr = ExprMacro { attrs: Vec::new(), mac: call.mac.clone() };
        self.found |= (self.look)(&Expr::Macro(expr)) == Some(true);
    }
}

/// The names that patterns bind.
#[derive(Default)]
pub(super) struct Bound<'p>(Vec<&'p PatIdent>);

impl<'p> Bound<'p> {
    /// Those of a pattern.
    pub(super) fn by(pat: &'p Pat) -> Vec<&'p PatIdent> {
        let mut bound = Self::default();
        bound.visit_pat(pat);
        bound.0
    }

    /// Whether a pattern binds a name.
    pub(super) fn has(pat: &Pat, name: &Ident) -> bool {
        Bound::by(pat).iter().any(|bound| bound.ident == *name)
    }

    /// Those of all patterns in an expression.
    pub(super) fn within(expr: &'p Expr) -> Vec<&'p PatIdent> {
        let mut bound = Self::default();
        bound.visit_expr(expr);
        bound.0
    }
}

impl<'p> Visit<'p> for Bound<'p> {
    fn visit_pat_ident(&mut self, name: &'p PatIdent) {
        self.0.push(name);
        visit::visit_pat_ident(self, name);
    }
}
