//! Checkpoints: what they bring back, and what they refuse.

use std::fs;

use renderer_core::Error;

use super::*;

fn variables() -> [Variable; 2] {
    [
        Variable::new("x", vec![-1.2], 0.013).bounded(-2.0, f64::INFINITY),
        Variable::new("y", vec![1.0], 0.017),
    ]
}

fn bits(x: &[f64]) -> Vec<u64> {
    x.iter().map(|x| x.to_bits()).collect()
}

fn interrupt(folder: &Path, iteration: u64, settings: Settings) -> Outcome {
    let (variables, settings) = (variables(), in_folder(folder, true, settings));
    Optimization::start(&variables, &settings)
        .unwrap()
        .run(&mut rosenbrock, &mut InterruptAt(iteration))
        .unwrap()
}

fn resume(folder: &Path, settings: Settings) -> Result<Outcome, Error> {
    run(&variables(), &in_folder(folder, true, settings), rosenbrock)
}

pub(super) fn assert_same(outcome: &Outcome, expected: &Outcome) {
    for (point, expected) in [(&outcome.best, &expected.best), (&outcome.last, &expected.last)] {
        assert_eq!(bits(&point.x), bits(&expected.x));
        assert_eq!(point, expected);
    }
    assert_eq!(outcome.stop, expected.stop);
    assert_eq!(outcome.history.len(), expected.history.len());
    for (record, expected) in outcome.history.iter().zip(&expected.history) {
        assert_eq!(record.iteration, expected.iteration);
        assert_eq!(record.loss.to_bits(), expected.loss.to_bits());
        assert_eq!(record.gradient_norm.to_bits(), expected.gradient_norm.to_bits());
    }
}

#[test]
fn interrupted_run_continues_bit_for_bit() {
    let expected = run(&variables(), &iterations(60), rosenbrock).unwrap();
    for k in [0, 1, 2, 17, 58, 59] {
        let folder = tempfile::tempdir().unwrap();
        interrupt(folder.path(), k, iterations(60));
        let outcome = resume(folder.path(), iterations(60)).unwrap();
        assert_eq!(outcome.start, Start::Resumed { iteration: k + 1 });
        assert_same(&outcome, &expected);
    }
}

/// Halves learning rates after one iteration, and interrupts after another.
struct SlowDown {
    after: u64,
    until: u64,
    iteration: u64,
}

impl Observer for SlowDown {
    fn step(&mut self, step: &Step) -> ControlFlow<()> {
        self.iteration = step.record.iteration;
        assert_eq!(step.learning_rate_factor, if self.iteration > self.after { 0.5 } else { 1.0 });
        InterruptAt(self.until).step(step)
    }

    fn learning_rate_factor(&mut self) -> Option<f64> {
        (self.iteration == self.after).then_some(0.5)
    }
}

#[test]
fn changed_learning_rates_are_kept() {
    let variables = variables();
    let watched = |settings: &Settings, after, until| {
        let mut observer = SlowDown { after, until, iteration: 0 };
        let optimization = Optimization::start(&variables, settings).unwrap();
        optimization.run(&mut rosenbrock, &mut observer).unwrap()
    };
    let expected = watched(&iterations(40), 12, u64::MAX);
    let plain = run(&variables, &iterations(40), rosenbrock).unwrap();
    assert_eq!(plain.history[12].loss, expected.history[12].loss);
    assert!(plain.history[13].loss != expected.history[13].loss);
    for until in [12, 13, 30] {
        let folder = tempfile::tempdir().unwrap();
        let settings = in_folder(folder.path(), true, iterations(40));
        watched(&settings, 12, until);
        assert_same(&run(&variables, &settings, rosenbrock).unwrap(), &expected);
    }
}

/// The rates are small enough for plain gradient descent, too.
#[test]
fn every_method_continues_bit_for_bit() {
    for optimizer in methods() {
        for schedule in schedules(&optimizer) {
            let settings = Settings { optimizer, schedule, ..iterations(30) };
            let variables = variables().map(|mut variable| {
                variable.learning_rate[0] *= 0.01;
                variable
            });
            let expected = run(&variables, &settings, rosenbrock).unwrap();
            assert!(expected.best.loss < expected.initial_loss, "{optimizer:?} {schedule:?}");
            let folder = tempfile::tempdir().unwrap();
            let settings = in_folder(folder.path(), true, settings);
            for k in [0, 1, 12] {
                Optimization::start(&variables, &settings)
                    .unwrap()
                    .run(&mut rosenbrock, &mut InterruptAt(k))
                    .unwrap();
            }
            let outcome = run(&variables, &settings, rosenbrock).unwrap();
            assert_eq!(outcome.start, Start::Resumed { iteration: 13 });
            assert_same(&outcome, &expected);
        }
    }
}

#[test]
fn schedules_and_levels_span_the_run() {
    let cosine = Settings { schedule: Schedule::named("cosine").unwrap(), ..iterations(10) };
    for settings in [cosine, Settings { coarse_to_fine: 1, ..iterations(10) }] {
        let folder = tempfile::tempdir().unwrap();
        interrupt(folder.path(), 4, settings.clone());
        let longer = Settings { iterations: 20, ..settings.clone() };
        let problem = resume(folder.path(), longer).unwrap_err().problem;
        assert!(problem.contains("a run with another number of iterations, which"), "{problem}");
        assert!(resume(folder.path(), settings).is_ok());
    }
}

