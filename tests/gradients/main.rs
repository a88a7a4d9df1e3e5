//! Gradients against independent oracles.

mod away_from_edges;
mod custom;
mod edges;
mod everything;
mod image;
mod sampling;
mod scenes;
mod single_vertices;
mod smooth;
mod threads;
mod transparency;
mod visibility;
