//! Patterns: which part of a value each name is bound to.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::{Expr, Member, Pat, Type};

use crate::ir::{Binding, Operand, Operation, Place, Projection, Statement, VarId};
use crate::lower::Lowerer;
use crate::lower::expression::operator;
use crate::lower::search::Bound;
use crate::lower::state::Alias;
use crate::lower::syntax::{
    calls, is_transparent, is_type_name, is_unknown_macro, outcome, strip_parens,
};

/// What a pattern is matched against.
#[derive(Clone, Copy)]
pub struct Matched {
    /// Whether a derivative flows through it.
    pub active: bool,
    /// Whether the match may fail: only then can a name in the pattern mean a constant.
    pub refutable: bool,
    /// Whether it may be a reference: names are bound to references then.
    pub reference: bool,
    /// Its length, where a pattern counts elements from the end.
    pub length: Option<VarId>,
    /// The variable, of which a part is matched as `&mut`, and the number of steps to that part: names
    /// are bound to places in it then.
    pub exclusive: Option<(VarId, usize)>,
}

impl Lowerer<'_> {
    /// The pattern with generated names, and what it binds.
    pub(super) fn pattern(&mut self, pat: &Pat, matched: Matched) -> (TokenStream, Vec<Binding>) {
        let mut bindings = Vec::new();
        let tokens = self.subpattern(pat, &[], matched, &mut bindings);
        (tokens, bindings)
    }

    pub fn subpattern(
        &mut self,
        pat: &Pat,
        path: &[Projection],
        matched: Matched,
        bindings: &mut Vec<Binding>,
    ) -> TokenStream {
        match pat {
            Pat::Wild(_)
            | Pat::Lit(_)
            | Pat::Range(_)
            | Pat::Path(_)
            | Pat::Rest(_)
            | Pat::Const(_) => pat.to_token_stream(),
            Pat::Paren(inner) => {
                let inner = self.subpattern(&inner.pat, path, matched, bindings);
                quote!((#inner))
            }
            Pat::Ident(ident)
                if matched.refutable && ident.subpat.is_none() && is_type_name(&ident.ident) =>
            {
                if ident.ident != "None" {
                    self.capitals.insert(ident.ident.to_string());
                }
                pat.to_token_stream()
            }
            Pat::Ident(ident) if let Some((root, _)) = matched.exclusive => {
                self.exclusive_name(ident, Place { root, path: path.to_vec() })
            }
            Pat::Ident(ident) => self.bound_name(ident, path, matched, bindings),
            Pat::Reference(reference) => {
                if let Some(token) = &reference.mutability {
                    self.refuse(token, "`&mut` is not supported");
                }
                if matched.exclusive.is_some() {
                    self.refuse(pat, "what is behind a reference here cannot be changed: match on the place itself");
                }
                let target = Matched { reference: false, ..matched };
                let inner = self.subpattern(&reference.pat, path, target, bindings);
                quote!(&#inner)
            }
            Pat::Tuple(tuple) => {
                let elements = tuple.elems.iter().zip(positions(&tuple.elems));
                let elements: Vec<_> = elements
                    .map(|(element, position)| {
                        self.check_position(&position, element, matched.exclusive.is_some());
                        let path = [path, &[position]].concat();
                        self.subpattern(element, &path, matched, bindings)
                    })
                    .collect();
                quote!((#(#elements,)*))
            }
            Pat::Slice(slice) => {
                let elements = self.slice_pattern(slice, path, matched, bindings);
                quote!([#(#elements),*])
            }
            Pat::TupleStruct(pattern) => {
                let constructor = &pattern.path;
                let elements = match content_path(path, constructor) {
                    Some(path) => {
                        let elements = pattern.elems.iter();
                        elements.map(|e| self.subpattern(e, &path, matched, bindings)).collect()
                    }
                    None => {
                        let path = self.variant_path(path, constructor);
                        self.numbered_patterns(&pattern.elems, &path, matched, bindings)
                    }
                };
                quote!(#constructor(#(#elements),*))
            }
            Pat::Struct(pattern) => {
                let path = self.variant_path(path, &pattern.path);
                let step = |member: Member| [&path[..], &[Projection::Field(member)]].concat();
                let fields: Vec<_> = pattern
                    .fields
                    .iter()
                    .map(|field| {
                        let member = &field.member;
                        let path = step(member.clone());
                        let inner = self.subpattern(&field.pat, &path, matched, bindings);
                        quote!(#member: #inner)
                    })
                    .collect();
                let (constructor, rest) = (&pattern.path, &pattern.rest);
                quote!(#constructor { #(#fields,)* #rest })
            }
            Pat::Or(alternatives) => {
                let before = bindings.len();
                let cases: Vec<_> = alternatives
                    .cases
                    .iter()
                    .map(|case| self.subpattern(case, path, matched, bindings))
                    .collect();
                if bindings.len() > before {
                    self.refuse(pat, "names in `|` patterns are supported in `match`, `if let` and `let else` only");
                }
                quote!(#(#cases)|*)
            }
            _ => {
                self.refuse(pat, "this pattern is not supported: bind the value by name and take it apart with `let`");
                quote!(_)
            }
        }
    }

    /// A name that a pattern binds to a value or a reference.
    fn bound_name(
        &mut self,
        ident: &syn::PatIdent,
        path: &[Projection],
        matched: Matched,
        bindings: &mut Vec<Binding>,
    ) -> TokenStream {
        let (by_ref, mutability) = (&ident.by_ref, &ident.mutability);
        if by_ref.is_some() && mutability.is_some() {
            self.refuse(ident, "`ref mut` is not supported: assign to the matched place");
            return quote!(_);
        }
        let var = self.bind(&ident.ident, mutability.is_some(), matched.active);
        self.vars[var].reference = matched.reference || by_ref.is_some();
        let mut name = self.ident(var).clone();
        let mut binding = Binding::new(var, path.to_vec());
        if may_be_constant(ident, matched)
            && name != ident.ident
            && let Some(written) = self.names.in_pattern(&ident.ident)
        {
            name = written;
            binding.written = Some(name.clone());
        }
        bindings.push(binding);
        let subpattern = ident.subpat.as_ref().map(|(at, inner)| {
            let inner = self.subpattern(inner, path, matched, bindings);
            quote!(#at #inner)
        });
        quote!(#by_ref #mutability #name #subpattern)
    }

    /// A name that a pattern binds to a place which it lets be changed.
    pub(super) fn exclusive_name(
        &mut self,
        ident: &syn::PatIdent,
        mut place: Place,
    ) -> TokenStream {
        if ident.by_ref.is_some() || ident.mutability.is_some() || ident.subpat.is_some() {
            self.refuse(ident, "write the name alone: it is bound to a `&mut` already");
        }
        let name = self.names.fresh(&ident.ident.to_string(), ident.ident.span());
        let bound = self.var(name.clone(), false, false);
        place.path.push(Projection::Behind(bound));
        self.alias_place(&ident.ident, Alias::exclusive(place));
        quote!(#name)
    }

    /// The way into the cotangent of an enum, where `constructor` is one of its variants.
    fn variant_path(&self, path: &[Projection], constructor: &syn::Path) -> Vec<Projection> {
        let variant = self.variant(constructor);
        let variant = variant.map(|ident| Projection::Field(ident.clone().into()));
        path.iter().cloned().chain(variant).collect()
    }

    fn numbered_patterns<'p>(
        &mut self,
        elements: &'p syn::punctuated::Punctuated<Pat, syn::Token![,]>,
        path: &[Projection],
        matched: Matched,
        bindings: &mut Vec<Binding>,
    ) -> Vec<TokenStream> {
        self.check_rest(elements);
        let pattern = |(index, element): (usize, &'p Pat)| {
            let member = syn::Index { index: index as u32, span: element.span() };
            let path = [path, &[Projection::Field(Member::Unnamed(member))]].concat();
            self.subpattern(element, &path, matched, bindings)
        };
        elements.iter().enumerate().map(pattern).collect()
    }

    /// No place in Rust is named by what stands behind it.
    pub fn check_position(&mut self, position: &Projection, at: &Pat, may_change: bool) {
        if let (Projection::FromEnd(_), true) = (position, may_change) {
            self.refuse(at, "what stands behind `..` cannot be changed by this name: write `_` for each element in place of `..`");
        }
    }

    /// Behind `..` the position of an element is not known, except in tuples.
    pub fn check_rest(&mut self, elements: &syn::punctuated::Punctuated<Pat, syn::Token![,]>) {
        let rest = elements.iter().position(|element| matches!(element, Pat::Rest(_)));
        if let Some(rest) = rest
            && rest + 1 < elements.len()
        {
            self.refuse(
                elements,
                "`..` is supported at the end of this pattern only: write `_` for each element",
            );
        }
    }

    /// `let pat: ty = value;`
    pub fn bind_pattern(&mut self, pat: &Pat, ty: Option<&Type>, value: Operand) {
        match pat {
            Pat::Paren(inner) => self.bind_pattern(&inner.pat, ty, value),
            Pat::Type(typed) => self.bind_pattern(&typed.pat, Some(&typed.ty), value),
            Pat::Wild(_) => self.discard(value),
            Pat::Ident(ident) if ident.subpat.is_none() && ident.by_ref.is_none() => {
                self.bind_name(ident, ty, value);
            }
            _ => self.destructure(pat, ty, value),
        }
    }

    fn bind_name(&mut self, ident: &syn::PatIdent, ty: Option<&Type>, value: Operand) {
        let mutable = ident.mutability.is_some();
        match value {
            Operand::Var(var) if !mutable && ty.is_none() => self.alias(&ident.ident, var),
            value => {
                let active = match &value {
                    Operand::Var(_) => true,
                    Operand::Constant(tokens) => mutable && !is_discrete_literal(tokens),
                };
                let var = self.bind(&ident.ident, mutable, active);
                if let Some(ty) = ty {
                    self.note_type(var, ty);
                }
                if ty.is_some_and(|ty| operator::is_own_type(ty, &self.scalars)) {
                    self.own.insert(var);
                }
                if let Operand::Var(source) = value {
                    self.note_source(var, source);
                }
                if let (Operand::Var(source), None) = (&value, ty) {
                    self.vars[var].reference = self.vars[*source].reference;
                    if self.references.contains(source) {
                        self.references.insert(var);
                    }
                }
                let ty = ty.cloned();
                self.push(Statement::Define { var, ty, operation: Operation::Use(value) });
            }
        }
    }

    /// Remembers of a variable what is known of the one that it has its value from.
    fn note_source(&mut self, var: VarId, source: VarId) {
        for facts in [&mut self.own, &mut self.own_methods, &mut self.movable] {
            if facts.contains(&source) {
                facts.insert(var);
            }
        }
        self.containers.extend(self.containers.get(&source).map(|&container| (var, container)));
    }

    fn destructure(&mut self, pat: &Pat, ty: Option<&Type>, value: Operand) {
        match value {
            Operand::Var(root) => {
                self.destructure_place(pat, ty, Place::of(root));
            }
            // What is assigned to later may get a derivative then.
            Operand::Constant(_) if binds_mutably(pat) => {
                let source = self.named(value, "value", pat.span());
                self.destructure(pat, ty, Operand::Var(source));
            }
            Operand::Constant(value) => {
                // Of what has no derivative no position is asked for.
                let length = None;
                let matched = Matched {
                    active: false,
                    refutable: false,
                    reference: false,
                    length,
                    exclusive: None,
                };
                let (pattern, bindings) = self.pattern(pat, matched);
                let ty = ty.map(|ty| quote!(: #ty));
                let defines = bindings.iter().map(|binding| binding.var).collect();
                self.push(Statement::Plain { code: quote!(let #pattern #ty = #value;), defines });
            }
        }
    }

    /// `let pat: ty = source;`, where what a name is bound to is copied or moves out of the place.
    fn destructure_place(&mut self, pat: &Pat, ty: Option<&Type>, source: Place) {
        let reference = source.path.is_empty() && self.may_refer(source.root);
        let whole = self.place_tokens(&source);
        let length = self.length_for([pat], &whole);
        let matched =
            Matched { active: true, refutable: false, reference, length, exclusive: None };
        let (pattern, bindings) = self.pattern(pat, matched);
        let ty = ty.cloned();
        self.push(Statement::Destructure { pattern, ty, source, bindings });
    }

    /// `let pat: ty = place;` of a part of a variable, or of one that may be assigned to: what no name is bound to
    /// stays there. Says whether it is that.
    pub fn take_apart(&mut self, pat: &Pat, ty: Option<&Type>, value: &Expr) -> bool {
        if matches!(pat, Pat::Ident(_) | Pat::Wild(_)) || self.depth(value) > 0 {
            return false;
        }
        let stays = |lowerer: &Self, place: &Place| {
            let root = &lowerer.vars[place.root];
            root.active && (!place.path.is_empty() || root.mutable && !root.exclusive)
        };
        let place = self.place_if(value, stays);
        if let Some(place) = &place {
            self.destructure_place(pat, ty, place.clone());
        }
        place.is_some()
    }

    /// A variable declared with an integer or boolean type.
    pub fn discrete_local(&mut self, pat: &Pat, ty: Option<&Type>, value: &Expr, matters: bool) {
        // What is called needs a derivative here as under a `let` without type.
        let is_unknown = matches!(value, Expr::Macro(call) if is_unknown_macro(&call.mac));
        let is_computed = calls(value) && !is_unknown
            || matches!(value, Expr::If(_) | Expr::Match(_) | Expr::Block(_) | Expr::Loop(_));
        let value = match is_computed {
            true => {
                let value = match matters {
                    true => self.until_its_end(true, |lowerer| lowerer.operand(value, "value")),
                    false => self.operand(value, "value"),
                };
                self.without_derivative(&value)
            }
            false => self.plain_constant(value),
        };
        match pat {
            Pat::Ident(ident) if ident.subpat.is_none() && ident.by_ref.is_none() => {
                let var = self.bind(&ident.ident, ident.mutability.is_some(), false);
                let ty = ty.cloned();
                let operation = Operation::Use(Operand::Constant(value));
                self.push(Statement::Define { var, ty, operation });
            }
            _ => self.destructure(pat, ty, Operand::Constant(value)),
        }
    }

    /// The pattern of a parameter.
    pub fn parameter_pattern(&mut self, pat: &Pat, parameter: VarId) {
        let by_name = matches!(pat, Pat::Ident(ident)
            if ident.mutability.is_none() && ident.subpat.is_none() && ident.by_ref.is_none());
        if by_name {
            return;
        }
        let value = self.operand_of(parameter);
        self.bind_pattern(pat, None, value);
    }

    /// The place that is matched on as `&mut`, if it is that.
    pub fn exclusive_scrutinee(&mut self, expr: &Expr) -> Option<Place> {
        let mut place = match strip_parens(expr) {
            Expr::Reference(reference) if reference.mutability.is_some() => {
                self.place(&reference.expr)
            }
            // Of an option or a result, which the patterns tell.
            Expr::MethodCall(call) if call.method == "as_mut" && call.args.is_empty() => {
                self.place(&call.receiver)
            }
            name @ (Expr::Path(_) | Expr::MethodCall(_)) => {
                self.place_if(name, |lowerer, place| {
                    let is_parameter = place.path.is_empty() && lowerer.vars[place.root].exclusive;
                    is_parameter || lowerer.is_exclusive_alias(name)
                })
            }
            _ => None,
        }?;
        let root = &self.vars[place.root];
        if place.path.is_empty() && root.exclusive {
            place.path.push(Projection::Deref);
        }
        root.mutable.then_some(place)
    }

    /// What is matched on, and the place it has if a derivative flows through it.
    pub fn scrutinee(&mut self, expr: &Expr) -> (TokenStream, Option<Place>) {
        let (target, borrow) = match expr {
            Expr::Reference(reference) if reference.mutability.is_none() => {
                (&*reference.expr, Some(quote!(&)))
            }
            _ => (expr, None),
        };
        let borrow = match self.depth(target) {
            0 => borrow,
            _ => Some(quote!(&)),
        };
        // A `&mut` itself is not a place to match on: the bindings would be references to change.
        let is_matched = |lowerer: &Self, place: &Place| {
            let root = &lowerer.vars[place.root];
            root.active && (!root.exclusive || !place.path.is_empty())
        };
        if let Some(place) = self.place_if(target, is_matched) {
            let tokens = self.place_tokens(&place);
            return (quote!(#borrow #tokens), Some(place));
        }
        let matched = self.operand(expr, "matched");
        match self.kept(matched, expr) {
            Operand::Var(root) => {
                let ident = self.ident(root);
                (quote!(#ident), Some(Place::of(root)))
            }
            Operand::Constant(tokens) => {
                let var = self.named(Operand::Constant(tokens), "matched", expr.span());
                let ident = self.ident(var);
                (quote!(#ident), None)
            }
        }
    }
}

/// Which member of a tuple each element of a pattern is matched against.
pub fn positions(
    elements: &syn::punctuated::Punctuated<Pat, syn::Token![,]>,
) -> impl Iterator<Item = Projection> {
    let rest = elements.iter().position(|element| matches!(element, Pat::Rest(_)));
    let (rest, count) = (rest.unwrap_or(elements.len()), elements.len());
    (0..count).zip(elements).map(move |(index, element)| match index <= rest {
        true => Projection::Field(Member::Unnamed(syn::Index {
            index: index as u32,
            span: element.span(),
        })),
        false => Projection::FromEnd(count - 1 - index),
    })
}

/// Whether a name in a pattern may be that of a constant.
fn may_be_constant(name: &syn::PatIdent, matched: Matched) -> bool {
    matched.refutable
        && name.by_ref.is_none()
        && name.mutability.is_none()
        && name.subpat.is_none()
        && !name.ident.to_string().starts_with("r#")
}

/// The way to the only part of an option or a result.
fn content_path(path: &[Projection], constructor: &syn::Path) -> Option<Vec<Projection>> {
    if is_transparent(constructor) {
        return Some(path.to_vec());
    }
    let member = outcome(constructor)?;
    Some(path.iter().cloned().chain([Projection::Field(member)]).collect())
}

/// Whether the tokens are an integer or boolean literal: a variable that starts with one stays
/// without derivative.
pub fn is_discrete_literal(tokens: &TokenStream) -> bool {
    match syn::parse2::<syn::Lit>(tokens.clone()) {
        Ok(syn::Lit::Int(number)) => !number.suffix().starts_with('f'),
        Ok(syn::Lit::Bool(_) | syn::Lit::Char(_)) => true,
        _ => false,
    }
}

/// Whether the pattern binds a variable that may be assigned to.
pub fn binds_mutably(pat: &Pat) -> bool {
    Bound::by(pat).iter().any(|name| name.mutability.is_some())
}
