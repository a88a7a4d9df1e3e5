//! The renderer at the extremes.

mod extended;
mod images;
mod kernels;
mod meshes;
mod oracle;
mod camera;
mod scale;
#[path = "../gradients/scenes.rs"]
mod scenes;
mod self_intersection;
mod shading;
mod spheres;
mod triangles;
mod watertight;
