//! The renderer at the extremes.

#[path = "../gradients/away_from_edges.rs"]
mod away_from_edges;
mod camera;
mod error_growth;
mod extended;
mod images;
mod kernels;
mod meshes;
mod non_finite;
mod optimisation;
mod oracle;
mod random_bits;
mod scale;
#[path = "../gradients/scenes.rs"]
mod scenes;
mod self_intersection;
mod shading;
mod smooth;
mod spheres;
mod triangles;
mod watertight;

/// How scenes are rendered where the interior term is checked.
fn without_edges() -> renderer::Settings {
    renderer::Settings { edges: renderer::Edges::Off, ..renderer::Settings::default() }
}
