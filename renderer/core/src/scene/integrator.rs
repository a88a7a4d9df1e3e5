//! Which paths of light count.

use super::{Bsdf, MOST_EDGED_LIGHTS, Object, ParameterId, Scene};
use crate::Error;
use crate::settings::{Edges, GradientSamples, Pass, Samples, Sampling, Settings};

/// Which paths of light count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Integrator {
    /// Light comes straight from lights, or by mirrors and through transparent
    /// surfaces; what emits light is seen, and lights nothing. Images have no noise.
    #[default]
    Direct,
    /// Light takes all paths, from every emitter and the environment, and some are chosen at random.
    Path(PathTracing),
}

/// How paths are chosen.
///
/// Random numbers are those of the Sobol' sequence with Owen's scrambling, another one for each pixel. The
/// same scene and seed give the same image, and a gradient by what moves no path is the exact derivative of the
/// loss of that image: which light, lobe and direction a path takes does not depend on radiances and colours, or
/// in steps alone. Where a gradient is asked for by a colour that is 0, which no path of the image depends on, it
/// is that of other paths, and right in the mean; so it is by what moves surfaces, lights that shine, or the camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PathTracing {
    /// How many straight pieces a path has at most, from the camera to where the light comes from: with 1,
    /// only what emits light is seen, with 2 there is direct light.
    pub max_depth: u32,
    /// How many paths go through each pixel, where the [settings](crate::Settings::sampling) do not say.
    pub samples: u32,
    /// Tells random choices apart.
    pub seed: u32,
}

impl PathTracing {
    /// The most paths through a pixel: beyond, the sequence begins anew.
    pub const MOST_SAMPLES: u32 = 1 << 16;

    /// Where the paths go through each pixel, if settings say nothing but through its middle.
    pub fn sampling(self, given: Sampling) -> Sampling {
        let Self { samples: count, seed, .. } = self;
        match given {
            Sampling::Center => {
                Sampling::Sobol(Samples { count, seed, gradient: GradientSamples::Same })
            }
            given => given,
        }
    }
}

/// 16 paths through each pixel, of up to 6 pieces.
impl Default for PathTracing {
    fn default() -> Self {
        Self { max_depth: 6, samples: 16, seed: 0 }
    }
}

impl Scene {
    /// How paths are chosen, if light takes all.
    pub(crate) fn path_tracing(&self) -> Option<PathTracing> {
        match self.integrator {
            Integrator::Direct => None,
            Integrator::Path(path_tracing) => Some(path_tracing),
        }
    }

    /// The same where a pass is shown: radiance alone asks for it.
    pub(crate) fn path_tracing_of(&self, pass: Pass) -> Option<PathTracing> {
        self.path_tracing().filter(|_| pass == Pass::Radiance)
    }

    /// Whether edges count for gradients by some parameters: on or off.
    pub fn edges_for(&self, edges: Edges, ids: &[ParameterId]) -> Edges {
        edges.given(ids.iter().any(|&id| self.moves_edges(id)))
    }

    /// Whether a parameter bends rays: what is seen behind a dielectric moves with its index of refraction.
    pub(crate) fn refracts_by(&self, id: ParameterId) -> bool {
        match id.object {
            Object::Material(i) => id.field == "ior" && self.materials[i].bsdf == Bsdf::Dielectric,
            _ => false,
        }
    }

    /// Checks that images have derivatives by these parameters: those of [passes](Pass) other than radiance and
    /// identifiers always have.
    ///
    /// # Errors
    ///
    /// If the pass is that of identifiers, or if edges count and there are more lights, or points of them, than the 64 whose shadows have edges.
    pub fn check_differentiable(
        &self,
        settings: &Settings,
        ids: &[ParameterId],
    ) -> Result<(), Error> {
        if settings.pass == Pass::Ids {
            return Err(Error::new("pass", "identifiers are whole numbers and have no derivative"));
        }
        if settings.pass != Pass::Radiance {
            return Ok(());
        }
        let points = self.light_points();
        if self.edges_for(settings.edges, ids) == Edges::On && points > MOST_EDGED_LIGHTS {
            let problem = format!(
                "{points} lights, or points of them, cast shadows, and edges are known of \
                 {MOST_EDGED_LIGHTS}: lower light_samples, or leave the boundary term out (--edges off)"
            );
            return Err(Error::new("light", problem));
        }
        Ok(())
    }
}
