//! The experiments of `examples/` at reduced size: each must come to what it claims.

mod bvh;
mod camera_calibration;
mod cornell;
mod edges;
mod environment;
mod finite_differences;
mod gradient_images;
mod inverse_lighting;
mod material_color;
mod pose;
mod roughness;
mod shadow;
mod tape;
mod teapot;
mod texture_recovery;
