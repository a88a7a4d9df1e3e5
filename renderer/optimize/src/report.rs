//! What a run leaves in its output folder.

use std::fmt::Write as _;
use std::path::Path;

use renderer_core::Error;
use renderer_files::disk::{create_folder, write_atomically};
use serde_json::{Map, Value, json};

use super::variable::{element_path, split};
use super::{Outcome, Point, Record, Variable, loss_svg};

/// Writes `history.csv`, `loss.svg`, `trajectory.json` and `summary.json` into `folder`, which is
/// made if need be.
///
/// `trajectory.json` holds `paths`, one for each element of the parameters, `target`, its true value
/// or null, and one entry of `iterations`, `losses` and `values` for each point of the trajectory.
///
/// `extra` goes into the summary as it is; see [`summary`].
///
/// # Errors
///
/// If a file cannot be written; the place is the file.
pub fn write_report(
    folder: &Path,
    variables: &[Variable],
    outcome: &Outcome,
    extra: Map<String, Value>,
) -> Result<(), Error> {
    create_folder(folder)?;
    let summary = Value::Object(summary(variables, outcome, extra));
    let files = [
        ("history.csv", history_csv(&outcome.history)),
        ("loss.svg", loss_svg(&outcome.history)?),
        ("trajectory.json", format!("{}\n", trajectory_json(variables, &outcome.trajectory))),
        ("summary.json", format!("{summary:#}\n")),
    ];
    files.iter().try_for_each(|(name, text)| write_atomically(&folder.join(name), text.as_bytes()))
}

/// The history as comma-separated values with a header: `iteration`, `loss`, `gradient_norm`,
/// `seconds`. The numbers read back exactly.
pub fn history_csv(history: &[Record]) -> String {
    let mut csv = String::from("iteration,loss,gradient_norm,seconds\n");
    for Record { iteration, loss, gradient_norm, seconds } in history {
        // Writing to a string cannot fail.
        let _ = writeln!(csv, "{iteration},{loss:e},{gradient_norm:e},{seconds}");
    }
    csv
}

/// The summary of a run:
///
/// - `loss`: `initial`, `final`, `ratio` (final over initial, null if the initial loss was 0), and
///   `last`, the loss of the latest iteration. The final loss is the lowest, which the recovered
///   parameters have.
/// - `iterations`: the steps taken; `best_iteration`: the one that recovered the parameters.
/// - `evaluations` of the objective, `seconds` of work, and `seconds_per_iteration`.
/// - `stop_reason` (see [`StopReason`](super::StopReason)) and `stop_detail`, for people.
/// - `parameters`: for each path `initial`, `final` and, where it is known, `target`.
///
/// Entries of `extra` are added; if one has a name from above, both of them objects, their entries
/// are merged, otherwise that of `extra` stands. A number that is not finite becomes null.
pub fn summary(
    variables: &[Variable],
    outcome: &Outcome,
    extra: Map<String, Value>,
) -> Map<String, Value> {
    let Outcome { best, last, history, stop, evaluations, seconds, .. } = outcome;
    let initial = outcome.initial_loss;
    let mut parameters = Map::new();
    for (variable, found) in split(variables, &best.x) {
        let mut entry = Map::new();
        entry.insert("initial".to_owned(), json!(variable.initial));
        entry.insert("final".to_owned(), json!(found));
        if let Some(target) = &variable.target {
            entry.insert("target".to_owned(), json!(target));
        }
        parameters.insert(variable.path.clone(), Value::Object(entry));
    }
    let fields = [
        (
            "loss",
            json!({
                "initial": initial,
                "final": best.loss,
                "ratio": best.loss / initial,
                "last": last.loss,
            }),
        ),
        ("iterations", json!(last.iteration)),
        ("best_iteration", json!(best.iteration)),
        ("evaluations", json!(evaluations)),
        ("seconds", json!(seconds)),
        ("seconds_per_iteration", json!(seconds / history.len() as f64)),
        ("stop_reason", json!(stop.reason)),
        ("stop_detail", json!(stop.detail)),
        ("parameters", Value::Object(parameters)),
    ];
    let mut summary: Map<String, Value> =
        fields.into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
    merge(&mut summary, extra);
    summary
}

fn merge(into: &mut Map<String, Value>, from: Map<String, Value>) {
    for (name, value) in from {
        match (into.get_mut(&name), value) {
            (Some(Value::Object(own)), Value::Object(other)) => merge(own, other),
            (_, value) => {
                into.insert(name, value);
            }
        }
    }
}

