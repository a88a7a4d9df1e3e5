//! A run's folder as one HTML page that needs nothing else: no network, no other file.
//!
//! What is in the folder decides what is on the page: only `summary.json` must be there. Everything
//! that comes from files is escaped, pictures are embedded, and the one script only moves the
//! slider.

mod chart;
mod html;
mod run_folder;

#[cfg(test)]
mod tests;

use std::collections::HashMap;
use std::path::Path;

use serde_json::Value;

use crate::Error;
use crate::optimize::loss_svg;
use chart::{Curve, label, line_chart};
use html::{data_uri, escape, number, numbers};
use run_folder::{Frame, ObjectPictures, RunFolder, Trajectory};

/// Elements whose trajectories are drawn; a page of more would not be read.
const MOST_CHARTS: usize = 24;
/// Numbers of a long parameter that are shown one by one.
const MOST_MOVED: usize = 4;

/// The page about the run whose results are in `folder`.
///
/// # Errors
///
/// If the folder holds no `summary.json`, or a file of it is broken; the place is the file.
pub fn report_page(folder: &Path) -> Result<String, Error> {
    let run = RunFolder::read(folder)?;
    let name = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    let name = name.file_name().map_or("run".into(), |name| name.to_string_lossy());
    let mut sections = vec![("Result", figures(&run.summary))];
    sections.push(("Images", images(&run)));
    sections.push(("Comparison", comparison(&run.images)));
    if run.frames.len() > 1 {
        sections.push(("Course", strip(&run.frames)));
    }
    if !run.history.is_empty() {
        sections.push(("Loss", loss_svg(&run.history)?));
    }
    sections.push(("Parameters", parameters(&run.summary)));
    sections.push(("Textures and shapes", pictures(&run.pictures)));
    if let Some(trajectory) = &run.trajectory {
        sections.push(("Trajectories", trajectories(trajectory)));
    }
    sections.push(("Settings", settings(&run.summary)));
    if let Some(scene) = &run.scene {
        let text = escape(scene);
        let code = format!("<details><summary>scene.toml</summary><pre>{text}</pre></details>");
        sections.push(("Recovered scene", code));
    }
    let body: String = sections
        .into_iter()
        .filter(|(_, content)| !content.is_empty())
        .map(|(title, content)| format!("<section><h2>{title}</h2>\n{content}</section>\n"))
        .collect();
    Ok(html::page(&escape(&name), &body))
}

/// The figures of a run.
fn figures(summary: &Value) -> String {
    let at = |pointer: &str| summary.pointer(pointer).cloned().unwrap_or(Value::Null);
    let rows = [
        ("initial loss", number(&at("/loss/initial"))),
        ("final loss", number(&at("/loss/final"))),
        ("final over initial", number(&at("/loss/ratio"))),
        ("iterations", number(&at("/iterations"))),
        ("best iteration", number(&at("/best_iteration"))),
        ("evaluations", number(&at("/evaluations"))),
        ("seconds", number(&at("/seconds"))),
        ("stopped because", at("/stop_detail").as_str().map(escape).unwrap_or_default()),
    ];
    let rows = rows.iter().filter(|(_, value)| !value.is_empty());
    let rows: String =
        rows.map(|(name, value)| format!("<tr><th>{name}</th><td>{value}</td></tr>\n")).collect();
    format!("<table class=\"figures\">\n{rows}</table>\n")
}

/// Initial and final values, and where they are known the true ones.
fn parameters(summary: &Value) -> String {
    let Some(parameters) = summary["parameters"].as_object().filter(|p| !p.is_empty()) else {
        return String::new();
    };
    let mut columns = vec![("initial", "initial"), ("recovered", "final")];
    if parameters.values().any(|values| !values["target"].is_null()) {
        columns.push(("true", "target"));
    }
    let row = |(path, values): (&String, &Value)| {
        let cell = |(_, name): &(_, &str)| format!("<td>{}</td>", numbers(&values[*name]));
        let cells: String = columns.iter().map(cell).collect();
        let row = format!("<tr><th>{}</th>{cells}</tr>\n", escape(path));
        match most_moved(&values["initial"], &values["final"]) {
            Some(moved) => format!("{row}<tr><td></td><td colspan=\"3\">{moved}</td></tr>\n"),
            None => row,
        }
    };
    let rows: String = parameters.iter().map(row).collect();
    let titles: String = columns.iter().map(|(title, _)| format!("<th>{title}</th>")).collect();
    format!("<table>\n<tr><th>path</th>{titles}</tr>\n{rows}</table>\n")
}

/// How far the numbers of a parameter that has many have moved, and which of them most.
fn most_moved(initial: &Value, last: &Value) -> Option<String> {
    let (initial, last) = (initial.as_array()?, last.as_array()?);
    let pairs = initial.iter().zip(last).map(|(a, b)| Some((a.as_f64()?, b.as_f64()?)));
    let pairs: Vec<(f64, f64)> = pairs.collect::<Option<_>>()?;
    if pairs.len() <= html::MOST_NUMBERS {
        return None;
    }
    let squares: f64 = pairs.iter().map(|(a, b)| (b - a).powi(2)).sum();
    let mut indices: Vec<usize> = (0..pairs.len()).collect();
    let moved = |i: &usize| (pairs[*i].1 - pairs[*i].0).abs();
    indices.sort_by(|i, j| moved(j).total_cmp(&moved(i)));
    let most = indices.iter().take(MOST_MOVED).map(|&i| {
        let (a, b) = pairs[i];
        format!("[{i}] {} → {}", label(a), label(b))
    });
    Some(format!(
        "moved by {} (root mean square); most: {}",
        label((squares / pairs.len() as f64).sqrt()),
        most.collect::<Vec<_>>().join(", ")
    ))
}

