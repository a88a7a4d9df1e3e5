//! Which derivative belongs to a function that is named.
//!
//! Values and types have name spaces of their own: that `g` is a function and `g::vjp` a derivative does
//! not make the one the derivative of the other. What the function itself declares or imports is looked
//! up here; the functions of the standard library, and of `ad`, that are treated as such have to be
//! those; and in debug builds each call compares the names of both (`ad::rt::is_other`).

use proc_macro2::{Ident, Span, TokenStream};
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{ExprPath, Path, PathArguments, PathSegment};

use crate::floats;
use crate::ir::{Callee, Derivative};
use crate::lower::Lowerer;
use crate::lower::syntax::is_type_name;

impl Lowerer<'_> {
    /// The derivative of the function at a path.
    pub(super) fn derivative_of(&mut self, function: &ExprPath) -> Derivative {
        if let Some(known) = self.known_derivative(&function.path) {
            return known;
        }
        let mut function = function.clone();
        if let Some(name) = function.path.get_ident()
            && let Some(path) = self.local_functions.imported.get(&name.to_string())
        {
            let mut path = path.clone();
            path.segments.iter_mut().for_each(|segment| segment.ident.set_span(name.span()));
            function.path = path;
        }
        if is_associated(&function) {
            return self.associated(&function);
        }
        let path = &function.path;
        let last = path.segments.last().expect("a path has a segment");
        let is_of_ad = path.leading_colon.is_some()
            && path.segments.first().is_some_and(|first| first.ident == "ad");
        // What an attribute writes here hides nothing from an import.
        let is_local = path
            .get_ident()
            .is_some_and(|name| self.local_functions.derived.contains(&name.to_string()));
        let ty = match is_of_ad || is_local {
            true => twin_of(path),
            false => self.called.twin(twin_of(path), &last.ident, self.names),
        };
        Derivative::Twin { ty, turbofish: turbofish(last), is_of_attribute: !is_of_ad }
    }

    /// Refuses a function that is declared here without the attribute, for one of its name may have it
    /// outside.
    pub(super) fn check_attribute(&mut self, function: &ExprPath) {
        if let Some(name) = function.path.get_ident()
            && self.local_functions.plain.contains(&name.to_string())
        {
            self.refuse(
                function,
                format!("`{name}` has no derivative: put `#[differentiable]` on it where it is written, in this function"),
            );
        }
    }

    /// The derivative of a function of the standard library.
    fn known_derivative(&mut self, path: &Path) -> Option<Derivative> {
        let mut segments = path.segments.iter().rev();
        let name = &segments.next()?.ident;
        let is_known = segments.next()?.ident == "mem"
            && ["swap", "replace", "take"].iter().any(|known| name == known);
        if !is_known {
            return None;
        }
        self.check_function(path, &quote!(::core::mem::#name), &quote!(::<u8>));
        Some(Callee::of_ad(quote!(::ad::rules::replace::#name)).derivative)
    }

    /// Has the compiler check that a path leads to a certain function, which could have these type
    /// arguments.
    pub fn check_function(&mut self, path: &Path, function: &TokenStream, arguments: &TokenStream) {
        let twin = twin_of(path);
        if !self.checked.insert(twin.to_string()) {
            return;
        }
        let code = quote_spanned! {path.span()=>
            ::ad::rt::same_function(#function #arguments, #twin);
        };
        self.push_plain(code);
    }

    /// The derivative of a function of a type.
    fn associated(&mut self, function: &ExprPath) -> Derivative {
        let (path, qself) = (&function.path, &function.qself);
        let last = path.segments.last().expect("a path has a segment");
        let (name, turbofish) = (last.ident.clone(), turbofish(last));
        let ruled = qself.as_ref().and_then(|qself| ruled_trait(path, qself.position));
        let owner = match (qself, ruled) {
            (Some(qself), Some((span, canonical))) => {
                // The rules for the methods of these traits stand in traits of `ad`.
                let ty = &qself.ty;
                let code = quote_spanned! {span=>
                    ::ad::rt::same_function(<#ty as #canonical>::#last, #function);
                };
                self.push_plain(code);
                quote!(<#ty>::)
            }
            (Some(qself), None) => {
                let ty = &qself.ty;
                let owner: Vec<_> = path.segments.iter().take(qself.position).collect();
                match &owner[..] {
                    [] => quote!(<#ty>::),
                    owner => {
                        let leading = &path.leading_colon;
                        quote!(<#ty as #leading #(#owner)::*>::)
                    }
                }
            }
            // A trait of the user's may have a method of this name for numbers, too; this is the number's own.
            (None, _) if let Some(rules) = rules_of_number(path) => {
                // A module may have the name of a number.
                let number = &path.segments[path.segments.len() - 2];
                self.check_function(path, &quote!(<#number>::#last), &TokenStream::new());
                rules
            }
            (None, _) => {
                let leading = &path.leading_colon;
                let owner = path.segments.iter().take(path.segments.len() - 1);
                quote!(#leading #(#owner::)*)
            }
        };
        Derivative::Sibling { owner, name, turbofish }
    }
}

/// What has the derivatives of a method of numbers, in place of the number in `f64::exp`.
fn rules_of_number(path: &Path) -> Option<TokenStream> {
    let mut segments = path.segments.iter().rev();
    let (method, number) = (&segments.next()?.ident, &segments.next()?.ident);
    let name = method.to_string();
    let is_known = (number == "f32" || number == "f64") && floats::takes_number(&name);
    let rules = match floats::real_returns_number(&name) {
        true => quote!(RealRules),
        false => quote!(FloatRules),
    };
    is_known.then(
        || quote_spanned!(number.span()=> <::core::primitive::#number as ::ad::rules::#rules>::),
    )
}

/// A trait with rules by its name in `<Type as Trait>::f`, which is checked to be it.
fn ruled_trait(path: &Path, position: usize) -> Option<(Span, TokenStream)> {
    let owner = path.segments.get(position.checked_sub(1)?)?;
    let arguments = &owner.arguments;
    let canonical = match () {
        () if owner.ident == "Real" => quote!(::ad::Real),
        () if owner.ident == "From" => quote!(::core::convert::From #arguments),
        () => return None,
    };
    Some((owner.ident.span(), canonical))
}

/// `Box::new`
pub(super) fn is_box_new(path: &Path) -> bool {
    ends_with(path, "Box", "new")
}

/// `Vec::with_capacity` and its like, whose argument decides nothing.
pub(super) fn makes_room(path: &Path) -> bool {
    ["Vec", "VecDeque"].iter().any(|list| ends_with(path, list, "with_capacity"))
}

/// `mem::swap`
pub(super) fn is_swap(path: &Path) -> bool {
    ends_with(path, "mem", "swap")
}

/// `array::from_fn`, however far its path is written out.
pub fn is_from_fn(path: &Path) -> bool {
    ends_with(path, "array", "from_fn")
}

/// What gives the elements of what may be an array, as [`option`](crate::lower::expression::option) writes it.
pub fn is_taken(path: &Path) -> bool {
    let names = path.segments.iter().map(|segment| &segment.ident);
    path.leading_colon.is_some() && names.eq(["ad", "rules", "attempt", "taken"])
}

fn ends_with(path: &Path, owner: &str, name: &str) -> bool {
    let mut segments = path.segments.iter().rev();
    segments.next().is_some_and(|last| last.ident == name)
        && segments.next().is_some_and(|segment| segment.ident == owner)
}

/// Whether a path leads to a function of a type.
pub fn is_associated(function: &ExprPath) -> bool {
    let is_type = |owner: &Ident| is_type_name(owner) || is_primitive(owner);
    function.qself.is_some()
        || function.path.segments.iter().rev().nth(1).is_some_and(|owner| is_type(&owner.ident))
}

/// Whether this is the name of a type of the language itself.
fn is_primitive(name: &Ident) -> bool {
    const PRIMITIVE: [&str; 16] = [
        "bool", "char", "f32", "f64", "i8", "i16", "i32", "i64", "i128", "isize", "u8", "u16",
        "u32", "u64", "u128", "usize",
    ];
    PRIMITIVE.iter().any(|primitive| name == primitive)
}

/// A path without the type arguments of the function it leads to, which is that of the type which has
/// the derivatives.
fn twin_of(path: &Path) -> TokenStream {
    let mut path = path.clone();
    if let Some(last) = path.segments.last_mut() {
        last.arguments = PathArguments::None;
    }
    quote!(#path)
}

/// `::<T>`
fn turbofish(last: &PathSegment) -> Option<TokenStream> {
    match &last.arguments {
        PathArguments::AngleBracketed(arguments) => {
            let mut arguments = arguments.clone();
            arguments.colon2_token = Some(Default::default());
            Some(quote!(#arguments))
        }
        _ => None,
    }
}
