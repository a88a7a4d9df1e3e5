//! Paths that light takes where it takes all: a path integrator beside the direct one.
//!
//! The scene decides. Where it asks for direct light, nothing of this runs. Where it asks for paths, each
//! sample of a tile is a path of wavefronts as ever, and what a wavefront hits is gathered, shaded and pulled back
//! by the same code. Rays do not keep their lanes: those that go on are [packed](packing) where that leaves blocks
//! of lanes empty. What is added to a wavefront is its [`Scattering`]: at every vertex one [emitter](emitters) is looked for (next event estimation), and the path
//! [goes on](walk) in one direction, by a mirror, through a transparent surface, or scattered. Where both
//! find the same emitter, each counts by its weight (multiple importance sampling). Paths that bring little
//! end at random (Russian roulette).
//!
//! **The gradient** by what moves no path is the exact derivative of the same estimate. The vertices of a path are
//! kept, one wavefront for each depth, reused from sample to sample; so memory depends neither on samples nor
//! on pixels. They are walked backwards through the generated pullbacks of
//! [`transport`](crate::transport), like those of mirrors. What was chosen, and with which probability, is a
//! constant there (detached sampling), and it is one in fact: emitters, lobes and the ends of paths are
//! chosen with probabilities that are rounded, in powers of two or in eighths, so that they change in steps
//! alone, and [directions](directions) are scattered by the cosine, or by facets whose width is rounded in the
//! same way; where maps bend normals, about these normals, rounded. So a finite difference with the same random
//! numbers sees the same derivative, and an optimiser descends the loss that it measures.
//!
//! Where paths move, with the camera, surfaces or emitters, the gradient is right in the mean: directions that
//! were scattered stay, in the world, with their probabilities, while the points that they start from and that
//! they meet move; mirrored, [refracted](refraction) and straight ones follow (Zeltner et al., "Monte Carlo Estimators for
//! Differential Light Transport", 2021). Points of emitters stay where they are on these, whether they were looked
//! for or [found], so that the borders of emitters are no edges. What edges add is
//! [told apart](crate::adjoint).
//!
//! Turned down: sampling that follows parameters exactly. Its probabilities have derivatives, which cancel
//! in the mean but not in one estimate; and directions that turn with a surface come over the edges of all others.
//! Also turned down: regenerating paths by their random numbers in place of keeping them (path replay), which
//! saves a few hundred kilobytes and traces every ray again.

mod directions;
mod emitters;
mod found;
mod guided;
mod packing;
mod refraction;
mod sky;
mod vertex;
mod walk;

use ad::Vec3;
use ad::lanes::Lanes;

use super::coalesce::Coalesced;
use crate::number::Number;
use crate::trace::layout::Kind;
use crate::transport::illumination::Illumination;

pub use directions::Facets;
pub use guided::{Guide, Guided};
pub use packing::Packing;
pub use sky::{SkyLight, missed};

/// How the paths of a wavefront were chosen.
pub struct Scattering<S: Number> {
    /// Where its rays were in the wavefront before, if they have been moved.
    pub packing: Option<Packing>,
    /// By block: the weights of what the rays find, of surfaces that emit and of the environment.
    pub found: Vec<S>,
    /// In the order of their groups.
    pub emitters: Vec<EmitterSample<S>>,
    /// By block: how paths go on; none where all end.
    pub events: Vec<Event<S>>,
}

/// Emitters of one kind that were looked for from a group.
pub struct EmitterSample<S: Number> {
    /// The index of the group.
    pub group: usize,
    /// A bit for each lane that sees its emitter.
    pub lanes: u32,
    pub source: EmitterSource<S::Lanes>,
    pub emission: Vec3<S>,
    /// The solid angle that the emission counts for.
    pub weighted: S,
    pub illumination: Illumination<S>,
}

/// What shines.
pub enum EmitterSource<L: Lanes> {
    /// Points of surfaces.
    Surfaces(EmitterPoints<L>),
    /// The environment.
    Sky,
}

/// Points of surfaces of one kind that shine, one in each lane.
pub struct EmitterPoints<L: Lanes> {
    pub kind: Kind,
    pub primitives: Coalesced,
    /// A bit for each lane that looks for a sphere from inside of it.
    pub inside: u32,
    /// One over the probability with which the primitive was chosen.
    pub choices: L,
    /// The barycentric coordinates in triangles; of spheres the numbers from 0 to 1 that choose a
    /// [direction](crate::transport::emitter::sight_of_sphere()), then 0.
    pub at: [L; 3],
    pub chosen: Chosen<L>,
}

/// How points of emitters were chosen.
#[derive(Clone, Copy)]
pub enum Chosen<L: Lanes> {
    /// They were looked for.
    LookedFor,
    /// Scattered rays [found] them, which counted for this spread, and have this [factor](Event::factor).
    Scattered { spread: L, factor: L },
}

/// How paths go on from surfaces.
#[derive(Clone, Copy)]
pub struct Event<S: Number> {
    pub direction: Vec3<S>,
    /// A bit for each lane that goes through, straight or refracted.
    pub straight: u32,
    /// A bit for each lane that is mirrored.
    pub mirrored: u32,
    /// One over the probability, 0 where the path ends; see
    /// [`sent_on`](crate::transport::scatter::sent_on()).
    pub factor: S,
}

impl<S: Number> Default for Scattering<S> {
    fn default() -> Self {
        Self { packing: None, found: Vec::new(), emitters: Vec::new(), events: Vec::new() }
    }
}

impl<S: Number> Scattering<S> {
    /// The emitters that were looked for from a group.
    pub fn emitters_of(&self, group: usize) -> impl Iterator<Item = &EmitterSample<S>> {
        let first = self.emitters.partition_point(|sample| sample.group < group);
        self.emitters[first..].iter().take_while(move |sample| sample.group == group)
    }
}
