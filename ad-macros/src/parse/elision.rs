//! Lifetimes that a signature leaves out.
//!
//! `fn first(xs: &[f64]) -> &f64` borrows from its only reference; `jvp` has a second one, the
//! tangent, so the first has to be named.

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::quote;
use syn::visit::Visit;
use syn::visit_mut::{self, VisitMut};
use syn::{
    FnArg, GenericParam, Lifetime, LifetimeParam, ParenthesizedGenericArguments, ReceiverKind,
    ReturnType, Signature, Type, TypeFnPtr, TypeImplTrait, TypeReference, TypeTraitObject,
};

/// The lifetime that stands for one that was left out.
pub fn lifetime() -> Lifetime {
    Lifetime::new("'__primal", Span::mixed_site())
}

/// An `impl` block with a name for the lifetimes that its head leaves out, `impl Trait for View<'_>`:
/// what a pullback may hold on to is listed by name.
pub fn in_head(item: TokenStream) -> TokenStream {
    let mut tokens: Vec<_> = item.clone().into_iter().collect();
    let last = tokens.len().saturating_sub(1);
    let Some(head) = tokens.iter().position(|token| is_word(token, "impl")) else { return item };
    let mut left_out = Vec::new();
    for index in head..last {
        let is_mark = matches!(&tokens[index], TokenTree::Punct(mark) if mark.as_char() == '\'');
        if is_mark && is_word(&tokens[index + 1], "_") {
            let name = format!("__of_self_{}", left_out.len());
            let name = Ident::new(&name, Span::mixed_site().located_at(tokens[index + 1].span()));
            tokens[index + 1] = name.clone().into();
            left_out.push(Lifetime { apostrophe: name.span(), ident: name });
        }
    }
    if left_out.is_empty() {
        return item;
    }
    // Lifetimes stand before all other parameters.
    let has_parameters =
        matches!(tokens.get(head + 1), Some(TokenTree::Punct(angle)) if angle.as_char() == '<');
    let named = match has_parameters {
        true => quote!(#(#left_out,)*),
        false => quote!(<#(#left_out),*>),
    };
    let at = head + 1 + usize::from(has_parameters);
    tokens.splice(at..at, named);
    tokens.into_iter().collect()
}

fn is_word(token: &TokenTree, word: &str) -> bool {
    matches!(token, TokenTree::Ident(ident) if ident == word)
}

/// A signature with names for the lifetimes that it leaves out in the types of its parameters,
/// `view: View<'_>`: the type of the pullback names them, too. Where it [borrows](crate::parse::borrowing) from the
/// parameters, so does it those of references, and in any case the one that the result leaves out, as in
/// `fn view(&self) -> View<'_>`.
pub fn in_parameters(signature: &Signature, borrows: bool) -> Signature {
    let mut signature = signature.clone();
    let is_method = signature.receiver().is_some();
    let lends = leaves_out(&signature.output, !is_method);
    let mut numbering =
        Numbering { lifetimes: Vec::new(), of_references: borrows || lends && !is_method };
    let mut of_receiver = None;
    for input in &mut signature.inputs {
        match input {
            FnArg::Typed(typed) => numbering.visit_type_mut(&mut typed.ty),
            FnArg::Receiver(receiver) => {
                if let ReceiverKind::Reference(and, own, None) = &mut receiver.kind {
                    if own.is_none() && (borrows || lends) {
                        *own = Some(numbering.next(and.span));
                    }
                    of_receiver.clone_from(own);
                }
            }
        }
    }
    // What a result leaves out is that of the receiver, or the only one there is.
    let source = match (&numbering.lifetimes[..], is_method) {
        (_, true) => of_receiver,
        ([lifetime], false) => Some(lifetime.clone()),
        _ => None,
    };
    if let (Some(name), ReturnType::Type(_, ty), true) =
        (source, &mut signature.output, borrows || lends)
    {
        Naming { name, found: false }.visit_type_mut(ty);
    }
    // They stand before all other parameters.
    for lifetime in numbering.lifetimes.into_iter().rev() {
        let parameter = GenericParam::Lifetime(LifetimeParam::new(lifetime));
        signature.generics.params.insert(0, parameter);
    }
    signature
}

/// Whether a result is of a type with a lifetime that it leaves out, `View<'_>`, or, of `references`, too,
/// `Option<&f64>`.
fn leaves_out(result: &ReturnType, references: bool) -> bool {
    struct Finder {
        references: bool,
        found: bool,
    }

    impl<'ast> Visit<'ast> for Finder {
        fn visit_type_reference(&mut self, reference: &'ast TypeReference) {
            match &reference.lifetime {
                Some(lifetime) => self.visit_lifetime(lifetime),
                None => self.found |= self.references,
            }
            self.visit_type(&reference.elem);
        }

        // These are refused.
        fn visit_type_trait_object(&mut self, _: &'ast TypeTraitObject) {}
        fn visit_type_impl_trait(&mut self, _: &'ast TypeImplTrait) {}

        fn visit_lifetime(&mut self, lifetime: &'ast Lifetime) {
            self.found |= lifetime.ident == "_";
        }
    }

    let mut finder = Finder { references, found: false };
    match result {
        // That of a reference itself is named where it matters.
        ReturnType::Type(_, ty) if let Type::Reference(reference) = &**ty => {
            finder.visit_type(&reference.elem);
        }
        result => finder.visit_return_type(result),
    }
    finder.found
}

struct Numbering {
    lifetimes: Vec<Lifetime>,
    /// Whether those of references count.
    of_references: bool,
}

impl Numbering {
    fn next(&mut self, span: Span) -> Lifetime {
        let name = format!("__parameter_{}", self.lifetimes.len());
        let ident = Ident::new(&name, Span::mixed_site().located_at(span));
        let lifetime = Lifetime { apostrophe: ident.span(), ident };
        self.lifetimes.push(lifetime.clone());
        lifetime
    }
}

impl VisitMut for Numbering {
    fn visit_type_reference_mut(&mut self, reference: &mut TypeReference) {
        let is_left_out = reference.lifetime.as_ref().is_none_or(|lifetime| lifetime.ident == "_");
        if self.of_references && is_left_out && reference.mutability.is_none() {
            reference.lifetime = Some(self.next(reference.and_token.span));
        }
        self.visit_type_mut(&mut reference.elem);
    }

    fn visit_lifetime_mut(&mut self, lifetime: &mut Lifetime) {
        if lifetime.ident == "_" {
            *lifetime = self.next(lifetime.span());
        }
    }

    fn visit_type_fn_ptr_mut(&mut self, _: &mut TypeFnPtr) {}
    fn visit_parenthesized_generic_arguments_mut(&mut self, _: &mut ParenthesizedGenericArguments) {
    }
}

/// `ty` with [`lifetime`] for those that it leaves out, and whether there are any.
pub fn named(ty: &Type) -> (Type, bool) {
    let (mut ty, mut naming) = (ty.clone(), Naming { name: lifetime(), found: false });
    naming.visit_type_mut(&mut ty);
    (ty, naming.found)
}

struct Naming {
    name: Lifetime,
    found: bool,
}

impl VisitMut for Naming {
    fn visit_type_reference_mut(&mut self, reference: &mut TypeReference) {
        if reference.lifetime.is_none() {
            self.found = true;
            reference.lifetime = Some(self.name.clone());
        }
        visit_mut::visit_type_reference_mut(self, reference);
    }

    fn visit_lifetime_mut(&mut self, lifetime: &mut Lifetime) {
        if lifetime.ident == "_" {
            self.found = true;
            *lifetime = self.name.clone();
        }
    }

    // Within the types of functions, what is left out is theirs.
    fn visit_type_fn_ptr_mut(&mut self, _: &mut TypeFnPtr) {}
    fn visit_parenthesized_generic_arguments_mut(&mut self, _: &mut ParenthesizedGenericArguments) {
    }
}
