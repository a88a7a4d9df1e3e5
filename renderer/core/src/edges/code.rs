//! What rays meet, in little room.

use crate::primal::known::KnownHit;
use crate::trace::bvh::{NO_PRIMITIVE, PACKET_RAYS, PacketHits};

/// The bit of a primitive that says that a ray leaves a sphere.
pub const LEAVES: u32 = 1 << 31;

/// The primitive where a path has ended.
pub const END: u32 = NO_PRIMITIVE ^ LEAVES;

/// What a ray meets, as one number.
pub fn code(known: &KnownHit) -> u32 {
    match known.primitive {
        NO_PRIMITIVE => NO_PRIMITIVE,
        primitive => primitive | if known.leaves { LEAVES } else { 0 },
    }
}

/// What the `seen` rays of a packet meet; [`END`] for the others.
pub fn code_packet(hits: &PacketHits, seen: u64) -> [u32; PACKET_RAYS] {
    let code = |ray: usize| match (seen >> ray & 1, hits.primitive[ray]) {
        (0, _) => END,
        (_, NO_PRIMITIVE) => NO_PRIMITIVE,
        (_, primitive) => primitive | ((hits.leaves >> ray & 1) as u32) << LEAVES.trailing_zeros(),
    };
    std::array::from_fn(code)
}

/// What a [code](code) stands for.
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
    let is_primitive = |code: u32| code != END && code != NO_PRIMITIVE;
    let primitive = |code: u32| if is_primitive(code) { code & !LEAVES } else { NO_PRIMITIVE };
    let leaves = |code: u32| u64::from(is_primitive(code) && code & LEAVES != 0);
    let bits = codes.iter().enumerate().fold(0, |bits, (ray, &code)| bits | leaves(code) << ray);
    (codes.map(primitive), bits)
}
