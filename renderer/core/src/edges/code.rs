//! What rays meet, in little room.

use crate::primal::known::KnownHit;
use crate::trace::bvh::{NO_PRIMITIVE, PACKET_RAYS, PacketHits};

/// The bit of a primitive that says that a ray leaves a sphere.
pub const LEAVES: u32 = 1 << 31;

/// The primitive where a path has ended.
pub const END: u32 = NO_PRIMITIVE ^ LEAVES;

/// What a ray meets, as one number.
pub fn code(known: &KnownHit) -> u32 {
    code_of(known.primitive, known.leaves)
}

fn code_of(primitive: u32, leaves: bool) -> u32 {
    match primitive {
        NO_PRIMITIVE => NO_PRIMITIVE,
        primitive => primitive | if leaves { LEAVES } else { 0 },
    }
}

/// What the `seen` rays of a packet meet; [`END`] for the others.
pub fn code_packet(hits: &PacketHits, seen: u64) -> [u32; PACKET_RAYS] {
    std::array::from_fn(|ray| match seen >> ray & 1 {
        0 => END,
        _ => code_of(hits.primitive[ray], hits.leaves >> ray & 1 == 1),
    })
}

/// What a [code](code) stands for.
#[inline]
pub fn decode(code: u32) -> KnownHit {
    match code {
        NO_PRIMITIVE => KnownHit { primitive: code, leaves: false, blocked: 0, filters: 0 },
        _ => KnownHit {
            primitive: code & !LEAVES,
            leaves: code & LEAVES != 0,
            blocked: 0,
            filters: 0,
        },
    }
}

/// What the [codes](code) of a packet stand for: the primitives, and a bit for each ray that leaves a sphere.
pub fn decode_packet(codes: &[u32; PACKET_RAYS]) -> ([u32; PACKET_RAYS], u64) {
    let known = |code: u32| decode(if code == END { NO_PRIMITIVE } else { code });
    let leaves = |(ray, &code): (usize, &u32)| u64::from(known(code).leaves) << ray;
    (codes.map(|code| known(code).primitive), codes.iter().enumerate().map(leaves).sum())
}
