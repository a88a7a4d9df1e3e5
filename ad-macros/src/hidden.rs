//! Methods of a trait that a method of the type itself hides.
//!
//! `spring.energy(x)` is the method of the type where there is one, and that of a trait where there is
//! none; and so is `spring.energy_vjp(x)`. If the type's own has no attribute these are two methods.
//! Where the macro writes a call it sees neither; here, in the `impl` of the trait, the compiler is
//! asked whether the name leads to the trait in both cases. It finds no answer where two traits in
//! scope give one type a method of that name.

use proc_macro2::TokenStream;
use quote::{format_ident, quote_spanned};
use syn::{FnArg, GenericParam, Ident, ImplItem, ItemImpl, Path, Signature, Type};

use crate::lower::is_own_type;

/// Has the compiler check the methods of an `impl` of the trait at `path`.
pub fn checks(block: &ItemImpl, path: &Path) -> TokenStream {
    // The methods of numbers and vectors have rules: two for one name are ambiguous where it is called.
    if !is_own_type(&block.self_ty, &[]) {
        return TokenStream::new();
    }
    let methods = block.items.iter().filter_map(|item| match item {
        ImplItem::Fn(method) if can_be_named(&method.sig) => Some(&method.sig.ident),
        _ => None,
    });
    let check = |name: &Ident| {
        let vjp = format_ident!("{name}_vjp", span = name.span());
        quote_spanned! {name.span()=>
            let _ = || {
                #[allow(unused_imports)]
                use ::ad::rt::Hidden as _;
                ::ad::rt::same_owner((
                    ::ad::rt::Found(Self::#name, <Self as #path>::#name).owner(),
                    ::ad::rt::Found(Self::#vjp, <Self as #path>::#vjp).owner(),
                ));
            };
        }
    };
    methods.map(check).collect()
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
