//! A shape and a light that the renderer does not know: an ellipsoid and a spotlight. Their kernels
//! are `#[differentiable]`, which gives their pullbacks.

use ad::differentiable;
use glam::DVec3;
use renderer::kernels::camera::{Ray, RayTangent};
use renderer::kernels::light::{Illumination, IlluminationTangent};
use renderer::kernels::surface::{SurfacePoint, SurfacePointTangent};
use renderer::scene::{CustomLight, CustomShape};

/// An ellipsoid along the axes. Parameters: its centre, then its three radii.
#[derive(Debug)]
pub struct Ellipsoid;

#[differentiable]
fn vector(numbers: &[f64], first: usize) -> DVec3 {
    DVec3::new(numbers[first], numbers[first + 1], numbers[first + 2])
}

/// The distance at which a ray enters an ellipsoid, or leaves it if it starts inside; not a number if
/// it misses it.
#[differentiable]
fn ellipsoid_distance(parameters: &[f64], ray: Ray<f64>) -> f64 {
    let radii = vector(parameters, 3);
    // Where the ellipsoid is the unit sphere.
    let origin = (ray.origin - vector(parameters, 0)) / radii;
    let direction = ray.direction / radii;
    let a = direction.dot(direction);
    let half_b = origin.dot(direction);
    let c = origin.dot(origin) - 1.0;
    let root = (half_b * half_b - a * c).sqrt();
    let near = (-half_b - root) / a;
    if near > 0.0 { near } else { (root - half_b) / a }
}

#[differentiable]
fn ellipsoid_surface(parameters: &[f64], ray: Ray<f64>) -> SurfacePoint<f64> {
    let point = ray.origin + ray.direction * ellipsoid_distance(parameters, ray);
    let radii = vector(parameters, 3);
    let normal = (point - vector(parameters, 0)) / (radii * radii);
    SurfacePoint { point, normal: normal.normalize(), view: -ray.direction }
}

impl CustomShape for Ellipsoid {
    fn bounds(&self, parameters: &[f64]) -> (DVec3, DVec3) {
        let (center, radii) = (vector(parameters, 0), vector(parameters, 3));
        (center - radii, center + radii)
    }

    fn intersect(&self, parameters: &[f64], ray: Ray<f64>) -> Option<f64> {
        let distance = ellipsoid_distance(parameters, ray);
        (distance > 0.0).then_some(distance)
    }

    fn surface(&self, parameters: &[f64], ray: Ray<f64>) -> SurfacePoint<f64> {
        ellipsoid_surface(parameters, ray)
    }

    fn surface_pullback(
        &self,
        parameters: &[f64],
        ray: Ray<f64>,
        cotangent: SurfacePointTangent<f64>,
        to_parameters: &mut [f64],
    ) -> RayTangent<f64> {
        let (_, pullback) = ellipsoid_surface::vjp(parameters, ray);
        let (parameters, ray) = pullback(cotangent);
        add(to_parameters, &parameters);
        ray
    }
}

/// A point light that shines mostly one way. Parameters: where it stands, where it shines to, its
/// radiant intensity straight ahead, in hundreds, and how sharp its cone is, in tens: optimisers
/// take one learning rate for all numbers of a light, so these are of like size.
#[derive(Debug)]
pub struct Spotlight;

#[differentiable]
fn spotlight_illumination(parameters: &[f64], point: DVec3) -> Illumination<f64> {
    let position = vector(parameters, 0);
    let to_light = position - point;
    let direction = to_light.normalize();
    let axis = (position - vector(parameters, 3)).normalize();
    let cone = axis.dot(direction).max(0.0).powf(10.0 * parameters[7]);
    let irradiance = 100.0 * parameters[6] * cone / to_light.length_squared();
    Illumination { direction, irradiance: DVec3::ONE * irradiance }
}

impl CustomLight for Spotlight {
    fn distance(&self, parameters: &[f64], point: DVec3) -> f64 {
        vector(parameters, 0).distance(point)
    }

    fn illumination(&self, parameters: &[f64], point: DVec3) -> Illumination<f64> {
        spotlight_illumination(parameters, point)
    }

    fn illumination_pullback(
        &self,
        parameters: &[f64],
        point: DVec3,
        cotangent: IlluminationTangent<f64>,
        to_parameters: &mut [f64],
    ) -> DVec3 {
        let (_, pullback) = spotlight_illumination::vjp(parameters, point);
        let (parameters, point) = pullback(cotangent);
        add(to_parameters, &parameters);
        point
    }
}

fn add(sums: &mut [f64], terms: &[f64]) {
    for (sum, term) in sums.iter_mut().zip(terms) {
        *sum += term;
    }
}
