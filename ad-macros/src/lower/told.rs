//! Types that are written in one place and needed in another.
//!
//! In `let rows: Vec<f64> = m.iter().map(|row| row.iter().sum()).collect();` the type of the sums stands
//! far from them. The derivative adds them up where they stand, so it is told there; and `x.into()`, what it
//! makes of `x`.

use proc_macro2::{Ident, Span};
use syn::{Expr, ExprClosure, ExprMethodCall, Stmt, Type, parse_quote};

use super::chain::is_chain;
use crate::types::element;

/// The statements of a block with a value of this type.
pub(super) fn statements(mut stmts: Vec<Stmt>, ty: &Type) -> Vec<Stmt> {
    tell_last(&mut stmts, ty);
    stmts
}

fn tell_last(stmts: &mut [Stmt], ty: &Type) {
    if let Some(Stmt::Expr(value, None)) = stmts.last_mut() {
        tell(value, ty);
    }
}

/// Tells what a variable is set to the type of the variable.
pub(super) fn tell_local(value: &mut Expr, ty: &Type) {
    match value {
        Expr::MethodCall(call) if is_into(call) => {}
        value => tell(value, ty),
    }
}

/// Tells an expression its type.
pub(super) fn tell(value: &mut Expr, ty: &Type) {
    match value {
        Expr::Paren(paren) => tell(&mut paren.expr, ty),
        Expr::Block(block) => tell_last(&mut block.block.stmts, ty),
        Expr::MethodCall(call) if call.args.is_empty() && is_chain(&call.receiver) => {
            if call.method == "sum" || call.method == "product" {
                call.turbofish.get_or_insert_with(|| parse_quote!(::<#ty>));
            }
            if call.method == "collect" {
                match element(ty) {
                    Some(element) => tell_items(&mut call.receiver, element),
                    None if is_no_vec(ty) => {
                        call.turbofish.get_or_insert_with(|| parse_quote!(::<#ty>));
                    }
                    None => {}
                }
            }
        }
        Expr::MethodCall(call) if is_into(call) && !matches!(ty, Type::Infer(_)) => {
            let name = Ident::new("into", Span::mixed_site());
            *value = parse_quote!({
                let #name: #ty = #call;
                #name
            });
        }
        _ => {}
    }
}

/// `x.into()`
fn is_into(call: &ExprMethodCall) -> bool {
    call.method == "into" && call.args.is_empty()
}

/// Whether a name certainly is that of something else in the standard library than a `Vec`.
fn is_no_vec(ty: &Type) -> bool {
    const OTHERS: [&str; 9] = [
        "Option", "Result", "String", "Box", "VecDeque", "HashMap", "HashSet", "BTreeMap",
        "BTreeSet",
    ];
    matches!(ty, Type::Path(path)
        if path.path.segments.last().is_some_and(|last| OTHERS.iter().any(|name| last.ident == name)))
}

/// Tells an iterator the type of its items.
pub(super) fn tell_items(iterator: &mut Expr, ty: &Type) {
    if let Expr::MethodCall(call) = iterator
        && call.method == "map"
        && let Some(Expr::Closure(ExprClosure { body, .. })) = call.args.first_mut()
    {
        tell(body, ty);
    }
}
