//! The parameters that are optimised.

use std::borrow::Cow;
use std::collections::HashSet;
use std::ops::Range;

use renderer_core::Error;

use super::{Fingerprint, Preconditioner, Scale};

/// One parameter to optimise: a block of numbers under a path.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Names it in messages and in the summary: `light.key.position`.
    pub path: String,
    /// Where the optimisation starts.
    pub initial: Vec<f64>,
    /// What steps are taken in: the elements, or their logarithms.
    pub scale: Scale,
    /// About how far each element moves per step, on its [scale](Scale). For
    /// [`Sgd`](super::Sgd), what the gradient is multiplied with.
    pub learning_rate: Vec<f64>,
    /// The least value of each element; negative infinity for no bound.
    pub min: Vec<f64>,
    /// The greatest value of each element; infinity for no bound.
    pub max: Vec<f64>,
    /// How far each element of a [start](super::Starts) is from its initial value at most, on its scale; 0 or more.
    pub spread: Vec<f64>,
    /// The true values, where they are known: reported, not used.
    pub target: Option<Vec<f64>>,
    /// The coordinates that first-order methods take their steps in, if not its own.
    pub preconditioner: Option<Preconditioner>,
}

impl Variable {
    /// A variable without bounds, of one learning rate, whose target is unknown.
    pub fn new(path: impl Into<String>, initial: Vec<f64>, learning_rate: f64) -> Self {
        let len = initial.len();
        Self {
            path: path.into(),
            initial,
            scale: Scale::Linear,
            learning_rate: vec![learning_rate; len],
            min: vec![f64::NEG_INFINITY; len],
            max: vec![f64::INFINITY; len],
            spread: vec![0.0; len],
            target: None,
            preconditioner: None,
        }
    }

    /// This variable with each element kept in `min..=max`.
    pub fn bounded(mut self, min: f64, max: f64) -> Self {
        self.min.fill(min);
        self.max.fill(max);
        self
    }

    fn check(&self) -> Result<(), Error> {
        let len = self.initial.len();
        let blocks = [
            ("learning_rate", Some(&self.learning_rate)),
            ("min", Some(&self.min)),
            ("max", Some(&self.max)),
            ("spread", Some(&self.spread)),
            ("target", self.target.as_ref()),
        ];
        for (name, block) in blocks {
            if let Some(block) = block
                && block.len() != len
            {
                let problem =
                    format!("{name} has {} numbers, but the parameter has {len}", block.len());
                return Err(Error::new(&self.path, problem));
            }
        }
        if self.scale == Scale::Log && self.preconditioner.is_some() {
            let problem = "has coordinates of its own; leave them out, or the logarithmic scale";
            return Err(Error::new(&self.path, problem));
        }
        (0..len).try_for_each(|i| {
            self.check_element(i).map_err(|problem| Error::new(self.element_path(i), problem))
        })
    }

    fn check_element(&self, i: usize) -> Result<(), String> {
        let (initial, rate) = (self.initial[i], self.learning_rate[i]);
        let (min, max, spread) = (self.min[i], self.max[i], self.spread[i]);
        if !initial.is_finite() {
            return Err(format!("the initial value is {initial}; it must be a finite number"));
        }
        if initial < self.scale.least() {
            return Err(format!(
                "the initial value is {initial}; on a logarithmic scale it must be above 0"
            ));
        }
        if !(rate > 0.0 && rate.is_finite()) {
            return Err(format!("the learning rate is {rate}; it must be a positive number"));
        }
        if !(spread >= 0.0 && spread.is_finite()) {
            return Err(format!("the spread of starts is {spread}; it must be 0 or more"));
        }
        if min.is_nan() || max.is_nan() || min > max {
            return Err(format!("the bounds {min} to {max} hold no number"));
        }
        if initial < min {
            return Err(format!("the initial value {initial} is below its minimum {min}"));
        }
        if initial > max {
            return Err(format!("the initial value {initial} is above its maximum {max}"));
        }
        Ok(())
    }

    fn element_path(&self, i: usize) -> String {
        if self.initial.len() == 1 { self.path.clone() } else { format!("{}[{i}]", self.path) }
    }
}

/// The elements of all variables, one after the other.
#[derive(Clone, Debug)]
pub(super) struct Flat {
    pub x: Vec<f64>,
    pub scale: Vec<Scale>,
    pub learning_rate: Vec<f64>,
    pub min: Vec<f64>,
    pub max: Vec<f64>,
    pub spread: Vec<f64>,
    /// Those of each variable.
    pub blocks: Vec<Range<usize>>,
    preconditioners: Vec<Option<Preconditioner>>,
}

impl Flat {
    /// # Errors
    ///
    /// If the variables are not fit to be optimised; the place is the path.
    pub fn new(variables: &[Variable]) -> Result<Self, Error> {
        if variables.iter().all(|variable| variable.initial.is_empty()) {
            return Err(Error::new("optimize", "there is no parameter to optimise; name one"));
        }
        let mut paths = HashSet::new();
        for variable in variables {
            variable.check()?;
            if !paths.insert(&variable.path) {
                return Err(Error::new(&variable.path, "the parameter is listed twice"));
            }
        }
        let concat = |block: fn(&Variable) -> &[f64]| variables.iter().flat_map(block).copied();
        Ok(Self {
            x: concat(|variable| &variable.initial).collect(),
            scale: variables.iter().flat_map(|of| vec![of.scale; of.initial.len()]).collect(),
            learning_rate: concat(|variable| &variable.learning_rate).collect(),
            min: concat(|variable| &variable.min).collect(),
            max: concat(|variable| &variable.max).collect(),
            spread: concat(|variable| &variable.spread).collect(),
            blocks: blocks(variables),
            preconditioners: variables.iter().map(|of| of.preconditioner.clone()).collect(),
        })
    }

