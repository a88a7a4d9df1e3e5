//! What engines give, on generated scenes.

mod scenes;

use super::axis::Axis;
use super::engine::{Adjoint, Engine, Forward, ImageFirst, Question, Tape, is_geometry};
use super::sampling::RayPlaces;
use super::table::pareto_front;
use super::*;
use crate::arithmetic::{Arithmetic, Precision};
use crate::experiment::{Experiment, TunedParameter};
use crate::scene::{Integrator, Material, Mesh, Object, PathTracing, Transform};

pub use scenes::random_experiment;

/// The gradient of a problem on tapes, in double precision and with all mirrors that the scene asks
/// for.
pub fn gradient_on_tapes(recovery: &Recovery<'_>) -> Vec<f64> {
    Tape::new(exactly(recovery), false).gradient()
}

fn exactly<'a>(recovery: &'a Recovery<'_>) -> Question<'a> {
    Question { recovery, settings: without_edges().in_double_precision() }
}

fn recovery(experiment: &Experiment) -> Recovery<'_> {
    let settings = without_edges().in_double_precision();
    Recovery::new(experiment, "a generated scene", &settings).unwrap()
}

/// Three ways that share the forward pass and nothing else agree: that by dual numbers in `at_most` components.
fn assert_agreement(number: u64, experiment: &Experiment, at_most: usize) {
    let recovery = recovery(experiment);
    let question = exactly(&recovery);
    let adjoint = Adjoint::new(question).gradient();
    let metric = GradientMetric::new(recovery.scene(), recovery.ids());
    assert!(adjoint.iter().any(|&derivative| derivative != 0.0), "{number}");

    let error = metric.error(&gradient_on_tapes(&recovery), &adjoint);
    assert!(error < 1e-10, "{number}: tape and adjoint differ by {error:e}");

    let some: Vec<usize> = (0..metric.count()).step_by(metric.count().div_ceil(at_most)).collect();
    let forward = Forward::new(question, some.clone()).gradient();
    let error = metric.error_among(&some, &forward, &adjoint);
    assert!(error < 1e-10, "{number}: dual numbers and adjoint differ by {error:e}");
}

#[test]
fn adjoint_tape_and_dual_numbers_agree() {
    for number in 0..30 {
        let mut experiment = random_experiment(number);
        turn_spheres(&mut experiment);
        assert_agreement(number, &experiment, 8);
    }
}

/// The same three ways on smooth meshes, whose normals are computed or given.
#[test]
fn they_agree_on_smooth_meshes() {
    for number in 0..6 {
        let mut experiment = random_experiment(number);
        add_smooth_mesh(&mut experiment, number % 2 == 0);
        assert_agreement(number, &experiment, usize::MAX);
    }
}

/// The same three ways where light takes all paths, several of them through each pixel.
#[test]
fn they_agree_along_paths() {
    for number in 0..4 {
        let mut experiment = random_experiment(number);
        let scene = &mut experiment.scene;
        scene.integrator = Integrator::Path(PathTracing { max_depth: 3, samples: 3, seed: 5 });
        // By weights of zero the derivative needs other paths than the image has.
        let ids = scene.parameters().into_iter();
        let ids = ids.filter(|&id| scene.get(id).iter().any(|&number| number != 0.0));
        let parameters = ids.map(TunedParameter::new).collect();
        experiment.optimize.get_or_insert_default().parameters = parameters;
        assert_agreement(number, &experiment, usize::MAX);
    }
}

/// Adds a bent sheet before the spheres, all of whose numbers vary.
fn add_smooth_mesh(experiment: &mut Experiment, is_computed: bool) {
    let scene = &mut experiment.scene;
    let vertices = vec![[-1.5, 0.1, 2.0], [0.0, 0.2, 2.9], [1.5, 0.0, 2.1], [0.1, 1.9, 1.7]];
    let mesh = Mesh::new("sail", vertices, vec![[0, 1, 3], [1, 2, 3]]);
    let normals = vec![[-1.0, 0.2, 1.0], [0.1, 0.1, -2.0], [0.7, 0.1, 1.0], [0.0, 0.9, 1.0]];
    let mesh = match is_computed {
        true => mesh.smooth(),
        false => mesh.normals(normals, vec![[0, 1, 3], [1, 2, 3]]),
    };
    let rotation = glam::DVec3::new(5.0, -10.0, 3.0);
    let scale = glam::DVec3::new(1.1, 0.9, -1.2);
    let mesh = mesh.transform(Transform { rotation, scale, ..Transform::IDENTITY });
    let silk = Material {
        specular: glam::DVec3::splat(0.3),
        exponent: 9.0,
        mirror: glam::DVec3::splat(0.2),
        ..Material::lambertian(glam::DVec3::splat(0.5))
    };
    let silk = scene.add_material("silk", silk).unwrap();
    let mesh = scene.add_mesh(mesh.material(silk)).unwrap() as usize;
    let ids = scene.parameters_of(Object::Mesh(mesh));
    let tuned = ids.map(TunedParameter::new);
    experiment.optimize.get_or_insert_default().parameters.extend(tuned);
}

