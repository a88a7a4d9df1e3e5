//! `renderer init` and `renderer scene`

use std::fmt::Write;
use std::path::{Path, PathBuf};

use glam::DVec3;
use renderer_files::disk::{check_writable, write_atomically};

use super::load;
use super::output::{print, short};
use crate::Error;
use crate::scene::{Light, LightSource, Scene};

/// The format of scene files, and what recoveries add to it.
const FORMAT: [&str; 2] =
    [include_str!("../../docs/scene.md"), include_str!("../../docs/recoveries.md")];

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// A mesh (OBJ, PLY, STL, glTF) to frame and light; without one, a ball on a floor
    mesh: Option<PathBuf>,

    /// Where to write the scene file
    #[arg(short, long, value_name = "FILE", default_value = "scene.toml")]
    output: PathBuf,
}

/// Writes a scene file to start from.
pub(super) fn run(arguments: &Arguments) -> Result<(), Error> {
    let Arguments { mesh, output } = arguments;
    check_writable(output)?;
    if output.exists() {
        let problem = "is there already; choose another file with --output";
        return Err(Error::new(output.display(), problem));
    }
    let text = match mesh {
        Some(path) => of_mesh(path, output)?,
        None => include_str!("init.toml").to_owned(),
    };
    write_atomically(output, text.as_bytes())?;
    print(output.display())
}

/// Explains the format of scene files.
pub(super) fn explain() -> Result<(), Error> {
    print(FORMAT.map(str::trim_end).join("\n\n"))
}

/// The scene file of a mesh as it is framed and lit by default.
fn of_mesh(path: &Path, output: &Path) -> Result<String, Error> {
    let scene = load(path)?.scene;
    let folder = output.parent().unwrap_or(Path::new(""));
    let from_folder = path.strip_prefix(folder).unwrap_or(path);
    // A path beside the scene file is found wherever both are moved to; any other is whole.
    let is_beside = folder.as_os_str().is_empty() || path.starts_with(folder);
    let place = if is_beside {
        from_folder.to_owned()
    } else {
        path.canonicalize().map_err(|error| Error::new(path.display(), error))?
    };
    let (low, high) = scene.bounding_box().unwrap_or((DVec3::ZERO, DVec3::ONE));
    let size = low.distance(high);
    let mut text = camera(&scene, size);
    for light in &scene.lights {
        text += &self::light(&light.name, &light.source, size);
    }
    let place = toml::Value::from(place.to_string_lossy().into_owned());
    let material = scene.materials.first().map_or("default", |material| &material.name);
    let material = toml::Value::from(format!("material.{material}.diffuse"));
    let middle = position(low.midpoint(high), size);
    // Writing into a string cannot fail.
    let _ = write!(
        text,
        "[[mesh]]\npath = {place}\n# normals = \"smooth\"             # shade it smoothly\n\
         # rotation = [0.0, 0.0, 0.0]     # turn it about the file's origin: the axis times degrees\n\
         # translation = [0.0, 0.0, 0.0]  # and move it then: its middle is at {middle}\n\n\
         # What to recover from a photograph, with `renderer optimize`:\n\
         # [optimize]\n# target = \"photo.png\"\n#\n\
         # [[optimize.parameter]]\n# path = {material}\n"
    );
    Ok(text)
}

fn camera(scene: &Scene, size: f64) -> String {
    let camera = &scene.camera;
    format!(
        "# `renderer scene` explains every field.\n[camera]\nlook_from = {}\nlook_at = {}\n\
         vfov = {}                     # vertical field of view, degrees\n\
         width = {}\nheight = {}\n\n",
        position(camera.look_from, size),
        position(camera.look_at, size),
        float(camera.vfov),
        scene.width,
        scene.height
    )
}

/// The table of a light that a mesh file brings, or of the default one.
fn light(name: &str, source: &LightSource, size: f64) -> String {
    let name = toml::Value::from(name);
    let numbers = match source {
        LightSource::Known(Light::Point(light)) => format!(
            "type = \"point\"\nposition = {}\nradiant_intensity = {}  # W/sr\n",
            position(light.position, size),
            float(light.radiant_intensity)
        ),
        LightSource::Known(Light::Distant(light)) => format!(
            "type = \"distant\"\ndirection = {}  # towards the light\nirradiance = {}  # W/m²\n",
            triple(light.direction.to_array()),
            float(light.irradiance)
        ),
        LightSource::Known(Light::Spot(light)) => format!(
            "type = \"spot\"\nposition = {}\ndirection = {}\nradiant_intensity = {}  # W/sr\n\
             inner_angle = {}\nouter_angle = {}\n",
            position(light.position, size),
            triple(light.direction.to_array()),
            float(light.radiant_intensity),
            float(light.inner_angle),
            float(light.outer_angle)
        ),
        // Mesh files bring no others.
        _ => return String::new(),
    };
    format!("[[light]]\nname = {name}\n{numbers}\n")
}

/// A number as TOML: with a point or an exponent, in six digits.
fn float(value: f64) -> String {
    let text = short(value);
    if text.contains(['.', 'e']) { text } else { format!("{text}.0") }
}

fn triple(values: [f64; 3]) -> String {
    format!("[{}]", values.map(float).join(", "))
}

/// A place to a millionth of the size of what is there, however far away it is.
fn position(place: DVec3, size: f64) -> String {
    let digits = (6.0 - size.max(f64::MIN_POSITIVE).log10().floor()).clamp(-300.0, 300.0);
    let unit = 10.0_f64.powi(digits as i32);
    let rounded = |x: f64| Some((x * unit).round() / unit).filter(|x| x.is_finite()).unwrap_or(x);
    // Adding 0 leaves no -0.
    format!("{:?}", place.to_array().map(|x| rounded(x) + 0.0))
}
