//! Bounds and learning rates for who gives none.

use glam::DVec3;

use crate::experiment::TunedParameter;
use crate::optimize::Variable;
use crate::scene::{ParameterId, Scene};

/// The part of an Adam step in the scale of the parameter.
const RELATIVE_RATE: f64 = 0.02;

/// The variable for a parameter.
pub(super) fn variable(
    scene: &Scene,
    tuned: &TunedParameter,
    common_rate: Option<f64>,
    target: Option<Vec<f64>>,
) -> Variable {
    let initial = scene.parameters.get(tuned.id).to_vec();
    let rate = tuned
        .learning_rate
        .or(common_rate)
        .unwrap_or_else(|| RELATIVE_RATE * natural_scale(scene, tuned.id));
    let mut variable = Variable::new(scene.path(tuned.id).to_string(), initial, rate);
    let (low, high) = domain(tuned.id);
    variable = variable.bounded(low, high);
    let narrow = |bounds: &mut [f64], given: &Option<Vec<f64>>, tighter: fn(f64, f64) -> f64| {
        for (bound, given) in bounds.iter_mut().zip(given.iter().flatten()) {
            *bound = tighter(*bound, *given);
        }
    };
    narrow(&mut variable.min, &tuned.min, f64::max);
    narrow(&mut variable.max, &tuned.max, f64::min);
    variable.target = target;
    variable
}

/// The values for which a parameter means something, ends included.
fn domain(id: ParameterId) -> (f64, f64) {
    use ParameterId::*;
    let above_zero = (1e-30, f64::INFINITY);
    match id {
        Vfov => (1e-3, 179.999),
        Focus | SphereRadius(_) => above_zero,
        LightColor(_) | LightIntensity(_) | Ambient(_) | Diffuse(_) | Specular(_) | Exponent(_) => {
            (0.0, f64::INFINITY)
        }
        LookFrom | LookAt | Up | LightPosition(_) | LightDirection(_) | SphereCenter(_)
        | Vertices(_) => (f64::NEG_INFINITY, f64::INFINITY),
    }
}

/// A change of a parameter that changes the image a lot: distances count in the distance from the
/// camera to what it looks at, vertices and centres in the size of the scene.
pub fn natural_scale(scene: &Scene, id: ParameterId) -> f64 {
    use ParameterId::*;
    let parameters = &scene.parameters;
    let size = parameters.get(id).iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    let camera = &parameters.camera;
    let view = camera.look_from.distance(camera.look_at);
    match id {
        LookFrom | LookAt => view,
        LightPosition(_) => size.max(view),
        Up | LightDirection(_) | Vfov | Focus | LightIntensity(_) | Exponent(_)
        | SphereRadius(_) => positive_or_one(size),
        LightColor(_) | Ambient(_) | Diffuse(_) | Specular(_) => 1.0,
        SphereCenter(_) | Vertices(_) => positive_or_one(extent(scene)) * 0.1,
    }
}

fn positive_or_one(size: f64) -> f64 {
    if size > 0.0 { size } else { 1.0 }
}

/// The diagonal of the box around all geometry.
fn extent(scene: &Scene) -> f64 {
    let vertices = scene.parameters.vertices.iter().flatten().map(|&v| DVec3::from(v));
    let corners = vertices.map(|v| (v, v));
    let spheres = scene.parameters.spheres.iter();
    let spheres = spheres.map(|s| (s.center - s.radius, s.center + s.radius));
    corners
        .chain(spheres)
        .reduce(|(low, high), (a, b)| (low.min(a), high.max(b)))
        .map_or(0.0, |(low, high)| low.distance(high))
}