/// A trajectory as JSON: `paths`, one for each element, `target`, the true value of each element
/// or null, and `iterations`, `losses` and `values`, one entry for each point.
fn trajectory_json(variables: &[Variable], trajectory: &[Point]) -> Value {
    let len = trajectory.first().map_or(0, |point| point.x.len());
    let paths: Vec<String> = (0..len).map(|i| element_path(variables, i)).collect();
    let target = |variable: &Variable| match &variable.target {
        Some(target) => target.iter().map(|&value| Some(value)).collect(),
        None => vec![None; variable.initial.len()],
    };
    json!({
        "paths": paths,
        "target": variables.iter().flat_map(target).take(len).collect::<Vec<Option<f64>>>(),
        "iterations": trajectory.iter().map(|point| point.iteration).collect::<Vec<_>>(),
        "losses": trajectory.iter().map(|point| point.loss).collect::<Vec<_>>(),
        "values": trajectory.iter().map(|point| &point.x[..]).collect::<Vec<_>>(),
    })
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::{Start, Stop, StopReason};

    fn outcome() -> Outcome {
        let record = |iteration, loss| Record {
            iteration,
            loss,
            gradient_norm: 1e-20,
            seconds: 0.1 * iteration as f64,
        };
        Outcome {
            best: Point { iteration: 1, loss: 0.1, x: vec![1.0, 2.0, 3.0] },
            last: Point { iteration: 2, loss: 0.3, x: vec![9.0; 3] },
            history: vec![record(0, 0.4), record(1, 0.1), record(2, 0.1 + 0.2)],
            trajectory: vec![Point { iteration: 0, loss: 0.4, x: vec![5.0, 6.0, 7.0] }],
            stop: Stop { reason: StopReason::GradientTolerance, detail: "flat".to_owned() },
            topologies: vec![],
            initial_loss: 0.4,
            evaluations: 4,
            seconds: 6.0,
            start: Start::Fresh,
        }
    }

    #[test]
    fn csv_reads_back_exactly() {
        let history = outcome().history;
        let csv = history_csv(&history);
        let mut rows = csv.lines();
        assert_eq!(rows.next(), Some("iteration,loss,gradient_norm,seconds"));
        let rows: Vec<Vec<f64>> =
            rows.map(|row| row.split(',').map(|n| n.parse().unwrap()).collect()).collect();
        assert_eq!(rows.len(), history.len());
        for (row, record) in rows.iter().zip(&history) {
            let Record { iteration, loss, gradient_norm, seconds } = *record;
            assert_eq!(*row, [iteration as f64, loss, gradient_norm, seconds]);
        }
    }

    #[test]
    fn summary_names_what_was_recovered() {
        let mut position = Variable::new("light.position", vec![5.0, 6.0], 0.1);
        position.target = Some(vec![1.5, 2.5]);
        let variables = [position, Variable::new("light.intensity", vec![7.0], 0.1)];
        let extra = json!({"threads": 2, "parameters": {"camera.vfov": {"final": [30.0]}}});
        let Value::Object(extra) = extra else { unreachable!() };
        let summary = Value::Object(summary(&variables, &outcome(), extra));
        assert_eq!(
            summary,
            json!({
                "loss": {"initial": 0.4, "final": 0.1, "ratio": 0.25, "last": 0.3},
                "iterations": 2,
                "best_iteration": 1,
                "evaluations": 4,
                "seconds": 6.0,
                "seconds_per_iteration": 2.0,
                "stop_reason": "gradient_tolerance",
                "stop_detail": "flat",
                "parameters": {
                    "light.position":
                        {"initial": [5.0, 6.0], "final": [1.0, 2.0], "target": [1.5, 2.5]},
                    "light.intensity": {"initial": [7.0], "final": [3.0]},
                    "camera.vfov": {"final": [30.0]},
                },
                "threads": 2,
            })
        );
    }

    #[test]
    fn numbers_that_json_lacks_are_null() {
        let mut outcome = outcome();
        outcome.initial_loss = 0.0;
        outcome.best.loss = 0.0;
        let variables = [Variable::new("x", vec![0.0; 3], 0.1)];
        let summary = summary(&variables, &outcome, Map::new());
        assert_eq!(summary["loss"]["ratio"], Value::Null);
    }

    #[test]
    fn report_leaves_four_files() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("new/out");
        let variables = [Variable::new("x", vec![0.0; 3], 0.1)];
        write_report(&out, &variables, &outcome(), Map::new()).unwrap();
        assert!(fs::read_to_string(out.join("history.csv")).unwrap().starts_with("iteration,"));
        assert!(fs::read_to_string(out.join("loss.svg")).unwrap().contains("<svg"));
        let summary = fs::read_to_string(out.join("summary.json")).unwrap();
        assert!(serde_json::from_str::<Value>(&summary).unwrap().is_object());
        assert_eq!(fs::read_dir(&out).unwrap().count(), 4);
    }

    #[test]
    fn json_names_every_element() {
        let mut position = Variable::new("p", vec![0.0, 0.0], 0.1);
        position.target = Some(vec![5.0, 6.0]);
        let variables = [position, Variable::new("q", vec![0.0], 0.1)];
        let point = |iteration: u64| Point { iteration, loss: 1.0, x: vec![iteration as f64; 3] };
        let json = trajectory_json(&variables, &[point(0), point(7)]);
        assert_eq!(
            json,
            json!({
                "paths": ["p[0]", "p[1]", "q"],
                "target": [5.0, 6.0, null],
                "iterations": [0, 7],
                "losses": [1.0, 1.0],
                "values": [[0.0, 0.0, 0.0], [7.0, 7.0, 7.0]],
            })
        );
    }
}
