//! Tiles and strips of tiles: the units of work.

use std::ops::Range;

use super::bvh::{PACKET_RAYS, ray_at, tile_position};
use crate::parallel;

/// The edge of a tile in pixels: its rays make one packet.
pub const TILE: usize = 8;

/// The width of a strip, the unit of parallel work, in pixels. Fixed, because the order of
/// summation depends on it.
const STRIP: usize = 8 * TILE;

const _: () = assert!(TILE * TILE == PACKET_RAYS);

/// 8 x 8 pixels, fewer at the right and the lower edge of the image.
#[derive(Clone, Copy, Debug)]
pub struct Tile {
    /// The first column.
    pub left: usize,
    /// The first row.
    pub top: usize,
    /// How many columns there are.
    pub columns: usize,
    /// How many rows there are.
    pub rows: usize,
}

impl Tile {
    /// A bit for each ray of the packet that goes through a pixel.
    pub fn rays(&self) -> u64 {
        if self.columns == TILE && self.rows == TILE {
            return u64::MAX;
        }
        let inside = |&ray: &usize| {
            let (column, row) = tile_position(ray);
            column < self.columns && row < self.rows
        };
        (0..PACKET_RAYS).filter(inside).fold(0, |bits, ray| bits | 1 << ray)
    }

    /// The column and the row of the pixel that a ray goes through.
    pub fn pixel(&self, ray: usize) -> (u32, u32) {
        let (column, row) = tile_position(ray);
        ((self.left + column) as u32, (self.top + row) as u32)
    }
}

/// Tiles side by side.
#[derive(Clone, Copy, Debug)]
pub struct Strip(Tile);

impl Strip {
    /// The tiles of the strip, from left to right.
    pub fn tiles(self) -> impl Iterator<Item = Tile> {
        let Self(Tile { left, columns, .. }) = self;
        (0..columns).step_by(TILE).map(move |offset| Tile {
            left: left + offset,
            columns: TILE.min(columns - offset),
            ..self.0
        })
    }

    /// The columns of one of its tiles, counted from the left edge of the strip.
    pub fn columns(self, tile: &Tile) -> Range<usize> {
        let first = tile.left - self.0.left;
        first..first + tile.columns
    }
}

/// Which of the strips of an image a pixel is in.
pub fn strip_index(width: u32, x: usize, y: usize) -> usize {
    y / TILE * (width as usize).div_ceil(STRIP) + x / STRIP
}

/// The tile of an image that a pixel is in, and the ray that goes through it.
pub fn tile_of(width: u32, height: u32, x: u32, y: u32) -> (Tile, usize) {
    let [x, y, width, height] = [x, y, width, height].map(|n| n as usize);
    let (left, top) = (x / TILE * TILE, y / TILE * TILE);
    let (columns, rows) = (TILE.min(width - left), TILE.min(height - top));
    (Tile { left, top, columns, rows }, ray_at(x - left, y - top))
}

/// The strips of an image, row by row.
pub fn strips(width: u32, height: u32) -> Vec<Strip> {
    let (width, height) = (width as usize, height as usize);
    let rows = (0..height).step_by(TILE);
    let columns = (0..width).step_by(STRIP);
    rows.flat_map(|top| columns.clone().map(move |left| (left, top)))
        .map(|(left, top)| {
            let (columns, rows) = (STRIP.min(width - left), TILE.min(height - top));
            Strip(Tile { left, top, columns, rows })
        })
        .collect()
}

/// Runs `work` on every strip of an image in parallel, with scratch memory from `start`; the results come in the
/// order of the strips.
pub fn for_each_strip<W: Send, R: Send>(
    width: u32,
    height: u32,
    start: impl Fn() -> W + Sync,
    work: impl Fn(&mut W, Strip) -> R + Sync,
) -> Vec<R> {
    parallel::map_init(strips(width, height), start, work)
}

/// Runs `work` on every strip of an image of this width in parallel, together with the rows of its
/// pixels and scratch memory from `start`.
fn fill_strips<T: Send, W: Send>(
    width: u32,
    pixels: &mut [T],
    start: impl Fn() -> W + Sync,
    work: impl Fn(&mut W, Strip, &mut [&mut [T]]) + Sync,
) {
    let columns = width as usize;
    let strips = strips(width, (pixels.len() / columns) as u32);
    let mut parts = Vec::with_capacity(strips.len());
    for band in pixels.chunks_mut(columns * TILE) {
        let first = parts.len();
        parts.resize_with(first + columns.div_ceil(STRIP), Vec::new);
        for row in band.chunks_mut(columns) {
            for (rows, part) in parts[first..].iter_mut().zip(row.chunks_mut(STRIP)) {
                rows.push(part);
            }
        }
    }
    let strips = strips.into_iter().zip(parts).collect();
    parallel::map_init(strips, start, |scratch, (strip, mut rows)| work(scratch, strip, &mut rows));
}

/// Fills the pixels of an image of this width, tile by tile in parallel, with what `color` makes of a tile
/// by ray.
pub fn fill_tiles<T: Copy + Send, W: Send, C: Fn(usize) -> T>(
    width: u32,
    pixels: &mut [T],
    start: impl Fn() -> W + Sync,
    color: impl Fn(&mut W, &Tile) -> C + Sync,
) {
    fill_strips(width, pixels, start, |scratch, strip, rows| {
        for tile in strip.tiles() {
            let color = color(scratch, &tile);
            for (row, pixels) in rows.iter_mut().enumerate() {
                for (column, pixel) in pixels[strip.columns(&tile)].iter_mut().enumerate() {
                    *pixel = color(ray_at(column, row));
                }
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use super::{Strip, fill_tiles, for_each_strip};
    use crate::image::Image;
    use crate::trace::bvh::{ray_at, rays, tile_position};

    fn pixels(strip: Strip) -> Vec<(u32, u32)> {
        let of_tile = |tile: super::Tile| rays(tile.rays()).map(move |ray| tile.pixel(ray));
        strip.tiles().flat_map(of_tile).collect()
    }

    #[test]
    fn every_pixel_is_in_one_tile() {
        for (width, height) in [(1, 1), (8, 8), (7, 9), (64, 16), (65, 17), (200, 3), (3, 200)] {
            let strips = for_each_strip(width, height, || (), |(), strip| pixels(strip));
            let mut all = strips.concat();
            all.sort_unstable();
            let expected = (0..width).flat_map(|x| (0..height).map(move |y| (x, y)));
            assert_eq!(all, expected.collect::<Vec<_>>(), "{width} x {height}");
        }
    }

    #[test]
    fn tiles_get_their_own_pixels() {
        let mut image = Image::black(133, 21);
        fill_tiles(
            133,
            &mut image.pixels,
            || (),
            |(), tile| {
                let tile = *tile;
                move |ray| {
                    let (x, y) = tile.pixel(ray);
                    [x as f32, y as f32, 1.0]
                }
            },
        );
        for (i, pixel) in image.pixels.iter().enumerate() {
            assert_eq!(*pixel, [(i % 133) as f32, (i / 133) as f32, 1.0]);
        }
    }

    #[test]
    fn rays_have_one_position_each() {
        for ray in 0..64 {
            let (column, row) = tile_position(ray);
            assert_eq!(ray_at(column, row), ray);
        }
    }
}
