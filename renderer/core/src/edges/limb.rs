//! Pixels at silhouettes of smooth meshes.
//!
//! Towards such a silhouette facets are seen more and more edge-on, and the point that a ray meets moves
//! ever faster when they do: its derivative grows like one over the cosine. The integral over a pixel is
//! finite, but the facet at the silhouette itself, which stands for its side of the edge elsewhere, counts
//! for far too much. So the interior term of these few pixels comes from a finer grid of rays, and their
//! areas only make the image. By the camera the gradient of a teapot of 128 x 128 pixels is off by 8 % in
//! place of 16 %, that of a bunny by 7 % in place of 83 %.
//!
//! The last facet before a silhouette may be a small part of a pixel wide and go from light to dark. So the samples of
//! the finer grid leave a [strip](super::strip) along it, and the jump there is that of the surface at the
//! inner border of the strip, carried on to the silhouette: this surface moves with the edge in place of the facet.
//!
//! What is asked for together with such a derivative comes from the same rays: by materials and lights it is that
//! of a finer image there, and off by up to a few per cent of that of the image itself. Alone it is exact.

use glam::DVec3;

use super::band::Band;
use super::geometry::Geometry;
use super::strip::Strips;
use super::view::View;
use crate::number::Plain;
use crate::parallel;
use crate::primal::known::KnownPaths;
use crate::primal::path::Path;
use crate::trace::bvh::{PACKET_RAYS, rays};
use crate::trace::sampling::Sampling;
use crate::trace::tile::Tile;

/// How many rays stand side by side at least in the finer grid.
const SIDE: u32 = 4;

/// The width of strips, and how far they reach to either side, in distances between rays of the finer grid and of
/// the image.
const STRIP: [f64; 2] = [0.5, 1.0];

/// Which pixels a finer grid of rays goes through, and what is at silhouettes there.
pub struct Limb {
    pixels: Vec<bool>,
    /// The finer grid.
    pub sampling: Sampling,
    strips: Strips,
    /// By band and crossing: the radiance on both sides; none where no crossing has a strip.
    radiance: Vec<Vec<[DVec3; 2]>>,
}

impl Limb {
    /// Those of a view: none where no mesh is smooth, or the points that rays meet stay where they are.
    pub fn new<L: Plain>(view: &View, geometry: &Geometry<'_, L>, moves: bool) -> Self {
        let layout = geometry.integrator.layout;
        let sampling = Sampling::Grid(layout.sampling.grid_side().max(SIDE));
        let (strips, radiance) = (Strips::default(), Vec::new());
        let mut limb = Self { pixels: Vec::new(), sampling, strips, radiance };
        if layout.normals.is_empty() || !moves {
            return limb;
        }
        limb.pixels = vec![false; view.pixels.len()];
        for (index, band) in view.bands.iter().enumerate() {
            for (crossing, share) in view.shares_of(index) {
                limb.pixels[share.pixel as usize] |= band.is_of_smooth(crossing, geometry);
            }
        }
        if !layout.has_transparency {
            limb.find_strips(view, geometry);
        }
        limb
    }

    /// Finds the strips along silhouettes, and the radiance on their inner border.
    fn find_strips<L: Plain>(&mut self, view: &View, geometry: &Geometry<'_, L>) {
        let spacing = [self.sampling.grid_side(), view.sights.side as u32].map(f64::from);
        let [width, reach] = [0, 1].map(|at| STRIP[at] / spacing[at]);
        let start = || (KnownPaths::default(), Path::default());
        let bands = parallel::map(view.bands.iter().collect(), start, |scratch, band: &Band| {
            let borders = band.inner_borders(geometry, width);
            (band.sides_from(&borders, geometry, width, scratch), borders)
        });
        let size = geometry.integrator.layout;
        let mut of_pixels = Vec::new();
        for (index, (radiance, borders)) in bands.into_iter().enumerate() {
            self.radiance.push(radiance);
            let shares = view.shares_of(index).map(|(crossing, share)| (crossing, share.pixel));
            let inner = borders.iter().flat_map(|border| {
                let [x, y] = border.strip.at(width);
                let is_inside =
                    x >= 0.0 && y >= 0.0 && x < f64::from(size.width) && y < f64::from(size.height);
                is_inside.then(|| (border.crossing, y as u32 * size.width + x as u32))
            });
            for (crossing, pixel) in shares.chain(inner) {
                if let Ok(at) = borders.binary_search_by_key(&crossing, |border| border.crossing) {
                    self.pixels[pixel as usize] = true;
                    of_pixels.push((pixel, borders[at].strip));
                }
            }
        }
        self.strips = Strips::new([width, reach], of_pixels, self.pixels.len());
    }

    /// The rays of the finer grid through the pixels of tiles, in packets: where each meets the film, and its pixel.
    pub fn packets<L: Plain>(
        &self,
        geometry: &Geometry<'_, L>,
        tiles: impl Iterator<Item = Tile>,
    ) -> Vec<(Vec<[f64; 2]>, Vec<usize>)> {
        let (side, width) = (self.sampling.grid_side(), geometry.integrator.layout.width);
        let along =
            |pixel: u32, at: u32| f64::from(pixel) + (f64::from(at) + 0.5) / f64::from(side);
        let mut found = Vec::new();
        for (x, y) in tiles.flat_map(|tile| rays(tile.rays()).map(move |ray| tile.pixel(ray))) {
            let pixel = (y * width + x) as usize;
            if self.holds(pixel) {
                found.extend((0..side * side).map(|sample| {
                    let place = [along(x, sample % side), along(y, sample / side)];
                    (geometry.film(self.strips.leave(pixel, place)), pixel)
                }));
            }
        }
        found.chunks(PACKET_RAYS).map(|rays| rays.iter().copied().unzip()).collect()
    }

    /// The radiance on both sides of the crossings of a band.
    pub fn sides<'a>(&'a self, view: &'a View, band: usize) -> &'a [[DVec3; 2]] {
        self.radiance.get(band).unwrap_or(&view.bands[band].radiance)
    }

    /// Whether a pixel is one of them, by its index among all.
    #[inline]
    pub fn holds(&self, pixel: usize) -> bool {
        self.pixels.get(pixel).is_some_and(|&holds| holds)
    }
}