/// How the run was started, and what it was told.
fn settings(summary: &Value) -> String {
    let Some(settings) = summary["settings"].as_object() else { return String::new() };
    let row = |(name, value): (&String, &Value)| {
        let value = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        format!("<tr><th>{}</th><td>{}</td></tr>\n", escape(name), escape(&value))
    };
    let rows: String = settings.iter().map(row).collect();
    format!("<table class=\"figures\">\n{rows}</table>\n")
}

fn images(run: &RunFolder) -> String {
    let largest = run.summary["largest_difference"].as_f64();
    let figures: String = run
        .images
        .iter()
        .map(|(name, png)| figure(Some(name), name, png, scale(name, largest)))
        .collect();
    html::grid(&figures)
}

/// What the greys of the image of differences mean.
fn scale(name: &str, largest: Option<f64>) -> String {
    match largest.filter(|_| name == "difference") {
        Some(largest) => format!(
            "<span class=\"scale\"></span><span class=\"ends\"><span>0</span><span>{}</span>\
             <span>{}</span></span>",
            label(0.5 * largest),
            label(largest)
        ),
        None => String::new(),
    }
}

fn pictures(pictures: &[ObjectPictures]) -> String {
    let pair = |ObjectPictures { path, initial, last }: &ObjectPictures| {
        let one = |state: &str, png| figure(None, &format!("{path}, {state}"), png, String::new());
        one("initial", initial) + &one("recovered", last)
    };
    html::grid(&pictures.iter().map(pair).collect::<String>())
}

/// A picture with what is said of it; `scale` is HTML.
fn figure(id: Option<&str>, caption: &str, png: &[u8], scale: String) -> String {
    let id = id.map(|id| format!(" id=\"image-{id}\"")).unwrap_or_default();
    let (caption, address) = (escape(caption), data_uri(png));
    format!(
        "<figure><img{id} src=\"{address}\" alt=\"{caption}\">{scale}<figcaption>{caption}</figcaption>\
         </figure>\n"
    )
}

/// The target and the recovered image in one place, parted by a line that moves, or in turns.
fn comparison(images: &[(&str, Vec<u8>)]) -> String {
    let has = |wanted: &str| images.iter().any(|(name, _)| *name == wanted);
    if has("target") && has("final") { html::COMPARISON.to_owned() } else { String::new() }
}

/// A slider over the images of the run; without scripts, its last one.
fn strip(frames: &[Frame]) -> String {
    let frame = |(i, frame): (usize, &Frame)| {
        let Frame { iteration, loss, png } = frame;
        let hidden = if i + 1 == frames.len() { "" } else { " hidden" };
        format!(
            "<figure class=\"frame\"{hidden}><img src=\"{}\" alt=\"iteration {iteration}\">\
             <figcaption>iteration {iteration}, loss {loss:.3e}</figcaption></figure>\n",
            data_uri(png)
        )
    };
    let shown: String = frames.iter().enumerate().map(frame).collect();
    let last = frames.len() - 1;
    format!(
        "<div id=\"strip\">\n{shown}</div>\n<input id=\"slider\" type=\"range\" min=\"0\" \
         max=\"{last}\" value=\"{last}\" aria-label=\"iteration\">\n"
    )
}

/// How far each element has moved, relative to the largest number of its parameter: the sum of its steps.
fn movements(trajectory: &Trajectory) -> Vec<f64> {
    let name = |path: &str| path.rfind('[').unwrap_or(path.len());
    let mut sizes: HashMap<&str, f64> = HashMap::new();
    for (i, path) in trajectory.paths.iter().enumerate() {
        let size = sizes.entry(&path[..name(path)]).or_default();
        *size = trajectory.values.iter().fold(*size, |size, point| size.max(point[i].abs()));
    }
    let movement = |(i, path): (usize, &String)| {
        let values = || trajectory.values.iter().map(|point| point[i]);
        let way: f64 = values().zip(values().skip(1)).map(|(a, b)| (b - a).abs()).sum();
        let size = sizes[&path[..name(path)]];
        if size > 0.0 { way / size } else { 0.0 }
    };
    trajectory.paths.iter().enumerate().map(movement).collect()
}

/// The elements whose trajectories are drawn, in their order: those that have moved most.
fn drawn(trajectory: &Trajectory) -> Vec<usize> {
    let mut elements: Vec<(usize, f64)> = movements(trajectory).into_iter().enumerate().collect();
    elements.sort_by(|(_, a), (_, b)| b.total_cmp(a));
    elements.truncate(MOST_CHARTS);
    let mut elements: Vec<usize> = elements.into_iter().map(|(i, _)| i).collect();
    elements.sort_unstable();
    elements
}

fn trajectories(trajectory: &Trajectory) -> String {
    let drawn = drawn(trajectory);
    let more = trajectory.paths.len() - drawn.len();
    let chart = |i: usize| {
        let values = trajectory.values.iter().map(|point| point[i]);
        let points = trajectory.iterations.iter().map(|&k| k as f64).zip(values).collect();
        let curve = Curve { points, truth: trajectory.target[i] };
        format!("<figure>{}</figure>\n", line_chart(&escape(&trajectory.paths[i]), &curve))
    };
    let charts: String = drawn.into_iter().map(chart).collect();
    let note = if more > 0 {
        format!("<p>{more} more, which moved less, are not drawn.</p>\n")
    } else {
        String::new()
    };
    let legend = if trajectory.target.iter().any(Option::is_some) {
        "<p>The dashed line is the true value.</p>\n"
    } else {
        ""
    };
    format!("{legend}<div class=\"charts\">\n{charts}</div>\n{note}")
}
