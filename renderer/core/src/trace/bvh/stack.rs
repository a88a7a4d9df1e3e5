//! The stack of a traversal.

/// How many entries are kept without an allocation: eight-wide trees of a million primitives need
/// about 50.
const INLINE: usize = 64;

/// Something yet to be visited.
#[derive(Clone, Copy, Debug, Default)]
pub struct Entry {
    /// The depth at which its box is entered.
    pub near: f32,
    /// What it is: the meaning is the traversal's.
    pub target: u32,
}

/// A stack of any depth, the first entries of which need no allocation.
pub struct Stack {
    inline: [Entry; INLINE],
    length: usize,
    /// What lies above a full `inline`.
    overflow: Vec<Entry>,
}

impl Stack {
    #[inline]
    pub fn new() -> Self {
        Self { inline: [Entry::default(); INLINE], length: 0, overflow: Vec::new() }
    }

    #[inline]
    pub fn push(&mut self, entry: Entry) {
        match self.inline.get_mut(self.length) {
            Some(place) => {
                *place = entry;
                self.length += 1;
            }
            None => self.overflow.push(entry),
        }
    }

    #[inline]
    pub fn pop(&mut self) -> Option<Entry> {
        if self.length == INLINE
            && let Some(entry) = self.overflow.pop()
        {
            return Some(entry);
        }
        self.length = self.length.checked_sub(1)?;
        self.inline.get(self.length).copied()
    }
}

/// The children of one node, the farthest first.
pub struct Sorted {
    entries: [Entry; 8],
    length: usize,
}

impl Sorted {
    /// Sorts the children whose bits are set.
    #[inline]
    pub fn new(mut bits: u32, entry: impl Fn(usize) -> Entry) -> Self {
        let mut sorted = Self { entries: [Entry::default(); 8], length: 0 };
        while bits != 0 {
            let entry = entry(bits.trailing_zeros() as usize & 7);
            bits &= bits - 1;
            let mut place = sorted.length & 7;
            while place > 0 && sorted.entries[place - 1].near < entry.near {
                sorted.entries[place] = sorted.entries[place - 1];
                place -= 1;
            }
            sorted.entries[place] = entry;
            sorted.length += 1;
        }
        sorted
    }

    #[inline]
    pub fn as_slice(&self) -> &[Entry] {
        &self.entries[..self.length.min(8)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_come_back_in_reverse_order_however_many_there_are() {
        let mut stack = Stack::new();
        for target in 0..3 * INLINE as u32 {
            stack.push(Entry { near: 0.0, target });
        }
        for target in (0..3 * INLINE as u32).rev() {
            assert_eq!(stack.pop().map(|entry| entry.target), Some(target));
        }
        assert!(stack.pop().is_none());
    }

    #[test]
    fn the_farthest_child_comes_first() {
        let near = [3.0, 1.0, 9.0, 4.0, 5.0, 2.0, 6.0, 8.0];
        let sorted = Sorted::new(0b1111_1011, |i| Entry { near: near[i], target: i as u32 });
        let targets: Vec<_> = sorted.as_slice().iter().map(|entry| entry.target).collect();
        assert_eq!(targets, [7, 6, 4, 3, 0, 5, 1]);
    }
}
