//! An operator, and the parts of an `impl` of one.

use proc_macro2::Ident;
use quote::{ToTokens, quote};
use syn::visit_mut::{self, VisitMut};
use syn::{Block, FnArg, ImplItem, ItemImpl, Path, PathArguments, Signature, Type, parse_quote};

use crate::names;

/// An operator.
#[derive(Clone, Copy)]
pub struct Operator {
    /// Its trait.
    pub name: &'static str,
    pub kind: Kind,
}

/// What its rule gets.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// `-a`
    Unary,
    /// `a + b`; the rule gets what was kept of the operands.
    Sum,
    /// `a * b`; the rule gets the operands.
    Product,
    /// `a += b`
    Increase,
    /// `a *= b`
    Scaling,
}

impl Operator {
    /// Whether it changes what stands to its left.
    pub fn changes(self) -> bool {
        matches!(self.kind, Kind::Increase | Kind::Scaling)
    }
}

/// The method as a function of `Self`, with a name in place of `self`.
pub fn without_receiver(signature: &Signature, body: &Block) -> Option<(Signature, Block)> {
    let mut signature = signature.clone();
    let mut written = std::collections::HashSet::new();
    names::collect(quote!(#signature #body), &mut written);
    let mut name = "this".to_owned();
    while written.contains(&name) {
        name.push('_');
    }
    let Some(first @ FnArg::Receiver(_)) = signature.inputs.first_mut() else { return None };
    let FnArg::Receiver(receiver) = &*first else { return None };
    let this = Ident::new(&name, receiver.self_token.span);
    let mutability = &receiver.mutability;
    *first = match receiver.kind {
        syn::ReceiverKind::Reference(_, _, Some(_)) => parse_quote!(#this: &mut Self),
        _ => parse_quote!(#mutability #this: Self),
    };
    let body = names::without_self(body.to_token_stream(), &this);
    let body = syn::parse2(body).expect("a block stays one when a name changes");
    Some((signature, body))
}

/// The type that is called `Self::Output`, if it has a name.
pub fn output(block: &ItemImpl) -> Option<Output> {
    block.items.iter().find_map(|item| match item {
        ImplItem::Type(associated) if associated.ident == "Output" => match &associated.ty {
            Type::Path(path) if path.qself.is_none() => Some(Output(path.path.clone())),
            _ => None,
        },
        _ => None,
    })
}

/// Puts the type itself in place of `Self::Output`, which looks like a variant of an enum.
pub struct Output(pub Path);

impl VisitMut for Output {
    fn visit_path_mut(&mut self, path: &mut Path) {
        let names: Vec<_> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        if let [first, second, ..] = &names[..]
            && first == "Self"
            && second == "Output"
        {
            let mut ty = self.0.clone();
            for segment in &mut ty.segments {
                if let PathArguments::AngleBracketed(arguments) = &mut segment.arguments {
                    arguments.colon2_token = Some(Default::default());
                }
            }
            ty.segments.extend(path.segments.iter().skip(2).cloned());
            *path = ty;
        }
        visit_mut::visit_path_mut(self, path);
    }
}
