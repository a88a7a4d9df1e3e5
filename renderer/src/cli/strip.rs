//! The images of a run on its way.

use std::path::Path;

use renderer_files::disk::create_folder;
use serde_json::{Value, json};

use crate::Error;
use crate::files::save_png;
use crate::optimize::Point;
use crate::recovery::Recovery;

/// The folder of the images, in the folder of the results.
pub(super) const STRIP_FOLDER: &str = "strip";

/// At most so many images, which together have up to so many pixels.
const MOST_IMAGES: usize = 24;
const MOST_PIXELS: usize = 8 << 20;

/// Renders some points of a trajectory into `out`, close together where the run was young and its
/// images changed most. The entry of the summary: iteration, loss and file of each image.
pub(super) fn save_strip(
    recovery: &Recovery<'_>,
    trajectory: &[Point],
    out: &Path,
) -> Result<Value, Error> {
    let pixels = recovery.target().pixels.len();
    let most = (MOST_PIXELS / pixels.max(1)).clamp(2, MOST_IMAGES);
    let mut entries = Vec::new();
    if !trajectory.is_empty() {
        let folder = out.join(STRIP_FOLDER);
        create_folder(&folder)?;
    }
    for (i, point) in chosen(trajectory, most).into_iter().enumerate() {
        let file = format!("{STRIP_FOLDER}/{i:02}.png");
        let image = recovery.render(&recovery.scene_at(&point.x));
        save_png(&recovery.targets()[0].picture(&image), &out.join(&file))?;
        entries.push(json!({ "iteration": point.iteration, "loss": point.loss, "file": file }));
    }
    Ok(Value::Array(entries))
}

/// At most `most` of the points, the first and the last among them, at squares of equal steps.
fn chosen(trajectory: &[Point], most: usize) -> Vec<&Point> {
    let last = trajectory.len().saturating_sub(1);
    let steps = most - 1;
    let mut indices: Vec<usize> = (0..=steps).map(|i| last * i * i / (steps * steps)).collect();
    indices.dedup();
    indices.into_iter().filter_map(|i| trajectory.get(i)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_and_last_are_chosen() {
        for len in [0, 1, 2, 3, 10, 200] {
            let point = |iteration| Point { iteration, loss: 0.0, x: vec![] };
            let trajectory: Vec<Point> = (0..len).map(point).collect();
            let chosen: Vec<u64> = chosen(&trajectory, 24).iter().map(|p| p.iteration).collect();
            assert_eq!(chosen.first().copied(), (len > 0).then_some(0));
            assert_eq!(chosen.last().copied(), len.checked_sub(1));
            assert!(chosen.len() <= 24 && chosen.is_sorted_by(|a, b| a < b), "{chosen:?}");
        }
    }
}
