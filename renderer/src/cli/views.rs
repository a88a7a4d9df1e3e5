//! The pictures of several views.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use renderer_files::disk::create_folder;
use renderer_files::names::file_stems;
use serde_json::{Map, Value, json};

use super::output::short;
use crate::Error;
use crate::files::save_png;
use crate::recovery::{Quality, Recovery};
use crate::scene::Scene;
use crate::settings::Pass;

/// The folder of the pictures of views, in the folder of the results.
pub(super) const VIEWS_FOLDER: &str = "views";

/// The names of the views of a scene as names of files.
pub(super) fn view_stems(scene: &Scene) -> Vec<String> {
    file_stems(scene.views().iter().map(|view| &view.name[..]))
}

/// `picture.png` as `picture-STEM.png`.
pub(super) fn path_of_view(path: &Path, stem: &str) -> PathBuf {
    let mut name = path.file_stem().unwrap_or_default().to_os_string();
    name.push(format!("-{stem}"));
    if let Some(extension) = path.extension() {
        name.push(".");
        name.push(extension);
    }
    path.with_file_name(name)
}

/// Renders all views as they were and as they are into `out`; the entry of the summary: of each its name,
/// what it shows, whether it was held out, how alike picture and target are, and the files.
pub(super) fn save_views(
    recovery: &Recovery<'_>,
    recovered: &Scene,
    out: &Path,
) -> Result<Value, Error> {
    create_folder(&out.join(VIEWS_FOLDER))?;
    let stems = view_stems(recovered);
    let mut entries = Vec::new();
    for target in recovery.targets() {
        let Some(view) = target.view else { continue };
        let found = recovery.render_target(target, recovered);
        let Quality { psnr, ssim } = target.quality(&found);
        let pass = match target.pass {
            Pass::Radiance => String::new(),
            pass => format!("-{}", pass.name()),
        };
        let initial = recovery.render_target(target, recovery.scene());
        let pictures = [
            ("target", Some(target.picture(&target.image))),
            ("initial", Some(target.picture(&initial))),
            ("difference", target.difference(&found)),
            ("final", Some(target.picture(&found))),
        ];
        let mut files = Map::new();
        for (kind, picture) in pictures {
            let Some(picture) = picture else { continue };
            let file = format!("{VIEWS_FOLDER}/{}{pass}-{kind}.png", stems[view]);
            save_png(&picture, &out.join(&file))?;
            files.insert(kind.to_owned(), file.into());
        }
        entries.push(json!({
            "name": target.name(recovered),
            "pass": target.pass.name(),
            "held_out": target.held_out,
            "psnr": psnr,
            "ssim": ssim,
            "files": files,
        }));
    }
    Ok(Value::Array(entries))
}

/// How alike pictures and targets are: a line for the views that were matched, and one for each that was
/// held out. Nothing of scenes without views.
pub(super) fn quality_lines(recovery: &Recovery<'_>, recovered: &Scene) -> Vec<String> {
    let figures =
        |Quality { psnr, ssim }: Quality| format!("PSNR {} dB, SSIM {}", short(psnr), short(ssim));
    let (mut matched, mut held_out) = (BTreeMap::<_, Vec<_>>::new(), Vec::new());
    for (target, quality) in recovery.targets().iter().zip(recovery.qualities(recovered)) {
        let pass = match target.pass {
            Pass::Radiance => String::new(),
            pass => format!(" by {}", pass.name()),
        };
        match target.name(recovered) {
            "" => {}
            name if target.held_out => {
                held_out.push(format!("view {name}, held out{pass}: {}", figures(quality)));
            }
            _ => matched.entry(pass).or_default().push(quality),
        }
    }
    let mut lines = Vec::new();
    for (pass, matched) in matched {
        let mean =
            |of: fn(&Quality) -> f64| matched.iter().map(of).sum::<f64>() / matched.len() as f64;
        let mean =
            Quality { psnr: mean(|quality| quality.psnr), ssim: mean(|quality| quality.ssim) };
        lines.push(format!("{} matched{pass}, mean: {}", matched.len(), figures(mean)));
    }
    lines.extend(held_out);
    lines
}
