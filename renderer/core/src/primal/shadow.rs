//! Shadow rays: the visibility mask of each light for the hits of a wavefront.

use ad::lanes::Lanes;
use ad::vector::Vector;
use ad::{Real, Vec3, select};
use glam::DVec3;

use super::integrator::Integrator;
use super::known::KnownHits;
use super::lanes::vectors_of_lanes;
use super::wavefront::{Bent, LaneGroup, Wavefront, set_vectors};
use crate::counts::count;
use crate::number::{MAX_LANES, Number, primal_vector};
use crate::trace::bvh::{Batch, Bvh, NO_PRIMITIVE, PACKET_RAYS, PacketHits, PacketVectors, rays};
use crate::trace::layout::Kind;

/// Up to this ratio of its distance to the coordinates of a surface point, shadow rays start at the
/// light; beyond, their ends would be too inexact.
const FARTHEST: f64 = 100.0;

/// How far a point may be from the surface that traversal sees, relative to the largest number that
/// went into it: that was rounded to single precision (the error analysis of Pharr, Jakob &
/// Humphreys, "Physically Based Rendering", section 6.8).
pub const SURFACE_ERROR: f64 = 8.0 * f32::EPSILON as f64;

impl<S: Number> Integrator<'_, S> {
    /// Finds which rays of a wavefront end where each light shines. Nothing is traced for lights that send
    /// nothing, unless they count.
    pub fn trace_shadows(&self, known: Option<&KnownHits>, wavefront: &mut Wavefront<S>) {
        let mut visible = std::mem::take(&mut wavefront.visible);
        let mut blocked = std::mem::take(&mut wavefront.blocked);
        visible.clear();
        blocked.clear();
        for (light, traits) in self.layout.lights.iter().enumerate() {
            let blocked_by = known.and_then(|known| known.blocked.get(light));
            let (facing, lit) = match blocked_by {
                _ if traits.is_black && !self.zero_weight.lights => (0, 0),
                Some(blocked) => (u64::MAX, !blocked),
                None => match self.tracer.position(light) {
                    Some(position) => self.visible_from(light, position, wavefront),
                    None => self.visible_along(light, wavefront),
                },
            };
            visible.push(lit);
            blocked.push(facing & !lit);
        }
        (wavefront.visible, wavefront.blocked) = (visible, blocked);
        self.trace_transmissions(known, wavefront);
    }

    /// A bit for each ray that ends on a surface that faces a light which faces it, and for each where it
    /// shines. Shadow rays of a light with a position start at the light: from there they are coherent.
    fn visible_from(&self, light: usize, position: DVec3, wavefront: &Wavefront<S>) -> (u64, u64) {
        let [x, y, z] = position.to_array().map(S::Lanes::from_f64);
        let start: Vec3<S::Lanes> = ad::vector::Vector3::new(x, y, z);
        let mut directions = PacketVectors::ZERO;
        let mut from = wavefront.hits.primitive;
        let known = self.tracer.known::<S::Lanes>(light);
        let (mut facing, mut traced, mut far) = (0, 0, 0);
        for group in &wavefront.groups {
            let (point, normal) = group.values();
            let to_light = start - point;
            let turned_away = known.and_then(|light| light.is_turned_away(to_light));
            let turned_away = turned_away.map_or(0, S::Lanes::mask_bits);
            let lanes = group.facing(normal, to_light) & !turned_away;
            let own = self.in_own_shadow(wavefront, group, to_light);
            facing |= u64::from(lanes | own) << group.first;
            let lanes = lanes & !own;
            if lanes == 0 {
                continue;
            }
            traced |= u64::from(lanes) << group.first;
            let (point, outward) = group.geometry();
            let to_light = start - point;
            let (reach, distance) = (group.reach(), to_light.length());
            let is_far = distance.cmpgt(reach * S::Lanes::from_f64(FARTHEST));
            far |= u64::from(S::Lanes::mask_bits(is_far) & lanes) << group.first;

            let error = reach.max(distance) * S::Lanes::from_f64(SURFACE_ERROR);
            let end = outward * error - to_light;
            set_vectors::<S::Lanes>(&mut directions, group.first, group.alive, end);
            for lane in rays(group.may_meet_themselves(to_light).into()) {
                from[group.first + lane] = NO_PRIMITIVE;
            }
        }
        if self.is_alone(wavefront) {
            return (facing, facing);
        }
        let (origin, near) = (position.as_vec3(), traced & !far);
        count(|counts| &counts.shadow_rays, u64::from(near.count_ones()));
        let occluded = self.tracer.bvh.occluded_packet(origin, &directions, 1.0, &from, near);
        (facing, near & !occluded | self.unoccluded(light, wavefront, traced & far))
    }

    /// The same for any other light: shadow rays start at the surfaces.
    fn visible_along(&self, light: usize, wavefront: &Wavefront<S>) -> (u64, u64) {
        let (mut facing, mut traced) = (0, 0);
        for group in &wavefront.groups {
            let illumination = self.inputs.lights[light].illuminate(group.surface.point);
            let to_light = primal_vector::<S>(illumination.direction);
            let (_, normal) = group.values();
            let lanes = group.facing(normal, to_light);
            let own = self.in_own_shadow(wavefront, group, to_light);
            facing |= u64::from(lanes | own) << group.first;
            traced |= u64::from(lanes & !own) << group.first;
        }
        (facing, self.unoccluded(light, wavefront, traced))
    }

    /// A bit for each lane with a triangle that is flat and opaque, but for its normal map, and has the light behind it.
    /// It is in its own shadow wherever the map turns normals, so that all of it is said to be: an edge has the same
    /// light on a side as a sample of that side.
    fn in_own_shadow(
        &self,
        wavefront: &Wavefront<S>,
        group: &LaneGroup<S>,
        to_light: Vec3<S::Lanes>,
    ) -> u32 {
        let Some(bent) = group.bent.as_ref().filter(|_| group.mapped.is_some()) else { return 0 };
        let behind = group.alive & !group.facing(primal_vector::<S>(bent.outward), to_light);
        let is_hidden = |&lane: &usize| {
            let triangle = wavefront.hits.primitive[group.first + lane] as usize;
            self.layout.shades_itself(triangle)
        };
        rays(behind.into()).filter(is_hidden).map(|lane| 1 << lane).sum()
    }

    /// Whether a wavefront shows the only primitive there is, from outside: nothing casts a shadow on it,
    /// but for triangles with other shading normals than their own, which light may reach from behind.
    fn is_alone(&self, wavefront: &Wavefront<S>) -> bool {
        let primitives = self.layout.material_of.len();
        let is_bent = !self.layout.normals.is_empty() || self.layout.has_normal_maps;
        let is_convex = self.layout.customs() == 0 && !is_bent;
        primitives == 1 && is_convex && wavefront.hits.leaves == 0
    }

    /// Those among `rays` that end at points from which nothing stands in the way to the light.
    fn unoccluded(&self, light: usize, wavefront: &Wavefront<S>, rays: u64) -> u64 {
        if rays == 0 || self.is_alone(wavefront) {
            return rays;
        }
        let mut shadows = Shadows::new(&wavefront.hits);
        shadows.batch.active = rays;
        for group in wavefront.groups.iter().filter(|group| group.lanes_of(rays) != 0) {
            let shadow_ray = self.shadow_rays(light, wavefront, group);
            for (lane, ray) in group.rays().filter(|(_, ray)| rays >> ray & 1 == 1) {
                let ShadowRay { origin, direction, limit, from } = shadow_ray(lane, ray);
                shadows.batch.origins.set(ray, origin);
                shadows.batch.directions.set(ray, direction.as_vec3());
                shadows.batch.from[ray] = from.unwrap_or(NO_PRIMITIVE);
                shadows.limits[ray] = limit;
            }
        }
        shadows.unoccluded(&self.tracer.bvh)
    }

    /// The shadow rays of a group, by lane and ray.
    pub fn shadow_rays(
        &self,
        light: usize,
        wavefront: &Wavefront<S>,
        group: &LaneGroup<S>,
    ) -> impl Fn(usize, usize) -> ShadowRay {
        let (point, _) = group.geometry();
        let [points, origins] = [point, group.outside(point, 0)].map(vectors_of_lanes::<S::Lanes>);
        let outward = |bent: &Bent<S>| primal_vector::<S>(bent.outward);
        let outward = group.bent.as_ref().map(outward).map(vectors_of_lanes::<S::Lanes>);
        move |lane, ray| {
            let towards = self.tracer.illuminate(light, points[lane]);
            let is_before =
                |outward: [DVec3; MAX_LANES]| outward[lane].dot(towards.direction) > 0.0;
            ShadowRay {
                origin: origins[lane].as_vec3(),
                direction: towards.direction,
                limit: towards.distance as f32,
                from: group.starts_on(wavefront, ray).filter(|_| outward.is_none_or(is_before)),
            }
        }
    }
}

