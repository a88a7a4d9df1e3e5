//! Packets: up to 64 rays with a common origin, traced together.
//!
//! Measured along an axis on which every ray advances, a ray is two slopes and the packet is a
//! rectangle of slopes: a frustum. Boxes are tested against its four sides, and only what survives
//! against the rays themselves, 16 at a time.

use bytemuck::{Pod, bytes_of, cast, pod_read_unaligned};
use glam::Vec3;
use wide::{f32x4, f32x8, f32x16, u32x16};

use super::Hit;
use super::single::origin_error;
use super::triangle_test::{TriangleTest, minor_axes};

/// How many rays a packet has: a tile of 8 x 8 pixels.
pub const PACKET_RAYS: usize = 64;

/// The `primitive` of a ray that meets nothing, or that starts on no primitive.
pub const NO_PRIMITIVE: u32 = u32::MAX;

/// How many rays are computed side by side.
const LANES: usize = 16;

/// How many times [`LANES`] a packet is.
pub const GROUPS: usize = PACKET_RAYS / LANES;

/// The steepest slope against its major axis that a packet may have.
const STEEPEST: f32 = 2.0;

/// A vector for each ray of a packet, such as its direction. What stands in inactive rays does not
/// matter.
///
/// Sixteen rays in a row are computed side by side: the more compact each sixteen are, the better.
/// [`tile_position`] gives an order of the pixels of a tile.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct PacketVectors {
    /// The x coordinate of each ray's vector.
    pub x: [f32; PACKET_RAYS],
    /// The y coordinate of each ray's vector.
    pub y: [f32; PACKET_RAYS],
    /// The z coordinate of each ray's vector.
    pub z: [f32; PACKET_RAYS],
}

impl PacketVectors {
    /// A packet of zero vectors.
    pub const ZERO: Self =
        Self { x: [0.0; PACKET_RAYS], y: [0.0; PACKET_RAYS], z: [0.0; PACKET_RAYS] };

    /// The vector of one ray.
    #[inline]
    pub fn get(&self, ray: usize) -> Vec3 {
        Vec3::new(self.x[ray], self.y[ray], self.z[ray])
    }

    /// Sets the vector of one ray.
    #[inline]
    pub fn set(&mut self, ray: usize, vector: Vec3) {
        [self.x[ray], self.y[ray], self.z[ray]] = vector.to_array();
    }
}

/// The column and the row, within a tile of 8 x 8 pixels, of a ray of a packet: each sixteen rays
/// are a block of 4 x 4 pixels.
#[inline]
pub const fn tile_position(ray: usize) -> (usize, usize) {
    let (group, lane) = (ray / LANES, ray % LANES);
    (group % 2 * 4 + lane % 4, group / 2 * 4 + lane / 4)
}

/// The ray that has this [`tile_position`].
#[inline]
pub const fn ray_at(column: usize, row: usize) -> usize {
    (row / 4 * 2 + column / 4) * LANES + row % 4 * 4 + column % 4
}

/// The rays whose bits are set.
#[inline]
pub fn rays(mut bits: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let ray = (bits != 0).then_some(bits.trailing_zeros() as usize)?;
        bits &= bits - 1;
        Some(ray)
    })
}

/// A bit for each of the first rays of a packet.
#[inline]
pub fn first_rays(count: usize) -> u64 {
    if count < PACKET_RAYS { (1 << count) - 1 } else { u64::MAX }
}

/// What the rays of a packet meet first.
#[derive(Clone, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct PacketHits {
    /// By ray: the distance from the origin in lengths of its direction; infinite if it meets
    /// nothing.
    pub distance: [f32; PACKET_RAYS],
    /// The index of the primitive that each ray hits, or [`NO_PRIMITIVE`].
    pub primitive: [u32; PACKET_RAYS],
    /// A bit for each ray that meets a sphere from its inside.
    pub leaves: u64,
}

impl PacketHits {
    /// No ray meets anything.
    pub const NONE: Self = Self {
        distance: [f32::INFINITY; PACKET_RAYS],
        primitive: [NO_PRIMITIVE; PACKET_RAYS],
        leaves: 0,
    };

