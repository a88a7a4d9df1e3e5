//! Writes `transforms.json`.

use std::path::{Component, Path, absolute};

use renderer_core::Error;
use serde_json::{Map, Value, json};

use super::FoundView;
use super::pinhole::Pinhole;
use crate::disk::write_atomically;

/// Writes cameras as a file `transforms.json`, which [`load_cameras`](super::load_cameras) reads: to the last bits,
/// but for names, which are then the stems of the files of images. The paths of images are written relative to the
/// folder of the file.
///
/// # Errors
///
/// If there are no cameras, or the file cannot be written.
pub fn save_cameras(cameras: &[FoundView], path: &Path) -> Result<(), Error> {
    let Some(first) = cameras.first() else {
        return Err(Error::new(path.display(), "there are no cameras to write"));
    };
    let folder = path.parent().unwrap_or(Path::new(""));
    // What all frames have in common stands before them: some programs look for it there alone.
    let common = lens(first);
    let frames = cameras.iter().map(|camera| {
        let Pinhole { position, axes, .. } = Pinhole::from(&camera.view.camera);
        let [x, y, z] = [0, 1, 2].map(|row| {
            let [right, up, backward] = axes.row(row).to_array();
            [right, up, backward, position[row]]
        });
        let mut frame = Map::new();
        frame.insert("file_path".to_owned(), relative(&camera.image, folder).into());
        frame.insert("transform_matrix".to_owned(), json!([x, y, z, [0.0, 0.0, 0.0, 1.0]]));
        let own = lens(camera);
        frame.extend(if own == common { Map::new() } else { own });
        Value::Object(frame)
    });
    let frames: Vec<Value> = frames.collect();
    let mut file = common;
    file.insert("camera_model".to_owned(), "PINHOLE".into());
    file.insert("frames".to_owned(), frames.into());
    write_atomically(path, format!("{:#}\n", Value::Object(file)).as_bytes())
}

/// The size of an image and how its camera maps directions to pixels.
fn lens(camera: &FoundView) -> Map<String, Value> {
    let [width, height] = [camera.view.width, camera.view.height].map(f64::from);
    let focal = 0.5 * height / Pinhole::from(&camera.view.camera).half_height;
    let numbers = [
        ("w", width),
        ("h", height),
        ("fl_x", focal),
        ("fl_y", focal),
        ("cx", 0.5 * width),
        ("cy", 0.5 * height),
        ("camera_angle_x", 2.0 * (0.5 * width / focal).atan()),
    ];
    numbers.into_iter().map(|(name, number)| (name.to_owned(), number.into())).collect()
}

/// The path of a file from a folder on, with slashes; as it is where there is none.
fn relative(file: &Path, folder: &Path) -> String {
    let whole =
        |path: &Path| absolute(if path.as_os_str().is_empty() { Path::new(".") } else { path });
    let (Ok(from), Ok(to)) = (whole(folder), whole(file)) else {
        return file.display().to_string();
    };
    let [from, to] = [&from, &to].map(|path| path.components().collect::<Vec<Component<'_>>>());
    let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    if shared == 0 {
        return file.display().to_string();
    }
    let up = from[shared..].iter().map(|_| "..".into());
    let down = to[shared..].iter().map(|part| part.as_os_str().to_string_lossy());
    up.chain(down).collect::<Vec<_>>().join("/")
}
