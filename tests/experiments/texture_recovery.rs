#[path = "../../examples/texture_recovery/experiment.rs"]
mod experiment;

#[test]
fn the_texture_is_found_from_three_views() {
    let views = experiment::views(16, 64).unwrap();
    let recoveries = experiment::recoveries(&views).unwrap();
    let initial = recoveries[0].variables()[0].initial.clone();
    let outcome = experiment::run(&recoveries, 150).unwrap();
    let (before, after) = (
        experiment::error(&recoveries[0], &initial),
        experiment::error(&recoveries[0], &outcome.best.x),
    );
    assert!(before > 0.1 && after < 0.005, "{before} {after}");
}
