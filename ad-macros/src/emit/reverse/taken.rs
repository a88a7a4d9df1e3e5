//! Calls of which the types have to tell what they take as `&mut` (see `ad::rt::Taken`).

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::Sweeper;
use super::contribute::cotangent_of;
use crate::ir::primal::Primal;
use crate::ir::{Argument, Callee, Derivative};

/// Of so many arguments the types can tell.
const MOST_TOLD: usize = 6;

impl Sweeper<'_> {
    /// The arguments of which the types tell whether the call takes them as `&` or as `&mut`: names of `&mut`, beside
    /// others that the call may change, and whatever a method is given that may change what it is called on. Functions of
    /// `ad`, as that for `mem::swap`, change what they are lent.
    pub(super) fn told(&self, callee: &Callee, arguments: &[Argument]) -> Vec<usize> {
        if let Derivative::Twin { is_of_attribute: false, .. } = callee.derivative {
            return Vec::new();
        }
        let is_active = |index: &usize| match &arguments[*index] {
            Argument::Exclusive(place) | Argument::Reborrow(place) => self.vars[place.root].active,
            _ => false,
        };
        let active: Vec<_> = (0..arguments.len()).filter(is_active).collect();
        let may_change = callee.is_method
            && matches!(&arguments[0], Argument::Receiver(place) if self.vars[place.root].mutable);
        let is_name = |index: &usize| matches!(arguments[*index], Argument::Reborrow(_));
        let is_asked = active.len() + usize::from(may_change) > 1
            && (may_change || active.iter().any(is_name));
        match is_asked && active.len() <= MOST_TOLD {
            true => active,
            false => Vec::new(),
        }
    }

    /// The call of a derivative whose types tell what it takes.
    pub(super) fn told_call(
        &self,
        vjp: &TokenStream,
        callee: &Callee,
        arguments: &[Argument],
        told: &[usize],
    ) -> TokenStream {
        let primal = Primal(self.vars);
        let name = |position: usize| Ident::new(&format!("taken_{position}"), Span::mixed_site());
        let names: Vec<_> = (0..told.len()).map(name).collect();
        let given = |(index, argument): (usize, &Argument)| {
            let tokens = primal.argument(argument);
            match told.iter().position(|other| *other == index) {
                Some(position) => {
                    let name = &names[position];
                    quote!(#name.by(#tokens))
                }
                None => tokens,
            }
        };
        let given = arguments.iter().enumerate().map(given).collect();
        let call = Primal::call_given(vjp, callee.is_method, arguments, given);
        quote! {{
            #(let #names = ::ad::rt::Taken::new();)*
            ::ad::rt::told(#call, (#(#names,)*))
        }}
    }

    /// The call of its pullback: what the call took as `&mut` lends its cotangent.
    pub(super) fn told_pullback(
        &mut self,
        reverse: &mut TokenStream,
        record: &Ident,
        cotangent: TokenStream,
        arguments: &[Argument],
        told: &[usize],
    ) -> TokenStream {
        let mut receiver = quote!(&mut ::ad::NoTangent::<()>::new());
        let mut given = Vec::new();
        for (index, argument) in arguments.iter().enumerate() {
            match argument {
                Argument::Exclusive(place) | Argument::Reborrow(place) => {
                    given.push(match told.iter().position(|other| *other == index) {
                        Some(position) => {
                            self.start(reverse, place.root);
                            let var = &self.vars[place.root];
                            let (lender, take) =
                                (cotangent_of(&var.cotangent, &place.path), take(position));
                            quote!(#record.#take(#lender))
                        }
                        None => {
                            let constant = self.of_constant(place);
                            quote!((#constant,))
                        }
                    });
                }
                Argument::Receiver(place)
                    if self.vars[place.root].mutable && !self.is_constant(place) =>
                {
                    self.start(reverse, place.root);
                    receiver = cotangent_of(&self.vars[place.root].cotangent, &place.path);
                }
                _ => {}
            }
        }
        let names: Vec<_> = (0..given.len()).map(|index| format_ident!("given_{index}")).collect();
        quote! {{
            #(let #names = #given;)*
            #record.pull_back(#cotangent, #receiver, (#(#names,)*))
        }}
    }
}

/// The method of a told pullback that takes the cotangent of the argument at a position.
fn take(position: usize) -> Ident {
    format_ident!("take_{position}")
}
