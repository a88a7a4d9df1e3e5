//! `renderer render`

use std::iter;
use std::path::{Path, PathBuf};

use super::changes::Changes;
use super::derivative::{derivative, in_colors};
use super::inputs::check_output;
use super::output::{print, print_warning};
use super::sampling::SamplingArguments;
use super::until::{self, UntilArguments};
use super::views::{path_of_view, view_stems};
use crate::arithmetic::Arithmetic;
use crate::display::{ToneMapping, color_ids, expose, normalize, range_of_measure};
use crate::files::images::picture_of_measure;
use crate::files::{check_image_path, save_image, save_passes};
use crate::progressive::{Estimate, Until};
use crate::render::Renderer;
use crate::scene::Scene;
use crate::settings::{Edges, Pass, PrimaryVisibility, Settings};
use crate::{Error, Image};

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// A scene file (TOML), or a mesh (OBJ, PLY, STL, glTF), which is framed and lit by default
    scene: PathBuf,

    /// Where to write the image: .png (sRGB, clipped to 0..1), .exr (linear, as rendered) or .hdr (linear,
    /// mantissas of 8 bits); of a scene with views, IMAGE-NAME for each of them. No input of the scene is replaced
    #[arg(short, long, value_name = "IMAGE")]
    output: PathBuf,

    /// Make light and colours brighter by so many stops, each a factor of two; negative for darker
    #[arg(long, value_name = "STOPS", value_parser = stops)]
    exposure: Option<f64>,

    /// What pixels show at edges: both sides by the areas that they cover, or what rays happen to hit
    #[arg(long, value_enum, default_value_t = Antialias::Coverage)]
    antialias: Antialias,

    /// How to show what is brighter than white: clipped, or compressed (Reinhard, ACES)
    #[arg(long, value_enum, default_value_t = ToneMapping::Clamp)]
    tone: ToneMapping,

    /// What to show of surfaces: the light they send to the camera, their diffuse colour, that they are there
    /// (their silhouettes), how far they are along the direction of the camera, their places, normals or texture
    /// coordinates, or the numbers of object, triangle and material; several, with commas between them, are the
    /// layers of one .exr, which holds the numbers themselves; levels of a .png are in proportion to depth or places,
    /// to normals from -1 to 1 and to texture coordinates from 0 to 1, and every object, triangle and material has a
    /// colour
    #[arg(
        long = "pass",
        value_name = "PASS",
        value_enum,
        value_delimiter = ',',
        default_value = "radiance"
    )]
    passes: Vec<Pass>,

    /// How to find primary visibility: rays through a bounding volume hierarchy, rays against every
    /// primitive, or rasterised primitives
    #[arg(long, value_enum, default_value_t = PrimaryVisibility::Bvh)]
    visibility: PrimaryVisibility,

    /// Make pixels black that are not finite, and say how many they are, instead of stopping at them
    #[arg(long)]
    allow_non_finite: bool,

    /// Show how the image changes while a parameter moves: light.key.position=1,0,0 is one unit along x;
    /// red becomes brighter, blue darker; an .exr holds the derivative itself
    #[arg(long, value_name = "PATH=DIRECTION", conflicts_with_all = ["exposure", "tone", "normalize"])]
    derivative: Option<String>,

    #[command(flatten)]
    changes: Changes,

    #[command(flatten)]
    sampling: SamplingArguments,

    #[command(flatten)]
    until: UntilArguments,

    /// Map the darkest channel to 0 and the brightest to 1
    #[arg(long, conflicts_with_all = ["exposure", "tone"])]
    normalize: bool,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Antialias {
    Coverage,
    None,
}

/// A number of stops: as many as lead from the faintest to the brightest number.
fn stops(text: &str) -> Result<f64, String> {
    let stops: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    let in_range = (-300.0..=300.0).contains(&stops);
    in_range.then_some(stops).ok_or_else(|| "must be from -300 to 300".to_owned())
}

pub(super) fn run(arguments: &Arguments, arithmetic: Arithmetic) -> Result<(), Error> {
    check_image_path(&arguments.output)?;
    if let Some(path) = &arguments.until.standard_error {
        check_image_path(path)?;
    }
    let experiment = arguments.changes.load_to_show(&arguments.scene, &arguments.passes)?;
    arguments.outputs(&experiment.scene).iter().try_for_each(|to| check_output(to, &experiment))?;
    let until = arguments.until.until(&experiment.scene)?;
    check_passes(arguments)?;
    if until.is_some() && !arguments.passes.contains(&Pass::Radiance) {
        return Err(Error::new("--pass", "has no noise to reduce: that is of radiance"));
    }
    let settings = |pass: Pass| Settings {
        arithmetic,
        visibility: arguments.visibility,
        pass,
        sampling: arguments.sampling.sampling(&experiment.scene),
        edges: match arguments.antialias {
            Antialias::Coverage => Edges::On,
            Antialias::None => Edges::Off,
        },
        ..Settings::default()
    };
    let renderer = |pass: &Pass| Renderer::unchecked(&experiment.scene, &settings(*pass));
    let mut renderers: Vec<Renderer> = arguments.passes.iter().map(renderer).collect();
    if experiment.scene.views().is_empty() {
        return save(arguments, &mut renderers, &experiment.scene, until, "");
    }
    let mut scene = experiment.scene;
    for (view, stem) in view_stems(&scene).iter().enumerate() {
        scene.look_through(view);
        renderers.iter_mut().for_each(|renderer| renderer.look(&scene));
        save(arguments, &mut renderers, &scene, until, stem)?;
    }
    Ok(())
}

