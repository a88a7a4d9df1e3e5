//! The renderer at the extremes.

mod extended;
mod kernels;
mod oracle;
mod camera;
mod shading;
mod spheres;
mod triangles;
