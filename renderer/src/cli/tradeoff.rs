//! `renderer tradeoff`

use std::path::{Path, PathBuf};

use super::output::print;
use super::{Problem, stem};
use crate::Error;
use crate::arithmetic::{Arithmetic, Precision};
use crate::atomic_file::write_atomically;
use crate::experiment::{Experiment, Target};
use crate::recovery::{Recovery, natural_scale};
use crate::scene::Differentiability;
use crate::tradeoff::{best_steps, csv, measure, plot_svg, table};

#[derive(clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    problem: Problem,

    /// How long each setting is repeated
    #[arg(long, default_value_t = 0.3, value_name = "SECONDS", value_parser = super::bench::seconds)]
    seconds: f64,

    /// Folder for the table (CSV) and the plot (SVG) [default: out/tradeoff]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let mut experiment = arguments.problem.load()?;
    let place = arguments.problem.scene.display().to_string();
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("out").join("tradeoff"));
    let invented = invent_target(&mut experiment);
    let recovery = Recovery::new(&experiment, &place, Arithmetic::fastest(Precision::F64))?;
    let scene = &experiment.scene;
    print(format_args!(
        "{place}: {} x {} pixels, {} derivatives, {} threads{}",
        scene.width,
        scene.height,
        recovery.ids().iter().map(|&id| scene.parameters.get(id).len()).sum::<usize>(),
        rayon::current_num_threads(),
        if invented { "; the target is the image with these parameters moved a little" } else { "" },
    ))?;
    let tradeoff = measure(&recovery, arguments.seconds);
    print(table(&tradeoff.measurements))?;
    print("*: no other setting is both faster and more accurate. Errors are relative to f64.")?;
    for sentence in best_steps(&tradeoff.measurements) {
        print(sentence)?;
    }
    let interior =
        |id: &crate::scene::ParameterId| id.differentiability() == Differentiability::Interior;
    if recovery.ids().iter().any(interior) {
        print(
            "Differences also see silhouettes and shadow edges move; the reference is the interior term.",
        )?;
    }
    for remark in &tradeoff.remarks {
        print(remark)?;
    }

    std::fs::create_dir_all(&out)
        .map_err(|error| Error::new(out.display(), format_args!("cannot be made: {error}")))?;
    let write = |name: &str, text: &str| {
        let path = out.join(name);
        write_atomically(&path, text.as_bytes()).map(|()| path)
    };
    let name = stem(&arguments.problem.scene);
    let caption = format!("{name}: the time of a gradient against its error");
    let csv = write(&format!("{name}.csv"), &csv(&tradeoff.measurements))?;
    let svg = write(&format!("{name}.svg"), &plot_svg(&caption, &tradeoff.measurements)?)?;
    print(format_args!("{}, {}", csv.display(), svg.display()))
}

/// How far parameters are moved for a target, in their natural scale.
const MOVED: f64 = 0.05;

/// Gives an experiment without target one: the image that the scene has with its parameters moved a
/// little. Whether it had none.
fn invent_target(experiment: &mut Experiment) -> bool {
    let Experiment { scene, optimize } = experiment;
    let Some(section) = optimize else { return false };
    if section.target.is_some() {
        return false;
    }
    let moved = |id| {
        let step = MOVED * natural_scale(scene, id);
        // Every other number goes the other way, so that they do not make up for each other.
        let numbers = scene.parameters.get(id).iter().enumerate();
        (id, numbers.map(|(i, value)| value + if i % 2 == 0 { step } else { -step }).collect())
    };
    let values = section.parameters.iter().map(|tuned| moved(tuned.id)).collect();
    section.target = Some(Target::Values(values));
    true
}
