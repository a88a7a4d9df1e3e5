//! The dial where gradients see edges.

use super::*;
use crate::experiment::Experiment;
use crate::optimize::Objective;
use crate::recovery::ImageObjective;
use crate::settings::Edges;

/// A tetrahedron in front of a camera that is aimed past it.
const SCENE: &str = r#"
    [camera]
    look_from = [0.4, 0.6, 4.0]
    look_at = [0.0, 0.1, 0.0]
    width = 32
    height = 32
    [[light]]
    name = "sun"
    type = "distant"
    direction = [0.5, 1.0, 2.0]
    irradiance = 3.0
    [material.paint]
    diffuse = [0.8, 0.5, 0.3]
    [[mesh]]
    name = "shape"
    path = "shape.obj"
    material = "paint"
    [[optimize.parameter]]
    path = "camera.look_at"
    [optimize.target_values]
    "camera.look_at" = [0.3, -0.2, 0.0]
"#;

const SHAPE: &str = "v -1 -0.7 0.2\nv 0.9 -0.8 0.4\nv 0.1 1.1 -0.1\nv 0.2 0.1 0.9\n\
                     f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

/// The truth is differences of finely sampled images, which know nothing of edges.
#[test]
fn settings_are_as_accurate_as_asked_where_edges_move() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("shape.obj"), SHAPE).unwrap();
    let experiment = Experiment::parse(SCENE, folder.path(), "a tetrahedron").unwrap();
    let fine = Settings { sampling: Sampling::Grid(24), edges: Edges::Off, ..Settings::default() };
    let fine = fine.in_double_precision();
    let integrals = Recovery::new(&experiment, "a tetrahedron", &fine).unwrap();
    let truth = differences(&integrals);
    let metric = GradientMetric::new(integrals.scene(), integrals.ids());

    let edges = Settings { edges: Edges::Auto, ..Settings::default() }.in_double_precision();
    let recovery = integrals.with_settings(&edges);
    for accuracy in [0.2, 0.02] {
        let selection =
            select(&recovery, accuracy, Rays::Chosen { sampler: Sampler::Sobol, most: 64 });
        assert!(selection.is_within(), "{selection}");
        // No setting is exact.
        assert!(selection.trials.iter().all(|trial| trial.error > 1e-5), "{selection}");
        let found = selection.best.setting.apply(&recovery).evaluate().unwrap().gradient;
        let error = metric.error(&found, &truth);
        assert!(error < accuracy, "{error:.1e}: {found:?} {truth:?}: {selection}");
    }
    let interior = integrals.evaluate().unwrap().gradient;
    assert!(metric.error(&interior, &truth) > 0.5, "{interior:?} {truth:?}");
}

/// Central differences of the loss by each number.
fn differences(recovery: &Recovery<'_>) -> Vec<f64> {
    const STEP: f64 = 5e-3;
    let at = recovery.initial();
    let mut objective = ImageObjective::new(recovery, recovery.render_settings());
    let mut loss_at = |index: usize, by: f64| {
        let mut moved = at.clone();
        moved[index] += by;
        objective.evaluate(&moved).loss
    };
    (0..at.len())
        .map(|index| (loss_at(index, STEP) - loss_at(index, -STEP)) / (2.0 * STEP))
        .collect()
}
