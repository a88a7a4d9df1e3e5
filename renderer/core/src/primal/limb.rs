//! The limb of spheres and of smooth meshes.
//!
//! Towards its silhouette the point of a sphere that a pixel shows moves ever faster when the sphere
//! does: its derivative grows like one over the root of the distance to the silhouette. The integral over
//! the image is finite, but a sample that happens to be next to the silhouette counts for far too much. So
//! each sample gets the mean over the strip that it stands for, along the normal of the silhouette: the
//! strip of the outermost sample reaches to the silhouette.
//!
//! At the silhouette of a smooth mesh the last triangle is seen edge-on. It may be much narrower than the distance
//! between samples and go from light to dark, and derivatives in it are large where any sample meets it. So samples
//! in [strips](Strips) along such silhouettes go to their inner borders, and what is seen there goes on to the edge.

use ad::lanes::Lanes;
use ad::{Fields, Real, select};

use super::integrator::Integrator;
use super::lanes::{lanes_of_numbers, numbers_of_lanes};
use super::wavefront::{LaneGroup, TileSample};
use crate::number::Number;
use crate::transport::camera::primary_ray;
use crate::transport::edge::sphere_margin;
use crate::transport::hit::Primitive;
use crate::transport::sphere::Sphere;

/// How the derivatives of what camera rays meet are taken towards the limb.
#[derive(Clone, Copy)]
pub struct Weights<'a> {
    /// The distance between samples in pixels.
    pub spacing: f64,
    /// Which places samples leave.
    pub strips: Option<&'a Strips>,
}

/// A piece of the inner side of a silhouette.
#[derive(Clone, Copy, Debug)]
pub struct Strip {
    /// A place on the silhouette, in pixels.
    pub place: [f64; 2],
    /// The unit normal of the silhouette into the mesh.
    pub inward: [f64; 2],
}

impl Strip {
    /// The place at a depth, in pixels.
    pub fn at(&self, depth: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.place[axis] + depth * self.inward[axis])
    }
}

/// Strips along the silhouettes of smooth meshes, by pixel.
#[derive(Default)]
pub struct Strips {
    /// How wide they are, and how far they reach along the silhouette to either side of their place, in pixels.
    size: [f64; 2],
    strips: Vec<Strip>,
    /// Where those of each pixel start, then their number.
    starts: Vec<u32>,
}

impl Strips {
    /// Strips of this `size`, each with its pixel, of so many pixels.
    pub fn new(size: [f64; 2], mut strips: Vec<(u32, Strip)>, pixels: usize) -> Self {
        strips.sort_by_key(|&(pixel, _)| pixel);
        let mut starts = vec![0; pixels + 1];
        strips.iter().for_each(|&(pixel, _)| starts[pixel as usize + 1] += 1);
        (0..pixels).for_each(|pixel| starts[pixel + 1] += starts[pixel]);
        Self { size, strips: strips.into_iter().map(|(_, strip)| strip).collect(), starts }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.strips.is_empty()
    }

    fn of_pixel(&self, pixel: usize) -> &[Strip] {
        let [start, end] = [0, 1].map(|next| self.starts[pixel + next] as usize);
        &self.strips[start..end]
    }

    /// Where a sample at a place goes: out of the strips of its pixel, to their inner borders. Places are in pixels.
    fn leave(&self, of_pixel: &[Strip], place: [f64; 2]) -> [f64; 2] {
        let [width, reach] = self.size;
        of_pixel.iter().fold(place, |place, Strip { place: [x, y], inward: [u, v] }| {
            let [x, y] = [place[0] - x, place[1] - y];
            let depth = x * u + y * v;
            let is_within = depth > 0.0 && depth < width && (x * v - y * u).abs() < reach;
            let by = if is_within { width - depth } else { 0.0 };
            [place[0] + by * u, place[1] + by * v]
        })
    }
}

