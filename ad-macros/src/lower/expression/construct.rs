//! Values made of parts: structs, tuples, variants, options, results.

use proc_macro2::TokenStream;
use quote::quote;
use syn::spanned::Spanned;
use syn::{ExprPath, Member, Path};

use crate::ir::{Operand, Operation, Place, Shape};
use crate::lower::Lowerer;
use crate::lower::syntax::{is_transparent, is_type_name, outcome};

impl Lowerer<'_> {
    /// `Some(x)`, `Name(x, y)`
    pub fn construct(&mut self, call: &syn::ExprCall, function: &ExprPath, hint: &str) -> Operand {
        let parts = self.operands(&call.args);
        let tokens = parts.iter().map(|part| self.tokens(part));
        let expression = quote!(#function(#(#tokens),*));
        let (shape, parts) = if is_transparent(&function.path) {
            (Shape::Transparent, numbered(parts))
        } else if let Some(member) = outcome(&function.path) {
            (Shape::Flow, parts.into_iter().map(|part| (member.clone(), part)).collect())
        } else if let Some(variant) = self.variant(&function.path) {
            (Shape::Variant(variant.clone()), numbered_at(parts, call.span()))
        } else {
            (Shape::Struct, numbered_at(parts, call.span()))
        };
        let value = self.aggregate(expression, shape.clone(), parts, hint, call.span());
        // A function whose name begins with a capital letter is no pattern.
        if let Operand::Var(var) = &value {
            let ident = self.ident(*var);
            let code = match shape {
                Shape::Struct => quote!(let #function(..) = &#ident;),
                Shape::Variant(_) => quote!(match &#ident { #function(..) => {} _ => {} }),
                _ => return value,
            };
            self.push_plain(code);
        }
        value
    }

    pub(super) fn struct_literal(&mut self, literal: &syn::ExprStruct, hint: &str) -> Operand {
        let shape = match self.variant(&literal.path) {
            Some(variant) => Shape::Variant(variant.clone()),
            None => Shape::Struct,
        };
        let values = literal.fields.iter().map(|field| &field.expr);
        let values = self.operands_before(values, literal.rest.as_deref(), "field");
        let members = literal.fields.iter().map(|field| field.member.clone());
        let parts: Vec<_> = members.zip(values).collect();
        let fields = parts.iter().map(|(member, value)| {
            let value = self.tokens(value);
            quote!(#member: #value)
        });
        let path = &literal.path;
        let Some(rest) = &literal.rest else {
            let expression = quote!(#path { #(#fields),* });
            return self.aggregate(expression, shape, parts, hint, literal.span());
        };
        let fields: Vec<_> = fields.collect();
        // Of a place the other fields alone are moved or copied.
        let place = match self.active_place(rest) {
            Some(place) => place,
            None => match self.operand(rest, "rest") {
                Operand::Var(root) => Place::of(root),
                Operand::Constant(rest) => {
                    let expression = quote!(#path { #(#fields,)* ..#rest });
                    return self.aggregate(expression, Shape::Updated, parts, hint, literal.span());
                }
            },
        };
        let tokens = self.place_tokens(&place);
        let expression = quote!(#path { #(#fields,)* ..#tokens });
        let operation = Operation::UpdateStruct { expression, parts, rest: place };
        Operand::Var(self.define(hint, literal.span(), true, operation))
    }

    /// `Enum::Variant`, told from `module::Type` by the capital letter; `Variant`, where what stands
    /// around it tells (see [`variants`](crate::lower::rewrite::variants)).
    pub fn variant<'p>(&self, path: &'p Path) -> Option<&'p syn::Ident> {
        let mut segments = path.segments.iter().rev();
        let last = &segments.next().filter(|last| is_type_name(&last.ident))?.ident;
        let is_variant = match segments.next() {
            Some(owner) => is_type_name(&owner.ident),
            None => self.variants.contains(&last.to_string()),
        };
        is_variant.then_some(last)
    }

    pub(super) fn aggregate(
        &mut self,
        expression: TokenStream,
        shape: Shape,
        parts: Vec<(Member, Operand)>,
        hint: &str,
        span: proc_macro2::Span,
    ) -> Operand {
        if parts.iter().all(|(_, part)| matches!(part, Operand::Constant(_))) {
            return Operand::Constant(expression);
        }
        // A pattern that takes it apart may reach into what a part refers to.
        let is_reference = |(_, part): &(Member, Operand)| match part {
            Operand::Var(var) => self.may_refer(*var),
            Operand::Constant(_) => false,
        };
        let reference = parts.iter().any(is_reference);
        let operation = Operation::Aggregate { expression, shape, parts };
        let var = self.define(hint, span, true, operation);
        self.vars[var].reference = reference;
        Operand::Var(var)
    }
}

pub fn numbered(parts: Vec<Operand>) -> Vec<(Member, Operand)> {
    numbered_at(parts, proc_macro2::Span::call_site())
}

/// The same, with errors about the parts at `span`.
fn numbered_at(parts: Vec<Operand>, span: proc_macro2::Span) -> Vec<(Member, Operand)> {
    let member = |index| Member::Unnamed(syn::Index { index, span });
    (0..).map(member).zip(parts).collect()
}
