//! Which primitives shine, and how much.

use ad::Scalar;

use super::inputs::Inputs;
use crate::number::{Number, widen};
use crate::scene::{Scene, Slot};
use crate::trace::emitters::Emitters;
use crate::trace::layout::{Kind, Layout};

/// The triangles and spheres that shine, where light takes all paths. Shapes of one's own, and what has a
/// texture of its emission, are found by scattered rays alone.
pub fn emitters<S: Number<Lane: Scalar>>(
    scene: &Scene,
    layout: &Layout,
    inputs: &Inputs<S>,
) -> Emitters {
    let mut powers = scene.materials.iter().map(|material| {
        let is_plain = material.textures.get(Slot::Emission).is_none();
        if is_plain { material.values.emission.max_element() } else { 0.0 }
    });
    if layout.path_tracing.is_none() || !powers.clone().any(|power| power > 0.0) {
        return Emitters::default();
    }
    let powers: Vec<f64> = powers.by_ref().collect();
    let power = |primitive: usize| {
        let radiance = powers[layout.material_of[primitive] as usize];
        (radiance > 0.0).then(|| radiance * area(layout, inputs, primitive))
    };
    let primitives = 0..layout.material_of.len();
    Emitters::new(primitives.filter_map(|primitive| Some((primitive as u32, power(primitive)?))))
}

fn area<S: Number<Lane: Scalar>>(layout: &Layout, inputs: &Inputs<S>, primitive: usize) -> f64 {
    match layout.kind_of(primitive) {
        (Kind::Triangle, index) => {
            let corner = |vertex: u32| widen::<S::Lane>(inputs.vertices[vertex as usize]);
            let [a, b, c] = layout.triangles[index].map(corner);
            0.5 * (b - a).cross(c - a).length()
        }
        (Kind::Sphere, index) => {
            let radius = inputs.spheres[index].radius.to_f64();
            4.0 * std::f64::consts::PI * radius * radius
        }
        (Kind::Custom, _) => 0.0,
    }
}
