//! Methods of a trait that a method of the type itself hides.
//!
//! `spring.energy(x)` is the method of the type where there is one, and that of a trait where there is
//! none; and so is `spring.energy_vjp(x)`. If the type's own has no attribute these are two methods.
//! Where the macro writes a call it sees neither; here, in the `impl` of the trait, the compiler is
//! asked whether the name leads to the trait in both cases, and, where it leads to the type, whether
//! both methods take the same `self`: which of them a call means depends on that. It finds no answer
//! where two traits in scope give one type a method of that name, and none for a trait of all types.

use proc_macro2::TokenStream;
use quote::{format_ident, quote_spanned};
use syn::{FnArg, GenericParam, ImplItem, ImplItemFn, ItemImpl, Path, Signature, Type};

use crate::lower::is_own_type;
use crate::rules;

/// Has the compiler check the methods of an `impl` of the trait at `path`.
pub fn checks(block: &ItemImpl, path: &Path) -> TokenStream {
    let has_rules = !is_own_type(&block.self_ty, &[]) && !is_container(&block.self_ty);
    let methods = block.items.iter().filter_map(|item| match item {
        // A method of numbers and vectors that has a rule is known where it is called.
        ImplItem::Fn(ImplItemFn { sig, .. })
            if can_be_named(sig) && !(has_rules && rules::is_method(&sig.ident.to_string())) =>
        {
            Some(sig)
        }
        _ => None,
    });
    let check = |signature: &Signature| {
        let name = &signature.ident;
        let vjp = format_ident!("{name}_vjp", span = name.span());
        let receivers = signature.receiver().map(|_| {
            quote_spanned! {name.span()=>
                ::ad::rt::same_receiver(
                    ::ad::rt::Found(Self::#name, <Self as #path>::#name).receivers(),
                );
            }
        });
        quote_spanned! {name.span()=>
            let _ = || {
                #[allow(unused_imports)]
                use ::ad::rt::Hidden as _;
                ::ad::rt::same_owner((
                    ::ad::rt::Found(Self::#name, <Self as #path>::#name).owner(),
                    ::ad::rt::Found(Self::#vjp, <Self as #path>::#vjp).owner(),
                ));
                #receivers
            };
        }
    };
    methods.map(check).collect()
}

/// Whether a type is one of the standard library that holds others.
fn is_container(ty: &Type) -> bool {
    match ty {
        Type::Array(_) | Type::Slice(_) | Type::Tuple(_) => true,
        Type::Path(path) => path.path.segments.last().is_some_and(|last| {
            ["Box", "Option", "Result", "Vec"].iter().any(|name| last.ident == name)
        }),
        _ => false,
    }
}

/// Whether a method is one without type arguments, which has a derivative.
fn can_be_named(signature: &Signature) -> bool {
    let is_lifetime = |parameter: &GenericParam| matches!(parameter, GenericParam::Lifetime(_));
    let is_anonymous = |input: &FnArg| match input {
        FnArg::Typed(typed) => match &*typed.ty {
            Type::Reference(reference) => matches!(*reference.elem, Type::ImplTrait(_)),
            ty => matches!(ty, Type::ImplTrait(_)),
        },
        FnArg::Receiver(_) => false,
    };
    !signature.inputs.is_empty()
        && signature.generics.params.iter().all(is_lifetime)
        && !signature.inputs.iter().any(is_anonymous)
}
