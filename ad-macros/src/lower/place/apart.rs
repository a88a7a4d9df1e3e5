//! Parts of one place that a call changes at the same time: halves of a slice, elements that a pattern
//! names. In generated code each is written as a part of the whole, which Rust does not borrow twice.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Expr, ExprCall, Ident};

use crate::ir::{Argument, Callee, Operand, Place, Projection};
use crate::lower::Lowerer;

impl Lowerer<'_> {
    /// `mem::swap` of two elements of one slice: the slice swaps them.
    pub fn swap_elements(&mut self, call: &ExprCall, arguments: &[Argument]) -> Option<Operand> {
        let [
            Argument::Exclusive(left) | Argument::Reborrow(left),
            Argument::Exclusive(right) | Argument::Reborrow(right),
        ] = arguments
        else {
            return None;
        };
        let common = parting(left, right)?;
        let indices = [element(&left.path[common..])?, element(&right.path[common..])?]
            .map(|index| Argument::Value(Operand::Constant(index)));
        let slice = Place { root: left.root, path: left.path[..common].to_vec() };
        // What is out of the bounds of a half is not out of those of the whole.
        let (left, right) = (self.place_tokens(left), self.place_tokens(right));
        let code = quote!(let _ = (&#left, &#right););
        self.push_plain(code);
        let callee = Callee::method(&Ident::new("swap", call.func.span()), None);
        let arguments = [Argument::Receiver(slice)].into_iter().chain(indices).collect();
        Some(self.finish_call(callee, arguments, "swap", call.span()))
    }

    /// Refuses to lend two parts of one slice at the same time.
    pub fn check_apart(&mut self, call: &impl ToTokens, arguments: &[Argument]) {
        let lent = |argument: &Argument| match argument {
            Argument::Exclusive(place) | Argument::Reborrow(place) => Some((place.clone(), true)),
            Argument::Borrow(place) => Some((place.clone(), false)),
            _ => None,
        };
        let lent: Vec<_> = arguments.iter().filter_map(lent).collect();
        let pairs = (0..lent.len()).flat_map(|index| (0..index).map(move |other| (index, other)));
        for (index, other) in pairs {
            let ((left, changes), (right, also_changes)) = (&lent[index], &lent[other]);
            if !(*changes || *also_changes) || left.root != right.root {
                continue;
            }
            if parting(left, right).is_some() {
                self.refuse(
                    call,
                    "two parts of one slice are lent here at the same time: pass the slice and where the parts are, `f(&mut v, i, j)`; elements are swapped by `v.swap(i, j)`",
                );
                return;
            }
            self.check_holders(call, left, right);
        }
    }

    /// Has the compiler check that what holds an element lends two parts of it, as a `Vec` does not.
    fn check_holders(&mut self, call: &impl ToTokens, left: &Place, right: &Place) {
        let common = in_common(left, right);
        let is_name = |step: &Projection| matches!(step, Projection::Behind(_));
        if common == left.path.len().min(right.path.len())
            || left.path.iter().chain(&right.path).any(is_name)
        {
            return;
        }
        let indices = (0..common).filter(|&index| matches!(left.path[index], Projection::Index(_)));
        for index in indices {
            let holder = Place { root: left.root, path: left.path[..index].to_vec() };
            let holder = self.place_tokens(&holder);
            let code = quote_spanned!(call.span()=> ::ad::rt::lends_parts(&#holder););
            self.push_plain(code);
        }
    }
}

/// The number of steps to the slice of which both places are parts.
fn parting(left: &Place, right: &Place) -> Option<usize> {
    let common = in_common(left, right);
    let is_index = |place: &Place| matches!(place.path.get(common), Some(Projection::Index(_)));
    (left.root == right.root && is_index(left) && is_index(right)).then_some(common)
}

/// Whether two places are parts of different fields.
pub fn are_other_fields(left: &Place, right: &Place) -> bool {
    let common = in_common(left, right);
    let is_field = |place: &Place| matches!(place.path.get(common), Some(Projection::Field(_)));
    is_field(left) && is_field(right)
}

/// Whether two places are the same, or one is a part of the other.
pub fn overlap(left: &Place, right: &Place) -> bool {
    let [left_steps, right_steps] = [left, right]
        .map(|place| place.path.iter().filter(|step| !matches!(step, Projection::Deref)));
    left.root == right.root && left_steps.zip(right_steps).all(are_same)
}

/// The number of steps that both ways begin with.
fn in_common(left: &Place, right: &Place) -> usize {
    left.path.iter().zip(&right.path).take_while(|steps| are_same(*steps)).count()
}

fn are_same(steps: (&Projection, &Projection)) -> bool {
    match steps {
        (Projection::Field(left), Projection::Field(right)) => left == right,
        (Projection::FromEnd(left), Projection::FromEnd(right)) => left == right,
        (Projection::Index(left), Projection::Index(right)) => {
            left.to_string() == right.to_string()
        }
        (Projection::Deref, Projection::Deref) => true,
        (Projection::Behind(left), Projection::Behind(right)) => left == right,
        _ => false,
    }
}

/// The index of an element of a part of a slice.
fn element(path: &[Projection]) -> Option<TokenStream> {
    let (last, ranges) = path.split_last()?;
    let Projection::Index(index) = last else { return None };
    if let Ok(Expr::Range(_)) = syn::parse2(index.clone()) {
        return None;
    }
    ranges.iter().try_fold(quote!(#index), |sum, range| {
        let Projection::Index(range) = range else { return None };
        let Ok(Expr::Range(range)) = syn::parse2(range.clone()) else { return None };
        Some(match range.start {
            Some(start) => quote!(#sum + #start),
            None => sum,
        })
    })
}
