//! `--target-error`, `--time-limit` and `--standard-error` of `renderer render`

use std::path::PathBuf;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

use super::interrupt::Interrupt;
use super::output::print_note;
use crate::Error;
use crate::progressive::{Estimate, Progress, Until, render_until};
use crate::render::Renderer;
use crate::scene::{Integrator, Scene};

#[derive(clap::Args)]
pub(super) struct UntilArguments {
    /// Where light takes all paths: take batches of --samples, or of the samples of the scene, two at least, until the standard errors of the pixels, their root
    /// mean square over the mean radiance, are E; Ctrl-C ends it early and writes the image
    #[arg(long, value_name = "E", value_parser = error, conflicts_with = "derivative")]
    target_error: Option<f64>,

    /// Where light takes all paths: take batches of samples for so many seconds, but two batches at least; the first
    /// has one sample, and none more than --samples, or than the samples of the scene
    #[arg(long, value_name = "SECONDS", value_parser = seconds, conflicts_with = "derivative")]
    time_limit: Option<Duration>,

    /// Where to write the standard error of each pixel (.exr or .hdr), of --target-error or --time-limit
    #[arg(long, value_name = "IMAGE")]
    pub standard_error: Option<PathBuf>,
}

fn error(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(error) if error > 0.0 => Ok(error),
        _ => Err("has to be a number above 0".into()),
    }
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    seconds
        .filter(|time| !time.is_zero())
        .ok_or_else(|| "has to be a number of seconds above 0".into())
}

impl UntilArguments {
    /// When the image is good enough, if that is asked for.
    pub fn until(&self, scene: &Scene) -> Result<Option<Until>, Error> {
        let until = Until { error: self.target_error, time: self.time_limit };
        if until == Until::default() {
            return match self.standard_error {
                None => Ok(None),
                Some(_) => Err(Error::new(
                    "--standard-error",
                    "is that of several batches: give --target-error or --time-limit",
                )),
            };
        }
        if scene.integrator == Integrator::Direct {
            let option = if until.error.is_some() { "--target-error" } else { "--time-limit" };
            let problem = "images of direct light have no noise: integrator.type = \"path\" has";
            return Err(Error::new(option, problem));
        }
        Ok(Some(until))
    }
}

/// Renders until that, with a line of progress on a terminal, and says what was reached.
pub(super) fn render(renderer: &mut Renderer, until: Until) -> Result<Estimate, Error> {
    let interrupt = Interrupt::new()?;
    let bar = ProgressBar::new_spinner();
    if let Ok(style) = ProgressStyle::with_template("{msg}") {
        bar.set_style(style);
    }
    let sampling = renderer.settings().sampling;
    let estimate = render_until(renderer, sampling, until, |progress| {
        bar.set_message(format!("{}{}", describe(progress), left(progress, until)));
        interrupt.flow()
    });
    bar.finish_and_clear();
    print_note(describe(&estimate.progress));
    Ok(estimate)
}

fn describe(progress: &Progress) -> String {
    let Progress { samples, error, elapsed } = progress;
    format!("{samples} samples per pixel, error {error:.2e}, {:.1} s", elapsed.as_secs_f64())
}

/// How long it takes yet: errors fall with the square root of the time.
fn left(progress: &Progress, until: Until) -> String {
    let elapsed = progress.elapsed.as_secs_f64();
    let by_error = until.error.map(|error| elapsed * ((progress.error / error).powi(2) - 1.0));
    let by_time = until.time.map(|time| time.as_secs_f64() - elapsed);
    let left = [by_error, by_time].into_iter().flatten().fold(f64::INFINITY, f64::min);
    if left.is_finite() { format!(", {:.0} s left", left.max(0.0)) } else { String::new() }
}