/// Lets the rotations of all spheres vary too.
fn turn_spheres(experiment: &mut Experiment) {
    let ids = experiment.scene.parameters().into_iter().filter(|id| id.field == "rotation");
    let turned = ids.map(TunedParameter::new);
    experiment.optimize.get_or_insert_default().parameters.extend(turned);
}

/// The same gradient, with single precision in between.
#[test]
fn the_image_may_come_first() {
    for number in 0..5 {
        let experiment = random_experiment(number);
        let recovery = recovery(&experiment);
        let question = exactly(&recovery);
        let metric = GradientMetric::new(recovery.scene(), recovery.ids());
        let in_one_pass = Adjoint::new(question).gradient();
        let image_first = ImageFirst(Adjoint::new(question)).gradient();
        let error = metric.error(&image_first, &in_one_pass);
        assert!(error < 1e-4, "{number}: {error:e}");
    }
}

/// Dual numbers in single precision are off by rounding alone.
#[test]
fn dual_numbers_are_in_the_precision_asked_for() {
    let experiment = ball(
        r#"
        specular = [0.5, 0.5, 0.5]
        exponent = 12.0
        [[optimize.parameter]]
        path = "light.key.radiant_intensity"
        [optimize.target_values]
        "light.key.radiant_intensity" = 50.0
        "#,
    );
    let recovery = recovery(&experiment);
    let metric = GradientMetric::new(recovery.scene(), recovery.ids());
    let double = exactly(&recovery);
    let single = Question { settings: without_edges(), ..double };
    let [single, double] =
        [single, double].map(|question| Forward::new(question, vec![0]).gradient());
    let error = metric.error(&single, &double);
    assert!(0.0 < error && error < 1e-5, "{error:e}");
}

/// One tape or many: the same sums in another order.
#[test]
fn the_length_of_tapes_does_not_matter() {
    let experiment = random_experiment(3);
    let recovery = recovery(&experiment);
    let of = |whole| Tape::new(exactly(&recovery), whole).gradient();
    let metric = GradientMetric::new(recovery.scene(), recovery.ids());
    assert!(metric.error(&of(false), &of(true)) < 1e-12);
}

#[test]
fn a_scene_is_measured_along_every_axis_that_it_has() {
    let experiment = (0..).map(random_experiment).find(|e| e.scene.bounces == 2).unwrap();
    let mut scene = experiment.scene.clone();
    scene.materials[0].values.mirror = glam::DVec3::splat(0.3);
    let experiment = Experiment { scene, ..experiment };
    let recovery = recovery(&experiment);
    let Tradeoff { measurements, .. } = measure(&recovery, 0.0);
    let settings = |axis: Axis| -> Vec<&Measurement> {
        measurements.iter().filter(|measurement| measurement.axis == axis).collect()
    };
    assert_eq!(settings(Axis::Arithmetic).len(), Arithmetic::ALL.len());
    assert_eq!(settings(Axis::Engine).len(), 5);
    assert_eq!(settings(Axis::Visibility).len(), 2);
    assert_eq!(settings(Axis::Bounces).len(), 2);
    let moves = recovery.ids().iter().any(is_geometry);
    assert_eq!(settings(Axis::Tree).len(), if moves { 5 } else { 8 });
    // Trees find the same, whatever they cost.
    let fastest = Arithmetic::fastest(Precision::F32).name();
    let fastest = settings(Axis::Arithmetic).into_iter().find(|it| it.setting == fastest).unwrap();
    for tree in settings(Axis::Tree) {
        assert_eq!(tree.gradient_error, fastest.gradient_error, "{tree:?}");
    }
    assert_eq!(settings(Axis::SingleDifferences).len(), 12);
    assert!(measurements.iter().all(|m| m.seconds > 0.0 && m.runs >= 1));
    // Single precision is off by rounding, and by much more than double precision.
    for measurement in settings(Axis::Arithmetic) {
        let range = match measurement.setting.starts_with("f32") {
            true => 1e-9..1e-2,
            false => 0.0..1e-10,
        };
        assert!(range.contains(&measurement.gradient_error), "{measurement:?}");
    }
    // Fewer mirrors are further off.
    let bounces = settings(Axis::Bounces);
    assert!(bounces[0].gradient_error > bounces[1].gradient_error, "{bounces:?}");
    assert!(bounces[1].image_error > Some(1e-5), "{bounces:?}");
}

