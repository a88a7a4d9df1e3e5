//! Material libraries (MTL).

use std::path::{Path, PathBuf};

use glam::DVec3;
use renderer_core::Error;
use renderer_core::scene::{Bsdf, Material, MaterialObject};

use super::map::Map;
use super::statements::{number, statements, words};
use crate::Warning;
use crate::disk::read_text;
use crate::meshes::{FullMaterial, ModelMaps};
use crate::warning::Warnings;

/// The materials of libraries.
#[derive(Default)]
pub(super) struct Library {
    pub materials: Vec<LibraryMaterial>,
    pub warnings: Vec<Warning>,
    /// About the first library that there is not.
    pub missing: Option<Warning>,
}

/// A material of a library.
pub(super) struct LibraryMaterial {
    pub name: String,
    pub material: MaterialObject,
    pub full: Option<FullMaterial>,
    pub maps: ModelMaps,
}

impl Library {
    /// Adds the libraries that one `mtllib` at `place` names, relative to `folder`.
    pub fn add(&mut self, names: &str, folder: &Path, place: &str) -> Result<(), Error> {
        // By the standard several names may follow; in practice one with spaces in it does.
        let whole = folder.join(names);
        let paths: Vec<PathBuf> = if whole.is_file() || names.is_empty() {
            vec![whole]
        } else {
            names.split_whitespace().map(|name| folder.join(name)).collect()
        };
        for path in paths {
            if path.is_file() {
                self.load(&path)?;
            } else {
                let problem = format_args!(
                    "the material library {} is missing; its materials are shown grey",
                    path.display()
                );
                self.missing.get_or_insert(Warning::new(place, problem));
            }
        }
        Ok(())
    }

    fn load(&mut self, path: &Path) -> Result<(), Error> {
        let text = read_text(path)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let file = path.display().to_string();
        let mut warnings = Warnings::default();
        let mut definition: Option<Definition> = None;
        for statement in statements(&text) {
            let place = format!("{file}:{}", statement.line);
            let refuse = |problem: String| Error::new(&place, problem);
            let (keyword, rest) = (statement.keyword, &*statement.rest);
            match (keyword.to_ascii_lowercase().as_str(), &mut definition) {
                ("newmtl", _) if rest.is_empty() => {
                    return Err(refuse("newmtl names no material".to_owned()));
                }
                ("newmtl", _) => {
                    let next = Definition { name: rest.to_owned(), ..Definition::default() };
                    let done = definition.replace(next);
                    self.materials.extend(done.map(|done| done.finish(&file, &mut warnings)));
                }
                (lower, Some(definition)) => definition
                    .read(lower, keyword, rest, folder, &place, &mut warnings)
                    .map_err(refuse)?,
                (lower, None) if OF_MATERIALS.contains(&lower) => {
                    return Err(refuse(format!("{keyword} stands before the first newmtl")));
                }
                (lower, None) => warnings.add(lower, &place, unknown(keyword)),
            }
        }
        self.materials.extend(definition.map(|last| last.finish(&file, &mut warnings)));
        self.warnings.append(&mut warnings.finish());
        Ok(())
    }
}

