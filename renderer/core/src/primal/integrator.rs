//! A scene, ready for a pass.

use std::sync::Arc;

use ad::Real;
use ad::lanes::Lanes;
use glam::DVec3;

use super::emitters::emitters;
use super::frame::Frame;
use super::inputs::Inputs;
use super::rounds::{Round, Rounds, rounds};
use super::tracer::Tracer;
use super::varying::Varying;
use crate::number::{Number, Plain};
use crate::parallel::Idle;
use crate::scene::Scene;
use crate::settings::{Edges, Pass, Settings};
use crate::trace::bvh::{Bvh, PACKET_RAYS, tile_position};
use crate::trace::emitters::Emitters;
use crate::trace::layout::{Layout, sampling_of};
use crate::trace::sampling::Sampling;
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
    /// The memory of images with edges.
    pub frames: &'a Idle<Frame>,
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

impl ZeroWeight {
    /// How many surfaces a path meets at most.
    pub fn depths(self, layout: &Layout) -> usize {
        if let Some(path_tracing) = layout.path_tracing {
            return path_tracing.max_depth as usize;
        }
        let goes_on = self.mirrors || layout.has_mirrors || layout.has_transparency;
        if goes_on { layout.bounces as usize + 1 } else { 1 }
    }

    /// Whether a ray goes on from a primitive: by a mirror, or what counts as one, or through it.
    pub fn goes_on_from(self, layout: &Layout, primitive: usize) -> bool {
        let traits = layout.traits_of(primitive);
        self.mirrors || traits.is_mirror || traits.is_transparent
    }
}

impl<'a, S: Number> Integrator<'a, S> {
    /// How many surfaces a path meets at most.
    pub fn depths(&self) -> usize {
        self.zero_weight.depths(self.layout)
    }

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
    frames: Idle<Frame>,
    /// Where light takes all paths: the scene in direct light, in which edges are found. Prepared when it is first
    /// asked for.
    direct: Idle<Box<Self>>,
}

impl<L: Plain> Prepared<L> {
    /// Prepares a scene, which has to be valid.
    pub fn new(scene: &Scene, settings: Settings) -> Self {
        let bounding_box = scene.bounding_box();
        let origin = bounding_box.map_or(DVec3::ZERO, |(low, high)| low.midpoint(high));
        let layout = Layout::new(scene, &settings);
        let bvh = Arc::new(Tracer::bvh_of_nothing(&settings, &layout));
        let mut prepared = Self::with_bvh(scene, settings, layout, origin, bvh);
        let Self { tracer, layout, inputs, .. } = &mut prepared;
        tracer.update_geometry(scene, layout, inputs);
        prepared
    }

    fn with_bvh(
        scene: &Scene,
        settings: Settings,
        layout: Layout,
        origin: DVec3,
        bvh: Arc<Bvh>,
    ) -> Self {
        let inputs = Inputs::new(scene, &layout, origin, &Varying::NONE);
        let tracer = Tracer::new(scene, &settings, &layout, &inputs, bvh);
        let emitters = emitters(scene, &layout, &inputs);
        let (film_offsets, frames) = (film_offsets::<L>(), Idle::default());
        let direct = Idle::default();
        Self { settings, layout, tracer, inputs, emitters, film_offsets, frames, direct }
    }

    /// Whether images are made with edges in them: not where light takes all paths, whose rays go all over a
    /// pixel, and not where what is shown has no mean.
    pub fn sees_edges(&self) -> bool {
        let layout = &self.layout;
        let has_means = layout.path_tracing.is_none() && layout.pass != Pass::Ids;
        has_means && self.settings.edges == Edges::On
    }

    /// The scene in direct light, in the light of each round. Its edges are those that paths see first, and those of
    /// the shadows there. The lights follow from the numbers of the scene alone, whatever they were before, and the
    /// acceleration structure is that of paths: a run that is resumed has those of one that was not interrupted.
    pub fn for_each_round(&self, scene: &Scene, mut each: impl FnMut(Round, &Self)) {
        let Rounds { sampling, mut lights, paths } = rounds(scene, &self.layout, &self.inputs);
        let mut direct = self.direct.take().unwrap_or_else(|| {
            let layout = Layout::direct(scene, &self.settings);
            let (origin, bvh) = (self.inputs.origin, Arc::clone(&self.tracer.bvh));
            Box::new(Self::with_bvh(scene, self.settings, layout, origin, bvh))
        });
        direct.tracer.bvh = Arc::clone(&self.tracer.bvh);
        direct.resample(sampling);
        [direct.layout.width, direct.layout.height] = scene.size();
        let count = lights.len() as u32;
        for (index, lights) in (0..).zip(&mut lights) {
            lights.exchange(&mut direct.layout);
            direct.update_numbers(scene);
            each(Round { index, count, paths }, &direct);
            lights.exchange(&mut direct.layout);
        }
        // What is shared cannot be refitted in place.
        direct.tracer.bvh = Arc::new(Bvh::list(&[]));
        self.direct.give(direct);
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
        let Self { layout, tracer, emitters, film_offsets, frames, .. } = self;
        Integrator {
            layout,
            tracer,
            inputs,
            emitters,
            film_offsets,
            frames,
            zero_weight: ZeroWeight::default(),
        }
    }

    /// Takes over the numbers of the scene, whose objects have stayed. If geometry has moved, the
    /// acceleration structure is refitted.
    pub fn update(&mut self, scene: &Scene) {
        if self.update_numbers(scene) {
            self.tracer.update_geometry(scene, &self.layout, &self.inputs);
        }
    }

    /// Takes over all numbers but those in the acceleration structure; whether geometry has moved.
    fn update_numbers(&mut self, scene: &Scene) -> bool {
        self.layout.update(scene);
        let moved = self.inputs.update(scene, &self.layout, &Varying::NONE);
        self.tracer.update(scene, &self.settings, &self.layout, &self.inputs);
        self.emitters = emitters(scene, &self.layout, &self.inputs);
        moved
    }

    /// Takes over where within pixels rays go.
    pub fn resample(&mut self, sampling: Sampling) {
        self.settings.sampling = sampling;
        self.layout.sampling = sampling_of(sampling, self.layout.path_tracing, self.layout.pass);
    }

    /// Takes over how many mirrors a path has at most.
    pub fn set_bounces(&mut self, bounces: u32) {
        if (self.settings.bounces, self.layout.bounces) != (Some(bounces), bounces) {
            self.settings.bounces = Some(bounces);
            self.layout.bounces = bounces;
            self.direct = Idle::default();
        }
    }

    /// Shows something else of surfaces.
    pub fn show(&mut self, scene: &Scene, pass: Pass) {
        self.settings.pass = pass;
        self.layout.show(scene, &self.settings);
        self.direct = Idle::default();
        self.update(scene);
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
