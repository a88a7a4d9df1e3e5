//! The light that a material reflects, whatever its model.

use ad::{Real, Vec3, differentiable};

use super::blinn_phong::blinn_phong;
use super::material::{Lobes, Material};
use super::microfacet::metallic_roughness;
use super::surface::SurfacePoint;

/// The BRDF of a material for light from `direction`, a unit vector. `lobes` holds those of all lanes.
#[differentiable]
#[inline]
pub fn brdf<S: Real>(
    material: Material<S>,
    lobes: Lobes,
    surface: SurfacePoint<S>,
    direction: Vec3<S>,
) -> Vec3<S> {
    if lobes.facets {
        metallic_roughness::<S>(material, surface, direction)
    } else {
        blinn_phong::<S>(material, lobes, surface, direction)
    }
}
