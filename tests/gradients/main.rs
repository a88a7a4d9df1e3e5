//! Gradients against independent oracles.

mod area_lights;
mod away_from_edges;
mod boundary_segments;
mod boxes;
mod curved_edges;
mod custom;
mod differences;
mod edges;
mod everything;
mod facets;
mod fine_images;
mod grazed_paths;
mod image;
mod materials;
mod mirrored_edges;
mod moving_paths;
mod normal_map_kernel;
mod normal_maps;
mod passes;
mod paths;
mod paths_of_direct_light;
mod sampling;
mod scenes;
mod single_vertices;
mod sky;
mod sky_parts;
mod smooth;
mod threads;
mod transparency;
mod uneven_emitters;
mod unseen;
mod views;
mod visibility;

/// How scenes are rendered where the interior term is checked.
fn without_edges() -> renderer::Settings {
    renderer::Settings { edges: renderer::Edges::Off, ..renderer::Settings::default() }
}
