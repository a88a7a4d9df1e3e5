//! Elements that are told by anything but a tuple: the tangent of the type is indexed as the type is.
//!
//! What `index` refers to is a part of `self`, and the tangent has a part of the same name. So the body is
//! written once more, for tangents: `v[i]` and `v[i] = x` in differentiable functions stay what they
//! are, and their derivatives are those of any other part. Turned down: methods in place of indices, as for tuples.
//! Nothing tells an own type from a slice where `v[i]` is written.

use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, format_ident, quote};
use syn::{Arm, Expr, FnArg, ImplItem, ImplItemFn, ItemImpl, Stmt, Type};

use super::not_a_reference;
use crate::lower::{macro_diverges, strip_parens};
use crate::names;

/// What the tangent needs to be indexed as `method` of `block` does.
pub fn of_tangent(block: &ItemImpl, method: &ImplItemFn) -> syn::Result<TokenStream> {
    let Some(FnArg::Typed(typed)) = method.sig.inputs.get(1) else {
        return Err(not_a_reference(&method.sig));
    };
    let (index, index_type, self_ty) = (&typed.pat, &typed.ty, &block.self_ty);
    let (impl_generics, _, bounds) = block.generics.split_for_impl();
    let tangent = tangent(self_ty, !block.generics.params.is_empty())?;
    let written = |how| Places(how).body(&method.block);
    if method.sig.ident == "index_mut" {
        let body = written(Access::Exclusive)?;
        return Ok(quote! {
            impl #impl_generics ::core::ops::IndexMut<#index_type> for #tangent #bounds {
                #[inline]
                fn index_mut(&mut self, #index: #index_type) -> &mut Self::Output { #body }
            }
        });
    }
    let output = block.items.iter().find_map(|item| match item {
        ImplItem::Type(output) => Some(&output.ty),
        _ => None,
    });
    // Of what is missing the compiler complains.
    let Some(output) = output else { return Ok(TokenStream::new()) };
    let part = quote!(::ad::Tangent<#output>);
    let (shared, grown) = (written(Access::Shared)?, written(Access::Cotangent)?);
    Ok(quote! {
        impl #impl_generics ::core::ops::Index<#index_type> for #tangent #bounds {
            type Output = #part;

            #[inline]
            fn index(&self, #index: #index_type) -> &Self::Output { #shared }
        }

        impl #impl_generics ::ad::rt::At<#index_type> for #tangent #bounds {
            type Part = #part;

            #[inline]
            fn at(&mut self, #index: #index_type) -> &mut Self::Part { #grown }
        }
    })
}

/// The tangent of a type. Parameters of an `impl` have to be named by what it is for, so that of a type
/// with parameters goes by its name.
fn tangent(ty: &Type, has_parameters: bool) -> syn::Result<TokenStream> {
    if !has_parameters {
        return Ok(quote!(<#ty as ::ad::Differentiable>::Tangent));
    }
    let Type::Path(path) = ty else {
        return Err(syn::Error::new_spanned(ty, "only a struct of your own is indexed here"));
    };
    let mut path = path.clone();
    if let Some(last) = path.path.segments.last_mut() {
        last.ident = format_ident!("{}Tangent", last.ident, span = last.ident.span());
    }
    Ok(path.to_token_stream())
}

/// How a part of a tangent is come to.
#[derive(Clone, Copy)]
enum Access {
    Shared,
    Exclusive,
    /// A `Vec` may lack elements that are zero.
    Cotangent,
}

/// Writes for the tangent what refers to a part of the value.
struct Places(Access);

impl Places {
    fn body(&self, block: &syn::Block) -> syn::Result<TokenStream> {
        let (last, before) = match block.stmts.split_last() {
            Some((Stmt::Expr(last, None), before)) => (self.reference(last)?, before),
            Some((Stmt::Macro(last), before)) if macro_diverges(&last.mac) => {
                (last.to_token_stream(), before)
            }
            Some((last, _)) => return Err(not_a_reference(last)),
            None => return Err(not_a_reference(block)),
        };
        // What the value was asked, the tangent need not be.
        let before: Vec<_> = before.iter().filter(|stmt| !is_assertion(stmt)).collect();
        before.iter().try_for_each(without_self)?;
        Ok(quote!(#(#before)* #last))
    }

    fn reference(&self, expr: &Expr) -> syn::Result<TokenStream> {
        match strip_parens(expr) {
            Expr::Reference(reference) => {
                let place = self.place(&reference.expr)?;
                Ok(match self.0 {
                    Access::Shared => quote!(&#place),
                    Access::Exclusive | Access::Cotangent => quote!(&mut #place),
                })
            }
            Expr::Block(block) => self.body(&block.block).map(|body| quote!({ #body })),
            Expr::If(branch) => {
                let (condition, first) = (&branch.cond, self.body(&branch.then_branch)?);
                without_self(condition)?;
                let Some((_, second)) = &branch.else_branch else {
                    return Err(not_a_reference(branch));
                };
                let second = self.reference(second)?;
                Ok(quote!(if #condition { #first } else { #second }))
            }
            Expr::Match(choice) => {
                let scrutinee = &choice.expr;
                without_self(scrutinee)?;
                let arms = choice.arms.iter().map(|arm| {
                    without_self(&arm.pat)?;
                    let body = self.reference(&arm.body)?;
                    let body = Box::new(syn::parse_quote!({ #body }));
                    Ok(Arm { body, ..arm.clone() })
                });
                let arms = arms.collect::<syn::Result<Vec<_>>>()?;
                Ok(quote!(match #scrutinee { #(#arms)* }))
            }
            Expr::Macro(call) if macro_diverges(&call.mac) => Ok(call.to_token_stream()),
            other => Err(not_a_reference(other)),
        }
    }

    /// A part of the value, as that of the tangent.
    fn place(&self, expr: &Expr) -> syn::Result<TokenStream> {
        match expr {
            Expr::Paren(inner) => self.place(&inner.expr),
            Expr::Path(path) if path.path.is_ident("self") => Ok(path.to_token_stream()),
            Expr::Field(field) => {
                let (base, member) = (self.place(&field.base)?, &field.member);
                Ok(quote!(#base.#member))
            }
            Expr::Index(index) => {
                let (whole, position) = (self.place(&index.expr)?, &index.index);
                without_self(position)?;
                if let Expr::Range(_) = strip_parens(position) {
                    return Err(syn::Error::new_spanned(
                        position,
                        "an element is one part of `self`, not a range: put the attribute on a method that returns the range",
                    ));
                }
                Ok(match self.0 {
                    Access::Cotangent => quote!((*::ad::rt::at(&mut #whole, #position))),
                    Access::Shared | Access::Exclusive => quote!(#whole[#position]),
                })
            }
            other => Err(not_a_reference(other)),
        }
    }
}

fn is_assertion(stmt: &Stmt) -> bool {
    let Stmt::Macro(call) = stmt else { return false };
    call.mac.path.segments.last().is_some_and(|last| {
        let name = last.ident.to_string();
        name.trim_start_matches("debug_").starts_with("assert")
    })
}

/// An error where code looks at the value, of which the tangent knows nothing.
fn without_self(code: &impl ToTokens) -> syn::Result<()> {
    let this = format_ident!("value", span = Span::call_site());
    let tokens = code.to_token_stream();
    match names::without_self(tokens.clone(), &this).to_string() == tokens.to_string() {
        true => Ok(()),
        false => Err(syn::Error::new_spanned(
            code,
            "where an element lies may depend on the index alone: give it a tuple, as in `Index<(usize, usize)>`, or put the attribute on a method that returns the element",
        )),
    }
}