    /// From gradients to those by the coordinates of steps, or from steps there to steps.
    pub fn precondition(&self, values: &mut [f64]) {
        for (block, preconditioner) in self.blocks.iter().zip(&self.preconditioners) {
            if let Some(preconditioner) = preconditioner {
                preconditioner.apply(&mut values[block.clone()]);
            }
        }
    }

    /// The places of `x` on the scales of the elements.
    pub fn places<'a>(&self, x: &'a [f64]) -> Cow<'a, [f64]> {
        if self.scale.iter().all(|&scale| scale == Scale::Linear) {
            return Cow::Borrowed(x);
        }
        self.scale.iter().zip(x).map(|(scale, &x)| scale.place(x)).collect()
    }

    /// The least finite number that an element may be.
    pub fn lowest(&self, i: usize) -> f64 {
        self.min[i].max(self.scale[i].least())
    }

    /// From the gradient by the elements, at `x`, to that by their places.
    pub fn pull_back_to_places(&self, x: &[f64], gradient: &mut [f64]) {
        for ((g, scale), &x) in gradient.iter_mut().zip(&self.scale).zip(x) {
            *g *= scale.slope(x);
        }
    }

    /// Moves `x` against `direction` by `factor` times the learning rate of each element, on its scale, and
    /// projects it onto the bounds. A finite `x` stays finite, and above 0 on a logarithmic scale.
    pub fn step(&self, x: &mut [f64], direction: &[f64], factor: f64) {
        for (i, (x, direction)) in x.iter_mut().zip(direction).enumerate() {
            // A rate that underflows to 0 must not meet an infinite direction.
            let step = self.learning_rate[i] * factor * direction.clamp(f64::MIN, f64::MAX);
            // No bound means the largest finite number.
            let highest = self.max[i].min(f64::MAX);
            *x = self.scale[i].moved(*x, -step).clamp(self.lowest(i), highest);
        }
    }

    /// The length of the gradient of the variables at `x`, leaving out what points out of bounds:
    /// at a minimum on a bound the gradient itself never vanishes.
    pub fn projected_norm(&self, x: &[f64], gradient: &[f64]) -> f64 {
        let norm = gradient.iter().enumerate().fold(0.0, |norm: f64, (i, &g)| {
            let blocked = (x[i] <= self.min[i] && g > 0.0) || (x[i] >= self.max[i] && g < 0.0);
            if blocked { norm } else { norm.hypot(g) }
        });
        norm.min(f64::MAX)
    }
}

/// The elements of each variable among those of all.
fn blocks(variables: &[Variable]) -> Vec<Range<usize>> {
    let mut end = 0;
    let block = |variable: &Variable| {
        let start = end;
        end += variable.initial.len();
        start..end
    };
    variables.iter().map(block).collect()
}

/// The path of one element of the concatenated variables: `light.key.position[1]`.
pub(super) fn element_path(variables: &[Variable], mut index: usize) -> String {
    for variable in variables {
        if index < variable.initial.len() {
            return variable.element_path(index);
        }
        index -= variable.initial.len();
    }
    format!("element {index} past the last parameter")
}

/// The part of `x` that belongs to each of the variables.
#[cfg(feature = "reports")]
pub(super) fn split<'a>(
    variables: &'a [Variable],
    mut x: &'a [f64],
) -> impl Iterator<Item = (&'a Variable, &'a [f64])> {
    variables.iter().map(move |variable| {
        let (own, rest) = x.split_at(variable.initial.len());
        x = rest;
        (variable, own)
    })
}

/// Tells apart variables that lead to different steps.
pub(super) fn fingerprint(variables: &[Variable]) -> Fingerprint {
    variables.iter().fold(Fingerprint::new(), |fingerprint, variable| {
        let coordinates = match variable.scale {
            Scale::Linear => variable.preconditioner.as_ref().map_or("", Preconditioner::name),
            Scale::Log => "logarithm",
        };
        fingerprint
            .text(&variable.path)
            .numbers(&variable.initial)
            .numbers(&variable.learning_rate)
            .numbers(&variable.min)
            .numbers(&variable.max)
            .numbers(&variable.spread)
            .text(coordinates)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_stay_within_bounds_and_finite() {
        let mut flat = Flat {
            x: vec![0.0; 3],
            scale: vec![Scale::Linear; 3],
            learning_rate: vec![0.3, 1e308, 1e-300],
            min: vec![-0.5, f64::NEG_INFINITY, f64::NEG_INFINITY],
            max: vec![f64::INFINITY; 3],
            spread: vec![0.0; 3],
            blocks: vec![Range { start: 0, end: 3 }],
            preconditioners: vec![None],
        };
        let mut x = std::mem::take(&mut flat.x);
        flat.step(&mut x, &[1.0, -2.0, f64::INFINITY], 0.25);
        assert_eq!(x[..2], [-0.075, 0.5e308]);
        flat.step(&mut x, &[0.0, 0.0, f64::INFINITY], 1e-30);
        assert!(x[2].is_finite());
        for _ in 0..10 {
            flat.step(&mut x, &[1.0, 1e308, f64::INFINITY], 1.0);
        }
        assert_eq!(x[..2], [-0.5, f64::MIN]);
        assert!(x[2].is_finite());
    }
}
