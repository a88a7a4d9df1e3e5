//! Pixels at silhouettes of smooth meshes.
//!
//! Towards such a silhouette facets are seen more and more edge-on, and the point that a ray meets moves
//! ever faster when they do: its derivative grows like one over the cosine. The integral over a pixel is
//! finite, but the facet at the silhouette itself, which stands for its side of the edge elsewhere, counts
//! for far too much. So the interior term of these few pixels comes from a finer grid of rays, and their
//! areas only make the image. By the camera the gradient of a teapot of 128 x 128 pixels is off by 8 % in
//! place of 16 %, that of a bunny by 7 % in place of 83 %.
//!
//! Within a [strip](super::strip) along the silhouette it comes from rays of its own.
//!
//! What is asked for together with such a derivative comes from the same rays: by materials and lights it is that
//! of a finer image there, and off by up to a few per cent of that of the image itself. Alone it is exact.

use super::band::Band;
use super::geometry::Geometry;
use super::strip::{Part, Strip, Strips};
use super::view::View;
use crate::number::Plain;
use crate::parallel;
use crate::primal::known::KnownPaths;
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
    /// Where it does not go.
    left_out: Strips,
    /// By band: the strips, with the indices of their crossings.
    strips: Vec<Vec<(usize, Strip)>>,
}

impl Limb {
    /// Those of a view: none where no mesh is smooth, or the points that rays meet stay where they are.
    pub fn new<L: Plain>(view: &View, geometry: &Geometry<'_, L>, moves: bool) -> Self {
        let layout = geometry.integrator.layout;
        let sampling = Sampling::Grid(layout.sampling.grid_side().max(SIDE));
        let (left_out, strips) = (Strips::default(), Vec::new());
        let mut limb = Self { pixels: Vec::new(), sampling, left_out, strips };
        if layout.normals.is_empty() || !moves {
            return limb;
        }
        let spacing = [sampling.grid_side(), view.sights.side as u32].map(f64::from);
        let size = [0, 1].map(|at| STRIP[at] / spacing[at]);
        limb.strips = parallel::map(
            view.bands.iter().collect(),
            || (),
            |(), band: &Band| band.strips(geometry, size[0]),
        );
        limb.pixels = vec![false; view.pixels.len()];
        let mut left_out = Vec::new();
        for (index, strips) in limb.strips.iter().enumerate() {
            for (crossing, share) in view.shares_of(index) {
                limb.pixels[share.pixel as usize] |=
                    view.bands[index].is_of_smooth(crossing, geometry);
                let found = strips.binary_search_by_key(&crossing, |&(crossing, _)| crossing);
                left_out.extend(found.ok().map(|at| (share.pixel, &strips[at].1)));
            }
            for (_, strip) in strips {
                let [x, y] = strip.at(size[0]);
                let is_inside = (0.0..f64::from(layout.width)).contains(&x)
                    && (0.0..f64::from(layout.height)).contains(&y);
                if is_inside {
                    let pixel = y as u32 * layout.width + x as u32;
                    limb.pixels[pixel as usize] = true;
                    left_out.push((pixel, strip));
                }
            }
        }
        limb.left_out = Strips::new(size, left_out, limb.pixels.len());
        limb
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
                let places = (0..side * side)
                    .map(|sample| [along(x, sample % side), along(y, sample / side)]);
                let places = places.filter(|&place| !self.left_out.hold(pixel, place));
                found.extend(places.map(|place| (geometry.film(place), pixel)));
            }
        }
        found.chunks(PACKET_RAYS).map(|rays| rays.iter().copied().unzip()).collect()
    }

    /// The bands whose strips have rays.
    pub fn bands(&self) -> Vec<usize> {
        let has_parts =
            |&band: &usize| self.strips[band].iter().any(|(_, strip)| !strip.parts.is_empty());
        (0..self.strips.len()).filter(has_parts).collect()
    }

    /// Calls `use_packet` with the rays of the strips of a band, as many as a packet has: what they see, and for each
    /// its crossing and the width that it stands for.
    pub fn of_strips<L: Plain>(
        &self,
        geometry: &Geometry<'_, L>,
        band: usize,
        known: &mut KnownPaths,
        mut use_packet: impl FnMut(&KnownPaths, &[(usize, f64)]),
    ) {
        let strips = self.strips.get(band).into_iter().flatten();
        let parts: Vec<(usize, &Part)> = strips
            .flat_map(|(crossing, strip)| strip.parts.iter().map(|part| (*crossing, part)))
            .collect();
        for packet in parts.chunks(PACKET_RAYS) {
            known.clear();
            for (_, part) in packet {
                let hits = part.hits.iter().copied();
                known.push(geometry.film(part.place), hits, geometry.edged_lights());
            }
            let widths: Vec<(usize, f64)> =
                packet.iter().map(|&(crossing, part)| (crossing, part.width)).collect();
            use_packet(known, &widths);
        }
    }

    /// Whether a pixel is one of them, by its index among all.
    #[inline]
    pub fn holds(&self, pixel: usize) -> bool {
        self.pixels.get(pixel).is_some_and(|&holds| holds)
    }
}
