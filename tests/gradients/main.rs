//! Gradients against independent oracles.
