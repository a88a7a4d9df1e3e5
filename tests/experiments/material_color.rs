#[path = "../../examples/material_color/experiment.rs"]
mod experiment;

use renderer::optimize::Optimizer;

#[test]
fn the_colours_are_found() {
    let problem = experiment::experiment(experiment::scene(40, 30).unwrap()).unwrap();
    let recovery = experiment::recovery(&problem).unwrap();
    let outcome = experiment::run(&recovery, Optimizer::default(), 200).unwrap();
    let truth = recovery.variables().iter().flat_map(|v| v.target.clone().unwrap());
    for (found, truth) in outcome.best.x.iter().zip(truth) {
        assert!((found - truth).abs() < 1e-3, "{found}, true {truth}");
    }
    let after_one = experiment::run(&recovery, Optimizer::default(), 1).unwrap();
    assert!(after_one.best.loss < 0.5 * after_one.initial_loss);
}
