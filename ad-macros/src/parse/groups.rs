//! Invisible groups: what a `macro_rules!` was given as `$e` stays one expression.
//!
//! The compiler forgets the groups of what a macro prints, so they are written out before anything is
//! parsed: in parentheses where what they hold could be torn apart by what stands around it, else not
//! at all. Parentheses are as good around a type or a pattern as around an expression: what tells by its type what
//! a parameter is looks at types without them.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use syn::visit_mut::{self, VisitMut};
use syn::{Expr, Type};

use crate::names::regrouped;

/// The tokens with every invisible group written out.
pub fn explicit(tokens: TokenStream) -> TokenStream {
    if !holds_invisible(tokens.clone()) {
        return tokens;
    }
    let mut written = TokenStream::new();
    let mut is_attribute = false;
    for token in tokens {
        let TokenTree::Group(group) = token else {
            is_attribute = matches!(&token, TokenTree::Punct(punct) if punct.as_char() == '#');
            written.extend([token]);
            continue;
        };
        let inner = match core::mem::take(&mut is_attribute) {
            true => flat(group.stream()),
            false => explicit(group.stream()),
        };
        match group.delimiter() {
            Delimiter::None if !can_be_torn_apart(&inner) => written.extend(inner),
            Delimiter::None => written.extend([regrouped(&group, Delimiter::Parenthesis, inner)]),
            delimiter => written.extend([regrouped(&group, delimiter, inner)]),
        }
    }
    written
}

/// Takes types out of parentheses, but sums of bounds, which could be torn apart.
pub struct BareTypes;

impl VisitMut for BareTypes {
    fn visit_type_mut(&mut self, ty: &mut Type) {
        while let Type::Paren(paren) = ty
            && !matches!(&*paren.elem, Type::TraitObject(_) | Type::ImplTrait(_))
        {
            *ty = (*paren.elem).clone();
        }
        visit_mut::visit_type_mut(self, ty);
    }
}

/// What an attribute holds: a `$meta` is one by itself, though it may look like an assignment.
fn flat(tokens: TokenStream) -> TokenStream {
    let tokens = tokens.into_iter().flat_map(|token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::None => flat(group.stream()),
        token => explicit(token.into()),
    });
    tokens.collect()
}

fn holds_invisible(tokens: TokenStream) -> bool {
    tokens.into_iter().any(|token| match token {
        TokenTree::Group(group) => {
            group.delimiter() == Delimiter::None || holds_invisible(group.stream())
        }
        _ => false,
    })
}

/// Whether an operator beside these tokens could take a part of them for its operand.
fn can_be_torn_apart(tokens: &TokenStream) -> bool {
    match syn::parse2::<Expr>(tokens.clone()) {
        Ok(expr) => matches!(
            expr,
            Expr::Assign(_)
                | Expr::Binary(_)
                | Expr::Cast(_)
                | Expr::Closure(_)
                | Expr::If(_)
                | Expr::Match(_)
                | Expr::Range(_)
                | Expr::Reference(_)
                | Expr::Struct(_)
                | Expr::Unary(_)
        ),
        Err(_) => {
            matches!(syn::parse2(tokens.clone()), Ok(Type::TraitObject(_) | Type::ImplTrait(_)))
        }
    }
}

#[cfg(test)]
mod tests {
    use proc_macro2::{Delimiter, Group, TokenStream};
    use quote::quote;

    use syn::visit_mut::VisitMut;

    use super::{BareTypes, explicit};

    fn invisible(tokens: TokenStream) -> Group {
        Group::new(Delimiter::None, tokens)
    }

    #[test]
    fn operators_get_parentheses() {
        let factor = invisible(quote!(a + b));
        let negative = invisible(quote!(-3.0));
        let written = explicit(quote!(t * #factor + #negative.abs()));
        assert_eq!(written.to_string(), quote!(t * (a + b) + (-3.0).abs()).to_string());
    }

    #[test]
    fn names_types_and_literals_stand_alone() {
        let (name, ty, number) =
            (invisible(quote!(x)), invisible(quote!(Vec<f64>)), invisible(quote!(2)));
        let written = explicit(quote!({ #name as #ty; f(#name, #number) }));
        assert_eq!(
            written.to_string(),
            quote!({
                x as Vec<f64>;
                f(x, 2)
            })
            .to_string()
        );
    }

    #[test]
    fn attributes_stay_as_they_are() {
        let meta = invisible(quote!(doc = "text"));
        let written = explicit(quote!(#[#meta] fn f() {}));
        assert_eq!(
            written.to_string(),
            quote!(
                #[doc = "text"]
                fn f() {}
            )
            .to_string()
        );
    }

    #[test]
    fn types_leave_parentheses() {
        let slice = invisible(quote!(&mut [f64]));
        let mut function = syn::parse2(explicit(quote!(
            fn f(xs: #slice, g: &(dyn Fn() + Sync), ys: ((Vec<(f64)>))) {}
        )))
        .expect("is a function");
        BareTypes.visit_item_fn_mut(&mut function);
        assert_eq!(
            quote!(#function).to_string(),
            quote!(
                fn f(xs: &mut [f64], g: &(dyn Fn() + Sync), ys: Vec<f64>) {}
            )
            .to_string()
        );
    }

    #[test]
    fn groups_in_groups_are_one() {
        let inner = invisible(quote!(a - b));
        let outer = invisible(quote!(#inner));
        assert_eq!(explicit(quote!(x - #outer)).to_string(), quote!(x - (a - b)).to_string());
        let twice = invisible(quote!(-#inner));
        assert_eq!(explicit(quote!(x - #twice)).to_string(), quote!(x - (-(a - b))).to_string());
    }
}
