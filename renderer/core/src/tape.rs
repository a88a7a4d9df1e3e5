//! The gradient on tapes that are recorded at run time.
//!
//! The forward pass runs on the variables of a tape, so what is recorded is the transport along the paths
//! that the tracer finds. It shares no code with the adjoint but the forward pass.

use ad::tape::{Recording, Var};
use ad::vector::{Vector, Vector3};
use ad::{Additive, Real, Vec3};

use crate::adjoint::Request;
use crate::loss::PixelLoss;
use crate::number::widen;
use crate::parallel;
use crate::primal::image::visit;
use crate::primal::inputs::Inputs;
use crate::primal::integrator::Prepared;
use crate::primal::path::Path;
use crate::primal::varying::Varying;
use crate::primal::wavefront::samples;
use crate::scene::{ParameterId, Scene};
use crate::settings::Settings;
use crate::trace::bvh::{PACKET_RAYS, rays};
use crate::trace::tile::{Tile, strips};

/// A prepared scene whose gradients are recorded on tapes, in double precision.
pub struct TapeRenderer {
    prepared: Prepared<f64>,
}

impl TapeRenderer {
    /// Prepares a valid scene.
    pub fn new(scene: &Scene, settings: Settings) -> Self {
        Self { prepared: Prepared::new(scene, settings) }
    }

    /// The gradient of a loss by some parameters, one after the other: on one tape for the `whole` image,
    /// or on one for each strip of it.
    pub fn gradient(
        &self,
        scene: &Scene,
        loss: &dyn PixelLoss,
        ids: &[ParameterId],
        whole: bool,
    ) -> Vec<f64> {
        let Self { prepared } = self;
        let strips = strips(prepared.layout.width, prepared.layout.height);
        let tiles: Vec<Vec<Tile>> =
            strips.into_iter().map(|strip| strip.tiles().collect()).collect();
        let on_one_tape = |tiles: &[Tile]| on_tape(prepared, scene, loss, ids, tiles);
        let parts: Vec<Vec<f64>> = match whole {
            true => vec![on_one_tape(&tiles.concat())],
            false => parallel::map(tiles, |tiles: Vec<Tile>| on_one_tape(&tiles)),
        };
        let mut total = vec![0.0; parts.first().map_or(0, Vec::len)];
        for part in parts {
            total.iter_mut().zip(part).for_each(|(total, part)| *total += part);
        }
        total
    }
}

/// What the pixels of some tiles add to the gradient.
fn on_tape(
    prepared: &Prepared<f64>,
    scene: &Scene,
    loss: &dyn PixelLoss,
    ids: &[ParameterId],
    tiles: &[Tile],
) -> Vec<f64> {
    let recording = Recording::start();
    let block = |&id: &ParameterId| {
        (id, scene.get(id).iter().map(|&value| recording.variable(value)).collect())
    };
    let varying = Varying { blocks: ids.iter().map(block).collect() };
    let (layout, origin) = (&prepared.layout, prepared.inputs.origin);
    let inputs = Inputs::<Var>::new(scene, layout, origin, &varying);
    let zero_weight = Request::new(scene, &prepared.layout, ids).zero_weight;
    let integrator = prepared.with_inputs(&inputs).with_zero_weight(zero_weight);
    let mut path = Path::default();
    let sampling = prepared.layout.sampling;
    let count = f64::from(sampling.count());
    // Each radiance times the derivative of the loss by it: the derivatives of the sum are those of the
    // loss.
    let mut linear_loss = Var::ZERO;
    for tile in tiles {
        let mut radiance: [Vec3<Var>; PACKET_RAYS] = [Additive::zero(); PACKET_RAYS];
        for sample in samples(tile, sampling) {
            visit(integrator, sample, &mut path, |group, brought| radiance[group.first] += brought);
        }
        for ray in rays(tile.rays()) {
            let (x, y) = tile.pixel(ray);
            let value = widen::<Var>(radiance[ray]);
            let (_, derivative) = loss.evaluate(x, y, value / count);
            let [x, y, z] = (derivative / count).to_array().map(Var::from_f64);
            linear_loss += radiance[ray].dot(Vector3::new(x, y, z));
        }
    }
    let cotangents = recording.cotangents(linear_loss);
    let variables = varying.blocks.iter().flat_map(|(_, block)| block);
    variables.map(|&variable| cotangents.by(variable)).collect()
}