/// The rays of a packet from surfaces to what shines.
pub struct Shadows {
    pub batch: Batch,
    /// By ray: where they end, in lengths of their directions.
    pub limits: [f32; PACKET_RAYS],
    /// By ray: what shines, if it is a primitive, or [`NO_PRIMITIVE`].
    pub targets: [u32; PACKET_RAYS],
}

impl Shadows {
    /// None yet, from what was hit.
    pub fn new(hits: &PacketHits) -> Self {
        let targets = [NO_PRIMITIVE; PACKET_RAYS];
        Self { batch: Batch::from(hits), limits: [0.0; PACKET_RAYS], targets }
    }

    /// A bit for each ray that nothing stands in the way of.
    pub fn unoccluded(&self, bvh: &Bvh) -> u64 {
        let Self { batch, limits, targets } = self;
        count(|counts| &counts.shadow_rays, u64::from(batch.active.count_ones()));
        batch.active & !bvh.occluded_batch(batch, limits, targets)
    }
}

/// A ray from a surface to a light.
pub struct ShadowRay {
    pub origin: glam::Vec3,
    pub direction: DVec3,
    /// The distance to the light.
    pub limit: f32,
    /// The primitive that the ray cannot meet, because it starts there and leaves it.
    pub from: Option<u32>,
}

