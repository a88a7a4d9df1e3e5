#[path = "../../examples/pose/experiment.rs"]
mod experiment;

use experiment::{Pose, Task};
use glam::DVec3;
use renderer::Edges;
use renderer::optimize::{Lbfgs, Lm, Optimizer};

#[test]
fn the_pose_is_found_with_edges_alone() {
    let by = DVec3::new(0.1, -0.06, 0.08);
    let task = Task::cubes(40);
    let start = task.truth.displaced(DVec3::new(0.5, 1.0, -0.4), 25.0, by);
    let problem = experiment::experiment(&task, &start, 0, 1).unwrap();
    let error = |edges| {
        let recovery = experiment::recovery(&problem, edges).unwrap();
        let outcome = experiment::run(&recovery, Optimizer::Lbfgs(Lbfgs::default()), 40).unwrap();
        Pose::found(&outcome.best.x).error(&task.truth)
    };
    let (degrees, distance) = error(Edges::On);
    assert!(degrees < 0.05 && distance < 1e-3, "{degrees} degrees, {distance}");
    assert!(!experiment::is_found(error(Edges::Off)));
}

/// A task whose start is too far away for the images as they are, and not for their halves' halves.
#[test]
fn least_squares_finds_the_pose_from_coarse_to_fine() {
    let by = DVec3::new(0.1, -0.06, 0.08);
    let task = Task::cubes(48);
    let start = task.truth.displaced(DVec3::new(0.5, 1.0, -0.4), 25.0, by);
    let problem = experiment::experiment(&task, &start, 3, 1).unwrap();
    let recovery = experiment::recovery(&problem, Edges::On).unwrap();
    let outcome = experiment::run(&recovery, Optimizer::Lm(Lm::default()), 60).unwrap();
    let (degrees, distance) = Pose::found(&outcome.best.x).error(&task.truth);
    assert!(degrees < 0.05 && distance < 1e-3, "{degrees} degrees, {distance}");
}
