//! Rays that go on, side by side: after some depths few do, and in the lanes of their pixels most would not count.

use ad::lanes::Lanes;
use ad::{Fields, Real};

use crate::number::Number;
use crate::trace::bvh::{NO_PRIMITIVE, PACKET_RAYS, PacketHits, rays};

/// Which rays of the wavefront before go on as those of a wavefront.
pub struct Packing {
    /// By ray: the ray of the wavefront before.
    before: [u8; PACKET_RAYS],
    /// By ray of the wavefront before: the ray that it goes on as, if it does.
    after: [u8; PACKET_RAYS],
    count: usize,
}

/// The most numbers that are moved together: those of a ray.
const MOST_NUMBERS: usize = 6;

/// Where there is no ray.
const NONE: u8 = u8::MAX;

impl Packing {
    /// Puts some rays side by side, in their order; nothing if as many blocks of lanes have rays as before.
    pub fn new<S: Number>(chosen: u64) -> Option<Self> {
        let lanes = <S::Lanes as Lanes>::COUNT;
        let all = u64::MAX >> (u64::BITS as usize - lanes);
        let is_filled = |first: &usize| chosen >> first & all != 0;
        let filled = (0..PACKET_RAYS).step_by(lanes).filter(is_filled).count();
        let count = chosen.count_ones() as usize;
        if count.div_ceil(lanes) == filled {
            return None;
        }
        let mut packing = Self { before: [NONE; PACKET_RAYS], after: [NONE; PACKET_RAYS], count };
        for (ray, before) in rays(chosen).enumerate() {
            packing.before[ray] = before as u8;
            packing.after[before] = ray as u8;
        }
        Some(packing)
    }

    /// A bit for each ray.
    pub fn rays(&self) -> u64 {
        (1 << self.count) - 1
    }

    /// The ray that one of the wavefront before goes on as, if it does.
    pub fn after(&self, ray: usize) -> Option<usize> {
        (self.after[ray] != NONE).then_some(self.after[ray].into())
    }

    /// Packs values by ray.
    pub fn pack<T: Copy>(&self, values: &mut [T; PACKET_RAYS]) {
        // Those in front go to places that were read before.
        for (ray, &before) in self.before[..self.count].iter().enumerate() {
            values[ray] = values[usize::from(before) % PACKET_RAYS];
        }
    }

    /// Packs bits by ray.
    pub fn pack_bits(&self, bits: u64) -> u64 {
        let packed = rays(bits).filter_map(|ray| self.after(ray));
        packed.fold(0, |bits, ray| bits | 1 << ray)
    }

    /// Packs what rays hit.
    pub fn pack_hits(&self, hits: &mut PacketHits) {
        self.pack(&mut hits.distance);
        self.pack(&mut hits.primitive);
        hits.distance[self.count..].fill(f32::INFINITY);
        hits.primitive[self.count..].fill(NO_PRIMITIVE);
        hits.leaves = self.pack_bits(hits.leaves);
    }

    /// Packs values by block.
    pub fn pack_blocks<S: Number, T: Fields<S>>(&self, blocks: &mut [T]) {
        let lanes = <S::Lanes as Lanes>::COUNT;
        self.move_blocks(blocks, &self.before, self.count.div_ceil(lanes));
    }

    /// Moves values by block to where the rays were before; those of other rays become zero.
    pub fn unpack_blocks<S: Number, T: Fields<S>>(&self, blocks: &mut [T]) {
        self.move_blocks(blocks, &self.after, blocks.len());
    }

    /// Fills the first blocks with the values of the rays that stand in `from`.
    fn move_blocks<S: Number, T: Fields<S>>(
        &self,
        blocks: &mut [T],
        from: &[u8; PACKET_RAYS],
        filled: usize,
    ) {
        let lanes = <S::Lanes as Lanes>::COUNT;
        // The place after all rays is zero.
        let mut numbers = [[<S::Lane as Real>::ZERO; PACKET_RAYS + 1]; MOST_NUMBERS];
        for (block, first) in blocks.iter().zip((0..).step_by(lanes)) {
            block.visit(&mut |index, number| {
                for lane in 0..lanes {
                    numbers[index][first + lane] = number.lane(lane);
                }
            });
        }
        for (block, from) in blocks.iter_mut().zip(from.chunks(lanes)).take(filled) {
            *block = T::from_fn(&mut |index| {
                S::from_each(|lane| numbers[index][usize::from(from[lane]).min(PACKET_RAYS)])
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use ad::lanes::{Lanes, f64x8};

    use super::Packing;

    #[test]
    fn rays_that_are_packed_come_back_to_their_lanes() {
        let is_chosen = |ray: usize| ray.is_multiple_of(3);
        let chosen = (0..64).filter(|&ray| is_chosen(ray)).fold(0, |bits, ray| bits | 1 << ray);
        let packing = Packing::new::<f64x8>(chosen).unwrap();
        let block = |first: usize| f64x8::from_lanes(|lane| (first + lane) as f64);
        let mut blocks: Vec<f64x8> = (0..64).step_by(8).map(block).collect();
        let number = |blocks: &[f64x8], ray: usize| blocks[ray / 8].lanes().as_ref()[ray % 8];

        packing.pack_blocks::<f64x8, f64x8>(&mut blocks);
        assert!((0..22).all(|ray| number(&blocks, ray) == (3 * ray) as f64));
        assert_eq!((packing.pack_bits(chosen), packing.rays()), (0x3f_ffff, 0x3f_ffff));
        assert_eq!((packing.after(6), packing.after(7)), (Some(2), None));

        packing.unpack_blocks::<f64x8, f64x8>(&mut blocks);
        let expected = |ray: usize| if is_chosen(ray) { ray as f64 } else { 0.0 };
        assert!((0..64).all(|ray| number(&blocks, ray) == expected(ray)));
    }

    #[test]
    fn rays_stay_where_packing_them_leaves_no_block_out() {
        assert!(Packing::new::<f64x8>(0x00ff_00fe).is_none());
        assert!(Packing::new::<f64x8>(0x0007_001f).is_some());
    }
}
