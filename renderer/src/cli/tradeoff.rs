//! `renderer tradeoff`

use std::path::{Path, PathBuf};

use renderer_files::disk::{create_folder, write_atomically};

use super::out_folder::check_out_folder;
use super::output::print;
use super::{Problem, stem};
use crate::Error;
use crate::experiment::{Experiment, Target};
use crate::recovery::Recovery;
use crate::settings::{Edges, Settings};
use crate::tradeoff::{
    Curve, EdgeRuns, Measurement, SamplingRuns, ScheduleRun, Titles, Tradeoff, best_step, csv,
    curves_svg, edge_csv, edge_table, measure, measure_edges, measure_sampling, measure_schedules,
    sampling_csv, sampling_curves, sampling_table, steps, table, tradeoff_svg,
};

#[derive(clap::Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    problem: Problem,

    /// How long each setting is repeated
    #[arg(long, default_value_t = 0.3, value_name = "SECONDS", value_parser = super::bench::seconds)]
    seconds: f64,

    /// Folder for tables (CSV) and plots (SVG) [default: out/tradeoff]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let mut experiment = arguments.problem.load()?;
    let place = arguments.problem.scene.display().to_string();
    if !experiment.scene.views().is_empty() {
        let problem = "has several views; what settings are worth is measured on one camera";
        return Err(Error::new(&place, problem));
    }
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("out").join("tradeoff"));
    check_out_folder(&out, std::iter::empty())?;
    let invented = invent_target(&mut experiment);
    let recovery = Recovery::new(
        &experiment,
        &place,
        &Settings { edges: Edges::Off, ..Settings::default() }.in_double_precision(),
    )?;
    recovery.evaluate()?;
    let scene = &experiment.scene;
    print(format_args!(
        "{place}: {} x {} pixels, {} derivatives, {} threads{}",
        scene.width,
        scene.height,
        recovery.initial().len(),
        rayon::current_num_threads(),
        if invented {
            "; the target is the image with these parameters moved a little"
        } else {
            ""
        },
    ))?;
    let tradeoff = measure(&recovery, arguments.seconds);
    print_tradeoff(&recovery, &tradeoff)?;
    let edges = measure_edges(&recovery);
    if let Some(edges) = &edges {
        print(edge_table(edges))?;
    }
    let samplings = measure_sampling(&recovery);
    print(sampling_table(&samplings))?;
    let runs = measure_schedules(&recovery, &recovery.settings())?;
    print_schedules(&runs)?;
    let name = stem(&arguments.problem.scene);
    save(&out, &name, &tradeoff.measurements, edges.as_ref(), &samplings, &runs)?;
    print(format_args!("table and plots in {}", out.display()))
}

fn print_tradeoff(recovery: &Recovery<'_>, tradeoff: &Tradeoff) -> Result<(), Error> {
    let Tradeoff { measurements, remarks } = tradeoff;
    print(table(measurements))?;
    print("*: no other setting is both faster and more accurate. Errors are relative to f64.")?;
    for curve in steps(measurements) {
        if let Some((step, error)) = best_step(&curve) {
            let Curve { label, .. } = curve;
            print(format_args!("{label}: the best step is {step:.0e}, off by {error:.1e}"))?;
        }
    }
    if recovery.ids().iter().any(|&id| recovery.scene().moves_edges(id)) {
        print(
            "Here the reference is the interior term, without edges, as all engines have it; differences also see edges move.",
        )?;
    }
    remarks.iter().try_for_each(print)
}

fn print_schedules(runs: &[ScheduleRun]) -> Result<(), Error> {
    if runs.is_empty() {
        return print("No optimisations were compared: the true parameters are not known.");
    }
    print(format_args!("{:<20} {:>9} {:>16}", "sizes of images", "seconds", "parameters off"))?;
    runs.iter().try_for_each(|run| {
        let (seconds, error) = run.way.last().copied().unwrap_or((0.0, 1.0));
        print(format_args!("{:<20} {seconds:>9.3} {error:>16.1e}", run.name()))
    })?;
    print("All take the same number of steps; the distance at the start is 1.")
}

/// Writes the table and the plots.
fn save(
    out: &Path,
    name: &str,
    measurements: &[Measurement],
    edges: Option<&EdgeRuns>,
    samplings: &SamplingRuns,
    runs: &[ScheduleRun],
) -> Result<(), Error> {
    create_folder(out)?;
    let write = |suffix: &str, text: &str| {
        write_atomically(&out.join(format!("{name}{suffix}")), text.as_bytes())
    };
    write(".csv", &csv(measurements))?;
    if let Some(edges) = edges {
        write("-edges.csv", &edge_csv(edges))?;
    }
    let caption = format!("{name}: the time of a gradient against its error");
    write(".svg", &tradeoff_svg(&caption, measurements)?)?;
    let titles = Titles {
        caption: &format!("{name}: central differences"),
        horizontal: "step, in the natural scale of each parameter",
        vertical: "relative error of the gradient",
    };
    write("-steps.svg", &curves_svg(&titles, &steps(measurements))?)?;
    write("-rays.csv", &sampling_csv(samplings))?;
    let titles = Titles {
        caption: &format!("{name}: gradients from several rays per pixel"),
        horizontal: "rays per pixel",
        vertical: "relative error of the gradient",
    };
    write("-rays.svg", &curves_svg(&titles, &sampling_curves(samplings))?)?;
    if runs.is_empty() {
        return Ok(());
    }
    let titles = Titles {
        caption: &format!("{name}: optimisations with images of these sizes"),
        horizontal: "seconds",
        vertical: "distance of the parameters, 1 at the start",
    };
    let curve = |(color, run): (usize, &ScheduleRun)| Curve {
        label: run.name(),
        points: run.way.clone(),
        color,
        is_dashed: false,
    };
    let curves: Vec<Curve> = runs.iter().enumerate().map(curve).collect();
    write("-schedules.svg", &curves_svg(&titles, &curves)?)
}

/// How far parameters are moved for a target, in their natural scale.
const MOVED: f64 = 0.05;

/// Gives an experiment without target one: the image that the scene has with its parameters moved a
/// little. Whether it had none.
fn invent_target(experiment: &mut Experiment) -> bool {
    let Experiment { scene, optimize, .. } = experiment;
    let Some(section) = optimize else { return false };
    if section.target.is_some() {
        return false;
    }
    let moved = |id| {
        let (step, (low, high)) = (MOVED * scene.natural_scale(id), scene.range(id));
        // Every other number goes the other way, so that they do not make up for each other.
        let values = scene.get(id).into_owned().into_iter().enumerate().map(|(index, value)| {
            let step = if index % 2 == 0 { step } else { -step };
            (value + step).clamp(low, high)
        });
        (id, values.collect())
    };
    let values = section.parameters.iter().map(|tuned| moved(tuned.id)).collect();
    section.target = Some(Target::Values(values));
    true
}