/// A material whose statements are being read.
#[derive(Default)]
struct Definition {
    name: String,
    emission: Option<DVec3>,
    diffuse: Option<DVec3>,
    specular: Option<DVec3>,
    exponent: Option<f64>,
    opacity: Option<f64>,
    /// 1 - the opacity, in files of other programs.
    transparency: Option<f64>,
    illumination: Option<u8>,
    emission_map: Option<Map>,
    diffuse_map: Option<Map>,
    specular_map: Option<Map>,
    opacity_map: Option<Map>,
    normal_map: Option<Map>,
    roughness: Option<f64>,
    metallic: Option<f64>,
    ior: Option<f64>,
    /// What glass lets through.
    filter: Option<DVec3>,
    /// What is said of `Ni` and `Tf` if nothing here has them, which later statements tell: the statement in
    /// small letters, its place, and the text.
    refraction: Vec<(&'static str, String, String)>,
    /// What is left out where light does not take all paths.
    left_out: Option<Warning>,
}

/// The statements that materials are made of.
const OF_MATERIALS: [&str; 15] = [
    "ke", "kd", "ks", "ns", "d", "tr", "illum", "map_ke", "map_kd", "map_ks", "map_d", "pr", "pm",
    "norm", "map_kn",
];

/// Statements that nothing here stands for: the number that leaves the image as it is, not a number
/// if there is none, and why there is no other one.
const LEFT_OUT: [(&str, f64, &str); 4] = [
    ("ka", 0.0, NO_AMBIENT_LIGHT),
    ("map_ka", f64::NAN, NO_AMBIENT_LIGHT),
    ("bump", f64::NAN, NO_HEIGHTS),
    ("map_bump", f64::NAN, NO_HEIGHTS),
];
const NO_HEIGHTS: &str = "it is a map of heights, or nobody knows; `norm` is one of normals";
const NO_FILTER: &str = "opacity has no colour";
const NO_REFRACTION: &str = "rays go straight on behind transparent surfaces";
const NO_AMBIENT_LIGHT: &str =
    "there is no ambient light; `emission` in a scene file is what a surface emits";

/// The roughness of a metal that does not say.
const DEFAULT_ROUGHNESS: f64 = 0.5;

/// What is said of a statement that is not known.
fn unknown(keyword: &str) -> String {
    format!("`{keyword}` is left out: nothing here stands for it")
}

impl Definition {
    /// Reads the statement `keyword`, `lower` in small letters.
    fn read(
        &mut self,
        lower: &str,
        keyword: &str,
        rest: &str,
        folder: &Path,
        place: &str,
        warnings: &mut Warnings,
    ) -> Result<(), String> {
        let mut map = || {
            let map = Map::read(keyword, rest, folder, place.to_owned())?;
            for option in &map.left_out {
                let subject = format!("{lower} {option}");
                warnings.add(&subject, place, format_args!("{option} of {keyword} is left out"));
            }
            Ok::<_, String>(Some(map))
        };
        match lower {
            "ke" => self.emission = Some(color(keyword, rest)?),
            "kd" => self.diffuse = Some(color(keyword, rest)?),
            "ks" => self.specular = Some(color(keyword, rest)?),
            "ns" => {
                let word = words(rest).next().unwrap_or("");
                self.exponent = Some(not_negative(keyword, word)?);
            }
            "d" | "tr" => {
                let word = words(rest).find(|word| *word != "-halo").unwrap_or("");
                let value = not_negative(keyword, word)?;
                if value > 1.0 {
                    return Err(format!("{keyword} must be at most 1, is {value}"));
                }
                *(if lower == "d" { &mut self.opacity } else { &mut self.transparency }) =
                    Some(value);
            }
            "pr" | "pm" => {
                let value = not_negative(keyword, words(rest).next().unwrap_or(""))?;
                if value > 1.0 {
                    return Err(format!("{keyword} must be at most 1, is {value}"));
                }
                if lower == "pm" && value > 0.0 {
                    let problem = "Pm is left out: metals are shown as matt surfaces unless light takes \
                                   all paths";
                    self.left_out.get_or_insert_with(|| Warning::new(place, problem));
                }
                *(if lower == "pr" { &mut self.roughness } else { &mut self.metallic }) =
                    Some(value);
            }
            "map_ke" => self.emission_map = map()?,
            "map_kd" => self.diffuse_map = map()?,
            "map_ks" => self.specular_map = map()?,
            "map_d" => self.opacity_map = map()?,
            "norm" | "map_kn" => self.normal_map = map()?,
            "illum" => {
                let word = words(rest).next().unwrap_or("");
                let model = word.parse().ok().filter(|model| *model <= 10);
                let model =
                    model.ok_or_else(|| format!("illum is a number from 0 to 10, not `{word}`"))?;
                let problem = match model {
                    0 => "a colour without light; it is lit as by `illum 1`",
                    4 | 6 | 7 | 9 => {
                        let problem = format_args!(
                            "illum {model} is glass that refracts; it is shown as by `illum 2` unless \
                             light takes all paths"
                        );
                        self.left_out.get_or_insert_with(|| Warning::new(place, problem));
                        ""
                    }
                    10 => "a surface for shadows alone; it is shown as by `illum 2`",
                    _ => "",
                };
                if !problem.is_empty() {
                    let subject = format!("illum {model}");
                    warnings.add(&subject, place, format_args!("{subject} is {problem}"));
                }
                self.illumination = Some(model);
            }
            "ni" => {
                let word = words(rest).next().unwrap_or("");
                // Blender writes -1 where it knows none.
                let ior = number(word).map_err(|problem| format!("{keyword}: {problem}"))?;
                self.ior = Some(ior).filter(|&ior| ior >= 1.0);
                self.may_leave_out("ni", keyword, rest, place, NO_REFRACTION);
            }
            "tf" => {
                self.filter = color(keyword, rest).ok();
                self.may_leave_out("tf", keyword, rest, place, NO_FILTER);
            }
            _ => match LEFT_OUT.iter().find(|(left_out, ..)| *left_out == lower) {
                Some((_, neutral, _)) if all_are(rest, *neutral) => {}
                Some((_, _, reason)) => {
                    warnings.add(lower, place, format_args!("{keyword} is left out: {reason}"));
                }
                None => warnings.add(lower, place, unknown(keyword)),
            },
        }
        let mut placements = self.maps().map(|map| map.placement);
        let first = placements.next();
        if placements.any(|placement| Some(placement) != first) {
            let problem = "-s and -o are those of the first of map_Kd, map_Ke, map_Ks, map_d, norm, for all of them";
            warnings.add("placements", place, problem);
        }
        if self.is_mirror() && self.specular_map.is_some() {
            let problem = "map_Ks varies the highlight alone, not the mirror";
            warnings.add("varied mirror", place, problem);
        }
        let is_transparent = self.opacity_map.is_some() || self.reduced_opacity().is_some();
        if self.is_mirror() && is_transparent {
            warnings.add("transparent mirror", place, "a mirror is shown opaque");
        }
        Ok(())
    }

