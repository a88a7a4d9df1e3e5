//! `no_diff(|| ..)`: any Rust, of which nothing is differentiated.
//!
//! The closure stays as it is, with variables renamed. It may read them all; that it changes none
//! behind the reverse sweep's back the compiler sees to, for `no_diff` takes an `Fn`.

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::visit_mut::{self, VisitMut};
use syn::{Expr, ExprCall, ExprClosure, FieldValue, Macro, Path, parse_quote};

use crate::ir::VarId;
use crate::lower::Lowerer;
use crate::lower::call::macros::captured_names;
use crate::lower::syntax::values_before_format;

/// `no_diff(|| ..)`
pub fn undifferentiated(call: &ExprCall) -> Option<&ExprClosure> {
    let Expr::Path(function) = &*call.func else { return None };
    let is_named = function.path.segments.last().is_some_and(|last| last.ident == "no_diff");
    match call.args.first() {
        Some(Expr::Closure(closure))
            if is_named && call.args.len() == 1 && closure.inputs.is_empty() =>
        {
            Some(closure)
        }
        _ => None,
    }
}

/// `stop_gradient(x)`
pub fn stopped(call: &ExprCall) -> Option<&Path> {
    let Expr::Path(function) = &*call.func else { return None };
    let is_named = function.path.segments.last().is_some_and(|last| last.ident == "stop_gradient");
    (is_named && call.args.len() == 1).then_some(&function.path)
}

/// Visits what a call is given.
pub(super) fn visit_arguments(visitor: &mut impl VisitMut, call: &mut syn::ExprCall) {
    call.args.iter_mut().for_each(|argument| visitor.visit_expr_mut(argument));
}

