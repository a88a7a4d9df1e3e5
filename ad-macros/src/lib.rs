//! The source transformation behind the crate `ad`; use it from there.
//!
//! The way of a function through this crate, one room after the other:
//!
//! 1. `parse` has the compiler answer the conditions in the annotated item, takes the item apart and checks
//!    its signature.
//! 2. `lower` rewrites the body to the few forms of `ir`: every operation has a name, every
//!    exit is the end of a block. What has no right derivative is refused here, at its span.
//! 3. `analyse` finds out about the lowered body what no type tells: which variables are numbers, where values
//!    are used last, which pullbacks of products may be plain.
//! 4. `emit` writes the forward and the reverse sweep (`reverse`) and the forward mode (`forward`) of the lowered
//!    body, and wraps them into the functions that users call (`items`; `lending`, `passing` and `checkpoint` write
//!    those beside `vjp`).
//!
//! `attribute` sends an item on this way: a function as it is, an `impl` block or a trait method by method.
//! `impls` gives `impl` blocks of operators, sums and indices their rules, by way of such functions. `derive`
//! stands apart: it gives structs and enums their tangents. What all rooms share stands at the root: `names` for
//! variables, `types` and `rules` for what a type or the name of a method tells, `errors`.
//! No folder reads one that stands after it.
//!
//! # The shape of generated code
//!
//! The forward sweep is the user's function in A-normal form; mutable variables stay mutable, and
//! each read of one is a copy under a name of its own. The reverse sweep is one block that visits
//! the operations backwards: `x_bar` gathers the cotangent of `x`, and an assignment to `x` takes
//! `x_bar` away from the value before and gives it to the value assigned. What the reverse sweep
//! names, the closure captures: rustc decides what is saved, and it is saved once. A branch returns
//! what its arm saved as a variant; a loop pushes what an iteration saved on a tape.
//!
//! Turned down: single static assignment with a pullback closure for each block (cotangents of all
//! variables that a block assigns would have to be threaded through tuples, and element access
//! would copy arrays); a closure for each operation (operands used twice would be saved twice).

mod analyse;
mod attribute;
mod derive;
mod emit;
mod errors;
mod floats;
mod impls;
mod ir;
mod lower;
mod names;
mod parse;
mod rules;
#[cfg(test)]
mod snapshots;
mod types;

use proc_macro::TokenStream;

/// Writes the derivative of a function at compile time.
///
/// See the documentation of the crate `ad`.
#[proc_macro_attribute]
pub fn differentiable(arguments: TokenStream, item: TokenStream) -> TokenStream {
    attribute::expand(arguments.into(), item.into()).into()
}

/// Gives a struct or an enum a tangent type: for the struct `Ray` the struct `RayTangent`, whose
/// fields hold the tangents of the fields of `Ray`; for the enum `Shape` the struct `ShapeTangent`,
/// with a field for each variant that holds data. The field has the name of the variant and holds
/// the tangents of its fields (`bar.Disc.0`, `bar.Square.side`).
///
/// A field marked `#[constant]` carries no derivative. Nor does a type as a whole that is marked so:
/// the tangent of such a struct is a `NoTangent` of it, that of such an enum holds a `NoTangent` for each field.
/// The tangent of an enum without data is `()`, as that of an integer.
#[proc_macro_derive(Differentiable, attributes(constant))]
pub fn derive_differentiable(item: TokenStream) -> TokenStream {
    derive::expand(item.into()).unwrap_or_else(syn::Error::into_compile_error).into()
}

/// Gives a struct that is generic over its scalar, and its tangent, the numbers they are made of: one
/// by one, and by the names of the fields.
///
/// See the trait `ad::Fields`.
#[proc_macro_derive(Fields)]
pub fn derive_fields(item: TokenStream) -> TokenStream {
    derive::fields::expand(item.into()).unwrap_or_else(syn::Error::into_compile_error).into()
}
