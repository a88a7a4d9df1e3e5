#[path = "../../examples/environment/experiment.rs"]
mod experiment;

use renderer::experiment::Experiment;
use renderer::files::save_scene;
use renderer::optimize::{Quiet, Settings as OptimizeSettings};
use renderer::recovery::Recovery;
use renderer::scene::PathTracing;
use renderer::{Settings, render};

/// What a rough ball reflects says where the light comes from.
#[test]
fn a_map_is_found_by_what_a_ball_reflects() {
    let truth = experiment::map();
    let paths = PathTracing { max_depth: 2, samples: 8, seed: 0 };
    let scene = experiment::scene(48, &truth, paths).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let target = PathTracing { samples: 512, seed: 1, ..paths };
    let problem = experiment::experiment(&scene, target, folder.path()).unwrap();
    let recovery = Recovery::new(&problem, "environment", &Settings::default()).unwrap();
    let settings = OptimizeSettings { iterations: 100, ..recovery.settings() };
    let outcome = recovery.run(&settings, &mut Quiet).unwrap();
    let texels = experiment::texels(&scene).unwrap();
    let off =
        |found: &renderer::Scene| experiment::difference(&scene.get(texels), &found.get(texels))[0];
    let (guess, found) = (off(&problem.scene), off(&recovery.scene_at(&outcome.best.x)));
    assert!(found < 0.6 * guess, "off by {found}, the guess by {guess}");
}

/// Scene files keep the map, its rotation, and the background.
#[test]
fn an_environment_is_read_as_it_was_written() {
    let paths = PathTracing { max_depth: 3, samples: 4, seed: 9 };
    for mut scene in [
        experiment::scene(8, &experiment::map(), paths).unwrap(),
        experiment::relit(8, &experiment::map(), paths).unwrap(),
    ] {
        let rotation = scene.parameter("environment.rotation").unwrap();
        scene.set(rotation, &[33.0]).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let read = Experiment::load(&save_scene(&scene, folder.path()).unwrap()).unwrap().scene;
        assert_eq!(read.environment, scene.environment);
        let settings = Settings::default();
        assert_eq!(render(&read, &settings).unwrap(), render(&scene, &settings).unwrap());
    }
}
