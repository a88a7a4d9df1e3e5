//! What the form of an expression or a pattern tells.

use syn::{Expr, Ident, Macro, Member, Pat, Path, Stmt};

use super::search::has;

/// An expression without the parentheses around it.
pub fn strip_parens(expr: &Expr) -> &Expr {
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
    match base(expr) {
        Expr::Path(path) => path.path.get_ident(),
        _ => None,
    }
}

/// That of which an expression names a part.
pub(super) fn base(expr: &Expr) -> &Expr {
    match expr {
        Expr::Field(field) => base(&field.base),
        Expr::Index(index) => base(&index.expr),
        Expr::Paren(paren) => base(&paren.expr),
        Expr::Unary(unary) => base(&unary.expr),
        other => other,
    }
}

/// Whether an expression makes a value, and names no place.
pub(super) fn makes_value(expr: &Expr) -> bool {
    matches!(
        strip_parens(expr),
        Expr::Array(_)
            | Expr::Binary(_)
            | Expr::Call(_)
            | Expr::Lit(_)
            | Expr::Macro(_)
            | Expr::MethodCall(_)
            | Expr::Repeat(_)
            | Expr::Struct(_)
            | Expr::Tuple(_)
    )
}

/// The name that an expression consists of.
pub(super) fn simple_path(expr: &Expr) -> Option<&Ident> {
    match strip_parens(expr) {
        Expr::Path(path) => path.path.get_ident(),
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

/// The name of a macro of the standard library.
pub(super) fn standard_macro(path: &Path) -> Option<String> {
    let mut segments = path.segments.iter();
    let last = segments.next_back()?;
    let standard = |segment: &syn::PathSegment| segment.ident == "std" || segment.ident == "core";
    segments.all(standard).then(|| last.ident.to_string())
}

/// The number of arguments before the format string of a macro, by the name that those of the standard
/// library and of loggers have.
pub fn values_before_format(name: &str) -> Option<usize> {
    Some(match name {
        "print" | "println" | "eprint" | "eprintln" | "format" | "format_args" => 0,
        "panic" | "unreachable" | "todo" | "unimplemented" => 0,
        "error" | "warn" | "info" | "debug" | "trace" => 0,
        "assert" | "debug_assert" | "write" | "writeln" => 1,
        "assert_eq" | "assert_ne" | "debug_assert_eq" | "debug_assert_ne" => 2,
        _ => return None,
    })
}

/// Whether nothing is known of a macro.
pub fn is_unknown_macro(call: &Macro) -> bool {
    let name = standard_macro(&call.path).unwrap_or_default();
    let is_value = ["dbg", "vec", "matches"].contains(&&*name);
    !is_value && values_before_format(&name).is_none()
}

/// Whether control never passes the macro.
pub fn macro_diverges(call: &Macro) -> bool {
    standard_macro(&call.path)
        .is_some_and(|name| matches!(&*name, "panic" | "unreachable" | "todo" | "unimplemented"))
}

/// Whether something is called within an expression, apart from what closures do.
pub(super) fn calls(expr: &Expr) -> bool {
    has(expr, |part| match part {
        Expr::Call(_) | Expr::MethodCall(_) | Expr::Macro(_) => Some(true),
        Expr::Closure(_) => Some(false),
        _ => None,
    })
}

/// Whether two expressions are parts of different fields of one variable.
pub fn are_other_fields(left: &Expr, right: &Expr) -> bool {
    let (Some((left, left_fields)), Some((right, right_fields))) = (fields(left), fields(right))
    else {
        return false;
    };
    let mut both = left_fields.iter().zip(&right_fields);
    left == right && both.any(|(left, right)| left != right)
}

/// The variable at the root of a place, and the fields on the way from there; which elements are on it does not matter.
fn fields(place: &Expr) -> Option<(&Ident, Vec<&Member>)> {
    fn walk<'e>(place: &'e Expr, fields: &mut Vec<&'e Member>) -> Option<&'e Ident> {
        match place {
            Expr::Path(path) => path.path.get_ident(),
            Expr::Paren(inner) => walk(&inner.expr, fields),
            Expr::Field(field) => {
                let root = walk(&field.base, fields)?;
                fields.push(&field.member);
                Some(root)
            }
            Expr::Index(index) => walk(&index.expr, fields),
            _ => None,
        }
    }
    let mut fields = Vec::new();
    walk(place, &mut fields).map(|root| (root, fields))
}
