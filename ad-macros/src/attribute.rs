//! `#[differentiable]` on a function, on an `impl` block or on a trait.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::visit_mut::{self, VisitMut};
use syn::{
    Attribute, Block, Expr, ExprForLoop, ExprLoop, ExprWhile, FnArg, ImplItem, ImplItemFn, ItemFn,
    ItemImpl, ItemTrait, ItemUse, PatType, Path, Receiver, Signature, TraitItem, TraitItemFn,
    UseTree, Visibility, parse_quote,
};

use crate::accumulation;
use crate::callable::Callables;
use crate::element;
use crate::expand::{Function, Place};
use crate::operator;
use crate::options::{Options, is_own, own_options};
use crate::signature::is_constant_mark;

/// Takes this crate's attributes off loops and parameters: the compiler knows none there.
struct Clean;

impl VisitMut for Clean {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        if let Expr::ForLoop(ExprForLoop { attrs, .. })
        | Expr::While(ExprWhile { attrs, .. })
        | Expr::Loop(ExprLoop { attrs, .. }) = expr
        {
            attrs.retain(|attribute| !is_own(attribute));
        }
        visit_mut::visit_expr_mut(self, expr);
    }

    fn visit_fn_arg_mut(&mut self, argument: &mut FnArg) {
        let (FnArg::Receiver(Receiver { attrs, .. }) | FnArg::Typed(PatType { attrs, .. })) =
            argument;
        attrs.retain(|attribute| !is_constant_mark(attribute));
    }
}

/// Expands the attribute. The item itself stays as it is, but for a lint.
pub fn expand(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let options = match syn::parse2::<Options>(arguments) {
        Ok(options) => options,
        Err(error) => return with_error(&item, &error),
    };
    if let Ok(function) = syn::parse2::<ItemFn>(item.clone()) {
        return function_derivative(function, options);
    }
    if let Ok(block) = syn::parse2::<ItemImpl>(item.clone()) {
        return impl_derivatives(block, &options);
    }
    if let Ok(definition) = syn::parse2::<ItemTrait>(item.clone()) {
        return trait_derivatives(definition, &options);
    }
    if let (Ok(import), Some(rule)) = (syn::parse2::<ItemUse>(item.clone()), &options.vjp) {
        return imported_derivative(&import, rule, options.jvp.as_ref());
    }
    let error = syn::Error::new(
        proc_macro2::Span::call_site(),
        "`#[differentiable]` goes on a function, an `impl` block or a trait; with `vjp = rule` on the `use` of a function, too",
    );
    with_error(&item, &error)
}