#[test]
fn run_interrupted_many_times_continues_bit_for_bit() {
    let expected = run(&variables(), &iterations(60), rosenbrock).unwrap();
    let folder = tempfile::tempdir().unwrap();
    for k in [3, 4, 20, 41] {
        interrupt(folder.path(), k, iterations(60));
    }
    assert_same(&resume(folder.path(), iterations(60)).unwrap(), &expected);
}

/// A process that dies leaves the checkpoint of some earlier step: here every one of them.
#[test]
fn killed_run_continues_bit_for_bit() {
    let expected = run(&variables(), &iterations(20), rosenbrock).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(CHECKPOINT_FILE);
    let mut checkpoints = Vec::new();
    run(&variables(), &in_folder(folder.path(), false, iterations(20)), |x| {
        checkpoints.extend(fs::read(&file));
        rosenbrock(x)
    })
    .unwrap();
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);

    assert_eq!(checkpoints.len(), 20);
    for (checkpoint, k) in checkpoints.into_iter().zip(1..) {
        fs::write(&file, checkpoint).unwrap();
        let outcome = resume(folder.path(), iterations(20)).unwrap();
        assert_eq!(outcome.start, Start::Resumed { iteration: k });
        assert_same(&outcome, &expected);
    }
}

#[test]
fn seconds_accumulate() {
    let folder = tempfile::tempdir().unwrap();
    let slow = |x: &[f64]| {
        std::thread::sleep(Duration::from_millis(20));
        rosenbrock(x)
    };
    let settings = in_folder(folder.path(), true, iterations(5));
    let variables = variables();
    let before = Optimization::start(&variables, &settings)
        .unwrap()
        .run(&mut { slow }, &mut InterruptAt(3))
        .unwrap();
    let after = run(&variables, &settings, slow).unwrap();
    assert!(before.seconds >= 0.08);
    assert!(after.seconds >= before.seconds + 0.04);
    assert!(after.history.is_sorted_by(|a, b| a.seconds < b.seconds), "{:?}", after.history);
}

#[test]
fn finished_run_returns_without_an_evaluation() {
    let folder = tempfile::tempdir().unwrap();
    let expected = resume(folder.path(), iterations(10)).unwrap();
    assert_eq!(expected.start, Start::Fresh);
    let settings = in_folder(folder.path(), true, iterations(10));
    let outcome = run(&variables(), &settings, |_| panic!("it was evaluated")).unwrap();
    assert_eq!(outcome.start, Start::Finished { iteration: 10 });
    assert_same(&outcome, &expected);
    assert_eq!(outcome.history, expected.history);
}

#[test]
fn run_stopped_by_a_non_finite_loss_is_finished() {
    let folder = tempfile::tempdir().unwrap();
    let settings = in_folder(folder.path(), true, iterations(10));
    let broken = |x: &[f64]| {
        let Evaluation { loss, gradient } = rosenbrock(x);
        Evaluation { loss: if x[1] == 1.0 { loss } else { f64::INFINITY }, gradient }
    };
    let expected = run(&variables(), &settings, broken).unwrap();
    assert_eq!(expected.stop.reason, StopReason::NonFiniteLoss);
    assert_same(&run(&variables(), &settings, |_| panic!("it was evaluated")).unwrap(), &expected);
}

#[test]
fn finished_run_can_be_given_more_iterations() {
    let expected = run(&variables(), &iterations(60), rosenbrock).unwrap();
    let folder = tempfile::tempdir().unwrap();
    resume(folder.path(), iterations(25)).unwrap();
    let outcome = resume(folder.path(), iterations(60)).unwrap();
    assert_eq!(outcome.start, Start::Resumed { iteration: 25 });
    assert_same(&outcome, &expected);
}

#[test]
fn criteria_that_would_have_stopped_before_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    resume(folder.path(), iterations(25)).unwrap();
    let error = resume(folder.path(), iterations(20)).unwrap_err().to_string();
    assert!(error.contains("checkpoint.json: "), "{error}");
    assert!(error.contains("at iteration 20 (all 20 iterations are done)"), "{error}");
    let loose = Settings { tolerance: 1e9, ..iterations(25) };
    let error = resume(folder.path(), loose).unwrap_err().to_string();
    assert!(error.contains("at iteration 0 (the loss"), "{error}");
}

#[test]
fn forgotten_resume_loses_nothing() {
    let folder = tempfile::tempdir().unwrap();
    interrupt(folder.path(), 4, iterations(10));
    let before = fs::read(folder.path().join(CHECKPOINT_FILE)).unwrap();
    let fresh = in_folder(folder.path(), false, iterations(10));
    let error = run(&variables(), &fresh, rosenbrock).unwrap_err();
    assert!(error.place.ends_with(CHECKPOINT_FILE), "{error}");
    assert!(error.problem.contains("unfinished run, which goes on at iteration 5"), "{error}");
    assert_eq!(fs::read(folder.path().join(CHECKPOINT_FILE)).unwrap(), before);

    // A finished run is replaced.
    resume(folder.path(), iterations(10)).unwrap();
    assert_eq!(run(&variables(), &fresh, rosenbrock).unwrap().start, Start::Fresh);
}

