//! Textures of numbers that are read as colours.

use std::path::Path;

use super::format::{ChannelEntry, SceneFile, TextureEntry};
use crate::Warning;
use crate::scene::Slot;

/// Warns of textures of the scene file `place` that materials take numbers from, but whose files store colours: these are
/// brought to linear light.
pub(super) fn of_levels(file: &SceneFile, place: &str) -> Vec<Warning> {
    let is_decoded = |name: &str| {
        let entry = file.textures.iter().find(|(texture, _)| texture == name);
        entry.is_some_and(|(_, entry)| stores_colors(entry))
    };
    let of_numbers = file.materials.iter().flat_map(|(material, entry)| {
        let slots = [Slot::MetallicRoughness, Slot::Normal].into_iter();
        slots.filter_map(move |slot| Some((material, slot.field(), entry.texture(slot)?)))
    });
    let warning = |(material, field, texture): (&String, &str, &str)| {
        let problem = format!(
            "is the {field}_texture of material.{material}, and its levels are read as colours; numbers are read as \
             `channel = \"data\"`"
        );
        Warning::new(format_args!("{place}: texture.{texture}"), problem)
    };
    of_numbers.filter(|(.., texture)| is_decoded(texture)).map(warning).collect()
}

/// Whether a texture is a file whose levels are those of colours for the eye: floating point numbers are linear already.
fn stores_colors(entry: &TextureEntry) -> bool {
    let is_linear = |path: &Path| {
        let extension = path.extension().and_then(|extension| extension.to_str());
        extension.is_some_and(|name| ["exr", "hdr"].iter().any(|l| name.eq_ignore_ascii_case(l)))
    };
    entry.channel == ChannelEntry::Color && entry.path.as_deref().is_some_and(|p| !is_linear(p))
}