fn with_error(item: &TokenStream, error: &syn::Error) -> TokenStream {
    let error = error.to_compile_error();
    quote!(#item #error)
}

/// The derivative of a function, or the errors and what stands in for it.
fn derivative_or_errors(function: &Function<'_>) -> TokenStream {
    function.derivative().unwrap_or_else(|error| {
        let (error, stub) = (error.into_compile_error(), function.stub());
        quote!(#error #stub)
    })
}

fn function_derivative(mut function: ItemFn, options: Options) -> TokenStream {
    if let Some(receiver) = function.sig.receiver() {
        let error = syn::Error::new_spanned(
            receiver,
            "put `#[differentiable]` on the `impl` block, not on the method",
        );
        return with_error(&quote!(#function), &error);
    }
    let derivatives = derivative_or_errors(&Function {
        place: Place::Free,
        attributes: &function.attrs,
        visibility: &function.vis,
        signature: &function.sig,
        callables: &Callables::new(&function.sig),
        body: Some(&function.block),
        options,
    });
    Clean.visit_item_fn_mut(&mut function);
    quote! {
        // Its gradient may be all that is used of it.
        #[allow(dead_code)]
        #function
        #derivatives
    }
}

/// A rule for an imported function: the module that bears the function's name.
fn imported_derivative(import: &ItemUse, rule: &Path, forward: Option<&Path>) -> TokenStream {
    let mut tree = &import.tree;
    let name = loop {
        match tree {
            UseTree::Path(path) => tree = &path.tree,
            UseTree::Name(name) => break &name.ident,
            UseTree::Rename(rename) => break &rename.rename,
            UseTree::Glob(_) | UseTree::Group(_) => {
                let error = syn::Error::new_spanned(tree, "import one function for each rule");
                return with_error(&quote!(#import), &error);
            }
        }
    };
    let visibility = &import.vis;
    // Inside of the module, what is private around it is still in reach.
    let inner = match visibility {
        Visibility::Inherited => quote!(pub(super)),
        visibility => quote!(#visibility),
    };
    let doc = format!("The derivative of the function `{name}`.");
    let forward = forward.map(|rule| quote!(#inner use super::#rule as jvp;));
    quote! {
        #import

        #[doc = #doc]
        #visibility mod #name {
            #inner use super::#rule as vjp;
            // Nothing is lent to it.
            #[doc(hidden)]
            #[allow(unused_imports)]
            #inner use super::#rule as vjp_onto;
            #forward
        }
    }
}

/// The derivative of a method, with the options of its own attribute.
fn method_derivative(
    place: Place<'_>,
    attributes: &mut Vec<Attribute>,
    visibility: &Visibility,
    signature: &Signature,
    body: Option<&Block>,
    options: &Options,
) -> TokenStream {
    let own = own_options(attributes);
    attributes.retain(|attribute| !is_own(attribute));
    let callables = &Callables::new(signature);
    let function =
        |options| Function { place, attributes, visibility, signature, callables, body, options };
    match own {
        Ok(own) => derivative_or_errors(&function(options.with(own))),
        Err(error) => {
            let (error, stub) = (error.into_compile_error(), function(options.clone()).stub());
            quote!(#error #stub)
        }
    }
}

/// The name of what `#[differentiable]` adds to a trait and to each of its `impl`s: an `impl`
/// without the attribute could change a method and keep the derivative of the provided one.
const MARK: &str = "this_impl_needs_the_attribute_differentiable";

fn impl_derivatives(mut block: ItemImpl, options: &Options) -> TokenStream {
    let generics = block.generics.clone();
    let place = match &block.trait_ {
        None => Place::Impl(&generics),
        Some((path, _)) if let Some(operator) = operator::of(path) => {
            let rule = operator::rule(operator, &block, options);
            return beside(block, rule);
        }
        Some((path, _)) if let Some(accumulation) = accumulation::of(path) => {
            let mark = accumulation::mark(accumulation, &block);
            return beside(block, mark);
        }
        Some((path, _)) if element::is_index(path) => {
            let derivatives = |element| impl_derivatives(element, options);
            let element =
                element::method(&block).map(|element| element.map(derivatives).unwrap_or_default());
            return beside(block, element);
        }
        Some((path, _)) if is_standard(path) => {
            let error = syn::Error::new_spanned(
                path,
                "a trait of the standard library has no derivatives: put the computation into a method of your own, and call that",
            );
            return with_error(&quote!(#block), &error);
        }
        Some(_) => Place::TraitImpl(&generics),
    };
    let mut siblings = Vec::new();
    for item in &mut block.items {
        let ImplItem::Fn(method) = item else { continue };
        // What is made from nothing is a constant to whoever calls it.
        if method.sig.inputs.is_empty() {
            continue;
        }
        let ImplItemFn { attrs, vis, sig, block, .. } = method;
        let sibling = method_derivative(place, attrs, vis, sig, Some(block), options);
        siblings.push(ImplItem::Verbatim(sibling));
        Clean.visit_signature_mut(sig);
        Clean.visit_block_mut(block);
        if let Place::Impl(_) = place {
            // Its gradient may be all that is used of it.
            attrs.push(parse_quote!(#[allow(dead_code)]));
        }
    }
    if block.trait_.is_some() {
        let mark = format_ident!("{MARK}");
        siblings.push(parse_quote!(fn #mark() {}));
    }
    block.items.extend(siblings);
    quote!(#block)
}

/// A block as it is, and what was made for it.
fn beside(mut block: ItemImpl, made: syn::Result<TokenStream>) -> TokenStream {
    for item in &mut block.items {
        if let ImplItem::Fn(method) = item {
            method.attrs.retain(|attribute| !is_own(attribute));
            Clean.visit_signature_mut(&mut method.sig);
            Clean.visit_block_mut(&mut method.block);
        }
    }
    let made = made.unwrap_or_else(syn::Error::into_compile_error);
    quote!(#block #made)
}

/// Traits of the standard library that numerical types have, and for which there are no rules.
const STANDARD: [&str; 11] = [
    "AsMut",
    "AsRef",
    "Clone",
    "Default",
    "Deref",
    "DerefMut",
    "From",
    "Into",
    "Iterator",
    "PartialEq",
    "PartialOrd",
];

fn is_standard(path: &Path) -> bool {
    path.segments.last().is_some_and(|last| STANDARD.iter().any(|name| last.ident == name))
}

fn trait_derivatives(mut definition: ItemTrait, options: &Options) -> TokenStream {
    let generics = definition.generics.clone();
    let visibility = Visibility::Inherited;
    let mut siblings = Vec::new();
    for item in &mut definition.items {
        let TraitItem::Fn(method) = item else { continue };
        if method.sig.inputs.is_empty() {
            continue;
        }
        let TraitItemFn { attrs, sig, default, .. } = method;
        let place = Place::Trait(&generics);
        let sibling = method_derivative(place, attrs, &visibility, sig, default.as_ref(), options);
        siblings.push(TraitItem::Verbatim(sibling));
        Clean.visit_signature_mut(sig);
        if let Some(body) = default {
            Clean.visit_block_mut(body);
        }
    }
    let mark = format_ident!("{MARK}");
    siblings.push(parse_quote! {
        #[doc(hidden)]
        fn #mark()
        where
            Self: ::core::marker::Sized;
    });
    definition.items.extend(siblings);
    quote!(#definition)
}
