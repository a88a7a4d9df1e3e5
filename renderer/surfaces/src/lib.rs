//! Surfaces by themselves, whatever images say of them: how vertices are tied to their neighbours, and
//! other triangles for the same surface. Nothing here renders.
//!
//! The crate `renderer` gives out `laplacian` and `remesh`. What is here runs over all triangles in every
//! step of a recovery, so it is optimised as kernels are.

// For the terms of the loss of `renderer`.
#[cfg(feature = "recovery")]
#[doc(hidden)]
pub mod energy;
#[cfg(feature = "recovery")]
pub mod laplacian;
pub mod remesh;
