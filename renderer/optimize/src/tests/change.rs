//! Elements that become more on the way.

use renderer_core::Error;

use super::*;

/// A bowl for each element, of which there are twice as many after every tenth step.
struct Doubling {
    /// The loss is no number from this iteration on.
    fails_at: u64,
    count: usize,
    iteration: u64,
}

impl Doubling {
    fn new() -> Self {
        Self { fails_at: u64::MAX, count: 2, iteration: 0 }
    }

    fn variables(count: usize) -> [Variable; 1] {
        [Variable::new("x", [-1.0, 0.3].repeat(count / 2), 0.05)]
    }
}

impl Objective for Doubling {
    fn begin(&mut self, iteration: u64, _level: u32) {
        self.iteration = iteration;
    }

    fn evaluate(&mut self, x: &[f64]) -> Evaluation {
        assert_eq!(x.len(), self.count);
        let bowl = |i: usize| if i.is_multiple_of(2) { 1.0 } else { 30.0 };
        let loss = x.iter().enumerate().map(|(i, x)| bowl(i) * (x - 1.0).powi(2)).sum::<f64>();
        let loss = if self.iteration >= self.fails_at { f64::NAN } else { loss };
        let gradient = x.iter().enumerate().map(|(i, x)| 2.0 * bowl(i) * (x - 1.0)).collect();
        Evaluation { loss, gradient }
    }

    fn change(&mut self, iteration: u64, x: &[f64]) -> Result<Option<Change>, Error> {
        if !iteration.is_multiple_of(10) {
            return Ok(None);
        }
        self.count *= 2;
        let (vertices, triangles, materials) = (vec![[0.0; 3]; self.count], vec![], vec![]);
        Ok(Some(Change {
            topologies: vec![Topology { variable: 0, vertices, triangles, materials }],
            variables: Self::variables(self.count).to_vec(),
            x: x.repeat(2),
            carry: Box::new(|memory| memory.repeat(2)),
        }))
    }

    fn restore(&mut self, topologies: &[Topology]) -> Result<Vec<Variable>, Error> {
        self.count = topologies[0].vertices.len();
        Ok(Self::variables(self.count).to_vec())
    }
}

fn run_doubling(settings: &Settings, observer: &mut dyn Observer) -> Outcome {
    let variables = Doubling::variables(2);
    let optimization = Optimization::start(&variables, settings).unwrap();
    optimization.run(&mut Doubling::new(), observer).unwrap()
}

#[test]
fn methods_remember_across_changes() {
    for optimizer in Optimizer::all() {
        let settings = Settings { optimizer, ..iterations(35) };
        let plain = |x: &[f64]| Doubling::new().evaluate(x);
        let expected = run(&Doubling::variables(2), &settings, plain).unwrap();
        let found = run_doubling(&settings, &mut Quiet);
        if optimizer.finds_step_lengths() {
            assert_eq!((&found.last, &found.topologies[..]), (&expected.last, &[][..]));
        } else {
            assert_eq!(found.last.x, expected.last.x.repeat(8), "{}", optimizer.name());
            assert_eq!(found.topologies[0].vertices.len(), 16);
            // What came before is of other elements.
            assert_eq!(found.trajectory[0].iteration, 30);
        }
    }
}

#[test]
fn runs_that_change_are_resumed_bit_for_bit() {
    let expected = run_doubling(&iterations(35), &mut Quiet);
    for k in [0, 8, 9, 10, 11, 19, 20, 29, 34] {
        let folder = tempfile::tempdir().unwrap();
        let settings = in_folder(folder.path(), true, iterations(35));
        let part = run_doubling(&settings, &mut InterruptAt(k));
        let counts = 2 << (k / 10);
        assert_eq!((part.best.x.len(), part.last.x.len()), (counts, counts));
        assert_eq!(part.topologies.is_empty(), k < 10);
        let found = run_doubling(&settings, &mut Quiet);
        assert_eq!((&found.best, &found.last), (&expected.best, &expected.last), "{k}");
        assert_eq!((found.topologies, found.history.len()), (expected.topologies.clone(), 36));
        // A finished run needs no evaluation.
        assert_eq!(run_doubling(&settings, &mut Quiet).best, expected.best);
    }
}

/// The last step of a run is followed by no change, but by one if there are more steps.
#[test]
fn finished_runs_go_on_as_if_they_had_not_ended() {
    let expected = run_doubling(&iterations(35), &mut Quiet);
    for end in [9, 10, 20, 21] {
        let folder = tempfile::tempdir().unwrap();
        let settings = |count| in_folder(folder.path(), true, iterations(count));
        let part = run_doubling(&settings(end), &mut Quiet);
        assert_eq!(part.best.x.len(), 2 << ((end - 1) / 10));
        assert_eq!(run_doubling(&settings(35), &mut Quiet).last, expected.last, "{end}");
    }
}

#[test]
fn a_change_that_leads_nowhere_leaves_what_was_found() {
    let folder = tempfile::tempdir().unwrap();
    let settings = in_folder(folder.path(), true, iterations(35));
    let variables = Doubling::variables(2);
    let start = || Optimization::start(&variables, &settings).unwrap();
    let mut failing = Doubling { fails_at: 20, ..Doubling::new() };
    let outcome = start().run(&mut failing, &mut Quiet).unwrap();
    assert_eq!(outcome.stop.reason, StopReason::NonFiniteLoss);
    assert_eq!((outcome.best.x.len(), outcome.topologies[0].vertices.len()), (4, 4));
    assert_eq!(start().run(&mut failing, &mut Quiet).unwrap().best, outcome.best);
}

#[test]
fn checkpoints_of_other_problems_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let settings = in_folder(folder.path(), true, iterations(35));
    run_doubling(&settings, &mut InterruptAt(15));
    let refused = run(&Doubling::variables(2), &settings, quadratic).unwrap_err();
    assert!(refused.to_string().contains("triangles have changed"), "{refused}");
}
