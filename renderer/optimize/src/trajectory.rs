//! The way of the parameters through a run.

use serde::{Deserialize, Serialize};

use super::Point;

/// Points are kept up to this many.
const MOST_POINTS: usize = 200;
/// And fewer where they are long: all of them together have up to this many elements.
const MOST_NUMBERS: usize = 200_000;

/// Some of the points that a run went through, evenly spaced: every `k`th iteration, where `k`
/// doubles whenever there are too many. A checkpoint holds it, so its size is bounded whatever the
/// length of the run is; parameters of more than 25,000 numbers leave none.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Trajectory {
    stride: u64,
    points: Vec<Point>,
}

impl Trajectory {
    pub fn new() -> Self {
        Self { stride: 1, points: Vec::new() }
    }

    /// Takes in the point of an iteration, unless it lies between those that are kept.
    pub fn record(&mut self, point: &Point) {
        let most = (MOST_NUMBERS / point.x.len().max(1)).min(MOST_POINTS);
        // An evaluation may be repeated when a run is resumed.
        let is_new = self.points.last().is_none_or(|last| last.iteration < point.iteration);
        if most < 8 || !point.iteration.is_multiple_of(self.stride) || !is_new {
            return;
        }
        self.points.push(point.clone());
        if self.points.len() > most {
            self.stride *= 2;
            self.points.retain(|point| point.iteration.is_multiple_of(self.stride));
        }
    }

    /// Forgets all points, whose elements are no longer those of the run.
    pub fn restart(&mut self) {
        *self = Self::new();
    }

    /// The points, in order; the latest of the run among them.
    pub fn finish(mut self, last: &Point) -> Vec<Point> {
        if self.points.last().is_some_and(|point| point.iteration < last.iteration) {
            self.points.push(last.clone());
        }
        self.points
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(iteration: u64, len: usize) -> Point {
        Point { iteration, loss: 1.0, x: vec![iteration as f64; len] }
    }

    #[test]
    fn points_are_evenly_spaced_and_not_too_many() {
        for (n, stride) in [(10, 1), (199, 1), (200, 2), (1000, 8), (100_000, 512)] {
            let mut trajectory = Trajectory::new();
            (0..=n).for_each(|k| trajectory.record(&point(k, 3)));
            assert_eq!(trajectory.stride, stride, "{n}");
            let points = trajectory.finish(&point(n, 3));
            let iterations: Vec<u64> = points.iter().map(|point| point.iteration).collect();
            let mut expected: Vec<u64> = (0..=n).step_by(stride as usize).collect();
            expected.extend((n % stride > 0).then_some(n));
            assert_eq!(iterations, expected);
        }
    }

    #[test]
    fn long_points_are_fewer() {
        let points = |len| {
            let mut trajectory = Trajectory::new();
            (0..=500).for_each(|k| trajectory.record(&point(k, len)));
            trajectory.finish(&point(500, len)).len()
        };
        assert!(points(1000) > 100);
        assert!((8..=21).contains(&points(10_000)), "{}", points(10_000));
        assert_eq!(points(25_001), 0);
    }
}
