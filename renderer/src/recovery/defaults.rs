//! Bounds and learning rates for who gives none.

use std::f64::consts::PI;

use glam::DVec3;

use crate::experiment::TunedParameter;
use crate::optimize::Variable;
use crate::scene::{LARGEST_EXPONENT, Light, ParameterId, Scene};

/// The learning rate of a parameter, the length of the first Adam step, in its natural scale.
///
/// Large enough to get anywhere within the default number of iterations; the steps get smaller
/// where the gradient does. Camera and vertices have to be close to begin with, because only the
/// interior term of their gradient is known; so they take their time.
fn relative_rate(id: ParameterId) -> f64 {
    use ParameterId::*;
    match id {
        LookFrom
        | LookAt
        | Up
        | Vfov
        | Focus
        | Vertices(_)
        | Vertex { .. }
        | TextureCoordinates(_)
        | ShapeParameters(_)
        | LightParameters(_) => 0.01,
        LightPosition(_) | LightDirection(_) | LightColor(_) | LightIntensity(_) | Ambient(_)
        | Diffuse(_) | Specular(_) | Exponent(_) | Reflection(_) | Opacity(_) | SphereCenter(_)
        | SphereRadius(_) | Texels(_) => 0.04,
    }
}

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
        .unwrap_or_else(|| relative_rate(tuned.id) * natural_scale(scene, tuned.id));
    let mut variable = Variable::new(scene.path(tuned.id).to_string(), initial, rate);
    let (low, high) = domain(scene, tuned.id);
    variable = variable.bounded(low, high);
    let narrow = |bounds: &mut [f64], given: &Option<Vec<f64>>, tighter: fn(f64, f64) -> f64| {
        for (bound, given) in bounds.iter_mut().zip(given.iter().flatten()) {
            *bound = tighter(*bound, *given);
        }
    };
    narrow(&mut variable.min, &tuned.min, f64::max);
    narrow(&mut variable.max, &tuned.max, f64::min);
    if tuned.max.is_none() {
        for (i, max) in variable.max.iter_mut().enumerate() {
            // What is above it to begin with, or is known to be, may stay there.
            let truth = target.as_ref().map_or(f64::NEG_INFINITY, |target| target[i]);
            *max = max.min(usual_max(tuned.id).max(variable.initial[i]).max(truth));
        }
    }
    variable.target = target;
    variable
}

/// The most that a parameter is where nobody says otherwise: a surface reflects no more light than it
/// receives. Beyond that, a bright spot could as well be explained by a surface that makes light as by a
/// stronger lamp.
fn usual_max(id: ParameterId) -> f64 {
    use ParameterId::*;
    match id {
        Diffuse(_) | Specular(_) | Reflection(_) => 1.0,
        _ => f64::INFINITY,
    }
}

/// The values for which a parameter means something, ends included.
pub(crate) fn domain(scene: &Scene, id: ParameterId) -> (f64, f64) {
    use ParameterId::*;
    let above_zero = (1e-18, f64::INFINITY);
    match id {
        Vfov => (1e-3, 179.999),
        Focus | SphereRadius(_) => above_zero,
        Exponent(_) => (0.0, LARGEST_EXPONENT),
        Opacity(_) => (0.0, 1.0),
        Texels(i) if scene.is_of_opacity(i) => (0.0, 1.0),
        LightColor(_) | LightIntensity(_) | Ambient(_) | Diffuse(_) | Specular(_)
        | Reflection(_) | Texels(_) => (0.0, f64::INFINITY),
        LookFrom
        | LookAt
        | Up
        | LightPosition(_)
        | LightDirection(_)
        | SphereCenter(_)
        | Vertices(_)
        | Vertex { .. }
        | TextureCoordinates(_)
        | ShapeParameters(_)
        | LightParameters(_) => (f64::NEG_INFINITY, f64::INFINITY),
    }
}

/// A change of a parameter that changes the image a lot.
///
/// - The camera turns or zooms by a part of its view; a light or the camera moves by a part of its
///   distance; a sphere by a part of its radius, vertices by a part of an edge of their mesh.
/// - Reflectances change by 1.
/// - A light changes as much as it takes to bring the irradiance 1 to what the camera looks at, or,
///   if it is stronger than that already, by what it is.
pub fn natural_scale(scene: &Scene, id: ParameterId) -> f64 {
    use ParameterId::*;
    let parameters = &scene.parameters;
    let size = parameters.get(id).iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    let camera = &parameters.camera;
    let view = camera.look_from.distance(camera.look_at);
    let from_light = |i: usize| match &parameters.lights[i] {
        Light::Point(light) => light.position.distance(camera.look_at),
        Light::Distant(_) => view,
    };
    match id {
        LookFrom => view,
        LookAt => view * (0.5 * camera.vfov).to_radians().tan() * camera.focus,
        LightPosition(i) => positive_or(from_light(i), view),
        LightIntensity(i) => match &parameters.lights[i] {
            Light::Point(_) => size.max(4.0 * PI * from_light(i).powi(2)),
            Light::Distant(_) => size.max(1.0),
        },
        Exponent(_) => size.max(10.0),
        Up | LightDirection(_) | Vfov | Focus => size,
        LightColor(_)
        | Ambient(_)
        | Diffuse(_)
        | Specular(_)
        | Reflection(_)
        | Opacity(_)
        | TextureCoordinates(_)
        | Texels(_) => 1.0,
        SphereCenter(i) => parameters.spheres[i].radius,
        SphereRadius(_) => size,
        ShapeParameters(_) | LightParameters(_) => positive_or(size, 1.0),
        Vertices(i) | Vertex { mesh: i, .. } => {
            positive_or(mean_edge(&scene.meshes[i].triangles, &parameters.vertices[i]), view)
        }
    }
}

fn positive_or(size: f64, other: f64) -> f64 {
    if size > 0.0 { size } else { other }
}

/// The mean length of the edges of a mesh.
fn mean_edge(triangles: &[[u32; 3]], vertices: &[[f64; 3]]) -> f64 {
    let vertex = |i: u32| DVec3::from_array(vertices[i as usize]);
    let edges = triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let total: f64 = edges.map(|(a, b)| vertex(a).distance(vertex(b))).sum();
    total / (3 * triangles.len().max(1)) as f64
}
