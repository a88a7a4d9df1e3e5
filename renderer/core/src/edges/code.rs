//! What rays meet, in little room.

use crate::primal::known::KnownHit;
use crate::trace::bvh::NO_PRIMITIVE;

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