impl Arguments {
    /// All files that are to be written.
    fn outputs(&self, scene: &Scene) -> Vec<PathBuf> {
        let named = || iter::once(&self.output).chain(&self.until.standard_error);
        match scene.views().is_empty() {
            true => named().cloned().collect(),
            false => view_stems(scene)
                .iter()
                .flat_map(|stem| named().map(|path| path_of_view(path, stem)))
                .collect(),
        }
    }
}

/// Several passes are layers of a file that has them, and have no derivative to show.
fn check_passes(arguments: &Arguments) -> Result<(), Error> {
    let Arguments { passes, output, derivative, .. } = arguments;
    if let Some(twice) =
        passes.iter().enumerate().find(|(index, pass)| passes[..*index].contains(pass))
    {
        return Err(Error::new("--pass", format!("has {} twice", twice.1.name())));
    }
    if is_a(output, "hdr") && passes.iter().any(|pass| pass.is_signed()) {
        return Err(Error::new(
            output.display(),
            "holds nothing below 0: give it the name of an .exr",
        ));
    }
    if passes.len() < 2 {
        return Ok(());
    }
    if derivative.is_some() {
        return Err(Error::new("--derivative", "is of one pass"));
    }
    match is_a(output, "exr") {
        true => Ok(()),
        false => Err(Error::new(output.display(), "several passes are the layers of one .exr")),
    }
}

fn is_a(path: &Path, extension: &str) -> bool {
    path.extension().is_some_and(|own| own.eq_ignore_ascii_case(extension))
}

/// Writes the pictures of a scene, or of its view of this stem, to a file.
fn save(
    arguments: &Arguments,
    renderers: &mut [Renderer],
    scene: &Scene,
    until: Option<Until>,
    stem: &str,
) -> Result<(), Error> {
    let path = |path: &Path| match stem {
        "" => path.to_owned(),
        stem => path_of_view(path, stem),
    };
    let output = path(&arguments.output);
    if let Some(direction) = &arguments.derivative {
        let mut image = derivative(&renderers[0], scene, direction)?;
        // Of the formats, one holds numbers of either sign.
        if !is_a(&output, "exr") {
            image = in_colors(&image);
        }
        save_image(&image, &output)?;
        return print(output.display());
    }
    let mut images = Vec::new();
    for renderer in renderers {
        let pass = renderer.settings().pass;
        let image = match until.filter(|_| pass == Pass::Radiance) {
            None => renderer.render(),
            Some(until) => {
                let Estimate { image, standard_error, .. } = until::render(renderer, until)?;
                if let Some(to) = &arguments.until.standard_error {
                    save_image(&standard_error, &path(to))?;
                }
                image
            }
        };
        images.push((pass, finished(arguments, renderer, scene, image)?));
    }
    match &mut images[..] {
        [(pass, image)] => {
            if pass.is_measure() && is_a(&output, "png") && !arguments.normalize {
                match pass {
                    Pass::Ids => color_ids(image),
                    _ => picture_of_measure(image, range_of_measure(image, *pass)),
                }
            }
            save_image(image, &output)?;
        }
        passes => save_passes(passes, &output)?,
    }
    print(output.display())
}

/// What is said of pixels that are not finite though the radiance of all their rays is.
fn at_edges(image: &Image) -> String {
    let is_finite = |pixel: &[f32; 3]| pixel.iter().all(|value| value.is_finite());
    let at = image.pixels.iter().position(|pixel| !is_finite(pixel)).unwrap_or_default() as u32;
    let (column, row) = (at % image.width, at / image.width);
    format!(
        "an edge in column {column}, row {row} is not finite: leave edges out (--antialias none)"
    )
}

/// A rendered image as it is to be written.
fn finished(
    arguments: &Arguments,
    renderer: &Renderer,
    scene: &Scene,
    mut image: Image,
) -> Result<Image, Error> {
    if !image.is_finite() {
        let found = renderer.find_non_finite(scene);
        let found = found.map_or_else(|| at_edges(&image), |found| found.to_string());
        if !arguments.allow_non_finite {
            return Err(Error::not_finite(arguments.scene.display(), found));
        }
        print_warning(format_args!("{}: {found}", arguments.scene.display()));
        image.blacken_non_finite();
    }
    let is_black = || image.pixels.iter().all(|pixel| *pixel == [0.0; 3]);
    let is_lit = !scene.lights.is_empty() || scene.environment.is_some();
    if renderer.settings().pass == Pass::Radiance && is_lit && is_black() {
        let problem = "the image is black: nothing that the camera sees sends light to it";
        print_warning(format_args!("{}: {problem}", arguments.scene.display()));
    }
    if matches!(renderer.settings().pass, Pass::Radiance | Pass::Albedo) {
        if let Some(stops) = arguments.exposure {
            expose(&mut image, stops);
        }
        arguments.tone.apply(&mut image);
    }
    if arguments.normalize {
        normalize(&mut image);
    }
    Ok(image)
}