    /// What one ray meets.
    #[inline]
    pub fn get(&self, ray: usize) -> Option<Hit> {
        let (primitive, distance) = (self.primitive[ray], self.distance[ray]);
        let leaves = self.leaves >> ray & 1 != 0;
        (primitive != NO_PRIMITIVE).then_some(Hit { primitive, distance, leaves })
    }

    /// A bit for each ray that meets something.
    #[inline]
    pub fn met(&self) -> u64 {
        let none = u32x16::splat(NO_PRIMITIVE);
        bits(&load(&self.primitive).map(|ids: u32x16| f32x16::from_bits(ids.simd_ne(none))))
    }

    /// Notes what one ray meets.
    #[inline]
    pub fn set(&mut self, ray: usize, hit: Hit) {
        self.distance[ray] = hit.distance;
        self.primitive[ray] = hit.primitive;
        self.leaves = self.leaves & !(1 << ray) | u64::from(hit.leaves) << ray;
    }
}

/// The rays of a packet, by groups of lanes.
pub type Rays<T> = [T; GROUPS];

/// A packet, prepared.
pub struct Packet {
    pub origin: Vec3,
    /// How far a difference to the origin may be from the truth.
    pub slack: f32,
    /// The axis along which depth is measured, and 1 if it points along it, else -1.
    pub major: usize,
    pub sign: f32,
    /// By minor axis: how much a ray advances for each unit of depth. Inactive rays repeat an active
    /// one.
    pub slope: [Rays<f32x16>; 2],
    /// Distance, in lengths of the direction, for each unit of depth.
    pub scale: Rays<f32x16>,
    /// By minor axis: the least and the greatest slope of each group, and of all.
    pub group_range: [Rays<[f32; 2]>; 2],
    pub range: [[f32; 2]; 2],
    /// Before which depth a hit counts; -1 for rays that want none.
    pub depth: Rays<f32x16>,
    /// The greatest of `depth`.
    pub far: f32,
}

impl Packet {
    /// Prepares a packet of the active rays; nothing if no axis serves all of them.
    pub fn new(origin: Vec3, directions: &PacketVectors, active: u64, limit: f32) -> Option<Self> {
        let groups: [Rays<f32x16>; 3] =
            [load(&directions.x), load(&directions.y), load(&directions.z)];
        let mut live = [f32x16::ZERO; GROUPS];
        for g in 0..GROUPS {
            let length = groups[0][g].abs() + groups[1][g].abs() + groups[2][g].abs();
            live[g] = mask(active >> (LANES * g)) & length.is_finite() & length.simd_gt(0.0);
        }
        let bits = bits(&live);
        if bits == 0 {
            return None;
        }
        let first = TriangleTest::new(origin, directions.get(bits.trailing_zeros() as usize))?;
        let (major, sign) = (first.major, first.sign);
        let minor = minor_axes(major);

        let mut coherent = f32x16::from_bits(u32x16::splat(u32::MAX));
        let mut slope = [[f32x16::ZERO; GROUPS]; 2];
        let mut scale = slope[0];
        let mut depth = slope[0];
        for g in 0..GROUPS {
            let length = groups[major][g] * f32x16::splat(sign);
            coherent &= length.simd_ge(f32::MIN_POSITIVE) | !live[g];
            scale[g] = f32x16::ONE / length;
            depth[g] = live[g].select(f32x16::splat(limit) * length, f32x16::splat(-1.0));
            for i in 0..2 {
                let ratio = groups[minor[i]][g] * scale[g];
                slope[i][g] = live[g].select(ratio, f32x16::splat(first.slope[i]));
                coherent &= slope[i][g].abs().simd_le(STEEPEST);
            }
        }
        if !coherent.all() {
            return None;
        }
        let group_range = [ranges(&slope[0]), ranges(&slope[1])];
        let range = group_range.map(|groups: Rays<[f32; 2]>| {
            groups.into_iter().fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], group| {
                [low.min(group[0]), high.max(group[1])]
            })
        });
        let slack = origin_error(origin);
        let mut packet =
            Self { origin, slack, major, sign, slope, scale, group_range, range, depth, far: 0.0 };
        packet.update_far();
        Some(packet)
    }

    /// Recomputes the greatest depths; to be called when `depth` has changed.
    #[inline]
    pub fn update_far(&mut self) {
        let [a, b, c, d] = self.depth;
        self.far = greatest(a.fast_max(b).fast_max(c.fast_max(d)));
    }

    /// One ray, prepared for triangles.
    pub fn triangle_test(&self, group: usize, lane: usize) -> TriangleTest {
        TriangleTest {
            origin: self.origin,
            major: self.major,
            sign: self.sign,
            slope: self.slope.map(|slope| slope[group].as_array()[lane]),
            scale: self.scale[group].as_array()[lane],
        }
    }
}

