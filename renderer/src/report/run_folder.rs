//! What a run has left in its folder.

use std::collections::HashMap;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use crate::Error;
use crate::optimize::Record;

pub(super) struct RunFolder {
    pub summary: Value,
    pub history: Vec<Record>,
    pub trajectory: Option<Trajectory>,
    /// Names and contents of the images.
    pub images: Vec<(&'static str, Vec<u8>)>,
    pub views: Vec<ViewImages>,
    pub frames: Vec<Frame>,
    pub pictures: Vec<ObjectPictures>,
    pub scene: Option<String>,
}

/// `trajectory.json`.
#[derive(Deserialize)]
pub(super) struct Trajectory {
    pub paths: Vec<String>,
    pub target: Vec<Option<f64>>,
    pub iterations: Vec<u64>,
    pub values: Vec<Vec<f64>>,
}

/// An image of the run on its way.
pub(super) struct Frame {
    pub iteration: u64,
    pub loss: f64,
    pub png: Vec<u8>,
}

/// A view, and how alike its picture and its target are.
pub(super) struct ViewImages {
    pub title: String,
    pub psnr: Option<f64>,
    pub ssim: f64,
    /// Target, initial, final.
    pub pictures: Vec<(&'static str, Vec<u8>)>,
}

/// A texture or a shape that varied, before and after.
pub(super) struct ObjectPictures {
    pub path: String,
    pub initial: Vec<u8>,
    pub last: Vec<u8>,
}

/// An entry of `pictures` in the summary.
#[derive(Deserialize)]
struct PictureEntry {
    path: String,
    initial: PathBuf,
    #[serde(rename = "final")]
    last: PathBuf,
}

/// An entry of `views` in the summary.
#[derive(Deserialize)]
struct ViewEntry {
    name: String,
    pass: String,
    held_out: bool,
    /// Null if the picture is the target.
    psnr: Option<f64>,
    ssim: f64,
    files: HashMap<String, PathBuf>,
}

/// An entry of `strip` in the summary.
#[derive(Deserialize)]
struct FrameEntry {
    iteration: u64,
    loss: f64,
    file: PathBuf,
}

impl RunFolder {
    pub fn read(folder: &Path) -> Result<Self, Error> {
        if folder.is_file() {
            let problem =
                "is a file; a report is of the folder that `renderer optimize` has filled";
            return Err(Error::new(folder.display(), problem));
        }
        let file = folder.join("summary.json");
        let Some(bytes) = optional(&file)? else {
            let problem =
                "no such file; a report needs a folder that `renderer optimize` has filled";
            return Err(Error::new(file.display(), problem));
        };
        let summary: Value = parse(&file, &bytes)?;
        let mut images = Vec::new();
        for name in ["target", "initial", "final", "difference"] {
            images
                .extend(optional(&folder.join(name).with_extension("png"))?.map(|png| (name, png)));
        }
        let scene = optional(&folder.join("scene.toml"))?;
        Ok(Self {
            history: history(&folder.join("history.csv"))?,
            trajectory: trajectory(&folder.join("trajectory.json"))?,
            frames: frames(folder, &file, &summary)?,
            pictures: pictures(folder, &file, &summary)?,
            views: views(folder, &file, &summary)?,
            images,
            scene: scene.map(|bytes| String::from_utf8_lossy(&bytes).into_owned()),
            summary,
        })
    }
}

/// The content of a file that need not be there.
fn optional(path: &Path) -> Result<Option<Vec<u8>>, Error> {
    match fs::read(path) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(Error::io(path, format!("cannot be read: {error}"), error)),
    }
}

fn parse<T: DeserializeOwned>(path: &Path, bytes: &[u8]) -> Result<T, Error> {
    serde_json::from_slice(bytes)
        .map_err(|error| Error::new(path.display(), format_args!("is broken: {error}")))
}

fn history(path: &Path) -> Result<Vec<Record>, Error> {
    let Some(bytes) = optional(path)? else { return Ok(Vec::new()) };
    let text = String::from_utf8_lossy(&bytes);
    let rows = text.lines().zip(1..).skip(1);
    rows.map(|(row, line)| {
        record(row).ok_or_else(|| {
            Error::new(
                format_args!("{}:{line}", path.display()),
                "must be an iteration and three finite numbers",
            )
        })
    })
    .collect()
}

fn record(row: &str) -> Option<Record> {
    let mut cells = row.split(',');
    let iteration = cells.next()?.parse().ok()?;
    let mut number = || cells.next()?.parse().ok().filter(|value: &f64| value.is_finite());
    Some(Record { iteration, loss: number()?, gradient_norm: number()?, seconds: number()? })
}

fn trajectory(path: &Path) -> Result<Option<Trajectory>, Error> {
    let Some(bytes) = optional(path)? else { return Ok(None) };
    let trajectory: Trajectory = parse(path, &bytes)?;
    let Trajectory { paths, target, iterations, values } = &trajectory;
    let fits = target.len() == paths.len()
        && values.len() == iterations.len()
        && values.iter().all(|point| point.len() == paths.len());
    if !fits {
        return Err(Error::new(path.display(), "is broken: its parts differ in length"));
    }
    Ok((!paths.is_empty()).then_some(trajectory))
}

/// What the summary lists under a key, if it has it.
fn entries<T: DeserializeOwned>(file: &Path, summary: &Value, key: &str) -> Result<Vec<T>, Error> {
    let Some(list) = summary.get(key) else { return Ok(Vec::new()) };
    serde_json::from_value(list.clone())
        .map_err(|error| Error::new(file.display(), format_args!("{key} is broken: {error}")))
}

/// The views that the summary lists.
fn views(folder: &Path, file: &Path, summary: &Value) -> Result<Vec<ViewImages>, Error> {
    let mut found = Vec::new();
    for ViewEntry { name, pass, held_out, psnr, ssim, files } in entries(file, summary, "views")? {
        let mut pictures = Vec::new();
        for kind in ["target", "initial", "final"] {
            if let Some(file) = files.get(kind) {
                pictures.extend(optional(&folder.join(file))?.map(|png| (kind, png)));
            }
        }
        let pass = match &pass[..] {
            "radiance" => String::new(),
            pass => format!(", {pass}"),
        };
        let held_out = if held_out { ", held out" } else { "" };
        found.push(ViewImages { title: format!("{name}{pass}{held_out}"), psnr, ssim, pictures });
    }
    Ok(found)
}

/// The pictures of textures and shapes that the summary lists.
fn pictures(folder: &Path, file: &Path, summary: &Value) -> Result<Vec<ObjectPictures>, Error> {
    let mut pictures = Vec::new();
    for PictureEntry { path, initial, last } in entries(file, summary, "pictures")? {
        if let (Some(initial), Some(last)) =
            (optional(&folder.join(initial))?, optional(&folder.join(last))?)
        {
            pictures.push(ObjectPictures { path, initial, last });
        }
    }
    Ok(pictures)
}

/// The images of the strip that the summary lists.
fn frames(folder: &Path, file: &Path, summary: &Value) -> Result<Vec<Frame>, Error> {
    let mut frames = Vec::new();
    for FrameEntry { iteration, loss, file } in entries(file, summary, "strip")? {
        if let Some(png) = optional(&folder.join(file))? {
            frames.push(Frame { iteration, loss, png });
        }
    }
    Ok(frames)
}
