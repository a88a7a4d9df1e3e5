//! Rays that have nothing in common, many at once.

use glam::Vec3;
use wide::f32x16;

use super::batch_traversal::{Found, Sixteen};
use super::packet::{
    GROUPS, NO_PRIMITIVE, PACKET_RAYS, PacketHits, PacketVectors, bits, load, rays,
};
use super::{Bvh, Hit};

/// Rays of a packet with origins of their own.
pub struct Batch {
    /// Where the rays start.
    pub origins: PacketVectors,
    /// Where they go.
    pub directions: PacketVectors,
    /// By ray: the flat primitive that it starts on, or [`NO_PRIMITIVE`].
    pub from: [u32; PACKET_RAYS],
    /// A bit for each ray that there is.
    pub active: u64,
}

/// No rays.
impl Default for Batch {
    fn default() -> Self {
        Self {
            origins: PacketVectors::ZERO,
            directions: PacketVectors::ZERO,
            from: [NO_PRIMITIVE; PACKET_RAYS],
            active: 0,
        }
    }
}

impl Batch {
    fn ray(&self, ray: usize) -> (Vec3, Vec3, Option<u32>) {
        let from = Some(self.from[ray]).filter(|&from| from != NO_PRIMITIVE);
        (self.origins.get(ray), self.directions.get(ray), from)
    }

    /// Calls `visit` with up to sixteen rays at a time, those that go into one octant side by side.
    fn sixteens(&self, mut visit: impl FnMut(&[usize])) {
        let PacketVectors { x, y, z } = &self.directions;
        let [x, y, z] = [x, y, z].map(|along| {
            let groups: [f32x16; GROUPS] = load(along);
            bits(&groups)
        });
        let mut order = [0; PACKET_RAYS];
        let mut count = 0;
        for octant in 0..8 {
            let side = |axis: u32, negative: u64| match octant >> axis & 1 {
                0 => !negative,
                _ => negative,
            };
            for ray in rays(self.active & side(0, x) & side(1, y) & side(2, z)) {
                order[count % PACKET_RAYS] = ray;
                count += 1;
            }
        }
        order[..count].chunks(16).for_each(&mut visit);
    }
}

impl Bvh {
    /// Whether sixteen rays at a time pay: where all primitives are triangles in a tree.
    fn takes_sixteen(&self) -> bool {
        !self.triangles.nodes.is_empty()
            && self.spheres.leaves.is_empty()
            && self.customs.leaves.is_empty()
    }

    /// The nearest primitives along rays: what [`nearest_but`](Self::nearest_but) finds for each of them, but
    /// for primitives that are equally near.
    pub fn nearest_batch(&self, batch: &Batch, hits: &mut PacketHits) {
        if !self.takes_sixteen() {
            for ray in rays(batch.active) {
                let (origin, direction, from) = batch.ray(ray);
                if let Some(hit) = self.nearest_but(from, origin, direction) {
                    hits.set(ray, hit);
                }
            }
            return;
        }
        let mut stack = Vec::new();
        batch.sixteens(|chosen| {
            let mut sixteen = Sixteen::new(batch, chosen, |_| f32::INFINITY);
            self.triangles.visit_sixteen(&mut sixteen, &mut stack, |found, scale| {
                let Found { lane, depth, primitive } = found;
                let ray = chosen[lane];
                if primitive == batch.from[ray] {
                    return None;
                }
                hits.set(ray, Hit { primitive, distance: depth * scale, leaves: false });
                Some(depth)
            });
        });
    }

    /// A bit for each ray that meets anything before its limit, which is in lengths of its direction, but the
    /// flat primitive that it starts on, and its target, of any kind.
    pub fn occluded_batch(
        &self,
        batch: &Batch,
        limits: &[f32; PACKET_RAYS],
        targets: &[u32; PACKET_RAYS],
    ) -> u64 {
        let counts_not =
            |ray: usize, primitive| primitive == targets[ray] || primitive == batch.from[ray];
        let mut occluded = 0;
        if !self.takes_sixteen() {
            for ray in rays(batch.active) {
                let (origin, direction, _) = batch.ray(ray);
                let is = self.is_occluded_but(origin, direction, limits[ray], |primitive| {
                    counts_not(ray, primitive)
                });
                occluded |= u64::from(is) << ray;
            }
            return occluded;
        }
        let mut stack = Vec::new();
        batch.sixteens(|chosen| {
            let mut sixteen = Sixteen::new(batch, chosen, |ray| limits[ray]);
            self.triangles.visit_sixteen(&mut sixteen, &mut stack, |found, _| {
                let ray = chosen[found.lane];
                if counts_not(ray, found.primitive) {
                    return None;
                }
                occluded |= 1 << ray;
                Some(-1.0)
            });
        });
        occluded
    }
}
