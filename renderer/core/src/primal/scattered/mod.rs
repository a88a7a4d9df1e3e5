//! Paths that light takes where it takes all: a path integrator beside the direct one.
//!
//! The scene decides. Where it asks for direct light, nothing of this runs. Where it asks for paths, each
//! sample of a tile is a path of wavefronts as ever: rays keep their lanes, and what a wavefront hits is
//! gathered, shaded and pulled back by the same code. What is added to a wavefront is its [`Scattering`]:
//! at every vertex one [emitter](emitters) is looked for (next event estimation), and the path
//! [goes on](walk) in one direction, by a mirror, through a transparent surface, or scattered. Where both
//! find the same emitter, each counts by its weight (multiple importance sampling). Paths that bring little
//! end at random (Russian roulette).
//!
//! **The gradient** is the exact derivative of the same estimate. The vertices of a path are kept, one
//! wavefront for each depth, reused from sample to sample; so memory depends neither on samples nor on
//! pixels. They are walked backwards through the generated pullbacks of
//! [`transport`](crate::transport), like those of mirrors. What was chosen, and with which probability, is a
//! constant there (detached sampling), and it is one in fact: emitters, lobes and the ends of paths are
//! chosen with probabilities that are rounded, in powers of two or in eighths, so that they change in steps
//! alone, and [directions](directions) are scattered by the cosine, or by facets whose width is rounded in the
//! same way; where maps bend normals, about these normals, rounded. So a finite difference with the same random
//! numbers sees the same derivative, and an optimiser descends the loss that it measures. Dielectrics reflect as often as their index of refraction says, by
//! which there is no gradient: it moves what is [refracted](refraction).
//!
//! Turned down: sampling that follows parameters exactly. Its probabilities have derivatives, which cancel
//! in the mean but not in one estimate, so that loss and gradient would not belong together. Also turned
//! down: regenerating paths by their random numbers in place of keeping them (path replay), which saves a
//! few hundred kilobytes and traces every ray again.
//!
//! **What it cannot do.** Points that are chosen at random move with geometry, and edges that paths come by
//! are not known; so there is no gradient by what moves edges
//! ([`Scene::is_differentiable`](crate::scene::Scene::is_differentiable)).

mod directions;
mod emitters;
mod refraction;
mod sky;
mod vertex;
mod walk;

use ad::Vec3;

use super::coalesce::Coalesced;
use crate::number::Number;
use crate::transport::light::Illumination;

pub use sky::{SkyLight, missed};

/// How the paths of a wavefront were chosen.
pub struct Scattering<S: Number> {
    /// By block: the weights of what the surfaces emit that were met.
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
    pub source: EmitterSource,
    pub emission: Vec3<S>,
    /// The solid angle that the emission counts for.
    pub weighted: S,
    pub illumination: Illumination<S>,
}

/// What shines.
pub enum EmitterSource {
    /// Surfaces: the lanes by their material.
    Surfaces(Coalesced),
    /// The environment.
    Sky,
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
        Self { found: Vec::new(), emitters: Vec::new(), events: Vec::new() }
    }
}

impl<S: Number> Scattering<S> {
    /// The emitters that were looked for from a group.
    pub fn emitters_of(&self, group: usize) -> impl Iterator<Item = &EmitterSample<S>> {
        let first = self.emitters.partition_point(|sample| sample.group < group);
        self.emitters[first..].iter().take_while(move |sample| sample.group == group)
    }
}
