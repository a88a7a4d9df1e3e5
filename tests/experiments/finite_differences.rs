#[path = "../../examples/finite_differences/experiment.rs"]
mod experiment;
#[path = "../../examples/shared/random.rs"]
mod random;

use std::time::{Duration, Instant};

#[test]
fn the_backward_pass_agrees_with_differences_and_is_faster() {
    let mut random = random::Random(1);
    let scene = experiment::scene(8, 32, &mut random).unwrap();
    let problem = experiment::experiment(scene, &mut random);
    let recovery = experiment::recovery(&problem).unwrap();
    let mut objective = recovery.objective();
    let x = recovery.initial();

    let mut backward_time = Duration::MAX;
    let mut backward = Vec::new();
    // The fastest of a few: other work on the machine may delay some.
    for _ in 0..10 {
        let clock = Instant::now();
        backward = experiment::backward(&recovery, objective.as_mut(), &x);
        backward_time = backward_time.min(clock.elapsed());
    }
    let clock = Instant::now();
    let differences = experiment::central_differences(&problem.scene, &recovery, 1).unwrap();
    let differences_time = clock.elapsed();

    assert_eq!(backward.len(), 8 * experiment::PER_TRIANGLE);
    let error = experiment::largest_error(&backward, &differences);
    assert!(error < 1e-5, "{error:e}");
    // 320 images against one backward pass: a wide margin for a machine that does other things.
    assert!(differences_time > 5 * backward_time, "{differences_time:?} {backward_time:?}");
}
