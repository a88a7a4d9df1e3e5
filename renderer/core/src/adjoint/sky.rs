//! From the distant lights that the parts of the sky are to the environment.

use ad::{Additive, Tangent};
use glam::DVec3;

use crate::scene::{DistantLight, Environment, EnvironmentObject};
use crate::trace::sky_parts::SkyPart;
use crate::transport::environment::{part_irradiance, turned};

/// From the cotangents of the lights of all parts to the environment and, by `to_texel`, to the texels of its
/// map.
pub fn pull_sky<'a>(
    environment: EnvironmentObject,
    lights: impl Iterator<Item = (&'a SkyPart, Tangent<DistantLight<f64>>)>,
    mut to_texel: impl FnMut(usize, DVec3),
) -> Tangent<Environment<f64>> {
    let Environment { radiance, rotation } = environment.values;
    let mut sum = Tangent::<Environment<f64>>::zero();
    for (part, light) in lights {
        let (_, pullback) = turned::vjp::<f64>(rotation, part.direction);
        let (rotation, _fixed) = pullback(light.direction);
        let (_, pullback) = part_irradiance::vjp::<f64>(radiance, part.integral);
        let (radiance, integral) = pullback(light.color);
        sum.accumulate(Tangent::<Environment<f64>> { radiance, rotation });
        if environment.texture.is_some() {
            part.texels().for_each(|(texel, irradiance)| to_texel(texel, integral * irradiance));
        }
    }
    sum
}
