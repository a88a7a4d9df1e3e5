//! Edges in images.
mod cell;
mod crossing;
mod forward;
mod geometry;
mod outline;
mod polygon;
mod sight;
mod view;

pub use crossing::{Crossing, Layer};
pub use geometry::{Edge, Geometry};
pub use view::{PACKET_CROSSINGS, View};
