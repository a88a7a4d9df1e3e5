//! Which of the many objects of one kind are asked for: vertices, texels, materials, and so on.

use std::ops::Range;

/// Indices that are asked for, in their order, without the others between them: each has a slot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Selection {
    /// In the order of their indices; none overlaps another.
    runs: Vec<Run>,
    count: usize,
    /// Whether nothing is left out, so that each index is its own slot.
    is_whole: bool,
}

/// Indices that follow each other.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Run {
    first: usize,
    count: usize,
    /// The slot of the first.
    slot: usize,
}

impl Selection {
    /// The indices in these ranges, which may overlap, of `total` that there are.
    pub fn new(ranges: impl IntoIterator<Item = Range<usize>>, total: usize) -> Self {
        let mut ranges: Vec<_> = ranges.into_iter().filter(|range| !range.is_empty()).collect();
        ranges.sort_unstable_by_key(|range| (range.start, range.end));
        let mut selection = Self::default();
        for range in ranges {
            let end = selection.runs.last().map_or(0, |run| run.first + run.count);
            let first = range.start.max(end);
            let Some(count) = range.end.checked_sub(first).filter(|&count| count > 0) else {
                continue;
            };
            selection.runs.push(Run { first, count, slot: selection.count });
            selection.count += count;
        }
        selection.is_whole = selection.count == total;
        selection
    }

    /// The slot of an index.
    #[inline]
    pub fn slot(&self, index: usize) -> Option<usize> {
        if self.is_whole {
            return Some(index);
        }
        let run = self.runs[..self.runs.partition_point(|run| run.first <= index)].last()?;
        let offset = index - run.first;
        (offset < run.count).then_some(run.slot + offset)
    }

    /// The slots of indices that follow each other and are all asked for.
    pub fn slots(&self, range: Range<usize>) -> Range<usize> {
        match self.slot(range.start) {
            Some(slot) if !range.is_empty() => slot..slot + range.len(),
            _ => 0..0,
        }
    }

    /// The number of slots.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Returns `true` if no object of the kind is requested.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Returns `true` if all objects of the kind are requested.
    pub fn is_whole(&self) -> bool {
        self.is_whole
    }
}

#[cfg(test)]
mod tests {
    use super::Selection;

    #[test]
    fn what_is_asked_for_has_a_slot_each() {
        let selection = Selection::new([7..9, 2..4, 3..5, 20..20], 10);
        assert_eq!(selection.count(), 5);
        assert!(!selection.is_whole() && !selection.is_empty());
        let slots: Vec<_> = (0..10).map(|index| selection.slot(index)).collect();
        let (some, none) = (Some::<usize>, None);
        let expected = [none, none, some(0), some(1), some(2), none, none, some(3), some(4), none];
        assert_eq!(slots, expected);
        assert_eq!(selection.slots(2..5), 0..3);
        assert_eq!(selection.slots(7..8), 3..4);
        assert!(Selection::new([0..3, 3..10], 10).is_whole());
        assert!(Selection::new([], 10).is_empty());
    }
}
