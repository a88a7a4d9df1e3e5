//! The memory of an image with edges.

use glam::DVec3;

/// Pixels, and what samples see. Images of a scene hand it on to each other: getting so many pages from the system
/// anew took up to a third of the time of an image.
#[derive(Default)]
pub struct Frame {
    /// The radiance of the pixels, row by row.
    pub pixels: Vec<DVec3>,
    /// What samples see at each depth of their paths.
    pub depths: Vec<Seen>,
}

/// What samples see at one depth, row by row.
#[derive(Default)]
pub struct Seen {
    /// A code for the primitives.
    pub primitives: Vec<u32>,
    /// A bit for each light that is blocked there; empty if no light has shadows.
    pub blocked: Vec<u64>,
    /// A number for the materials that lights come through; empty if nothing is transparent.
    pub filters: Vec<u32>,
}
