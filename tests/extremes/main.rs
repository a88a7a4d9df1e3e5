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
mod transparent_meshes;
mod triangles;
mod watertight;

/// The larger of two errors; no number is larger than any, while `f64::max` would drop it.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// How scenes are rendered where the interior term is checked.
fn without_edges() -> renderer::Settings {
    renderer::Settings { edges: renderer::Edges::Off, ..renderer::Settings::default() }
}