/// Where no edge moves, the error of differences has a bottom between large and small steps, lower
/// in double precision.
#[test]
fn differences_have_a_best_step() {
    let experiment = ball(
        r#"
        specular = [0.5, 0.5, 0.5]
        exponent = 12.0
        [[optimize.parameter]]
        path = "material.paint.exponent"
        [optimize.target_values]
        "material.paint.exponent" = 14.0
        "#,
    );
    let Tradeoff { measurements, .. } = measure(&recovery(&experiment), 0.0);
    let [single, double] = &steps(&measurements)[..] else { panic!("two curves") };
    let ((single_step, single_error), (double_step, double_error)) =
        (best_step(single).unwrap(), best_step(double).unwrap());
    // The cube root of the rounding unit, give or take the curvature.
    assert!((1e-4..1e-1).contains(&single_step), "{single:?}");
    assert!((1e-7..1e-3).contains(&double_step), "{double:?}");
    assert!(double_error < 1e-8 && single_error > 100.0 * double_error, "{single:?} {double:?}");
    for curve in [single, double] {
        let (first, last) = (curve.points[0].1, curve.points[11].1);
        let (_, least) = best_step(curve).unwrap();
        assert!(first > 10.0 * least && last > 10.0 * least, "{curve:?}");
    }
}

#[test]
fn the_front_holds_what_nothing_beats() {
    let measurement = |seconds: f64, gradient_error: f64| Measurement {
        axis: Axis::Arithmetic,
        setting: String::new(),
        step: None,
        seconds,
        runs: 1,
        bytes: None,
        image_error: None,
        gradient_error,
    };
    let measurements = [
        measurement(1.0, 1e-3),
        measurement(2.0, 1e-3),
        measurement(2.0, 1e-6),
        measurement(3.0, 1e-5),
        measurement(0.5, f64::INFINITY),
        measurement(4.0, 0.0),
    ];
    assert_eq!(pareto_front(&measurements), [0, 2, 5]);
    let csv = csv(&measurements);
    assert_eq!(csv.lines().count(), 7);
    assert_eq!(csv.lines().filter(|line| line.ends_with(",true")).count(), 3);
    // Names of axes have commas.
    assert!(csv.contains("\n\"adjoint\",\"\",1e0,1,,,1e-3,true\n"), "{csv}");
    let svg = tradeoff_svg("a plot", &measurements).unwrap();
    assert!(svg.contains("a plot") && !svg.contains("NaN") && !svg.contains("inf"), "{svg}");
}

#[test]
fn the_error_of_a_gradient_weighs_derivatives_by_their_scales() {
    let experiment = random_experiment(0);
    let scene = &experiment.scene;
    let ids =
        ["material.paint0.exponent", "camera.vfov"].map(|path| scene.parameter(path).unwrap());
    let metric = GradientMetric::new(scene, &ids);
    let scales = ids.map(|id| scene.natural_scale(id));
    let reference = [3.0 / scales[0], 4.0 / scales[1]];
    let gradient = [3.0 / scales[0], 4.5 / scales[1]];
    assert!((metric.error(&gradient, &reference) - 0.1).abs() < 1e-12);
    assert_eq!(metric.error(&reference, &reference), 0.0);
    assert_eq!(metric.error(&gradient, &[0.0; 2]), f64::INFINITY);
    assert_eq!(metric.error(&[f64::NAN, 0.0], &reference), f64::INFINITY);
}

