//! Pixels at silhouettes of smooth meshes, of curved surfaces, and of flat triangles that the camera grazes.
//!
//! Towards such a silhouette facets are seen more and more edge-on, and the point that a ray meets moves
//! ever faster when they do: its derivative grows like one over the cosine. The integral over a pixel is
//! finite, but the facet at the silhouette itself, which stands for its side of the edge elsewhere, counts
//! for far too much. So the interior term of these few pixels comes from a finer grid of rays, and their
//! areas only make the image. By the camera the gradient of a teapot of 128 x 128 pixels is off by 8 % in
//! place of 16 %, that of a bunny by 7 % in place of 83 %.
//!
//! It is the same with spheres and shapes of one's own, where the derivative grows like one over the root of the
//! distance to the silhouette; and with the derivative by a light at the camera, where it grazes facets or rough
//! surfaces that the viewer grazes.
//!
//! Within a [strip](super::strip) along the silhouette it comes from rays of its own.
//!
//! Where light takes all paths, the many samples of a pixel are its finer grid: with strips, and without more rays, the
//! deviation of a derivative by what moves a metal ball is 5 to 8 times less.
//!
//! What is asked for together with such a derivative comes from the same rays: by materials and lights it is that
//! of a finer image there, and off by up to a few per cent of that of the image itself. Alone it is exact.

use super::band::Band;
use super::geometry::Geometry;
use super::strip::{Part, Strip, Strips};
use super::view::View;
use crate::parallel;
use crate::primal::rounds::Round;
use crate::trace::bvh::{PACKET_RAYS, rays};
use crate::trace::random::PathNumbers;
use crate::trace::sampling::Sampling;
use crate::trace::tile::Tile;

/// How many rays stand side by side at least in the finer grid.
const SIDE: u32 = 4;

/// The width of strips of smooth meshes, of curved surfaces and of flat triangles that the camera grazes, in distances
/// between rays of the finer grid.
const WIDTHS: [f64; 3] = [0.5, 1.0, 2.0];

/// How far they reach to either side, in distances between rays of the image.
const REACH: f64 = 1.0;

/// How many rays strips of curved surfaces have at each crossing, and where light takes all paths.
const CURVED_PARTS: usize = 2;
const SCATTERED_PARTS: usize = 8;

/// A path of a ray in a strip stands for so many through a pixel.
const PATHS_OF_STRIP: u32 = 16;

/// Which pixels a finer grid of rays goes through, and what is at silhouettes there.
pub struct Limb {
    pixels: Vec<bool>,
    /// The finer grid.
    sampling: Sampling,
    /// How much its rays count.
    weights: Strips,
    /// By band: the strips, with the indices of their crossings.
    strips: Vec<Vec<(usize, Strip)>>,
}

/// Rays of the finer grid, as many as a packet has.
pub struct Finer {
    /// Where they meet the film.
    pub film: Vec<[f64; 2]>,
    /// The pixel of each, and how much of that it stands for.
    pub parts: Vec<(usize, f64)>,
}

/// The paths that the rays of strips take where light takes all.
#[derive(Clone, Copy)]
pub struct StripPaths {
    count: u32,
    seed: u32,
}

impl StripPaths {
    /// Those of an image whose edges are found in rounds.
    pub fn new(round: Round, sampling: Sampling) -> Self {
        Self { count: round.paths.div_ceil(PATHS_OF_STRIP), seed: sampling.seed() }
    }

    /// Calls `use_path` with the numbers of each path of the rays of a packet, the first of which has this number, and
    /// with how much it counts.
    pub fn each(self, first: u32, mut use_path: impl FnMut(&PathNumbers, f64)) {
        let part = 1.0 / f64::from(self.count);
        let paths = (0..self.count).map(|path| PathNumbers::in_strip(first, self.seed, path));
        paths.for_each(|numbers| use_path(&numbers, part));
    }
}

impl Limb {
    /// Those of a view: none where everything is flat and nothing is grazed, or derivatives do not get steep at silhouettes.
    pub fn new(view: &View, geometry: &Geometry<'_>, is_steep: bool) -> Self {
        Self::with_parts(view, geometry, is_steep, CURVED_PARTS)
    }

    /// The same where light takes all paths.
    pub fn of_paths(view: &View, geometry: &Geometry<'_>, is_steep: bool) -> Self {
        Self::with_parts(view, geometry, is_steep, SCATTERED_PARTS)
    }

