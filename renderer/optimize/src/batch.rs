//! Which views an iteration looks at.

use super::random::mixed;

/// A few of the views in each iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Batch {
    /// How many views; at least 1.
    pub size: usize,
    /// What the order follows from.
    pub seed: u64,
}

impl Batch {
    /// The views of an iteration, of `count`, in ascending order.
    ///
    /// All views take their turn before one comes again: iterations cut pieces from a row of shuffled
    /// decks, each of which follows from the seed and its number. So an iteration has the same views
    /// whether the run was interrupted before or not.
    pub fn views(self, iteration: u64, count: usize) -> Vec<usize> {
        let size = self.size.min(count);
        let (first, count) = (iteration * size as u64, count as u64);
        let mut views: Vec<usize> = Vec::with_capacity(size);
        let (mut deck, mut number) = (Vec::new(), None);
        for place in first..first + size as u64 {
            if number != Some(place / count) {
                number = Some(place / count);
                deck = self.deck(place / count, count as usize);
            }
            let view = deck[(place % count) as usize];
            // At the seam of two decks a view may be in both: its next turn comes soon enough.
            let missing = || (0..count as usize).find(|other| !views.contains(other));
            let view = if views.contains(&view) { missing().unwrap_or(view) } else { view };
            views.push(view);
        }
        views.sort_unstable();
        views
    }

    /// How many iterations see all of `count` views.
    pub fn epoch(self, count: usize) -> usize {
        count.div_ceil(self.size)
    }

    /// A shuffled deck of views (Fisher and Yates).
    fn deck(self, number: u64, count: usize) -> Vec<usize> {
        let mut deck: Vec<usize> = (0..count).collect();
        let mut state = mixed(self.seed ^ mixed(number));
        for last in (1..count).rev() {
            state = mixed(state);
            deck.swap(last, (state % (last as u64 + 1)) as usize);
        }
        deck
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_view_takes_its_turn() {
        for (size, count) in [(1, 1), (1, 8), (3, 8), (8, 8), (20, 8), (5, 7)] {
            for seed in 0..4 {
                let batch = Batch { size, seed };
                let mut seen = vec![0; count];
                for iteration in 0..400 {
                    let views = batch.views(iteration, count);
                    assert_eq!(views.len(), size.min(count));
                    assert!(views.is_sorted_by(|a, b| a < b), "{views:?}");
                    views.iter().for_each(|&view| seen[view] += 1);
                }
                let mean = 400.0 * size.min(count) as f64 / count as f64;
                let even = seen.iter().all(|&seen| (f64::from(seen) / mean - 1.0).abs() < 0.3);
                assert!(even, "{size} of {count}: {seen:?}");
            }
        }
        let orders: Vec<_> = (0..8).map(|i| Batch { size: 1, seed: 0 }.views(i, 8)[0]).collect();
        let others: Vec<_> = (8..16).map(|i| Batch { size: 1, seed: 0 }.views(i, 8)[0]).collect();
        assert_ne!(orders, others);
    }
}