#[test]
fn other_run_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    interrupt(folder.path(), 4, iterations(10));
    let settings = in_folder(folder.path(), true, iterations(10));
    let refused = |variables: &[Variable], settings: &Settings| {
        let error = run(variables, settings, rosenbrock).unwrap_err();
        assert!(error.place.ends_with(CHECKPOINT_FILE), "{error}");
        error.problem
    };

    let mut other = settings.clone();
    other.checkpointing.as_mut().unwrap().problem = Fingerprint::new().text("another problem");
    let problem = refused(&variables(), &other);
    assert!(problem.contains("belongs to another problem"), "{problem}");

    let other_optimizer =
        Settings { optimizer: Optimizer::Sgd(Sgd::default()), ..settings.clone() };
    let other_number = Optimizer::Adam(Adam { beta1: 0.8, ..Adam::default() });
    let other_number = Settings { optimizer: other_number, ..settings.clone() };
    let other_schedule =
        Settings { schedule: Schedule::named("step").unwrap(), ..settings.clone() };
    let other_starts = Settings { starts: Some(Starts { count: 2, seed: 0 }), ..settings.clone() };
    let changes: [fn(&mut Variable); 4] = [
        |x| x.initial[0] = -1.1,
        |x| x.learning_rate[0] = 0.02,
        |x| x.max[0] = 3.0,
        |x| x.path = "z".to_owned(),
    ];
    for (other, what) in [
        (other_optimizer, "belongs to a run with another optimizer; "),
        (other_number, "belongs to a run with another optimizer; "),
        (
            other_schedule,
            "another schedule, and another number of iterations, which its schedule or its coarse levels span; ",
        ),
        (other_starts, "belongs to a run with other starts; "),
    ] {
        let problem = refused(&variables(), &other);
        assert!(problem.contains(what), "{problem}");
    }
    let mut problems = vec![refused(&variables()[..1], &settings)];
    for change in changes {
        let mut variables = variables();
        change(&mut variables[0]);
        problems.push(refused(&variables, &settings));
    }
    for problem in problems {
        let what = "a run with other parameters, initial values, learning rates or bounds; ";
        assert!(problem.contains(what), "{problem}");
    }
}

#[test]
fn damaged_checkpoint_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    interrupt(folder.path(), 4, iterations(10));
    let file = folder.path().join(CHECKPOINT_FILE);
    let whole = fs::read_to_string(&file).unwrap();
    let digit = whole.rfind("\"loss\":").unwrap() + "\"loss\":".len();
    let changed = if whole.as_bytes()[digit] == b'3' { "4" } else { "3" };
    let flipped = format!("{}{changed}{}", &whole[..digit], &whole[digit + 1..]);
    for damaged in ["", "{}", "not JSON", &whole[..whole.len() / 2], &flipped] {
        fs::write(&file, damaged).unwrap();
        for resume in [true, false] {
            let settings = in_folder(folder.path(), resume, iterations(10));
            let error = run(&variables(), &settings, rosenbrock).unwrap_err();
            assert!(error.place.ends_with(CHECKPOINT_FILE), "{error}");
            assert!(error.problem.contains("is damaged"), "{error}");
            assert!(!error.problem.contains('\n'), "{error}");
        }
        assert_eq!(fs::read_to_string(&file).unwrap(), damaged);
    }
}

#[test]
fn folder_that_cannot_be_made_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let occupied = folder.path().join("occupied");
    fs::write(&occupied, "a file").unwrap();
    let settings = in_folder(&occupied, false, iterations(10));
    let error = run(&variables(), &settings, rosenbrock).unwrap_err();
    assert!(error.place.contains("occupied"), "{error}");
}

/// The steps of starts come before iteration 0, and are not taken again.
#[test]
fn the_start_that_was_chosen_is_resumed() {
    let mut variable = Variable::new("x", vec![-1.2, 1.0], 0.01);
    variable.spread = vec![1.0, 0.5];
    let variables = [variable];
    let starts = |seed| Settings { starts: Some(Starts { count: 6, seed }), ..iterations(20) };
    let whole = run(&variables, &starts(1), rosenbrock).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let settings = in_folder(folder.path(), false, starts(1));
    let optimization = Optimization::start(&variables, &settings).unwrap();
    optimization.run(&mut rosenbrock, &mut InterruptAt(7)).unwrap();
    let resumed = run(&variables, &in_folder(folder.path(), true, starts(1)), rosenbrock).unwrap();
    assert_eq!((&resumed.best, &resumed.last), (&whole.best, &whole.last));
    assert_eq!(resumed.evaluations, whole.evaluations);
    let other = in_folder(folder.path(), true, starts(2));
    let error = Optimization::start(&variables, &other).err().unwrap().to_string();
    assert!(error.contains("other starts"), "{error}");
}
