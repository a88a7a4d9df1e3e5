//! `Self` in the types of fields: these are written into the tangent, where it would be another type.

use syn::visit_mut::{self, VisitMut};
use syn::{DeriveInput, Type, parse_quote};

/// Writes the type by its name.
pub fn name(input: &mut DeriveInput) {
    let (name, (_, generics, _)) = (&input.ident, input.generics.split_for_impl());
    let mut itself = Itself(parse_quote!(#name #generics));
    itself.visit_data_mut(&mut input.data);
}

struct Itself(Type);

impl VisitMut for Itself {
    fn visit_type_mut(&mut self, ty: &mut Type) {
        match ty {
            Type::Path(path) if path.qself.is_none() && path.path.is_ident("Self") => {
                ty.clone_from(&self.0);
            }
            ty => visit_mut::visit_type_mut(self, ty),
        }
    }
}
