//! Direct light: the radiance that one light makes a surface reflect.

use ad::vector::Vector;
use ad::{Real, Vec3, differentiable, select};

use super::hit::SurfacePoint;
use super::light::{Illumination, Light, cosine, illuminate};
use super::material::{Material, brdf, lambertian_brdf};

/// The radiance that a surface reflects towards the viewer from one light: the BRDF times the
/// irradiance times the cosine, where the light is `visible`, times the `transmittance` of transparent
/// surfaces in between.
#[differentiable]
#[inline]
pub fn direct<S: Real>(
    material: Material<S>,
    surface: SurfacePoint<S>,
    light: Light<S>,
    visible: S::Mask,
    transmittance: S,
) -> Vec3<S> {
    let illumination = illuminate::<S>(light, surface.point);
    reflect::<S>(material, surface, illumination, visible, transmittance)
}

/// [`direct`] for a known illumination.
#[differentiable]
#[inline]
pub fn reflect<S: Real>(
    material: Material<S>,
    surface: SurfacePoint<S>,
    illumination: Illumination<S>,
    visible: S::Mask,
    transmittance: S,
) -> Vec3<S> {
    let reflectance = brdf::<S>(material, surface, illumination.direction);
    let cosine = cosine::<S>(surface.normal, illumination);
    let radiance = reflectance * illumination.irradiance * (cosine * transmittance);
    select(visible, radiance, Vec3::<S>::ZERO)
}

/// [`direct`] for a material without highlight: an image needs no power there.
#[inline]
pub fn direct_lambertian<S: Real>(
    diffuse: Vec3<S>,
    surface: SurfacePoint<S>,
    light: Light<S>,
    visible: S::Mask,
    transmittance: S,
) -> Vec3<S> {
    let illumination = illuminate::<S>(light, surface.point);
    let cosine = cosine::<S>(surface.normal, illumination);
    let radiance =
        lambertian_brdf::<S>(diffuse) * illumination.irradiance * (cosine * transmittance);
    select(visible, radiance, Vec3::<S>::ZERO)
}

/// The transmittance of what light has passed so far and one more surface of this opacity.
#[differentiable]
#[inline]
pub fn attenuate<S: Real>(transmittance: S, opacity: S) -> S {
    transmittance * (S::ONE - opacity)
}