    fn with_parts(view: &View, geometry: &Geometry<'_>, is_steep: bool, parts: usize) -> Self {
        let layout = geometry.layout;
        let sampling = Sampling::Grid(layout.sampling.grid_side().max(SIDE));
        let (weights, strips) = (Strips::default(), Vec::new());
        let mut limb = Self { pixels: Vec::new(), sampling, weights, strips };
        let is_flat =
            layout.normals.is_empty() && layout.material_of.len() == layout.triangles.len();
        if !is_steep {
            return limb;
        }
        let widths = WIDTHS.map(|width| width / f64::from(sampling.grid_side()));
        let strips = parallel::map(view.bands.iter().collect(), |band: &Band| {
            band.strips(geometry, widths, parts)
        });
        if is_flat && strips.iter().all(Vec::is_empty) {
            return limb;
        }
        limb.strips = strips;
        limb.pixels = vec![false; layout.width as usize * layout.height as usize];
        for (index, strips) in limb.strips.iter().enumerate() {
            for (crossing, share) in view.shares_of(index) {
                limb.pixels[share.pixel as usize] |=
                    view.bands[index].is_of_curved(crossing, geometry);
            }
            for (_, strip) in strips {
                for [x, y] in strip.needs() {
                    let is_inside = (0.0..f64::from(layout.width)).contains(&x)
                        && (0.0..f64::from(layout.height)).contains(&y);
                    if is_inside {
                        limb.pixels[(y as u32 * layout.width + x as u32) as usize] = true;
                    }
                }
            }
        }
        let strips = limb.strips.iter().flatten().map(|(_, strip)| strip);
        limb.weights =
            Strips::new(REACH / view.sights.side as f64, strips, [layout.width, layout.height]);
        limb
    }

    /// The rays of the finer grid through the pixels of tiles, in packets.
    pub fn packets(
        &self,
        geometry: &Geometry<'_>,
        tiles: impl Iterator<Item = Tile>,
    ) -> Vec<Finer> {
        let (side, width) = (self.sampling.grid_side(), geometry.layout.width);
        let along =
            |pixel: u32, at: u32| f64::from(pixel) + (f64::from(at) + 0.5) / f64::from(side);
        let mut found = Vec::new();
        for (x, y) in tiles.flat_map(|tile| rays(tile.rays()).map(move |ray| tile.pixel(ray))) {
            let pixel = (y * width + x) as usize;
            if self.holds(pixel) {
                let places = (0..side * side)
                    .map(|sample| [along(x, sample % side), along(y, sample / side)]);
                found.extend(places.filter_map(|place| {
                    let part = self.weights.weight(pixel, place) / f64::from(side * side);
                    (part > 0.0).then(|| (geometry.film(place), (pixel, part)))
                }));
            }
        }
        let packet = |rays: &[([f64; 2], (usize, f64))]| {
            let (film, parts) = rays.iter().copied().unzip();
            Finer { film, parts }
        };
        found.chunks(PACKET_RAYS).map(packet).collect()
    }

    /// The bands whose strips have rays.
    pub fn bands(&self) -> Vec<usize> {
        let has_parts =
            |&band: &usize| self.strips[band].iter().any(|(_, strip)| !strip.parts.is_empty());
        (0..self.strips.len()).filter(has_parts).collect()
    }

    /// Whether there are any strips.
    pub fn has_strips(&self) -> bool {
        self.strips.iter().any(|strips| !strips.is_empty())
    }

    /// How much the interior term of a sample counts, by its pixel and by where it meets the film: rays of strips stand
    /// for the rest.
    pub fn weight(&self, geometry: &Geometry<'_>, (x, y): (u32, u32), film: [f64; 2]) -> f64 {
        let pixel = y as usize * geometry.layout.width as usize + x as usize;
        self.weights.weight(pixel, geometry.place(film))
    }

    /// Calls `use_packet` with the rays of the strips of a band, as many as a packet has: the number of the first one, where
    /// they meet the film, and for each its crossing and the width that it stands for.
    pub fn of_strips(
        &self,
        geometry: &Geometry<'_>,
        band: usize,
        mut use_packet: impl FnMut((u32, &[[f64; 2]]), &[(usize, f64)]),
    ) {
        let parts = self.parts(band);
        let firsts = ((band << 16) as u32..).step_by(PACKET_RAYS);
        for (first, packet) in firsts.zip(parts.chunks(PACKET_RAYS)) {
            let (film, widths): (Vec<_>, Vec<_>) = packet
                .iter()
                .map(|&(crossing, part)| (geometry.film(part.place), (crossing, part.width)))
                .unzip();
            use_packet((first, &film), &widths);
        }
    }

    /// The parts of the strips of a band with their crossings. Bands are low: in this order rays of a packet are near to
    /// each other.
    fn parts(&self, band: usize) -> Vec<(usize, &Part)> {
        let strips = self.strips.get(band).into_iter().flatten();
        let mut parts: Vec<(usize, &Part)> = strips
            .flat_map(|(crossing, strip)| strip.parts.iter().map(|part| (*crossing, part)))
            .collect();
        parts.sort_by(|(_, a), (_, b)| a.place[0].total_cmp(&b.place[0]));
        parts
    }

    /// Whether a pixel is one of them, by its index among all.
    #[inline]
    pub fn holds(&self, pixel: usize) -> bool {
        self.pixels.get(pixel).is_some_and(|&holds| holds)
    }
}
