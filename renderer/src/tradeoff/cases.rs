//! The settings that a scene gives a choice of.

use ad::lanes::{f32x16, f64x8};
use glam::DVec3;

use super::axis::Axis;
use super::engine::{
    Adjoint, Differences, Engine, Geometry, ImageFirst, Question, ReplayMode, Replayed, is_geometry,
};
use super::measurement::Case;
use crate::acceleration::Effort;
use crate::accuracy::GradientMetric;
use crate::arithmetic::{Arithmetic, Precision, with_arithmetic};
use crate::integrator::{RenderSettings, Visibility};
use crate::recovery::Recovery;
use crate::scene::ParameterId;

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
    let settings = RenderSettings::default();
    let question = Question { recovery, settings };
    let (mut cases, mut remarks) = (Vec::new(), Vec::new());
    let mut push = |axis, setting: String, engine, elements| {
        cases.push(Case { axis, setting, step: None, engine, elements });
    };

    for arithmetic in Arithmetic::ALL {
        let engine: Box<dyn Engine + 'a> =
            with_arithmetic!(arithmetic, L => Box::new(Adjoint::<L>::new(question)));
        push(Axis::Arithmetic, arithmetic.name().to_owned(), engine, None);
    }

    let image_first = Box::new(ImageFirst(Adjoint::<f32x16>::new(question)));
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
    if scene.shapes.is_empty() && scene.custom_lights.is_empty() {
        let mut replay = |setting: &str, mode: ReplayMode, elements| {
            let engine = Box::new(Replayed::<f64x8>::new(question, mode));
            push(Axis::Engine, setting.to_owned(), engine, elements);
        };
        if pixels <= MOST_PIXELS_ON_TAPE {
            replay("tape for the image, f64", ReplayMode::Tape(pixels), None);
        } else {
            remarks.push(format!(
                "no tape for the whole image: it has more than {MOST_PIXELS_ON_TAPE} pixels"
            ));
        }
        replay("tape per 64 pixels, f64", ReplayMode::Tape(64), None);
        replay("dual numbers, f64", ReplayMode::Forward(elements.clone()), among.clone());
        for (setting, sums) in
            [("dual numbers, f32", Precision::F64), ("the same, sums in f32", Precision::F32)]
        {
            let mode = ReplayMode::SingleForward(elements.clone(), sums);
            replay(setting, mode, among.clone());
        }
    } else {
        remarks.push(
            "no tape and no dual numbers: the scene has shapes or lights of its user's own".into(),
        );
    }

    let triangles: usize = scene.meshes.iter().map(|mesh| mesh.triangles.len()).sum();
    let tests = pixels as f64 * (triangles + scene.spheres.len()) as f64;
    for (name, visibility) in [("list", Visibility::List), ("rasteriser", Visibility::Raster)] {
        if visibility == Visibility::List && tests > MOST_TESTS {
            remarks.push(format!("no list: it would take {tests:.0e} tests of rays"));
            continue;
        }
        let settings = RenderSettings { visibility, ..settings };
        let engine = Box::new(Adjoint::<f32x16>::new(Question { settings, ..question }));
        push(Axis::Visibility, format!("{name}, f32x16"), engine, None);
    }
    let is_moving = recovery.ids().iter().any(is_geometry);
    for effort in Effort::ALL {
        let settings = RenderSettings { effort, ..settings };
        let mut tree = |geometry, when: &str| {
            let question = Question { settings, ..question };
            let engine = Box::new(Adjoint::<f32x16>::with_geometry(question, geometry));
            push(Axis::Tree, format!("{} effort{when}, f32x16", effort.name()), engine, None);
        };
        if effort != Effort::default() {
            tree(Geometry::AsAsked, "");
        }
        if !is_moving {
            tree(Geometry::Fitted, ", fitted");
        }
        tree(Geometry::Anew, ", anew");
    }
    let is_mirror = |i: usize| scene.parameters.materials[i].reflection != DVec3::ZERO;
    let goes_on = |i: usize| is_mirror(i) || scene.materials[i].opacity.is_some();
    let has_bounces = (0..scene.materials.len()).any(goes_on);
    for bounces in if has_bounces { 0..scene.bounces } else { 0..0 } {
        let settings = RenderSettings { bounces: Some(bounces), ..settings };
        let engine = Box::new(Adjoint::<f32x16>::new(Question { settings, ..question }));
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
        let single = Box::new(Differences::<f32x16>::new(question, steps.clone()));
        let double = Box::new(Differences::<f64x8>::new(question, steps));
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
        .flat_map(|&id| (0..scene.parameters.get(id).len()).map(move |index| (id, index)))
        .collect();
    let step = |&element: &usize| {
        let (id, index) = numbers[element];
        (id, index, relative * metric.scale(element))
    };
    elements.iter().map(step).collect()
}
