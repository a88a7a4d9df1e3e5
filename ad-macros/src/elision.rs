//! Lifetimes that a signature leaves out.
//!
//! `fn first(xs: &[f64]) -> &f64` borrows from its only reference; `jvp` has a second one, the
//! tangent, so the first has to be named.

use proc_macro2::Span;
use syn::visit_mut::{self, VisitMut};
use syn::{Lifetime, ParenthesizedGenericArguments, Type, TypeFnPtr, TypeReference};

/// The lifetime that stands for one that was left out.
pub fn lifetime() -> Lifetime {
    Lifetime::new("'__primal", Span::mixed_site())
}

/// `ty` with [`lifetime`] for those that it leaves out, and whether there are any.
pub fn named(ty: &Type) -> (Type, bool) {
    let (mut ty, mut naming) = (ty.clone(), Naming { found: false });
    naming.visit_type_mut(&mut ty);
    (ty, naming.found)
}

struct Naming {
    found: bool,
}

impl VisitMut for Naming {
    fn visit_type_reference_mut(&mut self, reference: &mut TypeReference) {
        if reference.lifetime.is_none() {
            self.found = true;
            reference.lifetime = Some(lifetime());
        }
        visit_mut::visit_type_reference_mut(self, reference);
    }

    fn visit_lifetime_mut(&mut self, lifetime: &mut Lifetime) {
        if lifetime.ident == "_" {
            self.found = true;
            *lifetime = self::lifetime();
        }
    }

    // Within the types of functions, what is left out is theirs.
    fn visit_type_fn_ptr_mut(&mut self, _: &mut TypeFnPtr) {}
    fn visit_parenthesized_generic_arguments_mut(&mut self, _: &mut ParenthesizedGenericArguments) {
    }
}
