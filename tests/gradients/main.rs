//! Gradients against independent oracles.

mod away_from_edges;
mod custom;
mod everything;
mod image;
mod sampling;
mod scenes;
mod single_vertices;
mod threads;
mod transparency;
mod visibility;
