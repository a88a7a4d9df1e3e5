//! The source transformation behind the crate `ad`; use it from there.
//!
//! The way of a function through this crate, one room after the other:
//!
//! 1. `attribute` has the compiler answer the conditions in the annotated item (`conditional`), takes the
//!    item apart and checks its signature (`signature`).
//! 2. `lower` rewrites the body to the few forms of `ir`: every operation has a name, every
//!    exit is the end of a block. What has no right derivative is refused here, at its span.
//! 3. `sweep` writes the forward and the reverse sweep of the lowered body.
//! 4. `forward` writes the forward mode of the same lowered body.
//! 5. `expand` wraps them into the functions that users call (`lending`, `passing` and `checkpoint` write
//!    those beside `vjp`).
//!
//! What these rooms share stands below them: `function`, `signature` and `types` say what a function is,
//! `ir` is the lowered form, `primal` writes it as the user did. No file imports one that imports it back.
//!
//! `derive` stands apart: it gives structs and enums their tangents. `operator` and `accumulation`
//! give the operators and the sums of such types their rules, `element` their elements.
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

mod accumulation;
mod attribute;
mod borrowing;
mod callable;
mod checkpoint;
mod conditional;
mod derive;
mod element;
mod elision;
mod errors;
mod expand;
mod floats;
mod forward;
mod function;
mod groups;
mod hidden;
mod ir;
mod item;
mod itself;
mod kept;
mod lending;
mod lower;
mod names;
mod numbers;
mod operator;
mod options;
mod passing;
mod primal;
mod recursion;
mod refused;
mod rules;
mod signature;
#[cfg(test)]
mod snapshots;
mod sweep;
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
