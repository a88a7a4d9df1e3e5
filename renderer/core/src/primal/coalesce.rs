//! Lanes with an index in common.

use ad::{Fields, select};
use bytemuck::{cast_slice, pod_read_unaligned};
use wide::{f32x16, u32x16};

use crate::number::{MAX_LANES, Number};
use crate::trace::bvh::PACKET_RAYS;

/// The lanes of a group by an index, such as that of the primitive they hit. Neighbours mostly share
/// it, so that what belongs to an index is gathered, and cotangents that go to it are added, once.
#[derive(Clone, Copy, Debug)]
pub struct Coalesced {
    /// An index, and a bit for each of its lanes; in the order of their first lanes.
    shares: [(u32, u32); MAX_LANES],
    count: usize,
}

impl Coalesced {
    /// Sorts the lanes in `alive` by the indices of their rays, the first of which is that of lane 0.
    #[inline]
    pub fn new(indices: &[u32; PACKET_RAYS], first: usize, alive: u32) -> Self {
        // As many as a vector holds: near the end of the packet, those before the lanes too.
        let start = first.min(PACKET_RAYS - MAX_LANES);
        let before = first - start;
        let indices: u32x16 = pod_read_unaligned(cast_slice(&indices[start..start + MAX_LANES]));
        let mut coalesced = Self { shares: [(0, 0); MAX_LANES], count: 0 };
        let mut rest = alive << before;
        while rest != 0 {
            let index = indices.as_array()[rest.trailing_zeros() as usize % MAX_LANES];
            let same = f32x16::from_bits(indices.simd_eq(u32x16::splat(index)));
            let lanes = same.to_bitmask() & rest;
            coalesced.push(index, lanes >> before);
            rest &= !lanes;
        }
        coalesced
    }

    /// Lanes that have one index.
    pub fn all(index: usize, lanes: u32) -> Self {
        let mut coalesced = Self { shares: [(0, 0); MAX_LANES], count: 0 };
        coalesced.push(index as u32, lanes);
        coalesced
    }

    /// The lanes by what `f` makes of their index.
    #[inline]
    pub fn map(&self, f: impl Fn(usize) -> u32) -> Self {
        let mut mapped = Self { shares: [(0, 0); MAX_LANES], count: 0 };
        for (index, lanes) in self.iter() {
            let index = f(index);
            match mapped.shares[..mapped.count].iter_mut().find(|share| share.0 == index) {
                Some(share) => share.1 |= lanes,
                None => mapped.push(index, lanes),
            }
        }
        mapped
    }

    #[inline]
    fn push(&mut self, index: u32, lanes: u32) {
        self.shares[self.count % MAX_LANES] = (index, lanes);
        self.count += 1;
    }

    /// Each index, with a bit for each of its lanes.
    #[inline]
    pub fn iter(&self) -> impl Iterator<Item = (usize, u32)> {
        self.shares[..self.count].iter().map(|&(index, lanes)| (index as usize, lanes))
    }

    /// A bit for each lane for whose index `is` holds.
    #[inline]
    pub fn lanes_where(&self, is: impl Fn(usize) -> bool) -> u32 {
        self.iter().filter(|&(index, _)| is(index)).fold(0, |bits, (_, lanes)| bits | lanes)
    }

    /// Puts what `value` gives for an index into its lanes. The other lanes get that of the first
    /// index.
    #[inline]
    pub fn gather<S: Number, T: Fields<S>>(&self, value: impl Fn(usize) -> T) -> T {
        let mut gathered = value(self.shares[0].0 as usize);
        for (index, lanes) in self.iter().skip(1) {
            gathered = select_lanes::<S, T>(lanes, &value(index), &gathered);
        }
        gathered
    }
}

/// The numbers of `if_true` in the lanes whose bits are set, else those of `if_false`.
#[inline(always)]
pub fn select_lanes<S: Number, T: Fields<S>>(lanes: u32, if_true: &T, if_false: &T) -> T {
    let mask = S::mask(lanes);
    T::from_fn(&mut |index| select(mask, if_true.number(index), if_false.number(index)))
}

#[cfg(test)]
mod tests {
    use ad::lanes::{Lanes, f64x8};

    use super::{Coalesced, PACKET_RAYS};

    #[test]
    fn lanes_are_sorted_by_what_they_share() {
        let lanes = [5, 9, 5, 5, 9, 7, 7, 1];
        let mut indices = [7; PACKET_RAYS];
        for first in [0, 8, 40, PACKET_RAYS - lanes.len()] {
            indices[first..first + lanes.len()].copy_from_slice(&lanes);
            let coalesced = Coalesced::new(&indices, first, 0b0111_1110);
            let shares: Vec<_> = coalesced.iter().collect();
            assert_eq!(shares, [(9, 0b0001_0010), (5, 0b0000_1100), (7, 0b0110_0000)]);
        }

        let coalesced = Coalesced::new(&indices, 0, 0b0111_1110);
        let merged = coalesced.map(|index| u32::from(index > 6));
        assert_eq!(merged.iter().collect::<Vec<_>>(), [(1, 0b0111_0010), (0, 0b0000_1100)]);

        // Lanes that do not count get what the first share gets.
        let gathered = coalesced.gather::<f64x8, f64x8>(|index| f64x8::splat(index as f64));
        assert_eq!(gathered.lanes().as_ref(), [9.0, 9.0, 5.0, 5.0, 9.0, 7.0, 7.0, 9.0]);
    }
}