impl Lowerer<'_> {
    /// Has the compiler check that a path leads to `ad::stop_gradient`.
    pub(super) fn check_stopped(&mut self, path: &Path) {
        self.check_function(path, &quote!(::ad::stop_gradient), &quote!(::<u8>));
    }

    /// The value of `no_diff(|| ..)`, as it is here and now.
    pub fn no_diff(&mut self, function: &Expr, closure: &ExprClosure) -> TokenStream {
        if let Expr::Path(path) = function {
            self.check_function(&path.path, &quote!(::ad::no_diff), &quote!(::<u8, fn() -> u8>));
        }
        let mut bound = Bound { lowerer: self, again: None };
        bound.visit_expr(&closure.body);
        if let Some(name) = bound.again {
            self.refuse(
                &name,
                format!(
                    "`{name}` has a meaning outside of `no_diff` too: choose another name here"
                ),
            );
        }
        let mut closure = closure.clone();
        Renamed { lowerer: self }.visit_expr_mut(&mut closure.body);
        self.named_tokens("constant", closure.span(), quote!(#function(#closure)))
    }

    /// What the user's name for a variable stands for.
    pub(super) fn value_of(&self, var: VarId, span: Span) -> Expr {
        match self.aliases.get(&var) {
            Some(alias) => {
                let place = self.place_tokens(&alias.place);
                let place: Expr = parse_quote!(#place);
                (0..alias.depth).fold(place, |inner, _| parse_quote!((&#inner)))
            }
            None => {
                let ident = self.ident_at(var, span);
                parse_quote!(#ident)
            }
        }
    }
}

/// Looks for names that are bound again.
struct Bound<'l, 'a> {
    lowerer: &'l Lowerer<'a>,
    again: Option<Ident>,
}

impl<'ast> Visit<'ast> for Bound<'_, '_> {
    fn visit_pat_ident(&mut self, pat: &'ast syn::PatIdent) {
        if self.again.is_none() && self.lowerer.lookup(&pat.ident).is_some() {
            self.again = Some(pat.ident.clone());
        }
        visit::visit_pat_ident(self, pat);
    }
}

struct Renamed<'l, 'a> {
    lowerer: &'l mut Lowerer<'a>,
}

impl Renamed<'_, '_> {
    fn lookup(&self, ident: &Ident) -> Option<VarId> {
        self.lowerer.lookup(ident)
    }
}

impl VisitMut for Renamed<'_, '_> {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        let outside = self.lowerer.scopes.count();
        self.lowerer.check_cells(expr, outside);
        if let Expr::Call(call) = expr
            && self.lowerer.function_parameter(&call.func).is_some()
        {
            visit_arguments(self, call);
            *expr = self.lowerer.plain_call_of_parameter(call);
            return;
        }
        let Expr::Path(path) = expr else {
            return visit_mut::visit_expr_mut(self, expr);
        };
        let Some(var) = path.path.get_ident().and_then(|name| self.lookup(name)) else { return };
        if self.lowerer.closures.contains_key(&var) {
            self.lowerer.refuse(
                &*path,
                "bind the value of this closure to a variable with `let` before `no_diff`",
            );
        }
        *expr = self.lowerer.value_of(var, path.span());
    }

    fn visit_field_value_mut(&mut self, field: &mut FieldValue) {
        // `S { x }` becomes `S { x: renamed }`.
        field.colon_token.get_or_insert_default();
        visit_mut::visit_field_value_mut(self, field);
    }

    fn visit_macro_mut(&mut self, call: &mut Macro) {
        let name = call.path.segments.last().map(|last| last.ident.to_string());
        let captured = match name.as_deref().and_then(values_before_format) {
            Some(position) => self.captured_by(&call.tokens, position),
            None => TokenStream::new(),
        };
        let tokens = self.renamed_tokens(call.tokens.clone());
        call.tokens = quote!(#tokens #captured);
    }
}

impl Renamed<'_, '_> {
    /// The variables that the format string names which is the argument at `position`, as further
    /// arguments.
    fn captured_by(&self, tokens: &TokenStream, position: usize) -> TokenStream {
        let tokens: Vec<_> = tokens.clone().into_iter().collect();
        let is_punct = |token: &TokenTree, mark: char| matches!(token, TokenTree::Punct(punct) if punct.as_char() == mark);
        let mut arguments = tokens.split(|token| is_punct(token, ','));
        let Some([TokenTree::Literal(format)]) = arguments.nth(position) else {
            return TokenStream::new();
        };
        let syn::Lit::Str(format) = syn::Lit::new(format.clone()) else {
            return TokenStream::new();
        };
        let named: Vec<_> = arguments
            .filter_map(|argument| match argument {
                [TokenTree::Ident(name), equals, ..] if is_punct(equals, '=') => Some(name),
                _ => None,
            })
            .collect();
        let captured = captured_names(&format.value(), format.span());
        let captured = captured.into_iter().filter(|name| !named.contains(&name));
        let captured = captured.filter_map(|name| {
            let value = self.lowerer.value_of(self.lookup(&name)?, name.span());
            Some(quote!(#name = #value,))
        });
        let captured: TokenStream = captured.collect();
        let ends = tokens.last().is_some_and(|last| is_punct(last, ','));
        match captured.is_empty() || ends {
            true => captured,
            false => quote!(, #captured),
        }
    }

    /// The arguments of a macro, whose grammar is its own.
    fn renamed_tokens(&self, tokens: TokenStream) -> TokenStream {
        let tokens: Vec<_> = tokens.into_iter().collect();
        let is_punct = |index: usize, mark: char| matches!(tokens.get(index), Some(TokenTree::Punct(punct)) if punct.as_char() == mark);
        let renamed = |(index, token): (usize, &TokenTree)| match token {
            TokenTree::Ident(ident) => {
                // `a.name`, but not `a..name`; `name = value`, but not `name == value`.
                let is_part = index > 0
                    && is_punct(index - 1, '.')
                    && !(index > 1 && is_punct(index - 2, '.'));
                let is_label = is_punct(index + 1, '=') && !is_punct(index + 2, '=');
                match self.lookup(ident).filter(|_| !is_part && !is_label) {
                    Some(var) => self.lowerer.value_of(var, ident.span()).into_token_stream(),
                    None => ident.to_token_stream(),
                }
            }
            TokenTree::Group(group) => {
                let inner = self.renamed_tokens(group.stream());
                proc_macro2::Group::new(group.delimiter(), inner).into_token_stream()
            }
            token => token.to_token_stream(),
        };
        tokens.iter().enumerate().map(renamed).collect()
    }
}
