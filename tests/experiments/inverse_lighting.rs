#[path = "../../examples/inverse_lighting/experiment.rs"]
mod experiment;

use renderer::optimize::{Lbfgs, Optimizer};

#[test]
fn the_light_is_found_in_fewer_steps_than_the_paper_takes() {
    let problem = experiment::experiment(48).unwrap();
    let recovery = experiment::recovery(&problem).unwrap();
    for (optimizer, steps) in
        [(Optimizer::default(), 401), (Optimizer::Lbfgs(Lbfgs::default()), 252)]
    {
        let outcome = experiment::run(&recovery, optimizer, steps).unwrap();
        let reached = experiment::first_below(&outcome, 1e-4).expect("the loss ratio is reached");
        assert!(reached < steps, "{optimizer:?}: {reached}");
        let truth: Vec<f64> =
            recovery.variables().iter().flat_map(|v| v.target.clone().unwrap()).collect();
        let (found, truth) = (recovery.scene_at(&outcome.best.x), recovery.scene_at(&truth));
        let (degrees, irradiance) = experiment::error_at_tree(&found, &truth).unwrap();
        assert!(degrees < 0.5 && irradiance < 0.01, "{degrees} degrees, {irradiance}");
    }
}
