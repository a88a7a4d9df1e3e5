#[path = "../../examples/pose/experiment.rs"]
mod experiment;

use experiment::Pose;
use glam::DVec3;
use renderer::Edges;
use renderer::optimize::{Lbfgs, Optimizer};

#[test]
fn the_pose_is_found_with_edges_alone() {
    let by = DVec3::new(0.1, -0.06, 0.08);
    let start = Pose::truth().displaced(DVec3::new(0.5, 1.0, -0.4), 25.0, by);
    let problem = experiment::experiment(40, &start).unwrap();
    let error = |edges| {
        let recovery = experiment::recovery(&problem, edges).unwrap();
        let outcome = experiment::run(&recovery, Optimizer::Lbfgs(Lbfgs::default()), 40).unwrap();
        Pose::found(&outcome.best.x).error(&Pose::truth())
    };
    let (degrees, distance) = error(Edges::On);
    assert!(degrees < 0.05 && distance < 1e-3, "{degrees} degrees, {distance}");
    assert!(!experiment::is_found(error(Edges::Off)));
}
