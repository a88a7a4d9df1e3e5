//! Blocks that an operator stands behind, in parentheses: at the beginning of a statement, where an expression may come
//! to stand, `{ .. } == 2` would be a block and then something else.

use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{Expr, Stmt, parse_quote_spanned};

/// The statements with these blocks in parentheses.
pub fn in_parentheses(mut stmts: Vec<Stmt>) -> Vec<Stmt> {
    stmts.iter_mut().for_each(|stmt| Leading.visit_stmt_mut(stmt));
    stmts
}

struct Leading;

impl VisitMut for Leading {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        visit_mut::visit_expr_mut(self, expr);
        let leading = match expr {
            Expr::Assign(assign) => &mut *assign.left,
            Expr::Binary(binary) => &mut *binary.left,
            Expr::Call(call) => &mut *call.func,
            Expr::Cast(cast) => &mut *cast.expr,
            Expr::Index(index) => &mut *index.expr,
            Expr::Range(range) => match &mut range.start {
                Some(start) => &mut **start,
                None => return,
            },
            _ => return,
        };
        if matches!(
            leading,
            Expr::Block(_) | Expr::If(_) | Expr::Loop(_) | Expr::Match(_) | Expr::Unsafe(_)
        ) {
            *leading = parse_quote_spanned!(leading.span()=> (#leading));
        }
    }
}
