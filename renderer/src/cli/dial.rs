//! `--accuracy`

use super::output::print_note;
use crate::Error;
use crate::accuracy::pick;
use crate::arithmetic::{Arithmetic, Precision};
use crate::experiment::Experiment;
use crate::recovery::Recovery;

/// How accurate a gradient has to be.
#[derive(clap::Args)]
pub(super) struct Dial {
    /// Take the cheapest settings whose gradient is off by so much at most, relative to its length:
    /// tried on the scene itself, in place of --precision and --lanes
    #[arg(long, value_name = "E", value_parser = accuracy)]
    accuracy: Option<f64>,
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
        let Some(accuracy) = self.accuracy else {
            return Recovery::new(experiment, place, chosen.unwrap_or_default());
        };
        if chosen.is_some() {
            let problem = "picks precision and lanes itself; leave out --precision and --lanes";
            return Err(Error::new("--accuracy", problem));
        }
        let exact = Recovery::new(experiment, place, Arithmetic::fastest(Precision::F64))?;
        exact.evaluate()?;
        let pick = pick(&exact, accuracy);
        print_note(&pick);
        Ok(pick.best.setting.apply(&exact))
    }
}
