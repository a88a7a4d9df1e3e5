//! `#[differentiable]` on `impl Sum` and `impl Product` for one's own types.
//!
//! A sum is differentiated as the additions it is made of, so the attribute looks whether it is made
//! of them: `iter.fold(start, |sum, x| sum + x)`, whatever the start is.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{
    BinOp, Expr, ExprBinary, ExprClosure, ExprMethodCall, ImplItem, ItemImpl, Pat, Path,
    PathArguments, Stmt, UnOp,
};

/// Which of the two this is the trait of.
#[derive(Clone, Copy)]
pub enum Accumulation {
    Sum,
    Product,
}

/// The trait, if it is one of these.
pub fn of(path: &Path) -> Option<Accumulation> {
    let last = &path.segments.last()?.ident;
    match () {
        () if last == "Sum" => Some(Accumulation::Sum),
        () if last == "Product" => Some(Accumulation::Product),
        () => None,
    }
}

/// Says that sums, or products, of the type are made of its operator.
pub fn mark(kind: Accumulation, block: &ItemImpl) -> syn::Result<TokenStream> {
    let Some((path, _)) = &block.trait_ else { return Ok(TokenStream::new()) };
    let methods = block.items.iter().filter_map(|item| match item {
        ImplItem::Fn(method) => Some(method),
        _ => None,
    });
    for method in methods {
        let body = match &method.block.stmts[..] {
            [Stmt::Expr(body, None)] => Some(body),
            _ => None,
        };
        if !body.is_some_and(|body| is_fold(kind, body)) {
            let (name, form) = match kind {
                Accumulation::Sum => ("sum", "|sum, x| sum + x"),
                Accumulation::Product => ("product", "|product, x| product * x"),
            };
            return Err(syn::Error::new_spanned(
                &method.sig.ident,
                format!(
                    "a {name} is differentiated as a fold: write `iter.fold(start, {form})`, or take the attribute off, and fold where it is wanted"
                ),
            ));
        }
    }
    // That of references is made of the same operator.
    let takes_references = match path.segments.last().map(|last| &last.arguments) {
        Some(PathArguments::AngleBracketed(arguments)) => {
            quote!(#arguments).to_string().contains('&')
        }
        _ => false,
    };
    if takes_references {
        return Ok(TokenStream::new());
    }
    let (generics, _, bounds) = block.generics.split_for_impl();
    let (span, ty) = (path.span(), &block.self_ty);
    let mark = match kind {
        Accumulation::Sum => quote!(AddsUp),
        Accumulation::Product => quote!(MultipliesUp),
    };
    Ok(quote_spanned!(span=> impl #generics ::ad::rt::#mark for #ty #bounds {}))
}

/// Whether an expression is `iter.fold(start, |sum, x| sum + x)`.
fn is_fold(kind: Accumulation, body: &Expr) -> bool {
    let Expr::MethodCall(ExprMethodCall { receiver, method, args, .. }) = body else {
        return false;
    };
    let arguments: Vec<_> = args.iter().collect();
    match (&**receiver, &arguments[..]) {
        (Expr::Path(_), [_, Expr::Closure(step)]) => method == "fold" && is_step(kind, step),
        _ => false,
    }
}

/// Whether a closure applies the operator to its two parameters.
fn is_step(kind: Accumulation, step: &ExprClosure) -> bool {
    let names: Vec<_> = step.inputs.iter().map(bound_name).collect();
    let [Some(sum), Some(item)] = &names[..] else { return false };
    let Expr::Binary(ExprBinary { left, op, right, .. }) = &*step.body else { return false };
    let is_operator = match kind {
        Accumulation::Sum => matches!(op, BinOp::Add(_)),
        Accumulation::Product => matches!(op, BinOp::Mul(_)),
    };
    is_operator && is_named(left, sum) && is_named(right, item)
}

/// The name that a pattern binds: `x`, `&x`, `x: T`
fn bound_name(pattern: &Pat) -> Option<syn::Ident> {
    match pattern {
        Pat::Ident(pattern) if pattern.subpat.is_none() => Some(pattern.ident.clone()),
        Pat::Reference(pattern) => bound_name(&pattern.pat),
        Pat::Type(pattern) => bound_name(&pattern.pat),
        _ => None,
    }
}

/// Whether an expression is the variable `name`, or what it refers to.
fn is_named(expr: &Expr, name: &syn::Ident) -> bool {
    match expr {
        Expr::Path(path) => path.path.is_ident(name),
        Expr::Unary(unary) => matches!(unary.op, UnOp::Deref(_)) && is_named(&unary.expr, name),
        Expr::Paren(inner) => is_named(&inner.expr, name),
        _ => false,
    }
}
