//! `--accuracy`

use super::Problem;
use super::output::print_note;
use super::sampling::SamplingArguments;
use crate::Error;
use crate::accuracy::{Rays, select};
use crate::arithmetic::{Arithmetic, Precision};
use crate::experiment::{Experiment, Target};
use crate::recovery::Recovery;
use crate::settings::{Edges, Settings};

/// How accurate a gradient has to be.
#[derive(clap::Args)]
pub(super) struct AccuracyArguments {
    /// Take the cheapest settings whose gradient is off by so much at most, relative to its length:
    /// tried on the scene itself, in place of --precision; if the target is an image file,
    /// in place of --samples too
    #[arg(long, value_name = "E", value_parser = accuracy)]
    accuracy: Option<f64>,

    /// Whether the image and the gradient see edges: areas on both sides, and what pixels gain and lose
    /// when silhouettes and shadows move
    #[arg(long, value_enum, default_value_t = Edges::Auto)]
    edges: Edges,

    #[command(flatten)]
    sampling: SamplingArguments,
}

/// More rays through a pixel are not chosen.
const MOST_RAYS: u32 = 256;

pub(super) fn accuracy(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(accuracy) if accuracy > 0.0 && accuracy < 1.0 => Ok(accuracy),
        _ => Err("has to be a number between 0 and 1".into()),
    }
}

impl AccuracyArguments {
    /// Whether settings are chosen by the time that they take.
    pub fn is_selecting(&self) -> bool {
        self.accuracy.is_some()
    }

    /// Whether it is left to the parameters if edges are seen.
    pub fn leaves_edges_open(&self) -> bool {
        self.edges == Edges::Auto
    }

    /// The problem in the settings that the selection finds, which it prints; without it, in `chosen` or
    /// the default arithmetic.
    pub fn recovery<'a>(
        &self,
        problem: &Problem,
        experiment: &'a Experiment,
        chosen: Option<Arithmetic>,
    ) -> Result<Recovery<'a>, Error> {
        let place = problem.scene.display().to_string();
        let in_arithmetic = |arithmetic| {
            let sampling = self.sampling.sampling(&experiment.scene);
            let settings =
                Settings { arithmetic, sampling, edges: self.edges, ..Settings::default() };
            let recovery = Recovery::new(experiment, &place, &settings)?;
            Ok::<_, Error>(problem.allowing(recovery))
        };
        let Some(accuracy) = self.accuracy else {
            return in_arithmetic(chosen.unwrap_or_default());
        };
        if chosen.is_some() {
            let problem = "picks the precision itself; leave out --precision";
            return Err(Error::new("--accuracy", problem));
        }
        let exact = in_arithmetic(Arithmetic::fastest(Precision::F64))?;
        exact.evaluate()?;
        let selection = select(&exact, accuracy, self.rays(experiment));
        print_note(&selection);
        Ok(selection.best.setting.apply(&exact))
    }

    /// The pixels of a photo are integrals, so how many rays come close enough to them can be told.
    /// A target that is rendered here has the rays that are given, and is matched by these.
    fn rays(&self, experiment: &Experiment) -> Rays {
        let target = experiment.optimize.as_ref().and_then(|section| section.target.as_ref());
        match target {
            Some(Target::Image(_)) if self.sampling.is_open() => {
                Rays::Chosen { sampler: self.sampling.sampler, most: MOST_RAYS }
            }
            _ => Rays::Given,
        }
    }
}
