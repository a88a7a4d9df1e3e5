//! What the form of an expression or a pattern tells.

use syn::{Expr, Ident, Member, Pat, Path, Stmt};

/// An expression without the parentheses around it.
pub(super) fn strip_parens(expr: &Expr) -> &Expr {
    match expr {
        Expr::Paren(paren) => strip_parens(&paren.expr),
        _ => expr,
    }
}

/// A pattern, and the type written behind it.
pub(super) fn split_type(pat: &Pat) -> (&Pat, Option<&syn::Type>) {
    match pat {
        Pat::Type(typed) => (&typed.pat, Some(&typed.ty)),
        pat => (pat, None),
    }
}

/// The statements of a block, or an expression as the only one.
pub(super) fn as_statements(expr: &Expr) -> Vec<Stmt> {
    match expr {
        Expr::Block(block) if block.label.is_none() => block.block.stmts.clone(),
        expr => vec![Stmt::Expr(expr.clone(), None)],
    }
}

/// The name of the variable that a place is a part of.
pub(super) fn root_name(expr: &Expr) -> Option<&Ident> {
    match expr {
        Expr::Path(path) => path.path.get_ident(),
        Expr::Field(field) => root_name(&field.base),
        Expr::Index(index) => root_name(&index.expr),
        Expr::Paren(paren) => root_name(&paren.expr),
        Expr::Unary(unary) => root_name(&unary.expr),
        _ => None,
    }
}

/// The name that a pattern gives to the whole value.
pub(super) fn simple_name(pat: &Pat) -> Option<&Ident> {
    match pat {
        Pat::Ident(ident) if ident.by_ref.is_none() && ident.subpat.is_none() => Some(&ident.ident),
        _ => None,
    }
}

/// Types, variants and constants begin with a capital letter.
pub(super) fn is_type_name(ident: &syn::Ident) -> bool {
    ident
        .to_string()
        .trim_start_matches("r#")
        .trim_start_matches('_')
        .starts_with(char::is_uppercase)
}

/// `Some`
pub(super) fn is_transparent(path: &Path) -> bool {
    is_standard_variant(path, "Option")
        && path.segments.last().is_some_and(|last| last.ident == "Some")
}

/// Whether a path may lead to a variant of the standard library's `owner`.
fn is_standard_variant(path: &Path, owner: &str) -> bool {
    let named = path.segments.iter().rev().nth(1);
    named.is_none_or(|segment| segment.ident == owner)
}

/// `Ok`, `Err`: the member of the cotangent of a `Result`.
pub(super) fn outcome(path: &Path) -> Option<Member> {
    let last = &path.segments.last()?.ident;
    if !is_standard_variant(path, "Result") {
        return None;
    }
    match () {
        () if last == "Ok" => Some(Member::from(0)),
        () if last == "Err" => Some(Member::from(1)),
        () => None,
    }
}

/// Whether a pattern is a name and nothing else.
pub(super) fn is_plain_name(pat: &syn::PatIdent) -> bool {
    pat.by_ref.is_none() && pat.subpat.is_none() && pat.mutability.is_none()
}
