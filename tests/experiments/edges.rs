#[path = "../../examples/edges/experiment.rs"]
mod experiment;

use renderer::Edges;

#[test]
fn derivatives_with_edges_are_those_of_finely_sampled_images() {
    let scene = experiment::scene(32).unwrap();
    for (path, element, step) in experiment::NUMBERS {
        let number = (scene.parameter(path).unwrap(), element);
        let differences = experiment::by_differences(&scene, number, step).unwrap();
        let [without, with] = [Edges::Off, Edges::On].map(|edges| {
            let derivatives = experiment::by_forward_mode(&scene, number, edges).unwrap();
            experiment::relative_error(&derivatives, &differences)
        });
        assert!(with < 0.1 && without > 4.0 * with, "{path}: {with} {without}");
    }
}
