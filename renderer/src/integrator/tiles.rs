//! Tiles: the unit of parallel work.

use std::ops::Range;

use rayon::prelude::*;

use crate::acceleration::{PACKET_RAYS, tile_position};

/// The edge of a tile in pixels: its rays make one packet. Fixed, because the order of summation
/// depends on it.
const TILE: u32 = 8;

const _: () = assert!((TILE * TILE) as usize == PACKET_RAYS);

/// A rectangle of pixels.
#[derive(Clone, Debug)]
pub struct Tile {
    /// Columns.
    pub x: Range<u32>,
    /// Rows, from the top.
    pub y: Range<u32>,
}

impl Tile {
    /// Every pixel of the tile, in the order of the rays of a packet.
    pub fn pixels(&self) -> impl Iterator<Item = (u32, u32)> + use<> {
        let Self { x, y } = self.clone();
        (0..PACKET_RAYS)
            .map(tile_position)
            .map(move |(column, row)| (x.start + column as u32, y.start + row as u32))
            .filter(move |&(column, row)| column < x.end && row < y.end)
    }
}

/// Runs `work` on every tile of an image in parallel; the results come in the order of the tiles.
pub fn for_each_tile<R: Send>(width: u32, height: u32, work: impl Fn(Tile) -> R + Sync) -> Vec<R> {
    let columns = width.div_ceil(TILE);
    let count = columns as usize * height.div_ceil(TILE) as usize;
    (0..count)
        .into_par_iter()
        .map(|index| {
            let (column, row) = (index % columns as usize, index / columns as usize);
            let (left, top) = (column as u32 * TILE, row as u32 * TILE);
            let right = left.saturating_add(TILE).min(width);
            let bottom = top.saturating_add(TILE).min(height);
            work(Tile { x: left..right, y: top..bottom })
        })
        .collect()
}
