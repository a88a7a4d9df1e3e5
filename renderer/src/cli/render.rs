//! `renderer render`

use std::path::{Path, PathBuf};

use super::changes::Changes;
use super::derivative::derivative;
use super::output::{print, print_warning};
use super::sampling::SamplingArguments;
use super::until::{self, UntilArguments};
use super::views::{path_of_view, view_stems};
use crate::Error;
use crate::arithmetic::Arithmetic;
use crate::display::{ToneMapping, expose, normalize};
use crate::files::{check_image_path, save_image};
use crate::progressive::{Estimate, Until};
use crate::render::Renderer;
use crate::scene::Scene;
use crate::settings::{Edges, Pass, PrimaryVisibility, Settings};

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// A scene file (TOML), or a mesh (OBJ, PLY, STL, glTF), which is framed and lit by default
    scene: PathBuf,

    /// Where to write the image: .png (sRGB, clipped to 0..1), .exr (linear, as rendered) or .hdr (linear,
    /// mantissas of 8 bits); of a scene with views, IMAGE-NAME for each of them
    #[arg(short, long, value_name = "IMAGE")]
    output: PathBuf,

    /// Make the image brighter by so many stops, each a factor of two; negative for darker
    #[arg(long, value_name = "STOPS", allow_negative_numbers = true, value_parser = stops)]
    exposure: Option<f64>,

    /// What pixels show at edges: both sides by the areas that they cover, or what rays happen to hit
    #[arg(long, value_enum, default_value_t = Antialias::Coverage)]
    antialias: Antialias,

    /// How to show what is brighter than white: clipped, or compressed (Reinhard, ACES)
    #[arg(long, value_enum, default_value_t = ToneMapping::Clamp)]
    tone: ToneMapping,

    /// What to show of surfaces: the light they send to the camera, their diffuse colour, or that they are
    /// there (their silhouettes)
    #[arg(long, value_enum, default_value_t = Pass::Radiance)]
    pass: Pass,

    /// How to find primary visibility: rays through a bounding volume hierarchy, rays against every
    /// primitive, or rasterised primitives
    #[arg(long, value_enum, default_value_t = PrimaryVisibility::Bvh)]
    visibility: PrimaryVisibility,

    /// Make pixels black that are not finite, and say how many they are, instead of stopping at them
    #[arg(long)]
    allow_non_finite: bool,

    /// Show how the image changes while a parameter moves: light.key.position=1,0,0 is one unit along x;
    /// red becomes brighter, blue darker
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
    let experiment = arguments.changes.load(&arguments.scene)?;
    let until = arguments.until.until(&experiment.scene)?;
    let settings = Settings {
        arithmetic,
        visibility: arguments.visibility,
        pass: arguments.pass,
        sampling: arguments.sampling.sampling(&experiment.scene),
        edges: match arguments.antialias {
            Antialias::Coverage if arguments.pass.has_edges(&experiment.scene) => Edges::On,
            Antialias::Coverage | Antialias::None => Edges::Off,
        },
        ..Settings::default()
    };
    let mut renderer = Renderer::unchecked(&experiment.scene, &settings);
    if experiment.scene.views().is_empty() {
        return save(arguments, &mut renderer, &experiment.scene, until, "");
    }
    let mut scene = experiment.scene;
    for (view, stem) in view_stems(&scene).iter().enumerate() {
        scene.look_through(view);
        renderer.look(&scene);
        save(arguments, &mut renderer, &scene, until, stem)?;
    }
    Ok(())
}

/// Writes the picture of a scene, or of its view of this stem, to a file.
fn save(
    arguments: &Arguments,
    renderer: &mut Renderer,
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
        let image = derivative(renderer, scene, direction)?;
        save_image(&image, &output)?;
        return print(output.display());
    }
    let (mut image, standard_error) = match until {
        None => (renderer.render(), None),
        Some(until) => {
            let Estimate { image, standard_error, .. } = until::render(renderer, until)?;
            (image, Some(standard_error))
        }
    };
    if !image.is_finite() {
        let found = renderer.find_non_finite(scene);
        let found = found.map_or_else(String::new, |found| found.to_string());
        if !arguments.allow_non_finite {
            return Err(Error::not_finite(arguments.scene.display(), found));
        }
        print_warning(format_args!("{}: {found}", arguments.scene.display()));
        image.blacken_non_finite();
    }
    if let Some(stops) = arguments.exposure {
        expose(&mut image, stops);
    }
    arguments.tone.apply(&mut image);
    if arguments.normalize {
        normalize(&mut image);
    }
    save_image(&image, &output)?;
    if let (Some(image), Some(to)) = (standard_error, &arguments.until.standard_error) {
        save_image(&image, &path(to))?;
    }
    print(output.display())
}
