//! Direct light: the radiance that one light makes a surface reflect.

use ad::vector::Vector;
use ad::{Real, Vec3, differentiable, select};

use super::brdf::brdf;
use super::illumination::Illumination;
use super::material::{Lobes, Material};
use super::positive_part;
use super::surface::SurfacePoint;

/// The radiance that a surface reflects towards the viewer from one light: the BRDF times the
/// irradiance times the cosine, where the light is `visible`, times the `transmittance` of transparent
/// surfaces in between.
#[differentiable]
#[inline]
pub fn direct<S: Real>(
    material: Material<S>,
    lobes: Lobes,
    surface: SurfacePoint<S>,
    light: Illumination<S>,
    visible: S::Mask,
    transmittance: S,
) -> Vec3<S> {
    let reflectance = brdf::<S>(material, lobes, surface, light.direction);
    let cosine = cosine::<S>(surface.normal, light.direction);
    let radiance = reflectance * light.irradiance * (cosine * transmittance);
    select(visible, radiance, Vec3::<S>::ZERO)
}

/// The transmittance of what light has passed so far and one more surface of this opacity.
#[differentiable]
#[inline]
pub fn attenuate<S: Real>(transmittance: S, opacity: S) -> S {
    transmittance * (S::ONE - opacity)
}

/// The cosine between a normal and the direction of a light, 0 from behind.
#[differentiable]
#[inline]
fn cosine<S: Real>(normal: Vec3<S>, direction: Vec3<S>) -> S {
    positive_part::<S>(normal.dot(direction))
}