    /// Remembers a statement about refraction, unless it changes nothing.
    fn may_leave_out(
        &mut self,
        lower: &'static str,
        keyword: &str,
        rest: &str,
        place: &str,
        reason: &str,
    ) {
        if !all_are(rest, 1.0) {
            let problem = format!("{keyword} is left out: {reason}");
            self.refraction.push((lower, place.to_owned(), problem));
        }
    }

    /// Whether `Ni` or `Tf` means something to this material.
    fn has(&self, statement: &str) -> bool {
        match statement {
            "ni" => self.is_glass() || self.roughness.or(self.metallic).is_some(),
            _ => self.is_glass() && self.filter.is_some(),
        }
    }

    fn is_glass(&self) -> bool {
        matches!(self.illumination, Some(4 | 6 | 7 | 9))
    }

    /// The material where light takes all paths, by its numbers without facets.
    fn full(&self, values: Material<f64>) -> Option<MaterialObject> {
        let ior = self.ior.unwrap_or(values.ior);
        if self.is_glass() {
            let clear = MaterialObject::dielectric(ior);
            let diffuse = self.filter.unwrap_or(clear.values.diffuse);
            let values = Material { diffuse, emission: values.emission, ..clear.values };
            return Some(MaterialObject { values, ..clear });
        }
        self.roughness.or(self.metallic)?;
        let metallic = self.metallic.unwrap_or(0.0);
        let roughness = self.roughness.unwrap_or(DEFAULT_ROUGHNESS);
        let values = Material { metallic, roughness, ior, mirror: DVec3::ZERO, ..values };
        let full = MaterialObject { bsdf: Bsdf::MetallicRoughness, ..values.into() };
        Some(match self.reduced_opacity() {
            Some(opacity) => full.with_opacity(opacity),
            None => full,
        })
    }

