//! Surfaces that shine on others: points of them, as another surface sees them.
//!
//! An integral over the directions from a surface point is estimated from one direction at a time. What
//! it counts for is its [`spread`](Sight::spread), one over the probability density of directions, in
//! steradians. Points of triangles are chosen evenly by area; directions towards spheres evenly within the
//! cone that they fill (Shirley, Wang & Zimmerman, "Monte Carlo Techniques for Direct Lighting
//! Calculations", 1996), or all around from inside.
//!
//! A surface finds the same light by directions that its material [scatters](super::scatter) to. Where both
//! could have found a point, each counts by its [weight](emitter_spread()), and both weights add up to 1
//! (the power heuristic of Veach & Guibas, "Optimally Combining Sampling Techniques for Monte Carlo
//! Rendering", 1995).

use std::f64::consts::{FRAC_1_PI, PI};

use ad::vector::{Vector, Vector3};
use ad::{Differentiable, Real, Vec3, differentiable, select};

use super::direction::turn;
use super::hit::Primitive;
use super::illumination::Illumination;
use super::positive_part;
use super::sphere::{Sphere, sphere_uv};
use super::texture::Uv;
use super::triangle::{Triangle, edge_scale, exact_cross, interpolated_uv};

/// How far before an emitter a shadow ray ends, relative to its length: its neighbours touch it.
pub const BEFORE: f64 = 1e-4;

/// A point of an emitter as another point sees it.
#[derive(Clone, Copy, Debug, Differentiable)]
pub struct Sight<S: Real> {
    /// The unit vector towards it.
    pub direction: Vec3<S>,
    /// The distance to it.
    pub distance: S,
    /// What the direction counts for among all, in steradians: one over its probability density.
    pub spread: S,
}

/// The sight of the point of a triangle that has these barycentric coordinates. The points are spread
/// evenly over the triangle, which was chosen among all emitters with the probability one over
/// `choices`.
#[differentiable]
#[inline]
pub fn sight_of_triangle<S: Real>(
    triangle: Triangle<S>,
    barycentric: [S; 3],
    choices: S,
    point: Vec3<S>,
) -> Sight<S> {
    let on_triangle =
        triangle.a * barycentric[0] + triangle.b * barycentric[1] + triangle.c * barycentric[2];
    let to_light = on_triangle - point;
    let direction = to_light.normalize_or_zero();
    let distance = to_light.length();
    Sight {
        direction,
        distance,
        spread: triangle_spread::<S>(triangle, choices, direction, distance),
    }
}

/// Two even numbers as the barycentric coordinates of an even point of a triangle (Turk 1990).
pub fn barycentric_of<S: Real>([u, v]: [S; 2]) -> [S; 3] {
    let root = u.sqrt();
    let (at_a, at_b) = (S::ONE - root, root * (S::ONE - v));
    [at_a, at_b, root * v]
}

/// The sight of the point of a primitive that these numbers choose: barycentric coordinates, or the numbers of
/// [`sight_of_sphere()`], then any. `inside` is as there.
#[differentiable]
#[inline]
pub fn sight_of<S: Real>(
    primitive: Primitive<S>,
    inside: S::Mask,
    at: [S; 3],
    choices: S,
    point: Vec3<S>,
) -> Sight<S> {
    match primitive {
        Primitive::Triangle(triangle) => sight_of_triangle::<S>(triangle, at, choices, point),
        Primitive::Sphere(sphere) => {
            sight_of_sphere::<S>(sphere, inside, [at[0], at[1]], choices, point)
        }
    }
}

/// The texture coordinates of the point of a primitive that numbers choose as for [`sight_of()`], and which is seen
/// from `point` in a `direction` at a `distance`. Triangles interpolate those of their `corners`, spheres have their own.
#[differentiable]
#[inline]
pub fn uv_of_sight<S: Real>(
    primitive: Primitive<S>,
    corners: [Uv<S>; 3],
    at: [S; 3],
    direction: Vec3<S>,
    distance: S,
    point: Vec3<S>,
) -> Uv<S> {
    match primitive {
        Primitive::Triangle(_) => interpolated_uv::<S>(corners, at),
        Primitive::Sphere(sphere) => sphere_uv::<S>(sphere, point + direction * distance),
    }
}

/// What is seen of the emission of a surface: its opacity is the part of it that is there.
#[differentiable]
#[inline]
pub fn seen_emission<S: Real>(emission: Vec3<S>, opacity: S) -> Vec3<S> {
    emission * opacity
}

