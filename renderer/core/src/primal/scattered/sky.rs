//! What the environment brings: to rays that meet nothing, and to surfaces that look for it.

use ad::lanes::Lanes;
use ad::vector::Vector3;
use ad::{Real, Vec3};

use crate::number::{MAX_LANES, Number, primal_vector};
use crate::primal::gather::Lookup;
use crate::primal::integrator::Integrator;
use crate::primal::lanes::{all_lanes, lanes_of_numbers, numbers_of_lanes};
use crate::primal::wavefront::{RayLanes, Wavefront};
use crate::trace::bvh::PACKET_RAYS;
use crate::transport::camera::film_point;
use crate::transport::emitter::found_emission;
use crate::transport::environment::{Environment, map_coordinates, map_radiance};
use crate::transport::texture::Uv;

/// What the environment brings from some directions.
pub struct SkyLight<S: Number> {
    pub environment: Environment<S>,
    pub direction: Vec3<S>,
    /// The texels of its map, if it has one.
    pub lookup: Option<Lookup<S>>,
}

impl<S: Number> SkyLight<S> {
    /// The radiance.
    pub fn radiance(&self) -> Vec3<S> {
        match &self.lookup {
            None => self.environment.radiance,
            Some(lookup) => map_radiance::<S>(self.environment, lookup.footprint, self.direction),
        }
    }
}

impl<S: Number> Integrator<'_, S> {
    /// What the environment brings from directions; nothing if it is black.
    pub fn sky_light(&self, lanes: u32, direction: Vec3<S>) -> Option<SkyLight<S>> {
        let environment = self.inputs.environment?;
        let lookup = self.layout.map.as_ref().map(|(texture, layout)| {
            let uv = map_coordinates::<S>(environment.rotation, direction);
            self.texels(|_| Some((*texture, *layout)), lanes, uv)
        });
        Some(SkyLight { environment, direction, lookup })
    }

    /// What the environment brings to rays of a wavefront that meet nothing, and its weight beside what was
    /// looked for; nothing if it is black, or the camera sees a background in place of it.
    pub fn missed_light(
        &self,
        wavefront: &Wavefront<S>,
        lanes: RayLanes,
    ) -> Option<(SkyLight<S>, S)> {
        if self.layout.background.is_some() && is_primary(wavefront) {
            return None;
        }
        let light = self.sky_light(lanes.alive, self.missed_direction(wavefront, lanes))?;
        Some((light, wavefront.scattering.found[lanes.block::<S>()]))
    }

    /// Calls `use_radiance` with what rays bring that meet nothing, unless that is black.
    pub fn visit_missed(
        &self,
        wavefront: &Wavefront<S>,
        mut use_radiance: impl FnMut(RayLanes, Vec3<S>),
    ) {
        let background = self.layout.background.filter(|_| is_primary(wavefront));
        if self.inputs.environment.is_none() {
            return;
        }
        for lanes in missed::<S>(wavefront) {
            if let Some(background) = background {
                let [r, g, b] = background.to_array().map(S::from_f64);
                use_radiance(lanes, Vector3::new(r, g, b));
            } else if let Some((light, weight)) = self.missed_light(wavefront, lanes) {
                use_radiance(lanes, found_emission::<S>(light.radiance(), weight));
            }
        }
    }

    /// The directions of rays of a wavefront, of any length.
    fn missed_direction(&self, wavefront: &Wavefront<S>, lanes: RayLanes) -> Vec3<S> {
        match wavefront.film.get(lanes.block::<S>()) {
            Some(&(x, y)) => film_point::<S>(self.inputs.frame, S::constant(x), S::constant(y)),
            None => wavefront.rays[lanes.block::<S>()].direction,
        }
    }

    /// What directions count for had their part of the environment been looked for, in steradians; infinite
    /// where it would not have been.
    pub(super) fn spread_of_missed(
        &self,
        wavefront: &Wavefront<S>,
        lanes: RayLanes,
    ) -> Option<S::Lanes> {
        let sky = self.layout.sky.as_ref()?;
        let direction = primal_vector::<S>(self.missed_direction(wavefront, lanes));
        let Uv { u, v } = map_coordinates::<S::Lanes>(S::Lanes::ZERO, direction);
        let (u, v) = (numbers_of_lanes(u), numbers_of_lanes(v));
        let mut spreads = [f64::INFINITY; MAX_LANES];
        for (lane, _) in lanes.rays() {
            let (rank, row) = sky.rank_at([u[lane], v[lane]]);
            let cell = self.layout.material_of.len() as u32 + rank;
            spreads[lane] = self.emitters.choices(cell) * sky.solid_angle(row);
        }
        Some(lanes_of_numbers::<S::Lanes>(&spreads))
    }
}

/// Whether the rays of a wavefront are those of the camera.
pub(super) fn is_primary<S: Number>(wavefront: &Wavefront<S>) -> bool {
    !wavefront.film.is_empty()
}

/// The rays of a wavefront that meet nothing.
pub fn missed<S: Number>(wavefront: &Wavefront<S>) -> impl Iterator<Item = RayLanes> + use<S> {
    let missed = wavefront.missed;
    let blocks = (0..PACKET_RAYS).step_by(<S::Lanes as Lanes>::COUNT);
    let lanes = blocks.map(move |first| {
        let all = all_lanes::<S::Lanes>();
        RayLanes { first, alive: (missed >> first) as u32 & all }
    });
    lanes.filter(|lanes| lanes.alive != 0)
}
