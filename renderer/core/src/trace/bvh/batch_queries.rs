//! What rays that have nothing in common meet, many at once.

use std::cell::Cell;

use super::batch::Batch;
use super::batch_traversal::{Sixteen, Waiting};
use super::packet::{NO_PRIMITIVE, PACKET_RAYS, PacketHits, rays};
use super::{Bvh, Hit};

thread_local! {
    /// An empty stack, which has grown.
    static STACK: Cell<Vec<Waiting>> = const { Cell::new(Vec::new()) };
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
        let mut stack = STACK.take();
        let (limits, targets) = ([f32::INFINITY; PACKET_RAYS], [NO_PRIMITIVE; PACKET_RAYS]);
        batch.sixteens(|chosen| {
            let mut sixteen = Sixteen::new(batch, chosen, &limits, &targets);
            self.triangles.visit_sixteen::<false>(&mut sixteen, &mut stack);
            for (&ray, hit) in chosen.iter().zip(sixteen.hits(chosen.len())) {
                if let Some((primitive, distance)) = hit {
                    hits.set(ray, Hit { primitive, distance, leaves: false });
                }
            }
        });
        STACK.set(stack);
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
        let mut stack = STACK.take();
        batch.sixteens(|chosen| {
            let mut sixteen = Sixteen::new(batch, chosen, limits, targets);
            self.triangles.visit_sixteen::<true>(&mut sixteen, &mut stack);
            for (&ray, hit) in chosen.iter().zip(sixteen.hits(chosen.len())) {
                occluded |= u64::from(hit.is_some()) << ray;
            }
        });
        STACK.set(stack);
        occluded
    }
}