/// The illumination of a point by such a point of a primitive, for all of what shines; of a sphere that does not shine
/// evenly, by the point of [`sight_on_sphere()`]. The distance is shorter by a part that keeps the surface itself out
/// of the way.
#[differentiable(boxed)]
#[inline(never)]
pub fn illuminate_by_point_of<S: Real>(
    primitive: Primitive<S>,
    inside: S::Mask,
    at: [S; 3],
    is_even: bool,
    choices: S,
    emission: Vec3<S>,
    point: Vec3<S>,
) -> Illumination<S> {
    let Sight { direction, distance, spread } = match primitive {
        Primitive::Sphere(sphere) if !is_even => {
            sight_on_sphere::<S>(sphere, inside, at, choices, point)
        }
        _ => sight_of::<S>(primitive, inside, at, choices, point),
    };
    let before = distance * S::from_f64(1.0 - BEFORE);
    illuminate_by_emitter::<S>(emission, direction, before, spread)
}

/// The spread of a direction in which a triangle is met at a distance: its area as the cosine foreshortens
/// it, by the squared distance.
#[differentiable]
#[inline]
pub fn triangle_spread<S: Real>(
    triangle: Triangle<S>,
    choices: S,
    direction: Vec3<S>,
    distance: S,
) -> S {
    let (to_b, to_c) = (triangle.b - triangle.a, triangle.c - triangle.a);
    let scale = edge_scale::<S>(to_b, to_c);
    let twice_area = exact_cross::<S>(to_b * scale, to_c * scale);
    let length_recip = S::ONE / (distance * scale);
    let foreshortened = twice_area.dot(direction).abs() * S::HALF;
    foreshortened * length_recip * length_recip * choices
}

/// The sight of a sphere in a direction that two numbers from 0 to 1 choose, among all that meet it. The
/// sphere was chosen among all emitters with the probability one over `choices`. Whether the point is
/// `inside` is for the caller to say, who knows it of points on the sphere.
#[differentiable]
#[inline]
pub fn sight_of_sphere<S: Real>(
    sphere: Sphere<S>,
    inside: S::Mask,
    numbers: [S; 2],
    choices: S,
    point: Vec3<S>,
) -> Sight<S> {
    let away = (sphere.center - point).length();
    let axis = axis_of_sphere::<S>(sphere, point);
    // One minus the cosine: distant spheres fill small angles.
    let versine = numbers[0] * sphere_versine::<S>(sphere, inside, point);
    let sine_squared = versine * (S::TWO - versine);
    let sine = positive_part::<S>(sine_squared).sqrt();
    let around = numbers[1] * (S::PI + S::PI);
    let local = <Vec3<S>>::new(sine * around.cos(), sine * around.sin(), S::ONE - versine);
    let direction = turn::<S>(axis, local);
    let along = away * (S::ONE - versine);
    let radius = sphere.radius;
    let half_chord = positive_part::<S>(radius * radius - away * away * sine_squared).sqrt();
    Sight {
        direction,
        distance: select(inside, along + half_chord, along - half_chord),
        spread: sphere_spread::<S>(sphere, inside, choices, point),
    }
}

/// The sight of the point of a sphere that lies from its centre in the direction `at`, a unit vector. The points are
/// spread evenly over the sphere. From outside, its far side is not seen.
#[differentiable]
#[inline]
pub fn sight_on_sphere<S: Real>(
    sphere: Sphere<S>,
    inside: S::Mask,
    at: [S; 3],
    choices: S,
    point: Vec3<S>,
) -> Sight<S> {
    let normal = <Vec3<S>>::new(at[0], at[1], at[2]);
    let to_light = sphere.center + normal * sphere.radius - point;
    let direction = to_light.normalize_or_zero();
    let distance = to_light.length();
    let cosine = direction.dot(normal);
    let foreshortened = positive_part::<S>(select(inside, cosine, -cosine));
    let seen = sphere.radius / distance;
    Sight {
        direction,
        distance,
        spread: foreshortened * seen * seen * S::from_f64(4.0 * PI) * choices,
    }
}

/// The numbers by which [`sight_of_sphere()`] chooses a direction, a unit vector that meets the sphere, then 0.
pub fn cone_numbers<S: Real>(
    sphere: Sphere<S>,
    inside: S::Mask,
    point: Vec3<S>,
    direction: Vec3<S>,
) -> [S; 3] {
    let axis = axis_of_sphere::<S>(sphere, point);
    let versine = (direction - axis).length_squared() * S::HALF;
    let along = |x: S, y: S| turn::<S>(axis, <Vec3<S>>::new(x, y, S::ZERO)).dot(direction);
    let around = along(S::ZERO, S::ONE).atan2(along(S::ONE, S::ZERO)) / (S::PI + S::PI);
    let part = versine / sphere_versine::<S>(sphere, inside, point);
    [part.min(S::ONE), around, S::ZERO]
}