impl<S: Number> Integrator<'_, S> {
    /// Weighs the derivatives of the surface points of a group that the camera sees.
    pub(super) fn weigh_limb(
        &self,
        group: &mut LaneGroup<S>,
        (x, y): (S::Lanes, S::Lanes),
        spacing: f64,
    ) {
        let Some(Primitive::Sphere(sphere)) = self.primitive(group.kind, &group.primitives) else {
            return;
        };
        let weight = self.weight_of_sphere(sphere.map(S::primal), group, (x, y), spacing);
        group.limb = Some(weight);
        group.surface = weighted(&group.surface, weight);
    }

    /// Moves camera rays of lanes out of strips; the lanes are those of a sample from a ray on.
    pub(super) fn leave_strips(
        &self,
        strips: &Strips,
        (sample, first): (&TileSample<'_>, usize),
        film: &mut (S::Lanes, S::Lanes),
    ) {
        let [width, height] = [self.layout.width, self.layout.height].map(f64::from);
        let mut places = None;
        for lane in (0..S::Lanes::COUNT).filter(|lane| sample.pixels >> (first + lane) & 1 == 1) {
            let (column, row) = sample.tile.pixel(first + lane);
            let of_pixel = strips.of_pixel((row * self.layout.width + column) as usize);
            if !of_pixel.is_empty() {
                let [x, y] = places.get_or_insert_with(|| [film.0, film.1].map(numbers_of_lanes));
                let place = [0.5 * width * (1.0 + x[lane]), 0.5 * height * (1.0 - y[lane])];
                let to = strips.leave(of_pixel, place);
                x[lane] += 2.0 * (to[0] - place[0]) / width;
                y[lane] -= 2.0 * (to[1] - place[1]) / height;
            }
        }
        if let Some([x, y]) = places {
            *film = (lanes_of_numbers(&x), lanes_of_numbers(&y));
        }
    }

    /// The weight of the samples of spheres that are `spacing` pixels apart.
    fn weight_of_sphere(
        &self,
        sphere: Sphere<S::Lanes>,
        group: &LaneGroup<S>,
        (x, y): (S::Lanes, S::Lanes),
        spacing: f64,
    ) -> S::Lanes {
        let number = |value: f64| S::Lanes::from_f64(value);
        let (margin, pullback) = sphere_margin::vjp::<S::Lanes>(sphere, group.ray.map(S::primal));
        let (_, of_ray) = pullback(S::Lanes::ONE);
        let (_, pullback) = primary_ray::vjp::<S::Lanes>(self.inputs.frame.map(S::primal), x, y);
        let (_, x, y) = pullback(of_ray);
        let (x, y) = (
            x * number(2.0 / f64::from(self.layout.width)),
            y * number(2.0 / f64::from(self.layout.height)),
        );
        let slope = (x * x + y * y).sqrt() * number(spacing);
        // In distances between samples.
        let distance = (margin / slope).max(S::Lanes::ZERO);
        let half = S::Lanes::HALF;
        let to_silhouette = S::Lanes::TWO * (distance * (distance + half)).sqrt();
        let beyond = (distance - half).max(S::Lanes::ZERO).sqrt();
        let strip = S::Lanes::TWO * distance.sqrt() * ((distance + half).sqrt() - beyond);
        let weight = select(distance.cmplt(S::Lanes::ONE), to_silhouette, strip);
        // Far from the silhouette the difference of roots loses digits, and the weight is 1.
        let weight = select(distance.cmplt(number(100.0)), weight, S::Lanes::ONE);
        select(weight.is_finite(), weight, S::Lanes::ONE)
    }
}

/// The same values, with derivatives that are multiplied by a weight.
pub fn weighted<S: Number, T: Fields<S, With<S> = T>>(value: &T, weight: S::Lanes) -> T {
    value.map(|number| {
        let still = S::constant(number.primal());
        still + (number - still) * S::constant(weight)
    })
}
