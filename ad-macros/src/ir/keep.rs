//! Variables that one way on from a fork finds as they were, while another way may move them.
//!
//! Where control goes on from a block is told by its value, a `ControlFlow`: to the compiler each way from
//! there begins with what every way has left. So `for .. { let w = f(v); if c { break; } v = w; }`, in which
//! only the way by `break` leaves `v` moved, would move `v` twice. Ways that go on with such a variable
//! store it in a slot beside the fork, an `Option`, and take it from there where they arrive.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::{Var, VarId};

/// Where a jump leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// Out of what has this number, with a value: `return`, `break`.
    Leave(usize),
    /// To the next iteration of the loop with this number.
    Again(usize),
}

/// A way on from a loop, a branch or a block: to a target, or to what follows.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Way {
    /// The number of the fork.
    pub fork: usize,
    /// Where it leads.
    pub target: Option<Target>,
}

/// What is done about the variables that a way keeps.
pub struct Keep {
    pub action: Action,
    pub way: Way,
    pub kept: Vec<Kept>,
}

/// What is done about them where a fork or one of its ways begins or ends.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Action {
    /// Declares the slots of all ways.
    Declare,
    /// Moves the variables into their slots.
    Store,
    /// Moves them out again.
    Restore,
}

/// A variable, and its slot.
pub struct Kept {
    pub var: VarId,
    pub slot: Ident,
}

impl Keep {
    /// The statements; `of` gives what is stored of a variable, and where its value is to go.
    pub fn statements(
        &self,
        vars: &[Var],
        mut of: impl FnMut(VarId) -> TokenStream,
    ) -> TokenStream {
        let statements = self.kept.iter().map(|Kept { var, slot }| {
            let value = of(*var);
            // What never changes begins once more.
            let begins = (!vars[*var].mutable).then(|| quote!(let));
            match self.action {
                Action::Declare => quote!(let mut #slot = ::core::option::Option::None;),
                Action::Store => quote!(#slot = ::core::option::Option::Some(#value);),
                Action::Restore => {
                    quote!(#begins #value = ::core::option::Option::unwrap(#slot.take());)
                }
            }
        });
        statements.collect()
    }
}
