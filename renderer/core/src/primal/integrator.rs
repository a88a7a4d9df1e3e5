//! A scene, ready for a pass.

use ad::Real;
use ad::lanes::Lanes;
use glam::DVec3;

use super::emitters::emitters;
use super::inputs::Inputs;
use super::tracer::Tracer;
use super::varying::Varying;
use crate::number::{Number, Plain};
use crate::scene::Scene;
use crate::settings::{Edges, Settings};
use crate::trace::bvh::{PACKET_RAYS, tile_position};
use crate::trace::emitters::Emitters;
use crate::trace::layout::Layout;
use crate::transport::material::Lobes;

/// What computes radiance along paths: a scene at the scalar `S`. Passes at other scalars trace the same
/// rays, so layout and tracer are shared.
pub struct Integrator<'a, S: Number> {
    pub layout: &'a Layout,
    pub tracer: &'a Tracer,
    pub inputs: &'a Inputs<S>,
    /// Where light takes all paths: what shines.
    pub emitters: &'a Emitters,
    /// Twice the columns and the rows of the rays of a packet, within their tile, by groups of lanes.
    pub film_offsets: &'a [(S::Lanes, S::Lanes)],
    pub zero_weight: ZeroWeight,
}

/// What is computed although its weight is zero: the value is zero, the derivative with respect to the
/// weight is not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ZeroWeight {
    /// Every opaque material counts as a mirror, so that derivatives by mirror reflectances of zero are computed.
    pub mirrors: bool,
    /// What is black reflects.
    pub reflections: bool,
    /// Metals are sampled for the base that they would have below their facets if they were none.
    pub bases: bool,
    /// Lights that send nothing cast shadows.
    pub lights: bool,
    /// Every material has these.
    pub lobes: Lobes,
}

impl<'a, S: Number> Integrator<'a, S> {
    /// The same, computing also what has these weights of zero.
    pub fn with_zero_weight(self, zero_weight: ZeroWeight) -> Self {
        Self { zero_weight, ..self }
    }
}

impl<S: Number> Clone for Integrator<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Number> Copy for Integrator<'_, S> {}

/// A scene in the precision of the lanes `L`, with its acceleration structure.
pub struct Prepared<L: Plain> {
    pub settings: Settings,
    pub layout: Layout,
    pub tracer: Tracer,
    pub inputs: Inputs<L>,
    emitters: Emitters,
    film_offsets: Vec<(L, L)>,
}

impl<L: Plain> Prepared<L> {
    /// Prepares a scene, which has to be valid.
    pub fn new(scene: &Scene, settings: Settings) -> Self {
        let bounding_box = scene.bounding_box();
        let origin = bounding_box.map_or(DVec3::ZERO, |(low, high)| low.midpoint(high));
        let layout = Layout::new(scene, &settings);
        let inputs = Inputs::new(scene, &layout, origin, &Varying::NONE);
        let tracer = Tracer::new(scene, &settings, &layout, &inputs);
        let emitters = emitters(scene, &layout, &inputs);
        Self { settings, layout, tracer, inputs, emitters, film_offsets: film_offsets::<L>() }
    }

    /// Whether edges are seen: where light takes all paths they cannot be.
    pub fn edges(&self) -> Edges {
        match self.layout.path_tracing {
            Some(_) => Edges::Off,
            None => self.settings.edges,
        }
    }

    /// What computes radiance with these numbers.
    pub fn integrator(&self) -> Integrator<'_, L> {
        self.with_inputs(&self.inputs)
    }

    /// What computes radiance with others, along the same rays.
    pub fn with_inputs<'a, S: Number<Lanes = L>>(
        &'a self,
        inputs: &'a Inputs<S>,
    ) -> Integrator<'a, S> {
        let Self { layout, tracer, emitters, film_offsets, .. } = self;
        let zero_weight = ZeroWeight::default();
        Integrator { layout, tracer, inputs, emitters, film_offsets, zero_weight }
    }

    /// Takes over the numbers of the scene, whose objects have stayed. If geometry has moved, the
    /// acceleration structure is refitted.
    pub fn update(&mut self, scene: &Scene) {
        self.layout.update(scene);
        let moved = self.inputs.update(scene, &self.layout, &Varying::NONE);
        self.tracer.update(scene, &self.settings, &self.layout, &self.inputs, moved);
        self.emitters = emitters(scene, &self.layout, &self.inputs);
    }

    /// Takes over what the scene is seen through, and nothing else.
    pub fn look(&mut self, scene: &Scene) {
        let Self { settings, layout, tracer, inputs, .. } = self;
        [layout.width, layout.height] = scene.size();
        inputs.look(scene, &Varying::NONE);
        tracer.look(scene, settings, layout, inputs);
    }
}

/// Twice the columns and the rows of the rays of a packet, within their tile, by block.
fn film_offsets<L: Lanes>() -> Vec<(L, L)> {
    let offset = |ray: usize, axis: usize| {
        let (column, row) = tile_position(ray);
        <L::Element as Real>::from_f64(2.0 * [column, row][axis] as f64)
    };
    let blocks = (0..PACKET_RAYS).step_by(L::COUNT);
    blocks
        .map(|first| {
            let along = |axis: usize| L::from_lanes(|lane| offset(first + lane, axis));
            (along(0), along(1))
        })
        .collect()
}
