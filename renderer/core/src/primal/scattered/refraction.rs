//! How paths go on at dielectrics.

use ad::lanes::Lanes;
use ad::{Fields, Real, select};

use super::Event;
use crate::number::Number;
use crate::primal::coalesce::select_lanes;
use crate::primal::vertex::Vertex;
use crate::transport::dielectric::{reflectance, refracted_direction};

/// How paths go on from the surfaces of a vertex, all of dielectrics, as a number from 0 to 1 chooses:
/// mirrored as often as light is, so that what they reflect has no noise.
pub fn refract_or_reflect<S: Number>(vertex: &Vertex<'_, S>, choice: S::Lanes) -> Event<S> {
    let group = vertex.group;
    let (material, surface) = (vertex.material.map(S::primal), group.surface.map(S::primal));
    let inside = S::Lanes::mask_from_bits(group.inside);
    let reflected = reflectance::<S::Lanes>(material, surface, inside);
    let is_mirrored = choice.cmplt(reflected);
    let mirrored = S::Lanes::mask_bits(is_mirrored) & group.alive;
    let probability = select(is_mirrored, reflected, S::Lanes::ONE - reflected);
    let refracted = refracted_direction::<S>(vertex.material, group.surface, S::mask(group.inside));
    let mirror = group.next_rays(0).direction;
    Event {
        direction: select_lanes::<S, _>(mirrored, &mirror, &refracted),
        straight: group.alive & !mirrored,
        mirrored,
        factor: S::constant(S::Lanes::ONE / probability),
    }
}
