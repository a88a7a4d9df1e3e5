//! The environment where light is direct: distant lights, whose numbers follow from its own.

use ad::vector::{Vector, Vector3};
use ad::{Fields, Real, Vec3};
use glam::DVec3;

use super::inputs::{LightInputs, constant, in_lanes};
use super::varying::Varying;
use crate::number::Number;
use crate::scene::{EnvironmentObject, Object, Scene};
use crate::trace::layout::Layout;
use crate::trace::sky_parts::SkyPart;
use crate::transport::area_light::Place;
use crate::transport::environment::{part_irradiance, turn};
use crate::transport::light::{DistantLight, Light};

/// The parts of the sky as distant lights.
pub fn sky_lights<S: Number>(
    scene: &Scene,
    layout: &Layout,
    varying: &Varying<S::Wide>,
) -> Vec<LightInputs<S>> {
    let Some(environment) = scene.environment.filter(|_| !layout.sky_parts.is_empty()) else {
        return Vec::new();
    };
    let values = varying.lift(Object::Environment, &environment.values);
    let light = |part: &SkyPart| {
        let direction = turn::<S::Wide>(values.rotation, constant::<S>(part.direction));
        let integral = sky_integral::<S>(scene, environment, part, varying);
        let color = part_irradiance::<S::Wide>(values.radiance, integral);
        let light = DistantLight { direction, color, irradiance: Real::ONE };
        let light = Light::Distant(in_lanes::<S, _>(&light));
        LightInputs::Known { light, place: Place::POINT.map(S::from_f64) }
    };
    layout.sky_parts.iter().map(light).collect()
}

/// What a part of the sky brings to a surface that faces it, where the radiance of the environment is 1.
pub fn sky_integral<S: Number>(
    scene: &Scene,
    environment: EnvironmentObject,
    part: &SkyPart,
    varying: &Varying<S::Wide>,
) -> Vec3<S::Wide> {
    let Some(texture) = environment.texture.map(|texture| texture as usize) else {
        return constant::<S>(part.texels().map(|(_, irradiance)| DVec3::splat(irradiance)).sum());
    };
    match varying.block(Object::Texture(texture), "texels") {
        None => {
            let texels = &scene.textures[texture].texels;
            constant::<S>(
                part.texels().map(|(at, irradiance)| DVec3::from(texels.at(at)) * irradiance).sum(),
            )
        }
        Some(block) => {
            let mut sum = Vec3::<S::Wide>::splat(Real::ZERO);
            for (at, irradiance) in part.texels() {
                let &[r, g, b] = &block.as_chunks().0[at];
                sum = sum + Vec3::<S::Wide>::new(r, g, b) * S::Wide::from_f64(irradiance);
            }
            sum
        }
    }
}