/// The direction from a point to the middle of a sphere; any, if that is where the point is.
#[differentiable]
#[inline]
fn axis_of_sphere<S: Real>(sphere: Sphere<S>, point: Vec3<S>) -> Vec3<S> {
    let to_center = sphere.center - point;
    let up = <Vec3<S>>::new(S::ZERO, S::ZERO, S::ONE);
    select(to_center.length().cmpgt(S::ZERO), to_center.normalize_or_zero(), up)
}

/// The spread of every direction from a point in which a sphere is met: the solid angle that it fills.
#[differentiable]
#[inline]
pub fn sphere_spread<S: Real>(sphere: Sphere<S>, inside: S::Mask, choices: S, point: Vec3<S>) -> S {
    sphere_versine::<S>(sphere, inside, point) * (S::PI + S::PI) * choices
}

/// One minus the cosine of half the angle at which a sphere is seen; 2 from inside.
#[differentiable]
#[inline]
fn sphere_versine<S: Real>(sphere: Sphere<S>, inside: S::Mask, point: Vec3<S>) -> S {
    let away = (sphere.center - point).length();
    let sine = select(inside, S::ZERO, (sphere.radius / away).min(S::ONE));
    let sine_squared = sine * sine;
    let cosine = positive_part::<S>(S::ONE - sine_squared).sqrt();
    select(inside, S::TWO, sine_squared / (S::ONE + cosine))
}

/// The spread of a direction towards an emitter, times the weight that it has beside the same direction
/// had the material scattered to it with the given probability density; zero where the spread is
/// infinite.
#[differentiable]
#[inline]
pub fn emitter_spread<S: Real>(spread: S, density: S) -> S {
    let ratio = spread * density;
    let weighted = spread / (S::ONE + ratio * ratio);
    select(ratio.is_finite() & (ratio * ratio).is_finite(), weighted, S::ZERO)
}

/// The weight of light that a scattered direction finds, of this probability density, beside the same
/// direction had it been chosen towards the emitter. Either may be infinite: the density where nothing
/// was scattered, as by a mirror, the spread where emitters are not chosen; the weight is 1 there.
#[differentiable]
#[inline]
pub fn scattered_weight<S: Real>(spread: S, density: S) -> S {
    let both = spread.is_finite() & density.is_finite();
    let ratio = select(both, spread, S::ONE) * select(both, density, S::ONE);
    // Squares of what is at most 1.
    let is_large = ratio.cmpgt(S::ONE);
    let small = select(is_large, S::ONE / select(is_large, ratio, S::ONE), ratio);
    let squared = small * small;
    let weight = select(is_large, S::ONE, squared) / (S::ONE + squared);
    select(both, weight, S::ONE)
}

/// What a direction counts for that a material has scattered to with one over the probability `factor`, where it
/// has found a point of an emitter: its weight beside the same direction had it been chosen towards the
/// emitter, while the point stays where it is on the emitter. `first` is the spread at which it was found.
#[differentiable]
#[inline]
pub fn found_spread<S: Real>(spread: S, density: S, first: S, factor: S) -> S {
    scattered_weight::<S>(spread, density) * (spread / first) * factor
}

/// The probability density of directions that a diffuse surface scatters to which is chosen with a
/// `probability`, by solid angle.
#[differentiable]
#[inline]
pub fn cosine_density<S: Real>(normal: Vec3<S>, probability: S, direction: Vec3<S>) -> S {
    positive_part::<S>(normal.dot(direction)) * probability * S::from_f64(FRAC_1_PI)
}

/// What an emitter brings to a point that sees it: the radiance of its `emission` from all directions
/// that the one of this `weighted` spread stands for.
#[differentiable]
#[inline]
pub fn illuminate_by_emitter<S: Real>(
    emission: Vec3<S>,
    direction: Vec3<S>,
    distance: S,
    weighted: S,
) -> Illumination<S> {
    Illumination { direction, distance, irradiance: emission * weighted }
}

/// The emission of a surface that a ray has found, by its weight.
#[differentiable]
#[inline]
pub fn found_emission<S: Real>(emission: Vec3<S>, weight: S) -> Vec3<S> {
    emission * weight
}
