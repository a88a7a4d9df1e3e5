//! The task with a mesh of a file.

use std::path::Path;

use glam::{DQuat, DVec3};
use renderer::{Error, Mesh};

use crate::experiment::{Pose, Task};
use crate::merged::{merged, normalize};

/// A mesh of a file in front of nothing, smooth, its longest side 1.
pub fn task(path: &Path, size: u32) -> Result<Task, Error> {
    let (mut vertices, triangles) = merged(path)?;
    normalize(&mut vertices, |half, _| 0.5 / half.max_element());
    let [down, around] = [12.0_f64, 145.0].map(f64::to_radians);
    let rotation = DQuat::from_rotation_x(down) * DQuat::from_rotation_y(around);
    let truth = Pose { rotation, translation: DVec3::new(0.05, -0.03, 0.0) };
    let mesh = Mesh::new("object", vertices, triangles).smooth();
    Ok(Task { mesh, has_floor: false, size, truth })
}
