//! The experiments of `examples/` at reduced size: each must come to what it claims.

mod finite_differences;
mod inverse_lighting;
mod material_color;