#[test]
fn optimisations_approach_the_truth_whatever_their_sizes() {
    let experiment = ball(
        r#"
        diffuse = [0.2, 0.3, 0.4]
        [[optimize.parameter]]
        path = "material.paint.diffuse"
        [optimize.target_values]
        "material.paint.diffuse" = [0.5, 0.5, 0.5]
        "#,
    );
    let recovery = recovery(&experiment);
    let runs = measure_schedules(&recovery, &recovery.settings()).unwrap();
    assert_eq!(runs.len(), 4);
    for run in runs {
        let (&(_, first), &(_, last)) = (run.way.first().unwrap(), run.way.last().unwrap());
        assert_eq!(first, 1.0);
        // Each size goes on where the one before has ended.
        assert_eq!(run.way.iter().filter(|(_, distance)| *distance == 1.0).count(), 1);
        assert!(last < 0.05, "{}: {last}", run.name());
        assert!(run.way.is_sorted_by(|a, b| a.0 <= b.0), "{}", run.name());
    }
}

#[test]
fn more_rays_are_less_off_and_what_is_off_is_bias_and_spread() {
    let experiment = ball(
        r#"
        diffuse = [0.2, 0.3, 0.4]
        [[optimize.parameter]]
        path = "material.paint.diffuse"
        [[optimize.parameter]]
        path = "light.key.radiant_intensity"
        [optimize.target_values]
        "material.paint.diffuse" = [0.5, 0.5, 0.5]
        "#,
    );
    let measured = measure_sampling(&recovery(&experiment));
    let (middle, random) = measured.runs.split_first().unwrap();
    assert_eq!((middle.rays, middle.count), (RayPlaces::Middle, 1));
    assert!(middle.spread < 1e-12, "{middle:?}");
    assert_eq!(random.len(), 2 * 2 * 5);
    for run in random {
        let both = run.bias.hypot(run.spread);
        assert!((run.error - both).abs() < 1e-6 * both, "{run:?}");
        assert!(run.seconds > 0.0 && run.bias > 0.0, "{run:?}");
    }
    for way in random.chunks(5) {
        let (few, many) = (&way[1], &way[3]);
        assert_eq!((few.count, many.count), (4, 64));
        assert!(many.spread < 0.5 * few.spread, "{few:?} {many:?}");
        assert!(many.image_error < 0.5 * few.image_error, "{few:?} {many:?}");
        assert!(measured.reference_error < 0.5 * many.spread, "{measured:?}");
    }
    assert_eq!(sampling_table(&measured).lines().count(), 1 + 21 + 1);
    assert_eq!(sampling_csv(&measured).lines().count(), 1 + 21);
    let curves = sampling_curves(&measured);
    assert_eq!(curves.len(), 2 * 2 * 2);
    assert!(curves.iter().all(|curve| curve.points.len() == 5), "{curves:?}");
}

#[test]
fn edges_are_measured_where_parameters_move_them() {
    let material = "diffuse = [0.2, 0.3, 0.4]";
    let of = |path: &str, value: &str| {
        ball(&format!(
            "{material}\n[[optimize.parameter]]\npath = \"{path}\"\n\
             [optimize.target_values]\n\"{path}\" = {value}\n"
        ))
    };
    let still = of("light.key.radiant_intensity", "70.0");
    assert_eq!(measure_edges(&recovery(&still)), None);
    let moving = of("sphere.ball.center", "[0.2, 0.1, 0.0]");
    let measured = measure_edges(&recovery(&moving)).unwrap();
    let (off, on) = measured.runs.split_at(4);
    assert!(off.iter().all(|run| run.edges == Edges::Off && run.gradient_error > 0.3), "{off:?}");
    assert!(on.iter().all(|run| run.edges == Edges::On && run.gradient_error < 0.1), "{on:?}");
    assert!(on[3].image_error < 0.5 * on[0].image_error, "{on:?}");
    assert_eq!(edge_table(&measured).lines().count(), 1 + 8 + 1);
    assert_eq!(edge_csv(&measured).lines().count(), 1 + 8);
}

/// A ball under a light, in an image of 32 x 32 pixels; `rest` is its material, and what follows.
fn ball(rest: &str) -> Experiment {
    let text = format!(
        r#"
        [camera]
        look_from = [0.0, 0.0, 4.0]
        look_at = [0.0, 0.0, 0.0]
        width = 32
        height = 32
        [[light]]
        name = "key"
        type = "point"
        position = [1.0, 2.0, 4.0]
        radiant_intensity = 75.0
        [[sphere]]
        name = "ball"
        center = [0.0, 0.0, 0.0]
        radius = 1.0
        material = "paint"
        [material.paint]
        {rest}
        "#
    );
    Experiment::parse(&text, std::path::Path::new(""), "a ball").unwrap()
}
