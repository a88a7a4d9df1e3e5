//! Gradients against independent oracles.

mod custom;
mod image;
mod scenes;
mod threads;
mod visibility;
