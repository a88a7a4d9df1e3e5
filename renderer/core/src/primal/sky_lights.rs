//! The environment where light is direct: distant lights, whose numbers follow from its own.

use ad::vector::{Vector, Vector3};
use ad::{Real, Vec3};

use super::varying::{Varying, lifted_vector};
use crate::number::Number;
use crate::scene::{DistantLight, Object, Scene};
use crate::trace::layout::Layout;
use crate::trace::sky_parts::SkyPart;
use crate::transport::environment::{part_irradiance, turned};

/// The parts of the sky as distant lights.
pub fn sky_lights<S: Number>(
    scene: &Scene,
    layout: &Layout,
    varying: &Varying<S::Wide>,
) -> Vec<DistantLight<S::Wide>> {
    let Some(environment) = scene.environment else { return Vec::new() };
    let values = varying.lift(Object::Environment, &environment.values);
    let texels = environment
        .texture
        .and_then(|texture| varying.block(Object::Texture(texture as usize), "texels"));
    let light = |part: &SkyPart| {
        let direction = turned::<S::Wide>(values.rotation, lifted_vector::<S>(part.direction));
        let integral = match texels {
            None => lifted_vector::<S>(part.integral),
            Some(texels) => integral_of::<S::Wide>(part, texels.as_chunks().0),
        };
        let color = part_irradiance::<S::Wide>(values.radiance, integral);
        DistantLight { direction, color, irradiance: Real::ONE }
    };
    layout.sky_parts.iter().map(light).collect()
}

/// The integral of a part whose texels vary.
fn integral_of<W: Real>(part: &SkyPart, texels: &[[W; 3]]) -> Vec3<W> {
    part.texels().fold(Vec3::<W>::splat(W::ZERO), |sum, (texel, irradiance)| {
        let [r, g, b] = texels[texel];
        sum + Vec3::<W>::new(r, g, b) * W::from_f64(irradiance)
    })
}