    /// The opacity, unless it is 1. Programs that write `Tr` and `d` mean different things by `Tr`.
    fn reduced_opacity(&self) -> Option<f64> {
        let opacity = self.opacity.or(self.transparency.map(|transparency| 1.0 - transparency));
        opacity.filter(|&opacity| opacity < 1.0)
    }

    fn maps(&self) -> impl Iterator<Item = &Map> {
        let colors = [&self.diffuse_map, &self.emission_map, &self.specular_map];
        colors.into_iter().chain([&self.opacity_map, &self.normal_map]).flatten()
    }

    fn is_mirror(&self) -> bool {
        matches!(self.illumination, Some(3 | 5 | 8))
    }

    fn finish(mut self, file: &str, warnings: &mut Warnings) -> LibraryMaterial {
        let has_highlight = !matches!(self.illumination, Some(0 | 1));
        if !has_highlight {
            self.specular = Some(DVec3::ZERO);
            self.specular_map = None;
        }
        if self.is_mirror() {
            (self.opacity, self.transparency, self.opacity_map) = (None, None, None);
            if self.normal_map.take().is_some() {
                let problem = format!("norm of {} is left out: a mirror has none", self.name);
                warnings.add("normals of a mirror", file, problem);
            }
        }
        if self.reduced_opacity() == Some(0.0) {
            let problem = format!(
                "the opacity of {} is 0, so it is invisible; some programs write `Tr 1` for opaque",
                self.name
            );
            warnings.add("invisible material", file, problem);
        }
        for (statement, place, problem) in std::mem::take(&mut self.refraction) {
            if !self.has(statement) {
                warnings.add(statement, &place, problem);
            }
        }
        let default = Material::default();
        // What a texture varies is white where nothing else is said.
        let color = |given: Option<DVec3>, map: &Option<Map>, default: DVec3| {
            given.unwrap_or(if map.is_some() { DVec3::ONE } else { default })
        };
        let specular = color(self.specular, &self.specular_map, default.specular);
        let mut material = MaterialObject::from(Material {
            emission: color(self.emission, &self.emission_map, default.emission),
            diffuse: color(self.diffuse, &self.diffuse_map, default.diffuse),
            specular,
            exponent: self.exponent.unwrap_or(default.exponent),
            mirror: if self.is_mirror() { specular } else { default.mirror },
            ..default
        });
        let full = self.full(material.values);
        let left_out = self.left_out.take();
        let full = full.map(|material| FullMaterial { material, left_out });
        if let Some(opacity) = self.reduced_opacity() {
            material = material.with_opacity(opacity);
        }
        let placement = self.maps().next().map(|map| map.placement).unwrap_or_default();
        let source = |map: Option<Map>| map.map(|map| map.source);
        let [emission, diffuse, specular] =
            [self.emission_map, self.diffuse_map, self.specular_map].map(source);
        let [opacity, normal] = [self.opacity_map, self.normal_map].map(source);
        let sources = [emission, diffuse, specular, opacity, None, normal];
        LibraryMaterial { name: self.name, material, full, maps: ModelMaps { sources, placement } }
    }
}

fn color(keyword: &str, rest: &str) -> Result<DVec3, String> {
    let values: Result<Vec<f64>, String> =
        words(rest).map(|word| not_negative(keyword, word)).collect();
    match values?[..] {
        [grey] => Ok(DVec3::splat(grey)),
        [r, g, b] => Ok(DVec3::new(r, g, b)),
        _ => Err(format!("{keyword} is a colour of 3 numbers")),
    }
}

fn not_negative(keyword: &str, word: &str) -> Result<f64, String> {
    match number(word).map_err(|problem| format!("{keyword}: {problem}"))? {
        value if value < 0.0 => Err(format!("{keyword} must not be negative, is {value}")),
        value => Ok(value),
    }
}

/// Whether all words are one number.
fn all_are(rest: &str, value: f64) -> bool {
    words(rest).all(|word| word.parse() == Ok(value))
}
