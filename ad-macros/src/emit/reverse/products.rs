//! Products whose pullbacks are plain while all factors are finite (see [`products`](crate::analyse::products)).

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::Sweeper;
use crate::analyse::products::{Products, Rules};
use crate::ir::{Loop, VarId};

impl Sweeper<'_> {
    /// The products, if the forward sweep has to test their factors.
    fn tested_products(&self) -> Option<&Products> {
        self.products.as_ref().filter(|products| products.are_chosen() && !products.are_told)
    }

    /// The test of a result, where it needs one.
    pub(super) fn test(&self, var: VarId) -> TokenStream {
        match self.tested_products() {
            Some(products) if products.tested.contains(&var) => self.finiteness(products, var),
            _ => TokenStream::new(),
        }
    }

    fn finiteness(&self, products: &Products, var: VarId) -> TokenStream {
        let (irregular, ident) = (&products.irregular, &self.vars[var].ident);
        quote!(#irregular += ::ad::Differentiable::irregularity(&#ident);)
    }

    /// The tests that stand after a loop.
    pub(super) fn tests_after(&self, a_loop: &Loop) -> TokenStream {
        let Some(products) = self.tested_products() else { return TokenStream::new() };
        let vars = products.tested_after.get(&a_loop.record.to_string()).into_iter().flatten();
        vars.map(|&var| self.finiteness(products, var)).collect()
    }

    /// What the forward sweep starts with.
    pub(super) fn start_of_tests(&self) -> TokenStream {
        match self.tested_products() {
            Some(Products { irregular, .. }) => quote!(let mut #irregular = 0.0;),
            None => TokenStream::new(),
        }
    }

    /// The pullback's body: the reverse sweep, with rules of products as the forward sweep found
    /// them to be needed.
    pub(super) fn choose_products(
        &self,
        seed: &Ident,
        reverse: TokenStream,
        cotangents: TokenStream,
    ) -> TokenStream {
        let Some(Products { rules, are_told, irregular, name, .. }) = &self.products else {
            return quote!(#reverse #cotangents);
        };
        let told = are_told.then(|| quote!(let #irregular = ::ad::rt::vanishing(#seed);));
        let chosen = match rules {
            Rules::WrittenTwice => quote! {
                if #irregular == 0.0 {
                    let #name = ::ad::rt::Products::OF_FINITE;
                    #reverse
                    #cotangents
                } else {
                    ::ad::rt::rarely(move || {
                        let #name = ::ad::rt::Products::OF_ANY;
                        #reverse
                        #cotangents
                    })
                }
            },
            Rules::CompiledTwice => quote! {
                ::ad::rt::with_products(
                    #irregular,
                    #[inline(always)]
                    move |#name: ::ad::rt::Products| { #reverse #cotangents },
                )
            },
            Rules::Called => quote! {
                let #name = ::ad::rt::ProductsOutOfLine;
                #reverse
                #cotangents
            },
        };
        quote!(#told #chosen)
    }
}
