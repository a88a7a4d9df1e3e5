#[path = "../../examples/finite_differences/experiment.rs"]
mod experiment;
#[path = "../../examples/shared/random.rs"]
mod random;

#[test]
fn the_backward_pass_agrees_with_differences() {
    let mut random = random::Random(1);
    let scene = experiment::scene(8, 32, &mut random).unwrap();
    let problem = experiment::experiment(scene, &mut random);
    let recovery = experiment::recovery(&problem).unwrap();
    let mut objective = recovery.objective();
    let x = recovery.initial();

    let backward = experiment::backward(&recovery, objective.as_mut(), &x);
    let differences = experiment::central_differences(&problem.scene, &recovery, 1).unwrap();

    assert_eq!(backward.len(), 8 * experiment::PER_TRIANGLE);
    let error = experiment::largest_error(&backward, &differences);
    assert!(error < 1e-5, "{error:e}");
}
