//! Lights with an area, one point of them at a time.
//!
//! Direct light of an area is the mean over points of it, the same for all that is lit: as many lights of
//! one set of numbers, each with hard shadows whose edges are known. So images have no noise, and gradients
//! hold with respect to everything that moves a soft shadow. Turned down: points drawn anew for every pixel,
//! whose shadows have no edges that anybody could follow.

use ad::vector::{Vector, Vector3};
use ad::{Differentiable, Fields, Real, Vec3, differentiable};

use super::illumination::Illumination;
use super::positive_part;

/// A flat light that shines to one side, from every point with the same radiance in all directions: a
/// rectangle, or the ellipse in it. The camera does not see it.
///
/// It shines to the side from which `right`, `up` follow each other anticlockwise: along `right × up`.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable, Fields)]
pub struct AreaLight<S: Real> {
    /// The middle.
    pub center: Vec3<S>,
    /// The vector from the middle to the middle of an edge.
    pub right: Vec3<S>,
    /// The vector from the middle to the middle of the next edge.
    pub up: Vec3<S>,
    /// Linear RGB.
    pub color: Vec3<S>,
    /// The radiance, W/(m² sr).
    pub radiance: S,
}

/// A point of a light, and the part of the light that it stands for.
#[derive(Clone, Copy, Debug, Differentiable, Fields)]
pub struct Place<S: Real> {
    /// In units of `right`.
    pub x: S,
    /// In units of `up`.
    pub y: S,
    /// The area where `right × up` has the area 1.
    pub area: S,
}

impl Place<f64> {
    /// The place of lights that are points.
    pub const POINT: Self = Self { x: 0.0, y: 0.0, area: 0.0 };

    /// So many places that are spread evenly over a rectangle: the set of Hammersley, whose points are all
    /// different in each coordinate, so that shadows of straight edges have as many steps as there are points.
    pub fn on_rectangle(count: u32) -> impl Iterator<Item = Self> {
        let radical_inverse = |index: u32| f64::from(index.reverse_bits()) / 2.0_f64.powi(32);
        // So that the middle of the points is that of the light.
        let mean = (0..count).map(radical_inverse).sum::<f64>() / f64::from(count.max(1));
        (0..count).map(move |index| Self {
            x: (2.0 * f64::from(index) + 1.0) / f64::from(count) - 1.0,
            y: 2.0 * (radical_inverse(index) - mean),
            area: 4.0 / f64::from(count),
        })
    }

    /// The same on the disc in it, by a map that keeps areas (Shirley & Chiu, "A Low Distortion Map Between Disk
    /// and Square", 1997).
    pub fn on_disc(count: u32) -> impl Iterator<Item = Self> {
        use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
        Self::on_rectangle(count).map(|Self { x, y, area }| {
            let (radius, angle) = match x.abs() > y.abs() {
                true => (x, FRAC_PI_4 * y / x),
                false if y != 0.0 => (y, FRAC_PI_2 - FRAC_PI_4 * x / y),
                false => (0.0, 0.0),
            };
            Self { x: radius * angle.cos(), y: radius * angle.sin(), area: area * PI / 4.0 }
        })
    }
}

impl<S: Real> AreaLight<S> {
    /// Where a point of it is.
    pub fn at(&self, place: Place<S>) -> Vec3<S> {
        self.center + self.right * place.x + self.up * place.y
    }
}

/// The illumination by a part of a light. In the light itself, where it has no direction, it is zero.
// Boxed and called: inlined it would move residuals of other lights.
#[differentiable(boxed)]
#[inline(never)]
pub fn illuminate_by_area<S: Real>(
    light: AreaLight<S>,
    place: Place<S>,
    point: Vec3<S>,
) -> Illumination<S> {
    let AreaLight { center, right, up, color, radiance } = light;
    let to_light = center + right * place.x + up * place.y - point;
    let length_recip = to_light.length_recip();
    let recip = ad::select(length_recip.is_finite(), length_recip, S::ZERO);
    let direction = to_light.normalize_or_zero();
    let facing = positive_part::<S>(-right.cross(up).dot(direction)) * place.area;
    Illumination {
        direction,
        distance: to_light.length(),
        irradiance: color * (radiance * facing * recip * recip),
    }
}
