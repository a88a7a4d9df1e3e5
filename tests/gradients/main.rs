//! Gradients against independent oracles.

mod image;
mod scenes;
mod threads;
mod visibility;