/// What a packet looks for.
pub trait Goal {
    /// Takes hits at `depth` on a primitive over. To be called with hits that are nearer than
    /// `packet.depth`, which it changes.
    fn record(
        &mut self,
        packet: &mut Packet,
        group: usize,
        hit: f32x16,
        depth: f32x16,
        primitive: u32,
    );
}

/// The nearest primitive of each ray.
pub struct Nearest {
    pub primitives: Rays<u32x16>,
}

impl Goal for Nearest {
    #[inline]
    fn record(
        &mut self,
        packet: &mut Packet,
        group: usize,
        hit: f32x16,
        depth: f32x16,
        primitive: u32,
    ) {
        packet.depth[group] = hit.select(depth, packet.depth[group]);
        self.primitives[group] =
            hit.to_bits().select(u32x16::splat(primitive), self.primitives[group]);
    }
}

/// Whether anything but one primitive is in the way of each ray.
pub struct Occlusion {
    /// The primitive that does not count.
    pub from: Rays<u32x16>,
    /// A mask of the rays in whose way something is.
    pub occluded: Rays<f32x16>,
}

impl Goal for Occlusion {
    #[inline]
    fn record(
        &mut self,
        packet: &mut Packet,
        group: usize,
        hit: f32x16,
        _: f32x16,
        primitive: u32,
    ) {
        let counts = f32x16::from_bits(self.from[group].simd_ne(u32x16::splat(primitive)));
        let hit = hit & counts;
        self.occluded[group] |= hit;
        packet.depth[group] = hit.select(f32x16::splat(-1.0), packet.depth[group]);
    }
}

/// By groups of lanes. The bytes are read as lanes in one go: an array that is moved first leaves the
/// processor waiting for its parts.
#[inline]
pub fn load<T: Pod, V: Pod>(values: &[T; PACKET_RAYS]) -> Rays<V> {
    pod_read_unaligned(bytes_of(values))
}

/// A bit for each lane that is all ones.
#[inline]
pub fn bits(lanes: &Rays<f32x16>) -> u64 {
    lanes
        .iter()
        .enumerate()
        .fold(0, |bits, (g, lanes)| bits | u64::from(lanes.to_bitmask()) << (LANES * g))
}

/// All ones in the lanes whose bits are set.
#[inline]
fn mask(bits: u64) -> f32x16 {
    const BIT: u32x16 = {
        let mut bit = [0; LANES];
        let mut lane = 0;
        while lane < LANES {
            bit[lane] = 1 << lane;
            lane += 1;
        }
        u32x16::new(bit)
    };
    f32x16::from_bits((u32x16::splat(bits as u32) & BIT).simd_eq(BIT))
}

/// The greatest lane.
#[inline]
pub fn greatest(lanes: f32x16) -> f32 {
    let [a, b]: [f32x4; 2] = cast(halve(lanes));
    let [a, b, c, d] = a.fast_max(b).to_array();
    let max = |a: f32, b: f32| if a > b { a } else { b };
    max(max(a, b), max(c, d))
}

/// The least and the greatest lane of each group.
#[inline]
fn ranges(groups: &Rays<f32x16>) -> Rays<[f32; 2]> {
    let [a, b, c, d] = *groups;
    let columns = f32x8::transpose([-a, a, -b, b, -c, c, -d, d].map(halve));
    let [e, f, g, h, i, j, k, l] = columns;
    let all = e.fast_max(f).fast_max(g.fast_max(h)).fast_max(i.fast_max(j).fast_max(k.fast_max(l)));
    let ranges: Rays<[f32; 2]> = cast(all);
    ranges.map(|[low, high]| [-low, high])
}

/// The greater of each two lanes that are eight apart.
#[inline]
fn halve(lanes: f32x16) -> f32x8 {
    let [a, b]: [f32x8; 2] = cast(lanes);
    a.fast_max(b)
}
