//! Gradients against independent oracles.

mod away_from_edges;
mod custom;
mod image;
mod sampling;
mod scenes;
mod threads;
mod transparency;
mod visibility;
