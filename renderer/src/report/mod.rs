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

use std::path::Path;

use serde_json::Value;

use crate::Error;
use crate::optimize::loss_svg;
use chart::{Curve, line_chart};
use html::{data_uri, escape, number, numbers};
use run_folder::{Frame, RunFolder, Trajectory};

/// Elements whose trajectories are drawn; a page of more would not be read.
const MOST_CHARTS: usize = 24;

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
    if run.frames.len() > 1 {
        sections.push(("Course", strip(&run.frames)));
    }
    if !run.history.is_empty() {
        sections.push(("Loss", loss_svg(&run.history)?));
    }
    sections.push(("Parameters", parameters(&run.summary)));
    if let Some(trajectory) = &run.trajectory {
        sections.push(("Trajectories", trajectories(trajectory)));
    }
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
        format!("<tr><th>{}</th>{cells}</tr>\n", escape(path))
    };
    let rows: String = parameters.iter().map(row).collect();
    let titles: String = columns.iter().map(|(title, _)| format!("<th>{title}</th>")).collect();
    format!("<table>\n<tr><th>path</th>{titles}</tr>\n{rows}</table>\n")
}

fn images(run: &RunFolder) -> String {
    let figure = |(name, png): &(&str, Vec<u8>)| {
        format!(
            "<figure><img src=\"{}\" alt=\"{name}\"><figcaption>{name}</figcaption></figure>\n",
            data_uri(png)
        )
    };
    let figures: String = run.images.iter().map(figure).collect();
    if figures.is_empty() { figures } else { format!("<div class=\"images\">\n{figures}</div>\n") }
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
         max=\"{last}\" value=\"{last}\" aria-label=\"iteration\">\n{}",
        html::SLIDER
    )
}

fn trajectories(trajectory: &Trajectory) -> String {
    let shown = trajectory.paths.len().min(MOST_CHARTS);
    let chart = |i: usize| {
        let values = trajectory.values.iter().map(|point| point[i]);
        let points = trajectory.iterations.iter().map(|&k| k as f64).zip(values).collect();
        let curve = Curve { points, truth: trajectory.target[i] };
        format!("<figure>{}</figure>\n", line_chart(&escape(&trajectory.paths[i]), &curve))
    };
    let charts: String = (0..shown).map(chart).collect();
    let more = trajectory.paths.len() - shown;
    let note =
        if more > 0 { format!("<p>{more} more are not drawn.</p>\n") } else { String::new() };
    let legend = if trajectory.target.iter().any(Option::is_some) {
        "<p>The dashed line is the true value.</p>\n"
    } else {
        ""
    };
    format!("{legend}<div class=\"charts\">\n{charts}</div>\n{note}")
}
