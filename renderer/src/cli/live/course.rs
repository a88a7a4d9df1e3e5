//! The curves of a run.

use serde_json::{Value, json};

use crate::optimize::{Scale, Variable};

/// Points are kept up to this many: about as many as a curve has pixels.
const MOST_POINTS: usize = 400;
/// Of parameters with more numbers some are kept, evenly spaced.
const MOST_TRACKED: usize = 2000;
/// So many numbers are shown.
const MOST_SHOWN: usize = 8;

/// The loss, and some of the numbers, over the iterations: every `k`th of these, where `k` doubles whenever
/// there are too many.
pub(super) struct Course {
    tracked: Vec<Tracked>,
    stride: u64,
    points: Vec<Point>,
}

/// A number that is kept, by its index among all.
struct Tracked {
    index: usize,
    /// The variable, and its element, that it is.
    of: (usize, usize),
    path: String,
    scale: Scale,
    /// How far it moves on its scale in a step.
    learning_rate: f64,
    initial: f64,
    /// The true value, where that is known.
    truth: Option<f64>,
}

struct Point {
    iteration: u64,
    loss: f64,
    values: Vec<f64>,
}

impl Course {
    /// Curves of variables, each with the shape of its numbers, if it has curves.
    pub fn new(variables: &[Variable], shapes: &[Option<Vec<usize>>]) -> Self {
        let all = variables.iter().zip(shapes).enumerate();
        let all = all.flat_map(|(place, (variable, shape))| {
            let elements = 0..shape.as_ref().map_or(0, |_| variable.initial.len());
            elements.map(move |element| {
                ((place, element), variable, shape.as_deref().unwrap_or_default())
            })
        });
        let count = all.clone().count();
        let tracked = all.step_by(count.div_ceil(MOST_TRACKED).max(1));
        let tracked = tracked.map(|(of, variable, shape)| Tracked {
            index: 0,
            of,
            path: element_path(&variable.path, shape, of.1),
            scale: variable.scale,
            learning_rate: variable.learning_rate[of.1],
            initial: variable.initial[of.1],
            truth: variable.target.as_ref().map(|target| target[of.1]),
        });
        let mut course = Self { tracked: tracked.collect(), stride: 1, points: Vec::new() };
        course.count_anew(variables.iter().map(|variable| variable.initial.len()));
        course
    }

    /// Takes in how many elements variables have from now on.
    pub fn count_anew(&mut self, counts: impl Iterator<Item = usize>) {
        let starts: Vec<usize> = counts
            .scan(0, |end, count| {
                let start = *end;
                *end += count;
                Some(start)
            })
            .collect();
        for tracked in &mut self.tracked {
            tracked.index = starts[tracked.of.0] + tracked.of.1;
        }
    }

    /// Takes in an iteration, unless it lies between those that are kept.
    pub fn record(&mut self, iteration: u64, loss: f64, x: &[f64]) {
        if !iteration.is_multiple_of(self.stride) {
            return;
        }
        let values = self.tracked.iter().map(|tracked| x[tracked.index]).collect();
        self.points.push(Point { iteration, loss, values });
        if self.points.len() > MOST_POINTS {
            self.stride *= 2;
            self.points.retain(|point| point.iteration.is_multiple_of(self.stride));
        }
    }

    /// The curves for the page. The numbers are those that have moved most, in steps of their learning rates.
    pub fn json(&self) -> Value {
        let moved = |place: usize| {
            let Tracked { scale, initial, learning_rate, .. } = self.tracked[place];
            let last = self.points.last().map_or(initial, |point| point.values[place]);
            (scale.place(last) - scale.place(initial)).abs() / learning_rate
        };
        let mut places: Vec<usize> = (0..self.tracked.len()).collect();
        places.sort_by(|&a, &b| moved(b).total_cmp(&moved(a)));
        places.truncate(MOST_SHOWN);
        let number = |&place: &usize| {
            let Tracked { path, truth, .. } = &self.tracked[place];
            let values: Vec<f64> = self.points.iter().map(|point| point.values[place]).collect();
            json!({ "path": path, "truth": truth, "values": values })
        };
        json!({
            "iterations": self.points.iter().map(|point| point.iteration).collect::<Vec<_>>(),
            "losses": self.points.iter().map(|point| point.loss).collect::<Vec<_>>(),
            "numbers": places.iter().map(number).collect::<Vec<_>>(),
        })
    }
}

/// A number of a parameter: `mesh.tree.vertices[17][2]`.
fn element_path(path: &str, shape: &[usize], element: usize) -> String {
    match shape {
        [] => path.to_owned(),
        [_, row @ ..] => {
            let numbers: usize = row.iter().product();
            element_path(&format!("{path}[{}]", element / numbers), row, element % numbers)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_moves_most_is_shown() {
        let slow = Variable::new("slow", vec![0.0; 10], 0.1);
        let mut course = Course::new(
            &[slow, Variable::new("fast", vec![1.0], 10.0)],
            &[Some(vec![5, 2]), Some(vec![])],
        );
        for iteration in 0..1000 {
            let mut x = vec![0.0; 11];
            (x[3], x[10]) = (iteration as f64, 1.0 + 2.0 * iteration as f64);
            course.record(iteration, 1.0, &x);
        }
        let json = course.json();
        assert_eq!(
            (&json["numbers"][0]["path"], &json["numbers"][1]["path"]),
            (&"slow[1][1]".into(), &"fast".into())
        );
        let iterations = json["iterations"].as_array().unwrap();
        assert!((200..=400).contains(&iterations.len()));
        assert_eq!(json["numbers"][0]["values"][1], iterations[1].as_f64().unwrap());
        assert_eq!(json["numbers"].as_array().unwrap().len(), MOST_SHOWN);
    }

    #[test]
    fn of_many_numbers_some_are_kept() {
        let course =
            Course::new(&[Variable::new("many", vec![0.0; 12_345], 1.0)], &[Some(vec![4115, 3])]);
        assert!((1000..=MOST_TRACKED).contains(&course.tracked.len()));
        assert_eq!(course.tracked[1].path, "many[2][1]");
        assert!(Course::new(&[], &[]).json()["numbers"].as_array().unwrap().is_empty());
    }
}
