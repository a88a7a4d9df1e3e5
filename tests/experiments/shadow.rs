#[path = "../../examples/shadow/experiment.rs"]
mod experiment;

use glam::DVec3;
use renderer::Edges;

#[test]
fn the_light_is_found_from_a_shadow() {
    let start = DVec3::new(-0.4, 4.2, -0.6);
    let problem = experiment::experiment(40, start).unwrap();
    let error = |edges| {
        let recovery = experiment::recovery(&problem, edges).unwrap();
        experiment::error(&experiment::run(&recovery, 40).unwrap())
    };
    let [without_edges, with_edges] = [Edges::Off, Edges::On].map(error);
    assert!(with_edges < 1e-3 && without_edges > 0.02, "{with_edges} {without_edges}");
}
