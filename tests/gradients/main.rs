//! Gradients against independent oracles.

mod custom;
mod image;
mod sampling;
mod scenes;
mod threads;
mod transparency;
mod visibility;
