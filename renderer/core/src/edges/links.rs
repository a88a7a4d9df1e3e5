//! Sets of links, with a bit for each: most have nothing on them, and are passed by many at a time.

use std::ops::Range;

use crate::trace::bvh::rays;

/// How many columns of samples make a set.
pub const COLUMNS: usize = 64;

/// Links that start at samples side by side: a bit for each sample, of those to the right and of those downwards.
pub type Links = [u64; 2];

/// The links of a set: their columns and axes, column by column, those to the right before those downwards.
pub fn links(set: usize, [right, down]: Links) -> impl Iterator<Item = (usize, usize)> {
    rays(right | down).flat_map(move |at| {
        let is_there = move |&axis: &usize| [right, down][axis] >> at & 1 == 1;
        [0, 1].into_iter().filter(is_there).map(move |axis| (set * COLUMNS + at, axis))
    })
}

/// Which links of some rows have crossings, and where these start in a list.
pub struct Starts {
    /// Row by row: the links that have any, and how many these are in all sets before.
    sets: Vec<(Links, u32)>,
    sets_per_row: usize,
    /// By link that has any: its first crossing; then the number of all.
    firsts: Vec<u32>,
}

impl Starts {
    /// None, of rows of so many samples.
    pub fn new(columns: usize) -> Self {
        Self { sets: Vec::new(), sets_per_row: columns.div_ceil(COLUMNS), firsts: Vec::new() }
    }

    /// Goes on to the next set.
    pub fn next_set(&mut self) {
        self.sets.push(([0; 2], self.firsts.len() as u32));
    }

    /// Adds a link of the last set. They come in the order of [`links`].
    pub fn push(&mut self, column: usize, axis: usize, first: usize) {
        if let Some((links, _)) = self.sets.last_mut() {
            links[axis] |= 1 << (column % COLUMNS);
            self.firsts.push(first as u32);
        }
    }

    /// Says how many crossings there are.
    pub fn finish(&mut self, crossings: usize) {
        self.firsts.push(crossings as u32);
    }

    /// The crossings of a link.
    pub fn of_link(&self, row: usize, column: usize, axis: usize) -> Range<usize> {
        let (links, before) = self.sets[row * self.sets_per_row + column / COLUMNS];
        let at = column % COLUMNS;
        if links[axis] >> at & 1 == 0 {
            return 0..0;
        }
        let earlier = links.map(|links| (links & ((1 << at) - 1)).count_ones());
        let beside = if axis == 1 { links[0] >> at & 1 } else { 0 };
        let index = (before + earlier[0] + earlier[1]) as usize + beside as usize;
        self.firsts[index] as usize..self.firsts[index + 1] as usize
    }

    /// The links with crossings of a set of a row; none beyond its end.
    pub fn links(&self, row: usize, set: usize) -> Links {
        match set < self.sets_per_row {
            true => self.sets[row * self.sets_per_row + set].0,
            false => [0; 2],
        }
    }
}
