//! The material of the paper: rough diffuse below a Blinn-Phong highlight.

use std::f64::consts::{FRAC_1_PI, PI};

use ad::vector::Vector;
use ad::{Real, Vec3, differentiable, select};

use super::material::{Lobes, Material};
use super::positive_part;
use super::surface::SurfacePoint;

/// The BRDF for light from `direction`, a unit vector: the diffuse part, and
/// `specular / π * max(n · h, 0)^exponent`, where `h` is the direction half-way between light and viewer
/// (Blinn 1977). `lobes` holds those of all lanes.
///
/// The highlight is not normalised, as in RayTracer.jl: `exponent` changes its energy. Unlike there,
/// both parts are multiplied by the cosine of the light, so that the highlight fades towards the shadow
/// side instead of ending at an edge.
#[differentiable]
#[inline]
pub fn blinn_phong<S: Real>(
    material: Material<S>,
    lobes: Lobes,
    surface: SurfacePoint<S>,
    direction: Vec3<S>,
) -> Vec3<S> {
    let mut reflectance = material.diffuse;
    if lobes.rough {
        reflectance = reflectance * rough_diffuse::<S>(material.roughness, surface, direction);
    }
    if lobes.glossy {
        let half_way = (direction + surface.view).normalize_or_zero();
        let alignment = positive_part::<S>(surface.normal.dot(half_way));
        reflectance = reflectance + material.specular * alignment.powf(material.exponent);
    }
    reflectance * S::from_f64(FRAC_1_PI)
}

/// The BRDF of a rough diffuse surface, by Lambert's: facets in all directions, which are Lambertian and
/// hide each other (Oren & Nayar 1994), in the form of Fujii, which has no ring (Portsmouth, Kutz & Hill
/// 2024). It has a kink where light and viewer are at the same angle from the normal. The light that facets send to
/// each other is left out: at `roughness` 1 the mean albedo is 0.83. A viewer behind the shading normal sees what one
/// sees who is as far before it, so that the radiance does not jump where a light grazes the surface.
#[differentiable]
#[inline]
fn rough_diffuse<S: Real>(roughness: S, surface: SurfacePoint<S>, direction: Vec3<S>) -> S {
    let (to_light, to_viewer) = (surface.normal.dot(direction), surface.normal.dot(surface.view));
    let along_surface = direction.dot(surface.view) - to_light * to_viewer;
    // At grazing angles the cosine of the light tends to zero faster than this to infinity.
    let largest = to_light.max(to_viewer.abs()).max(S::EPSILON);
    let ratio = select(along_surface.cmpgt(S::ZERO), along_surface / largest, along_surface);
    let energy = S::ONE + roughness * S::from_f64(0.5 - 2.0 / (3.0 * PI));
    (S::ONE + roughness * ratio) / energy
}
