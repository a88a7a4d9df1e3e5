//! Several starts, of which the most promising is gone on with.

use super::optimizer::Method;
use super::random::{mixed, unit};
use super::variable::Flat;
use super::{Objective, Settings};

/// Starts drawn around the initial parameters.
///
/// A start differs from the initial value of each element by up to its [spread](super::Variable::spread),
/// evenly distributed, within its bounds; the first start is the initial parameters themselves. Each makes
/// [`STEPS`](Self::STEPS) steps on the coarsest [level](super::Settings::coarse_to_fine), which has the largest
/// basins and the cheapest images; the quarter with the lowest losses makes as many on the next finer level, and
/// so on (successive halving; Jamieson & Talwalkar 2016). The run goes on where the last one has come to, on
/// its level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Starts {
    /// How many, with the initial parameters; at least 1.
    pub count: u32,
    /// What they follow from.
    pub seed: u64,
}

impl Starts {
    /// How many steps each makes before they are ranked.
    pub const STEPS: u64 = 8;

    /// One of so many goes on to the next level.
    const KEPT: usize = 4;

    /// Where a start is.
    fn draw(self, index: u32, flat: &Flat) -> Vec<f64> {
        let mut state = mixed(self.seed ^ mixed(index.into()));
        let mut drawn = |i: usize| {
            state = mixed(state);
            let offset = if index == 0 { 0.0 } else { (2.0 * unit(state) - 1.0) * flat.spread[i] };
            flat.scale[i].moved(flat.x[i], offset).clamp(flat.lowest(i), flat.max[i])
        };
        (0..flat.x.len()).map(&mut drawn).collect()
    }

    /// Where the most promising start has come to, and on which level: the first of them, if several have the
    /// same loss.
    pub(super) fn most_promising(
        self,
        flat: &Flat,
        settings: &Settings,
        objective: &mut dyn Objective,
    ) -> (Vec<f64>, u32) {
        let mut level = settings.coarse_to_fine;
        let mut places: Vec<_> = (0..self.count).map(|index| self.draw(index, flat)).collect();
        loop {
            let walked = places.into_iter().map(|x| walk(x, flat, (settings, level), objective));
            let mut ranked: Vec<_> = walked.collect();
            ranked.sort_by(|(one, _), (other, _)| one.total_cmp(other));
            ranked.truncate(ranked.len().div_ceil(Self::KEPT));
            places = ranked.into_iter().map(|(_, x)| x).collect();
            if places.len() == 1 || level == 0 {
                return (places.swap_remove(0), level);
            }
            level -= 1;
        }
    }
}

/// The lowest loss on the way of a start on a level, infinite if none is finite, and where it is. Samples of a loss cannot
/// be compared: where steps take such, it is the loss of all that there is at the end of the way.
fn walk(
    mut x: Vec<f64>,
    flat: &Flat,
    (settings, level): (&Settings, u32),
    objective: &mut dyn Objective,
) -> (f64, Vec<f64>) {
    let is_sampled = settings.is_sampled;
    let mut best = (f64::INFINITY, x.clone());
    let mut method = Method::new(&settings.optimizer, x.len());
    let mut known = None;
    for step in 0.. {
        if step == 0 || is_sampled {
            objective.begin(step, level);
        }
        let evaluation = match known.filter(|_| !is_sampled) {
            Some(evaluation) => evaluation,
            None => objective.evaluate(&x),
        };
        if evaluation.loss < best.0 || is_sampled && evaluation.is_finite() {
            best = (evaluation.loss, x.clone());
        }
        if step == Starts::STEPS || !evaluation.is_finite() {
            break;
        }
        match method.step(flat, 1.0, &mut x, evaluation, objective) {
            Ok(evaluation) => known = evaluation,
            // It is where its method leads to.
            Err(_) => break,
        }
    }
    let (loss, x) = best;
    let full_loss = if is_sampled && loss.is_finite() { objective.full_loss(&x) } else { None };
    (full_loss.unwrap_or(loss), x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Evaluation, Optimization, Quiet, Variable};

    /// Waves in a bowl, whose lowest valley is at 3.
    fn waves(x: &[f64]) -> Evaluation {
        let (d, k) = (x[0] - 3.0, 4.0);
        let loss = 0.05 * d * d + 1.0 - (k * d).cos();
        Evaluation { loss, gradient: vec![0.1 * d + k * (k * d).sin()] }
    }

    fn found(starts: Option<Starts>) -> f64 {
        let mut variable = Variable::new("x", vec![0.2], 0.05);
        variable.spread = vec![4.0];
        let settings = Settings { starts, ..Settings::default() };
        let variables = [variable];
        let optimization = Optimization::start(&variables, &settings).unwrap();
        optimization.run(&mut waves, &mut Quiet).unwrap().best.x[0]
    }

    #[test]
    fn one_of_many_starts_is_in_the_lowest_valley() {
        assert!((found(None) - 3.0).abs() > 1.0);
        let starts = Starts { count: 24, seed: 1 };
        let x = found(Some(starts));
        assert!((x - 3.0).abs() < 1e-2, "{x}");
        assert_eq!(x, found(Some(starts)), "the same starts lead to the same parameters");
    }

    /// Every other iteration sees all of it, those between see nothing.
    struct Seen(bool);

    impl Objective for Seen {
        fn begin(&mut self, iteration: u64, _: u32) {
            self.0 = !iteration.is_multiple_of(2);
        }

        fn evaluate(&mut self, x: &[f64]) -> Evaluation {
            match self.0 {
                true => waves(x),
                false => Evaluation { loss: 0.0, gradient: vec![0.0] },
            }
        }

        fn full_loss(&mut self, x: &[f64]) -> Option<f64> {
            Some(waves(x).loss)
        }
    }

    #[test]
    fn starts_are_ranked_by_all_that_samples_are_taken_of() {
        let mut variable = Variable::new("x", vec![0.2], 0.05);
        variable.spread = vec![4.0];
        let starts = Some(Starts { count: 24, seed: 1 });
        let settings = Settings { starts, is_sampled: true, epoch: 2, ..Settings::default() };
        let variables = [variable];
        let optimization = Optimization::start(&variables, &settings).unwrap();
        let x = optimization.run(&mut Seen(false), &mut Quiet).unwrap().best.x[0];
        assert!((x - 3.0).abs() < 0.1, "{x}");
    }

    #[test]
    fn starts_are_spread_evenly_within_bounds() {
        let mut variable = Variable::new("x", vec![1.0, 5.0, 0.5], 0.1).bounded(0.0, 6.0);
        variable.spread = vec![0.5, 0.0, 2.0];
        let flat = Flat::new(&[variable]).unwrap();
        let starts = Starts { count: 400, seed: 3 };
        let drawn: Vec<_> = (0..400).map(|index| starts.draw(index, &flat)).collect();
        assert_eq!(drawn[0], [1.0, 5.0, 0.5]);
        assert!(drawn.iter().all(|x| (0.5..=1.5).contains(&x[0]) && x[1] == 5.0));
        assert!(drawn.iter().all(|x| (0.0..=2.5).contains(&x[2])));
        let mean = drawn.iter().map(|x| x[0]).sum::<f64>() / 400.0;
        let below = drawn.iter().filter(|x| x[0] < 0.75).count();
        assert!((mean - 1.0).abs() < 0.05 && (70..130).contains(&below), "{mean} {below}");
    }
}