impl<S: Number> LaneGroup<S> {
    /// The values of the surface points and of their normals.
    pub fn values(&self) -> (Vec3<S::Lanes>, Vec3<S::Lanes>) {
        (primal_vector::<S>(self.surface.point), primal_vector::<S>(self.surface.normal))
    }

    /// A bit for each lane whose surface is seen from the side that faces a light: from behind, a
    /// light brings nothing, whatever is in its way. A normal that is not a number faces every light,
    /// so that it shows in the image.
    #[inline]
    fn facing(&self, normal: Vec3<S::Lanes>, to_light: Vec3<S::Lanes>) -> u32 {
        !S::Lanes::mask_bits(normal.dot(to_light).cmple(S::Lanes::ZERO)) & self.alive
    }

    /// Where shadow rays start, and the values of the normals that geometry has there, whatever it is
    /// shaded with.
    #[inline]
    pub(super) fn geometry(&self) -> (Vec3<S::Lanes>, Vec3<S::Lanes>) {
        match &self.bent {
            None => self.values(),
            Some(Bent { curved, outward }) => (*curved, primal_vector::<S>(*outward)),
        }
    }

    /// A bit for each lane whose shadow ray may meet the primitive that it starts on: spheres and shapes
    /// have points before others of their own, and triangles that are smooth or have a normal map face lights
    /// that are behind them.
    #[inline]
    fn may_meet_themselves(&self, to_light: Vec3<S::Lanes>) -> u32 {
        match (self.kind, &self.bent) {
            (Kind::Triangle, None) => 0,
            (Kind::Triangle, Some(bent)) => {
                self.alive & !self.facing(primal_vector::<S>(bent.outward), to_light)
            }
            (Kind::Sphere | Kind::Custom, _) => self.alive,
        }
    }

    /// Adds rays from some lanes to what shines in these directions at these distances, which may be infinite. They are
    /// as many times as long as the directions.
    pub(super) fn add_shadow_rays(
        &self,
        batch: &mut Batch,
        lanes: u32,
        direction: Vec3<S::Lanes>,
        distance: S::Lanes,
    ) {
        if !self.is_smooth {
            return self.add_to(batch, lanes, 0, direction);
        }
        let (flat, (start, _)) = (self.values().0, self.geometry());
        // Seen from above the triangle it shines in another direction, unless it is infinitely far away.
        let lifted = direction - (start - flat) / distance;
        set_vectors::<S::Lanes>(&mut batch.origins, self.first, lanes, self.outside(start, 0));
        set_vectors::<S::Lanes>(&mut batch.directions, self.first, lanes, lifted);
        for lane in rays((lanes & self.may_meet_themselves(direction)).into()) {
            batch.from[self.first + lane] = NO_PRIMITIVE;
        }
        batch.active |= u64::from(lanes) << self.first;
    }

    /// Where rays that go on start. Rays in the lanes `behind` leave on the side that the viewer does not
    /// see.
    pub fn origins(&self, behind: u32) -> Vec3<S::Lanes> {
        let (point, _) = self.values();
        self.outside(point, behind)
    }

    /// Places beside points, far enough outside for rays not to meet the surface that they leave.
    fn outside(&self, point: Vec3<S::Lanes>, behind: u32) -> Vec3<S::Lanes> {
        let (_, outward) = self.geometry();
        let offset = outward * (self.reach() * S::Lanes::from_f64(SURFACE_ERROR));
        let offset = select(S::Lanes::mask_from_bits(behind), -offset, offset);
        point + offset
    }

    /// The largest numbers that went into the surface points.
    #[inline]
    fn reach(&self) -> S::Lanes {
        let (point, _) = self.values();
        let origin = primal_vector::<S>(self.ray.origin);
        let depth = (point - origin).dot(primal_vector::<S>(self.ray.direction));
        point.abs().max_element().max(depth)
    }
}
