//! The light that goes through transparent surfaces.
//!
//! Every surface on the way leaves `1 - d` of it, where `d` is its opacity at the place where the
//! light goes through. What shadow rays hit is looked for a second time, one by one, where the first
//! time said that there is something: a scene without transparent materials is rendered as if there
//! were none. How far light goes through is not limited by the depth of the scene.

use ad::Real;
use ad::lanes::Lanes;

use super::coalesce::{Coalesced, select_lanes};
use super::integrator::Integrator;
use super::known::{KnownHits, Occluding};
use super::shadow::ShadowRay;
use super::wavefront::{LaneGroup, Occluder, Transmission, Wavefront, blocks};
use crate::counts::count;
use crate::number::{MAX_LANES, Number};
use crate::scene::Slot;
use crate::trace::bvh::{NO_PRIMITIVE, PACKET_RAYS};
use crate::trace::layout::Kind;
use crate::transport::camera::Ray;
use crate::transport::direct::attenuate;
use crate::transport::hit::{hit, surface_uv};
use crate::transport::texture::modulate_opacity;

impl<S: Number> Integrator<'_, S> {
    /// Adds to the visibility masks of a wavefront the rays that end where lights shine through
    /// transparent surfaces.
    pub fn trace_transmissions(&self, known: Option<&KnownHits>, wavefront: &mut Wavefront<S>) {
        wavefront.transmissions.clear();
        wavefront.filters.clear();
        if !self.layout.has_transparency {
            return;
        }
        let mut filters = std::mem::take(&mut wavefront.filters);
        filters.resize(PACKET_RAYS, 0);
        for light in 0..wavefront.visible.len() {
            let mut transmission =
                Transmission { transmittance: vec![S::ONE; blocks::<S>()], occluders: Vec::new() };
            if !self.layout.lights[light].is_black || self.zero_weight.lights {
                let through =
                    self.transmit(light, known, wavefront, &mut transmission, &mut filters);
                wavefront.visible[light] |= through;
                wavefront.blocked[light] &= !through;
            }
            wavefront.transmissions.push(transmission);
        }
        wavefront.filters = filters;
    }

    /// Finds what a light sends through transparent surfaces to those of the rays that it reaches; returns a bit for
    /// each of these. Adds to the numbers of the materials that it comes through.
    fn transmit(
        &self,
        light: usize,
        known: Option<&KnownHits>,
        wavefront: &Wavefront<S>,
        transmission: &mut Transmission<S>,
        filters: &mut [u32],
    ) -> u64 {
        // Where paths are known, so is what is opaque.
        let dark = match known {
            Some(_) => wavefront.visible[light],
            None => wavefront.blocked[light],
        };
        let mut through = 0;
        for group in wavefront.groups.iter().filter(|group| group.lanes_of(dark) != 0) {
            let shadow_ray = self.shadow_rays(light, wavefront, group);
            let mut surfaces: [Vec<Occluding>; MAX_LANES] = std::array::from_fn(|_| Vec::new());
            for (lane, ray) in group.rays() {
                if dark >> ray & 1 == 0 {
                    continue;
                }
                let found = match known.and_then(|known| known.through(light, ray)) {
                    Some(known) => Some(known.to_vec()),
                    None => self.transparent_between(&shadow_ray(lane, ray)),
                };
                if let Some(found) = found {
                    let primitives = found.iter().map(|surface| surface.primitive);
                    let of_light = self.layout.filters(light, primitives);
                    filters[ray] = filters[ray].wrapping_add(of_light);
                    surfaces[lane] = found;
                    through |= 1 << ray;
                }
            }
            self.cross(light, group, &surfaces, transmission);
        }
        through
    }

    /// What a ray hits before the light; nothing if any of it is opaque.
    fn transparent_between(&self, ray: &ShadowRay) -> Option<Vec<Occluding>> {
        count(|counts| &counts.shadow_rays, 1);
        let ShadowRay { origin, direction, limit, from } = *ray;
        let direction = direction.as_vec3();
        let (mut found, mut is_blocked) = (Vec::new(), false);
        self.tracer.bvh.visit_crossings(origin, direction, limit, from, |primitive, leaves| {
            is_blocked = !self.layout.traits_of(primitive as usize).is_transparent;
            found.push(Occluding { primitive, leaves });
            !is_blocked
        });
        found.sort_unstable();
        (!is_blocked).then_some(found)
    }

    /// Multiplies the transmittance of a group by that of the surfaces that the light of each lane goes
    /// through.
    fn cross(
        &self,
        light: usize,
        group: &LaneGroup<S>,
        surfaces: &[Vec<Occluding>; MAX_LANES],
        transmission: &mut Transmission<S>,
    ) {
        let most = surfaces.iter().map(Vec::len).max().unwrap_or(0);
        for nth in 0..most {
            for kind in [Kind::Triangle, Kind::Sphere] {
                let (mut lanes, mut inside) = (0, 0);
                let mut primitives = [NO_PRIMITIVE; PACKET_RAYS];
                for (lane, surfaces) in surfaces.iter().enumerate() {
                    let Some(&Occluding { primitive, leaves }) = surfaces.get(nth) else {
                        continue;
                    };
                    if self.layout.kind_of(primitive as usize).0 == kind {
                        lanes |= 1 << lane;
                        inside |= u32::from(leaves) << lane;
                        primitives[group.first + lane] = primitive;
                    }
                }
                if lanes == 0 {
                    continue;
                }
                let known = Coalesced::new(&primitives, group.first, lanes);
                let (opacity, met) = self.opacity_at(light, group, (kind, &known, inside));
                let primitives = match lanes & !met {
                    0 => known,
                    _ if lanes & met == 0 => continue,
                    _ => Coalesced::new(&primitives, group.first, lanes & met),
                };
                lanes &= met;
                let before = transmission.of(group);
                let after = attenuate::<S>(before, opacity);
                transmission.transmittance[group.block()] =
                    select_lanes::<S, S>(lanes, &after, &before);
                transmission.occluders.push(Occluder {
                    group: group.index,
                    lanes,
                    primitives,
                    kind,
                    inside,
                    before,
                    opacity,
                });
            }
        }
    }

    /// The ray from the points of a group to a light.
    pub fn shadow_ray(&self, light: usize, group: &LaneGroup<S>) -> Ray<S> {
        let origin = self.shadow_origin(group);
        Ray { origin, direction: self.inputs.lights[light].illuminate(origin).direction }
    }

    /// The opacity of surfaces where the light of a group goes through them, with a bit for each lane in which it
    /// does: a ray that runs along a triangle comes to no point of its texture.
    fn opacity_at(
        &self,
        light: usize,
        group: &LaneGroup<S>,
        (kind, primitives, inside): (Kind, &Coalesced, u32),
    ) -> (S, u32) {
        let materials = self.materials(primitives);
        let opacity = self.material(&materials).opacity;
        let is_textured =
            |material: usize| self.layout.materials[material].textures.get(Slot::Opacity).is_some();
        let Some(primitive) = self.primitive(kind, primitives) else { return (opacity, u32::MAX) };
        if materials.lanes_where(is_textured) == 0 {
            return (opacity, u32::MAX);
        }
        let ray = self.shadow_ray(light, group);
        let point = hit::<S>(primitive, S::mask(inside), ray).point;
        let uv = surface_uv::<S>(primitive, self.corner_uvs(kind, primitives), point);
        let met = S::Lanes::mask_bits((uv.u + uv.v).primal().is_finite());
        match self.lookup(Slot::Opacity, kind, &materials, uv) {
            Some(lookup) => (modulate_opacity::<S>(opacity, lookup.footprint, uv), met),
            None => (opacity, u32::MAX),
        }
    }
}
