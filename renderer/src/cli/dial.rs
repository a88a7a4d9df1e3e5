//! `--accuracy`

use super::output::print_note;
use super::sampling::SamplingArguments;
use crate::Error;
use crate::accuracy::pick;
use crate::arithmetic::{Arithmetic, Precision};
use crate::experiment::Experiment;
use crate::integrator::RenderSettings;
use crate::recovery::Recovery;

/// How accurate a gradient has to be.
#[derive(clap::Args)]
pub(super) struct Dial {
    /// Take the cheapest settings whose gradient is off by so much at most, relative to its length:
    /// tried on the scene itself, in place of --precision and --lanes
    #[arg(long, value_name = "E", value_parser = accuracy)]
    accuracy: Option<f64>,

    #[command(flatten)]
    sampling: SamplingArguments,
}

fn accuracy(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(accuracy) if accuracy > 0.0 && accuracy < 1.0 => Ok(accuracy),
        _ => Err("has to be a number between 0 and 1".into()),
    }
}

impl Dial {
    /// The problem in the settings that the dial picks, which it prints; without it, in `chosen` or
    /// the default arithmetic.
    pub fn recovery<'a>(
        &self,
        experiment: &'a Experiment,
        place: &str,
        chosen: Option<Arithmetic>,
    ) -> Result<Recovery<'a>, Error> {
        let settings =
            RenderSettings { sampling: self.sampling.sampling(), ..RenderSettings::default() };
        let Some(accuracy) = self.accuracy else {
            return Recovery::with_settings(
                experiment,
                place,
                chosen.unwrap_or_default(),
                settings,
            );
        };
        if chosen.is_some() {
            let problem = "picks precision and lanes itself; leave out --precision and --lanes";
            return Err(Error::new("--accuracy", problem));
        }
        let double = Arithmetic::fastest(Precision::F64);
        let exact = Recovery::with_settings(experiment, place, double, settings)?;
        exact.evaluate()?;
        let pick = pick(&exact, accuracy);
        print_note(&pick);
        Ok(pick.best.setting.apply(&exact))
    }
}
