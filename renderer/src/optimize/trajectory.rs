//! The way of the parameters through a run.

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::variable::element_path;
use super::{Point, Variable};

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

    /// The points, in order; the latest of the run among them.
    pub fn finish(mut self, last: &Point) -> Vec<Point> {
        if self.points.last().is_some_and(|point| point.iteration < last.iteration) {
            self.points.push(last.clone());
        }
        self.points
    }
}

/// A trajectory as JSON: `paths`, one for each element, `target`, the true value of each element
/// or null, and `iterations`, `losses` and `values`, one entry for each point.
pub(super) fn trajectory_json(variables: &[Variable], trajectory: &[Point]) -> Value {
    let len = trajectory.first().map_or(0, |point| point.x.len());
    let paths: Vec<String> = (0..len).map(|i| element_path(variables, i)).collect();
    let target = |variable: &Variable| match &variable.target {
        Some(target) => target.iter().map(|&value| Some(value)).collect(),
        None => vec![None; variable.initial.len()],
    };
    json!({
        "paths": paths,
        "target": variables.iter().flat_map(target).take(len).collect::<Vec<Option<f64>>>(),
        "iterations": trajectory.iter().map(|point| point.iteration).collect::<Vec<_>>(),
        "losses": trajectory.iter().map(|point| point.loss).collect::<Vec<_>>(),
        "values": trajectory.iter().map(|point| &point.x[..]).collect::<Vec<_>>(),
    })
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

    #[test]
    fn json_names_every_element() {
        let mut position = Variable::new("p", vec![0.0, 0.0], 0.1);
        position.target = Some(vec![5.0, 6.0]);
        let variables = [position, Variable::new("q", vec![0.0], 0.1)];
        let json = trajectory_json(&variables, &[point(0, 3), point(7, 3)]);
        assert_eq!(
            json,
            json!({
                "paths": ["p[0]", "p[1]", "q"],
                "target": [5.0, 6.0, null],
                "iterations": [0, 7],
                "losses": [1.0, 1.0],
                "values": [[0.0, 0.0, 0.0], [7.0, 7.0, 7.0]],
            })
        );
    }
}
