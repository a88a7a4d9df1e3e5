//! What a signature may not name: types, where what they hide decides what the derivative is, and crates.

use syn::visit::{self, Visit};
use syn::{Ident, Type, TypeFnPtr, TypeImplTrait, TypePtr, TypeReference, TypeTraitObject};

use crate::errors::Errors;
use crate::types::pointee;

/// Refuses a function by its name, which a type that has its derivative gets, too.
pub fn name(name: &Ident, errors: &mut Errors) {
    if ["std", "core", "alloc", "ad"].iter().any(|known| name == known) {
        errors.at(name, format!("its derivative belongs to a type called `{name}`, which would hide the crate: give the function another name"));
    }
}

/// Refuses the type of a parameter.
pub fn parameter(ty: &Type, errors: &mut Errors) {
    match ty {
        Type::Reference(reference) if is_reference_to_exclusive(&reference.elem) => {
            errors.at(ty, "a reference to a `&mut` is not supported: take the `&mut` itself")
        }
        Type::ImplTrait(_) => {
            errors.at(ty, "`impl Trait` stands for a parameter itself or for what it refers to: write a type parameter `T: ..` instead")
        }
        Type::Ptr(_) => errors.at(ty, "a raw pointer has no derivative: take a reference"),
        _ => match pointee(ty) {
            Type::FnPtr(_) => errors.at(
                ty,
                "a call through a pointer cannot be differentiated: write a type parameter `F: Fn(..) -> ..`, and pass a closure",
            ),
            Type::TraitObject(_) => errors.at(
                ty,
                "a call through `dyn` cannot be differentiated: write a type parameter",
            ),
            ty => {
                if !within(ty, errors) {
                    exclusive_within(ty, errors);
                }
            }
        },
    }
}

/// Refuses a `&mut` that stands in a type.
fn exclusive_within(ty: &Type, errors: &mut Errors) {
    struct Finder<'e>(&'e mut Errors);

    impl<'ast> Visit<'ast> for Finder<'_> {
        fn visit_type_reference(&mut self, ty: &'ast TypeReference) {
            match ty.mutability {
                Some(_) => self.0.at(ty, "a `&mut` within the type of a parameter is not followed: take `&mut` parameters by themselves, and of an option `&mut Option<..>`"),
                None => visit::visit_type_reference(self, ty),
            }
        }
    }

    Finder(errors).visit_type(ty);
}

/// Refuses the type of a result; says whether it is not known what is returned.
pub fn result(ty: &Type, errors: &mut Errors) -> bool {
    match ty {
        Type::ImplTrait(_) => {
            errors.at(
                ty,
                "the result needs a type that can be named: `impl Trait` cannot be differentiated",
            );
            true
        }
        ty => within(ty, errors),
    }
}

fn is_reference_to_exclusive(target: &Type) -> bool {
    match target {
        Type::Reference(reference) => {
            reference.mutability.is_some() || is_reference_to_exclusive(&reference.elem)
        }
        _ => false,
    }
}

/// Refuses what stands in a type; says whether there is something.
fn within(ty: &Type, errors: &mut Errors) -> bool {
    struct Finder<'e> {
        errors: &'e mut Errors,
        found: bool,
    }

    impl Finder<'_> {
        fn refuse(&mut self, ty: impl quote::ToTokens, message: &str) {
            self.errors.at(ty, message);
            self.found = true;
        }
    }

    impl<'ast> Visit<'ast> for Finder<'_> {
        fn visit_type_trait_object(&mut self, ty: &'ast TypeTraitObject) {
            self.refuse(ty, "what a `dyn` holds has no derivative, for its type is not known: name the type, take a type parameter, or write an `enum` of the types there are");
        }

        fn visit_type_impl_trait(&mut self, ty: &'ast TypeImplTrait) {
            self.refuse(
                ty,
                "a type without a name has no derivative here: name it, or take a type parameter",
            );
        }

        fn visit_type_fn_ptr(&mut self, ty: &'ast TypeFnPtr) {
            self.refuse(ty, "a function behind a pointer has no derivative: write a type parameter `F: Fn(..) -> ..`, and pass a closure");
        }

        fn visit_type_ptr(&mut self, ty: &'ast TypePtr) {
            self.refuse(ty, "a raw pointer has no derivative: take a reference");
        }
    }

    let mut finder = Finder { errors, found: false };
    finder.visit_type(ty);
    finder.found
}
