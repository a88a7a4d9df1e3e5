//! Rays that have nothing in common.

use glam::Vec3;
use wide::f32x16;

use super::packet::{
    GROUPS, NO_PRIMITIVE, PACKET_RAYS, PacketHits, PacketVectors, bits, load, rays,
};

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

/// No rays yet, from what others have hit.
impl From<&PacketHits> for Batch {
    fn from(hits: &PacketHits) -> Self {
        Self {
            origins: PacketVectors::ZERO,
            directions: PacketVectors::ZERO,
            from: hits.primitive,
            active: 0,
        }
    }
}

impl Batch {
    /// Where a ray starts, where it goes, and what it starts on.
    pub fn ray(&self, ray: usize) -> (Vec3, Vec3, Option<u32>) {
        let from = Some(self.from[ray]).filter(|&from| from != NO_PRIMITIVE);
        (self.origins.get(ray), self.directions.get(ray), from)
    }

    /// Calls `visit` with up to sixteen rays at a time, those that go into one octant side by side.
    pub fn sixteens(&self, mut visit: impl FnMut(&[usize])) {
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
