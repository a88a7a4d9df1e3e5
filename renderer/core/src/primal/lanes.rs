//! Numbers between lanes and arrays.

use ad::lanes::Lanes;
use ad::vector::Vector3;
use ad::{Real, Scalar, Vec3, select};
use glam::DVec3;
use wide::f64x8;

use crate::number::MAX_LANES;

/// What `convert` makes of the number in each lane; those beyond the last lane are zero.
#[inline]
fn each_lane<L: Lanes, T: Copy + Default>(x: L, convert: impl Fn(f64) -> T) -> [T; MAX_LANES] {
    let mut numbers = [T::default(); MAX_LANES];
    for (number, x) in numbers.iter_mut().zip(x.lanes().as_ref()) {
        *number = convert(x.to_f64());
    }
    numbers
}

/// The number in each lane, in single precision; those beyond the last lane are zero.
#[inline]
pub fn singles_of_lanes<L: Lanes>(x: L) -> [f32; MAX_LANES] {
    each_lane(x, |x| x as f32)
}

/// The number in each lane, in double precision; those beyond the last lane are zero.
#[inline]
pub fn numbers_of_lanes<L: Lanes>(x: L) -> [f64; MAX_LANES] {
    each_lane(x, |x| x)
}

/// The vector in each lane, in double precision; those beyond the last lane are zero.
#[inline]
pub fn vectors_of_lanes<L: Lanes>(v: Vec3<L>) -> [DVec3; MAX_LANES] {
    let [x, y, z] = [v.x(), v.y(), v.z()].map(numbers_of_lanes);
    std::array::from_fn(|lane| DVec3::new(x[lane], y[lane], z[lane]))
}

/// The vectors side by side.
#[inline]
pub fn lanes_of_vectors<L: Lanes>(vectors: &[DVec3; MAX_LANES]) -> Vec3<L> {
    let along = |axis: usize| L::from_lanes(|lane| L::Element::from_f64(vectors[lane][axis]));
    Vector3::new(along(0), along(1), along(2))
}

/// The numbers side by side.
#[inline]
pub fn lanes_of_numbers<L: Lanes>(numbers: &[f64; MAX_LANES]) -> L {
    L::from_lanes(|lane| L::Element::from_f64(numbers[lane]))
}

/// The sum of the lanes in which `mask` holds, in double precision.
#[inline]
pub fn sum_of_lanes<L: Lanes>(x: L, mask: L::Mask) -> f64 {
    let numbers = numbers_of_lanes(select(mask, x, L::ZERO));
    if L::COUNT == 1 {
        return numbers[0];
    }
    let (low, high) = numbers.split_at(MAX_LANES / 2);
    (f64x8::from(low) + f64x8::from(high)).reduce_add()
}

/// The sum of the vectors in the lanes in which `mask` holds, in double precision.
#[inline]
pub fn sum_of_vectors<L: Lanes>(v: Vec3<L>, mask: L::Mask) -> DVec3 {
    DVec3::new(sum_of_lanes(v.x(), mask), sum_of_lanes(v.y(), mask), sum_of_lanes(v.z(), mask))
}

/// Sets the numbers of the lanes whose bits are set, in single precision.
#[inline]
pub fn set_singles<L: Lanes>(to: &mut [f32], lanes: u32, x: L) {
    let to = &mut to[..L::COUNT];
    let mut after = x;
    if lanes != all_lanes::<L>() {
        let before = L::from_lanes(|lane| Real::from_f64(to[lane].into()));
        after = select(L::mask_from_bits(lanes), x, before);
    }
    to.copy_from_slice(&singles_of_lanes(after)[..L::COUNT]);
}

/// A bit for each lane.
#[inline]
pub fn all_lanes<L: Lanes>() -> u32 {
    u32::MAX >> (32 - L::COUNT)
}
