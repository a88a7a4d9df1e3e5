//! The settings that a scene gives a choice of.

use glam::DVec3;

use super::axis::Axis;
use super::engine::{
    Adjoint, Differences, Engine, Forward, Geometry, ImageFirst, Question, Tape, is_geometry,
};
use super::measurement::Case;
use super::without_edges;
use crate::accuracy::GradientMetric;
use crate::arithmetic::Arithmetic;
use crate::recovery::Recovery;
use crate::scene::{MaterialObject, ParameterId};
use crate::settings::{BuildQuality, PrimaryVisibility, Settings};

/// Engines that go derivative by derivative are asked for so many at most, evenly spaced.
const MOST_ELEMENTS: usize = 12;
/// A list is measured up to so many tests of a ray against a primitive.
const MOST_TESTS: f64 = 1e10;
/// One tape for the whole image is recorded up to so many pixels: a pixel takes some 10 kilobytes.
const MOST_PIXELS_ON_TAPE: usize = 1 << 16;
/// The steps of differences: 10 to the power of minus these, times the natural scale.
const STEP_EXPONENTS: std::ops::RangeInclusive<i32> = 1..=12;

/// All settings for a recovery, and remarks on those that there are not.
pub(super) fn cases<'a>(
    recovery: &'a Recovery<'a>,
    metric: &GradientMetric,
) -> (Vec<Case<'a>>, Vec<String>) {
    let scene = recovery.scene();
    let settings = without_edges();
    let question = Question { recovery, settings };
    let (mut cases, mut remarks) = (Vec::new(), Vec::new());
    let mut push = |axis, setting: String, engine, elements| {
        cases.push(Case { axis, setting, step: None, engine, elements });
    };

    for &arithmetic in Arithmetic::ALL {
        let settings = Settings { arithmetic, ..settings };
        let engine = Box::new(Adjoint::new(Question { settings, ..question }));
        push(Axis::Arithmetic, arithmetic.name().to_owned(), engine, None);
    }

    let image_first = Box::new(ImageFirst(Adjoint::new(question)));
    push(Axis::Engine, "image, then adjoint, f32x16".into(), image_first, None);

    let pixels = scene.width as usize * scene.height as usize;
    let elements = sampled(metric.count());
    let among = (elements.len() < metric.count()).then(|| elements.clone());
    if among.is_some() {
        remarks.push(format!(
            "forward mode and differences: {} of {} derivatives, evenly spaced; their times are scaled up",
            elements.len(),
            metric.count()
        ));
    }
    let double = Question { settings: settings.in_double_precision(), ..question };
    if pixels <= MOST_PIXELS_ON_TAPE {
        let tape = Box::new(Tape::new(double, true));
        push(Axis::Engine, "tape for the image, f64".into(), tape, None);
    } else {
        remarks.push(format!(
            "no tape for the whole image: it has more than {MOST_PIXELS_ON_TAPE} pixels"
        ));
    }
    push(Axis::Engine, "tape per strip, f64".into(), Box::new(Tape::new(double, false)), None);
    for (setting, question) in [("dual numbers, f64", double), ("dual numbers, f32", question)] {
        let engine = Box::new(Forward::new(question, elements.clone()));
        push(Axis::Engine, setting.into(), engine, among.clone());
    }

    let triangles: usize = scene.meshes.iter().map(|mesh| mesh.triangles.len()).sum();
    let tests = pixels as f64 * (triangles + scene.spheres.len()) as f64;
    for (name, visibility) in
        [("brute force", PrimaryVisibility::BruteForce), ("rasteriser", PrimaryVisibility::Raster)]
    {
        if visibility == PrimaryVisibility::BruteForce && tests > MOST_TESTS {
            remarks.push(format!("no brute force: it would take {tests:.0e} tests of rays"));
            continue;
        }
        let settings = Settings { visibility, ..settings };
        let engine = Box::new(Adjoint::new(Question { settings, ..question }));
        push(Axis::Visibility, format!("{name}, f32x16"), engine, None);
    }
    let is_moving = recovery.ids().iter().any(is_geometry);
    for build_quality in BuildQuality::ALL {
        let settings = Settings { build_quality, ..settings };
        let mut tree = |geometry, when: &str| {
            let question = Question { settings, ..question };
            let engine = Box::new(Adjoint::with_geometry(question, geometry));
            let setting = format!("{} quality{when}, f32x16", build_quality.name());
            push(Axis::Tree, setting, engine, None);
        };
        if build_quality != BuildQuality::default() {
            tree(Geometry::AsAsked, "");
        }
        if !is_moving {
            tree(Geometry::Refitted, ", refitted");
        }
        tree(Geometry::Rebuilt, ", rebuilt");
    }
    let goes_on =
        |material: &MaterialObject| material.values.mirror != DVec3::ZERO || material.transparent;
    let has_bounces = scene.materials.iter().any(goes_on);
    for bounces in if has_bounces { 0..scene.bounces } else { 0..0 } {
        let settings = Settings { bounces: Some(bounces), ..settings };
        let engine = Box::new(Adjoint::new(Question { settings, ..question }));
        push(Axis::Bounces, format!("{bounces} bounces, f32x16"), engine, None);
    }
    cases.extend(differences(question, metric, &elements, among.as_ref()));
    (cases, remarks)
}

/// Central differences in both precisions, over all steps.
fn differences<'a>(
    question: Question<'a>,
    metric: &GradientMetric,
    elements: &[usize],
    among: Option<&Vec<usize>>,
) -> Vec<Case<'a>> {
    let mut cases = Vec::new();
    for exponent in STEP_EXPONENTS {
        let step = 10f64.powi(-exponent);
        let steps = steps(question.recovery, metric, elements, step);
        let settings = question.settings.in_double_precision();
        let single = Box::new(Differences::new(question, steps.clone()));
        let double = Box::new(Differences::new(Question { settings, ..question }, steps));
        let engines: [(Axis, Box<dyn Engine + 'a>); 2] =
            [(Axis::SingleDifferences, single), (Axis::DoubleDifferences, double)];
        cases.extend(engines.map(|(axis, engine)| Case {
            axis,
            setting: format!("step 1e-{exponent}"),
            step: Some(step),
            engine,
            elements: among.cloned(),
        }));
    }
    cases.sort_by_key(|case| case.axis == Axis::DoubleDifferences);
    cases
}

/// The indices that stand for `count` numbers.
fn sampled(count: usize) -> Vec<usize> {
    (0..count).step_by(count.div_ceil(MOST_ELEMENTS).max(1)).collect()
}

/// The parameter of each of the numbers, its index there, and its step.
fn steps(
    recovery: &Recovery<'_>,
    metric: &GradientMetric,
    elements: &[usize],
    relative: f64,
) -> Vec<(ParameterId, usize, f64)> {
    let scene = recovery.scene();
    let numbers: Vec<(ParameterId, usize)> = recovery
        .ids()
        .iter()
        .flat_map(|&id| (0..scene.count(id)).map(move |index| (id, index)))
        .collect();
    let step = |&element: &usize| {
        let (id, index) = numbers[element];
        (id, index, relative * metric.scale(element))
    };
    elements.iter().map(step).collect()
}
