//! Questions about packets.

use glam::Vec3;
use wide::{f32x16, u32x16};

use super::packet::{
    GROUPS, NO_PRIMITIVE, Nearest, Occlusion, PACKET_RAYS, Packet, PacketHits, PacketVectors, bits,
    load, rays,
};
use super::packet_triangles::test_leaf;
use super::single_leaf::SingleLeaf;
use super::tree::Tree;
use super::{Bvh, Hit};

impl Bvh {
    /// The nearest primitives along rays with a common origin, such as those of the camera through
    /// a tile of 8 x 8 pixels. `active` has a bit for each ray that is wanted.
    ///
    /// It finds what [`nearest`](Self::nearest) finds for each ray, but for primitives that are
    /// equally near. It is faster the closer the directions are, and no faster if no coordinate axis
    /// is within about 60 degrees of all of them.
    pub fn nearest_packet(
        &self,
        origin: Vec3,
        directions: &PacketVectors,
        active: u64,
    ) -> PacketHits {
        let mut hits = PacketHits::NONE;
        self.nearest_packet_into(origin, directions, active, &mut hits);
        hits
    }

    /// [`nearest_packet`](Self::nearest_packet), over hits that exist: moving them would take as long
    /// as a node of the tree.
    pub fn nearest_packet_into(
        &self,
        origin: Vec3,
        directions: &PacketVectors,
        active: u64,
        hits: &mut PacketHits,
    ) {
        hits.leaves = 0;
        let Some(mut packet) = Packet::new(origin, directions, active, f32::INFINITY) else {
            *hits = PacketHits::NONE;
            for ray in rays(active) {
                if let Some(hit) = self.nearest(origin, directions.get(ray)) {
                    hits.set(ray, hit);
                }
            }
            return;
        };

        let mut goal = Nearest { primitives: [u32x16::splat(NO_PRIMITIVE); GROUPS] };
        self.triangles.visit_packet::<false>(&mut packet, |leaf, packet| {
            test_leaf(packet, leaf, &mut goal);
        });
        for group in 0..GROUPS {
            let primitives = goal.primitives[group];
            let missed = f32x16::from_bits(primitives.simd_eq(u32x16::splat(NO_PRIMITIVE)));
            let distance = packet.depth[group] * packet.scale[group];
            let distance = missed.select(f32x16::INFINITY, distance);
            let range = 16 * group..16 * (group + 1);
            hits.distance[range.clone()].copy_from_slice(distance.as_array());
            hits.primitive[range].copy_from_slice(primitives.as_array());
        }
        nearest_of(&self.spheres, &mut packet, directions, hits);
        nearest_of(&self.customs, &mut packet, directions, hits);
    }

    /// Which rays with a common origin meet anything but one primitive each, `from`, before `limit`,
    /// which is in lengths of their directions; a bit for each. [`NO_PRIMITIVE`] lets every
    /// primitive count. `active` has a bit for each ray that is wanted.
    ///
    /// It serves shadows of a point light: rays start at the light, directions reach from there to
    /// the surface points, `from` is what these lie on, and `limit` is 1. Seen from the light the
    /// rays are coherent, seen from the surface they are not. Shorten the directions by the error of
    /// the surface points, or move these points off the surface by it.
    pub fn occluded_packet(
        &self,
        origin: Vec3,
        directions: &PacketVectors,
        limit: f32,
        from: &[u32; PACKET_RAYS],
        active: u64,
    ) -> u64 {
        let Some(mut packet) = Packet::new(origin, directions, active, limit) else {
            let occluded = |ray: &usize| {
                let from = Some(from[*ray]).filter(|&from| from != NO_PRIMITIVE);
                self.is_occluded(origin, directions.get(*ray), limit, from)
            };
            return rays(active).filter(occluded).fold(0, |bits, ray| bits | 1 << ray);
        };

        let mut goal = Occlusion { from: load(from), occluded: [f32x16::ZERO; GROUPS] };
        self.triangles.visit_packet::<true>(&mut packet, |leaf, packet| {
            test_leaf(packet, leaf, &mut goal);
        });
        bits(&goal.occluded)
            | occluded_by(&self.spheres, &mut packet, directions)
            | occluded_by(&self.customs, &mut packet, directions)
    }
}

fn nearest_of<L: SingleLeaf>(
    tree: &Tree<L>,
    packet: &mut Packet,
    directions: &PacketVectors,
    hits: &mut PacketHits,
) {
    tree.visit_packet::<false>(packet, |leaf, packet| {
        test_single(packet, directions, leaf, |ray, distance, leaves| {
            hits.set(ray, Hit { primitive: leaf.id(), distance, leaves });
        });
    });
}

/// A bit for each ray that hits a primitive. A ray may start on one and hit it again: it is not flat.
fn occluded_by<L: SingleLeaf>(
    tree: &Tree<L>,
    packet: &mut Packet,
    directions: &PacketVectors,
) -> u64 {
    let mut occluded = 0;
    tree.visit_packet::<true>(packet, |leaf, packet| {
        test_single(packet, directions, leaf, |ray, _, _| occluded |= 1 << ray);
    });
    occluded
}

/// Tests a packet against a leaf of one primitive. `record` takes the ray, the distance and whether the
/// ray leaves the primitive.
fn test_single(
    packet: &mut Packet,
    directions: &PacketVectors,
    leaf: &impl SingleLeaf,
    mut record: impl FnMut(usize, f32, bool),
) {
    for ray in 0..PACKET_RAYS {
        let (group, lane) = (ray / 16, ray % 16);
        let limit = packet.depth[group].as_array()[lane];
        if limit < 0.0 {
            continue;
        }
        let (distance, leaves) = leaf.distance(packet.origin, directions.get(ray));
        let depth = distance / packet.scale[group].as_array()[lane];
        if depth < limit {
            record(ray, distance, leaves);
            packet.depth[group].as_mut_array()[lane] = depth;
        }
    }
    packet.update_far();
}
