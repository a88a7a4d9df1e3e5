//! `#[differentiable]` on a function, on an `impl` block or on a trait.

use proc_macro2::TokenStream;
use quote::{format_ident, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::visit_mut::VisitMut;
use syn::{
    Attribute, Block, Generics, Ident, ImplItem, ImplItemFn, ItemFn, ItemImpl, ItemTrait, ItemUse,
    Path, ReceiverKind, Signature, TraitItem, TraitItemFn, Type, UseTree, Visibility,
};

use crate::impls::accumulation;
use crate::impls::element;
use crate::impls::hidden;
use crate::impls::operator;
use crate::names;
use crate::parse::borrowing;
use crate::parse::callable::Callables;
use crate::parse::conditional;
use crate::parse::elision;
use crate::parse::function::{Function, Place};
use crate::parse::groups::{self, BareTypes};
use crate::parse::item;
use crate::parse::itself;
use crate::parse::options::{Options, own_options};
use crate::parse::recursion;

/// Expands the attribute. The item itself stays as it is, but for a lint.
pub fn expand(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let options = match syn::parse2::<Options>(arguments.clone()) {
        Ok(options) => options,
        Err(error) => return with_error(&item, &error),
    };
    let explicit = groups::explicit(item.clone());
    match conditional::split(&arguments, explicit.clone()) {
        Ok(None) => {}
        Ok(Some(both)) => return both,
        Err(error) => return with_error(&item, &error),
    }
    if let Ok(mut function) = syn::parse2::<ItemFn>(explicit.clone()) {
        BareTypes.visit_item_fn_mut(&mut function);
        return function_derivative(item, &function, options);
    }
    let named = elision::in_head(explicit.clone());
    if let Ok(mut block) = syn::parse2::<ItemImpl>(named) {
        BareTypes.visit_item_impl_mut(&mut block);
        return impl_derivatives(elision::in_head(item), &block, &options);
    }
    if let Ok(mut definition) = syn::parse2::<ItemTrait>(explicit.clone()) {
        BareTypes.visit_item_trait_mut(&mut definition);
        return trait_derivatives(item, &definition, &options);
    }
    if let (Ok(import), Some(rule)) = (syn::parse2::<ItemUse>(explicit), &options.vjp) {
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

fn function_derivative(item: TokenStream, function: &ItemFn, options: Options) -> TokenStream {
    let item = item::function(item);
    if function.sig.receiver().is_some() || names_self(&function.sig) {
        let derivatives = method_derivative(function, options);
        return quote!(#item #derivatives);
    }
    let borrows = options.borrows || borrowing::keeps_references(&function.sig, &function.block);
    let options = Options { borrows, ..options };
    let signature = elision::in_parameters(&function.sig, borrows);
    let derivatives = derivative_or_errors(&Function {
        place: Place::Free,
        visibility: &function.vis,
        signature: &signature,
        callables: &Callables::new(&signature),
        exclusive_methods: &[],
        body: Some(&function.block),
        options,
    });
    quote! {
        // Its gradient may be all that is used of it.
        #[allow(dead_code)]
        #item
        #derivatives
    }
}

/// The siblings of one method of an `impl` block, of which nothing else is seen.
fn method_derivative(function: &ItemFn, options: Options) -> TokenStream {
    let (signature, generics) = (&function.sig, Generics::default());
    let methods =
        Methods::new(Place::Impl(&generics), None, Vec::new(), [signature].into_iter(), &options);
    methods.derivative(&function.attrs, &function.vis, signature, Some(&function.block))
}

/// Whether a function without receiver is one of an `impl` block.
fn names_self(signature: &Signature) -> bool {
    let mut named = std::collections::HashSet::new();
    names::collect(quote!(#signature), &mut named);
    named.contains("Self")
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

            /// Where the function is from only its import tells.
            #[doc(hidden)]
            #inner fn named() -> &'static str {
                ""
            }
        }
    }
}

/// The block in which methods stand.
struct Methods<'a> {
    place: Place<'a>,
    /// Those that call themselves, by way of others, too.
    circular: Vec<Ident>,
    /// Those that take `&mut self`.
    exclusive: Vec<Ident>,
    /// The type that they are methods of, where it is seen.
    owner: Option<&'a Type>,
    options: &'a Options,
}

impl<'a> Methods<'a> {
    fn new<'s>(
        place: Place<'a>,
        owner: Option<&'a Type>,
        circular: Vec<Ident>,
        signatures: impl Iterator<Item = &'s Signature>,
        options: &'a Options,
    ) -> Self {
        let exclusive = signatures.filter(|signature| {
            let receiver = signature.receiver();
            receiver.is_some_and(|receiver| {
                matches!(receiver.kind, ReceiverKind::Reference(_, _, Some(_)))
            })
        });
        Self {
            place,
            circular,
            exclusive: exclusive.map(|signature| signature.ident.clone()).collect(),
            owner,
            options,
        }
    }

    /// The derivative of one of them, with the options of its own attribute.
    fn derivative(
        &self,
        attributes: &[Attribute],
        visibility: &Visibility,
        signature: &Signature,
        body: Option<&Block>,
    ) -> TokenStream {
        let own = own_options(attributes);
        if !itself::is_returned(signature, self.owner) {
            return self.derivative_with(own, visibility, signature, body);
        }
        let signature = itself::marked(signature);
        let (own, body) = match (own, body.map(itself::body).transpose()) {
            (own, Ok(body)) => (own, body),
            (own, Err(error)) => (own.and(Err(error)), None),
        };
        self.derivative_with(own, visibility, &signature, body.as_ref())
    }

    fn derivative_with(
        &self,
        own: syn::Result<Options>,
        visibility: &Visibility,
        signature: &Signature,
        body: Option<&Block>,
    ) -> TokenStream {
        // A trait and its `impl`s have to agree.
        let borrows = self.options.borrows
            || own.as_ref().is_ok_and(|own| own.borrows)
            || matches!(self.place, Place::Impl(_))
                && body.is_some_and(|body| borrowing::keeps_references(signature, body));
        let signature = &elision::in_parameters(signature, borrows);
        let callables = &Callables::new(signature);
        let function = |options| Function {
            place: self.place,
            visibility,
            signature,
            callables,
            exclusive_methods: &self.exclusive,
            body,
            options,
        };
        match own {
            Ok(own) => {
                let options = self.options.with(own);
                let boxed = options.boxed || self.circular.contains(&signature.ident);
                derivative_or_errors(&function(Options { boxed, borrows, ..options }))
            }
            Err(error) => {
                let error = error.into_compile_error();
                let stub = function(self.options.clone()).stub();
                quote!(#error #stub)
            }
        }
    }
}

/// The name of what `#[differentiable]` adds to a trait and to each of its `impl`s: an `impl`
/// without the attribute could change a method and keep the derivative of the provided one. The compiler
/// shows it where one of them is without.
const MARK: &str = "the_trait_and_its_impls_need_the_attribute_differentiable";

fn impl_derivatives(item: TokenStream, block: &ItemImpl, options: &Options) -> TokenStream {
    let place = match &block.trait_ {
        None => Place::Impl(&block.generics),
        Some((path, _)) if let Some(operator) = operator::of(path) => {
            return beside(item, operator::rule(operator, block, options));
        }
        Some((path, _)) if let Some(accumulation) = accumulation::of(path) => {
            return beside(item, accumulation::mark(accumulation, block));
        }
        Some((path, _)) if element::is_index(path) => {
            let derivatives =
                |element: ItemImpl| impl_derivatives(quote!(#element), &element, options);
            return beside(item, element::beside(path, block, derivatives));
        }
        Some((path, _)) if is_standard(path) => {
            let error = syn::Error::new_spanned(
                path,
                "a trait of the standard library has no derivatives: put the computation into a method of your own, and call that",
            );
            return with_error(&item, &error);
        }
        Some(_) if let Type::Slice(_) = &*block.self_ty => {
            let error = syn::Error::new_spanned(
                &block.self_ty,
                "a trait for slices has no derivatives, for a slice has no size of its own: implement it for `Vec<T>` or `[T; N]`, or write functions that take `&[T]`",
            );
            return with_error(&item, &error);
        }
        Some(_) => Place::TraitImpl(&block.generics, &block.self_ty),
    };
    if let Err(error) = options.without_rules() {
        return with_error(&item, &error);
    }
    let methods = block.items.iter().filter_map(|item| match item {
        ImplItem::Fn(method) => Some(method),
        _ => None,
    });
    // What is made from nothing is a constant to whoever calls it.
    let methods = methods.filter(|method| !method.sig.inputs.is_empty());
    let owner = match &*block.self_ty {
        Type::Path(path) => path.path.segments.last().map(|last| &last.ident),
        _ => None,
    };
    let functions: Vec<_> =
        methods.clone().map(|ImplItemFn { sig, block, .. }| (sig, block)).collect();
    let circular = recursion::circular(owner, block.trait_.is_none(), &functions);
    let signatures = methods.clone().map(|method| &method.sig);
    let all = Methods::new(place, Some(&block.self_ty), circular, signatures, options);
    let siblings = methods.map(|ImplItemFn { attrs, vis, sig, block, .. }| {
        all.derivative(attrs, vis, sig, Some(block))
    });
    let mark = block.trait_.as_ref().map(|(path, _)| {
        let mark = format_ident!("{MARK}", span = path.span());
        let checks = hidden::checks(block, path);
        quote_spanned!(path.span()=> fn #mark() { #checks })
    });
    // The mark comes first: what is missing from a trait without the attribute is told in this order.
    item::block(item, &quote!(#mark #(#siblings)*), block.trait_.is_none())
}

/// A block as it is, and what was made for it.
fn beside(item: TokenStream, made: syn::Result<TokenStream>) -> TokenStream {
    let item = item::block(item, &TokenStream::new(), false);
    let made = made.unwrap_or_else(syn::Error::into_compile_error);
    quote!(#item #made)
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

fn trait_derivatives(item: TokenStream, definition: &ItemTrait, options: &Options) -> TokenStream {
    if let Err(error) = options.without_rules() {
        return with_error(&item, &error);
    }
    let methods = definition.items.iter().filter_map(|item| match item {
        TraitItem::Fn(method) if !method.sig.inputs.is_empty() => Some(method),
        _ => None,
    });
    let place = Place::Trait(&definition.generics);
    let all =
        Methods::new(place, None, Vec::new(), methods.clone().map(|method| &method.sig), options);
    let siblings = methods.map(|TraitItemFn { attrs, sig, default, .. }| {
        all.derivative(attrs, &Visibility::Inherited, sig, default.as_ref())
    });
    let mark = format_ident!("{MARK}");
    let members = quote! {
        #(#siblings)*

        #[doc(hidden)]
        fn #mark()
        where
            Self: ::core::marker::Sized;
    };
    item::block(item, &members, false)
}
