//! OpenEXR images of more than colours: passes side by side, and channels of depth and normals.

use std::fmt::Display;
use std::io::Cursor;
use std::path::Path;

use exr::prelude::{AnyChannel, AnyChannels, FlatSamples, MetaData, SmallVec, WritableImage};
use exr::prelude::{ReadChannels, ReadLayers};
use renderer_core::settings::Pass;
use renderer_core::{Error, Image, memory};

use super::{check, load_mask, not_encoded, one_line};
use crate::disk::{read, write_atomically};

/// What no surface is as far away as: where nothing is, some programs write this, others infinity.
const NOWHERE: f32 = 1e10;

/// Normals of half precision may be a little longer than 1. Those of pixels that several edges share were seen up to 1.22
/// long in images of the renderer: each edge adds the difference between its sides.
const LONGEST: f32 = 1.5;

/// More samples no byte of a file stands for; see `decode`.
const MOST_SAMPLES_PER_BYTE: u64 = 10_000;

/// The channels of a pass among others, by the channel of its image.
fn channels(pass: Pass) -> &'static [&'static str] {
    match pass {
        Pass::Radiance => &["R", "G", "B"],
        Pass::Albedo => &["albedo.R", "albedo.G", "albedo.B"],
        Pass::Coverage => &["coverage.A"],
        Pass::Depth => &["depth.Z"],
        Pass::Position => &["position.X", "position.Y", "position.Z"],
        Pass::Normals => &["normals.X", "normals.Y", "normals.Z"],
        Pass::Uv => &["uv.U", "uv.V"],
        Pass::Ids => &["ids.object", "ids.primitive", "ids.material"],
    }
}

/// Writes passes of one size as the channels of an OpenEXR image of 32 bit floats, exactly as they are:
/// radiance as `R`, `G` and `B`, and every other as a layer by its name, such as `depth.Z`.
///
/// # Errors
///
/// If an image has no area, a pixel is infinite or not a number, or the file cannot be written.
///
/// # Panics
///
/// If there is no pass, or sizes differ.
pub fn save_passes(passes: &[(Pass, Image)], path: &Path) -> Result<(), Error> {
    let mut list = SmallVec::new();
    for (pass, image) in passes {
        check(image, path.display())?;
        for (channel, name) in channels(*pass).iter().enumerate() {
            let samples = image.pixels.iter().map(|pixel| pixel[channel]).collect();
            list.push(AnyChannel::new(*name, FlatSamples::F32(samples)));
        }
    }
    let (width, height) = (passes[0].1.width as usize, passes[0].1.height as usize);
    let image = exr::prelude::Image::from_channels((width, height), AnyChannels::sort(list));
    let mut bytes = Cursor::new(Vec::new());
    image.write().to_buffered(&mut bytes).map_err(|error| not_encoded(path.display(), error))?;
    write_atomically(path, &bytes.into_inner())
}

/// Reads depth or normals from an OpenEXR image: from the layer that is named after them, else from a
/// channel `Z`, `V` or `Y`, or from `X`, `Y` and `Z`, else from `R`, `G` and `B`. Depth that is
/// infinite, or 1e10 and beyond, is that of nothing: 0. Coverage is the layer `coverage`, where there is one, and
/// else what [`load_mask`] reads.
///
/// # Errors
///
/// If the file cannot be read, is no OpenEXR image, has no such channels, a number is infinite or none, or the
/// numbers cannot be what is asked for: depths below 0, or of several colours, or normals longer than 1.
pub fn load_pass(path: &Path, pass: Pass) -> Result<Image, Error> {
    let bytes = read(path)?;
    if pass == Pass::Coverage && !has_layer(&bytes, "coverage") {
        return load_mask(path);
    }
    decode_pass(&bytes, path.display(), pass)
}

/// Whether the bytes are those of an OpenEXR image with channels `LAYER.*`.
fn has_layer(bytes: &[u8], layer: &str) -> bool {
    let Ok(found) = MetaData::read_from_buffered(Cursor::new(bytes), false) else { return false };
    let mut channels = found.headers.iter().flat_map(|header| &header.channels.list);
    channels.any(|channel| {
        let name = channel.name.to_string();
        name.rsplit_once('.').is_some_and(|(prefix, _)| prefix == layer)
    })
}

fn decode_pass(bytes: &[u8], place: impl Display, pass: Pass) -> Result<Image, Error> {
    let problem = |problem: String| Error::new(&place, problem);
    let not_decoded =
        |error| problem(format!("is no OpenEXR image of {}: {}", pass.name(), one_line(error)));
    let headers = MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(not_decoded)?;
    let samples = headers.headers.iter().map(|header| {
        let pixels = header.layer_size.area() as u64;
        pixels.saturating_mul(header.channels.list.len() as u64)
    });
    let samples = samples.fold(0, u64::saturating_add);
    if samples > MOST_SAMPLES_PER_BYTE * bytes.len() as u64 {
        return Err(problem(format!(
            "{} bytes cannot hold the {samples} samples it has",
            bytes.len()
        )));
    }
    memory::ask(samples.saturating_mul(size_of::<f32>() as u64))
        .map_err(|refused| problem(format!("{samples} samples: {refused}")))?;
    let file = exr::prelude::read().no_deep_data().largest_resolution_level().all_channels();
    let file = file.all_layers().all_attributes().from_buffered(Cursor::new(bytes));
    let file = file.map_err(not_decoded)?;

    let mut found = Vec::new();
    for layer in &file.layer_data {
        let prefix = layer.attributes.layer_name.as_ref().map(|name| format!("{name}."));
        for channel in &layer.channel_data.list {
            let name = format!("{}{}", prefix.as_deref().unwrap_or(""), channel.name);
            found.push((name.to_lowercase(), layer.size, &channel.sample_data));
        }
    }
    let is = |full: &str, layer: &str, channel: &str| match full.rsplit_once('.') {
        Some((prefix, own)) => own == channel && !layer.is_empty() && prefix.contains(layer),
        None => full == channel && layer.is_empty(),
    };
    let named = |layer: &str, names: &[&str]| -> Option<Vec<_>> {
        names.iter().map(|name| found.iter().find(|(full, ..)| is(full, layer, name))).collect()
    };
    let sets: &[&[&str]] = match pass {
        Pass::Depth => &[&["z"], &["v"], &["y"], &["r", "g", "b"], &["r"]],
        Pass::Coverage => &[&["a"]],
        _ => &[&["x", "y", "z"], &["r", "g", "b"]],
    };
    // Layers are called "depth", "Depth", "normals", "ViewLayer.Normal".
    let layer = pass.name().trim_end_matches('s');
    let mut choices =
        [layer, ""].into_iter().flat_map(|layer| sets.iter().map(move |set| (layer, set)));
    let chosen = choices.find_map(|(layer, set)| named(layer, set));
    let Some(chosen) = chosen else {
        let names: Vec<&str> = found.iter().map(|(name, ..)| &name[..]).collect();
        let names = names.join(", ");
        return Err(problem(format!("has no channels of {}, but {names}", pass.name())));
    };
    let size = chosen[0].1;
    if chosen.iter().any(|(_, other, _)| *other != size) {
        return Err(problem(format!("the channels of {} differ in size", pass.name())));
    }
    let value = |channel: usize, index: usize| {
        let (.., samples) = chosen[channel % chosen.len()];
        let value = samples.value_by_flat_index(index).to_f32();
        if pass == Pass::Depth && value >= NOWHERE { 0.0 } else { value }
    };
    let pixels = (0..size.area()).map(|index| [0, 1, 2].map(|channel| value(channel, index)));
    let (width, height) = (size.width() as u32, size.height() as u32);
    let image = Image { width, height, pixels: pixels.collect() };
    check(&image, &place)?;
    let is_possible = |pixel: &[f32; 3]| match pass {
        Pass::Depth => pixel[0] >= 0.0 && pixel[1..] == [pixel[0]; 2],
        Pass::Normals => pixel.iter().map(|n| n * n).sum::<f32>() <= LONGEST * LONGEST,
        _ => true,
    };
    match image.pixels.iter().find(|pixel| !is_possible(pixel)) {
        None => Ok(image),
        Some(pixel) => {
            Err(Error::new(place, format!("holds {pixel:?}, which is no value of {}", pass.name())))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(channels: &[(&str, f32)]) -> Vec<u8> {
        let channel = |&(name, value): &(&str, f32)| {
            AnyChannel::new(name, FlatSamples::F32(vec![value, 0.5 * value]))
        };
        let list = AnyChannels::sort(channels.iter().map(channel).collect());
        let mut bytes = Cursor::new(Vec::new());
        let image = exr::prelude::Image::from_channels((2, 1), list);
        image.write().to_buffered(&mut bytes).unwrap();
        bytes.into_inner()
    }

    #[test]
    fn passes_are_read_back() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("passes.exr");
        let image = |first: f32| Image {
            width: 2,
            height: 3,
            pixels: (0..6).map(|i| [first - 0.1 * i as f32, -0.1, first]).collect(),
        };
        let gray = |first: f32| {
            let pixels = (0..6).map(|i| [first + i as f32; 3]).collect();
            Image { width: 2, height: 3, pixels }
        };
        let passes = [
            (Pass::Radiance, image(1.0)),
            (Pass::Position, image(2.0)),
            (Pass::Normals, image(0.3)),
            (Pass::Depth, gray(4.0)),
        ];
        save_passes(&passes, &path).unwrap();
        assert_eq!(crate::load_image(&path).unwrap().image, passes[0].1);
        assert_eq!(load_pass(&path, Pass::Normals).unwrap(), passes[2].1);
        assert_eq!(load_pass(&path, Pass::Depth).unwrap(), passes[3].1);
    }

    #[test]
    fn channels_go_by_the_names_that_programs_give_them() {
        let first = |channels: &[(&str, f32)], pass: Pass| {
            decode_pass(&file(channels), "a.exr", pass).map(|image| image.pixels[0])
        };
        let blender = [
            ("ViewLayer.Depth.V", 3.0),
            ("ViewLayer.Normal.X", 0.1),
            ("ViewLayer.Normal.Y", 0.2),
            ("ViewLayer.Normal.Z", 0.3),
            ("ViewLayer.Position.Z", 9.0),
        ];
        assert_eq!(first(&blender, Pass::Depth).unwrap(), [3.0; 3]);
        assert_eq!(first(&blender, Pass::Normals).unwrap(), [0.1, 0.2, 0.3]);
        assert_eq!(first(&[("Z", 2.0), ("R", 7.0)], Pass::Depth).unwrap(), [2.0; 3]);
        assert_eq!(first(&[("Y", 2.5)], Pass::Depth).unwrap(), [2.5; 3]);
        let colors = [("R", 1.0), ("G", 2.0), ("B", 3.0)];
        let grey = colors.map(|(name, _)| (name, 1.0));
        assert_eq!(first(&grey, Pass::Depth).unwrap(), [1.0; 3]);
        let short = colors.map(|(name, value)| (name, 0.1 * value - 0.5));
        assert_eq!(first(&short, Pass::Normals).unwrap(), short.map(|(_, value)| value));
        // Where several edges share a pixel.
        let edged = colors.map(|(name, _)| (name, 0.7));
        assert_eq!(first(&edged, Pass::Normals).unwrap(), [0.7; 3]);
        assert_eq!(first(&[("Z", 1e10)], Pass::Depth).unwrap(), [0.0; 3]);
        assert_eq!(first(&[("Z", f32::INFINITY)], Pass::Depth).unwrap(), [0.0; 3]);
        let refused =
            |channels: &[(&str, f32)], pass| first(channels, pass).unwrap_err().to_string();
        assert_eq!(
            refused(&[("position.Z", 1.0)], Pass::Depth),
            "a.exr: has no channels of depth, but position.z"
        );
        assert!(refused(&[("Z", f32::NAN)], Pass::Depth).contains("not a finite number"));
        for (channels, pass) in
            [(&colors[..], Pass::Depth), (&colors, Pass::Normals), (&[("Z", -1.5)], Pass::Depth)]
        {
            assert!(refused(channels, pass).contains("which is no value of"));
        }
    }

    #[test]
    fn broken_files_are_refused() {
        let bytes = file(&[("Z", 1.0)]);
        for end in 0..bytes.len() {
            assert!(decode_pass(&bytes[..end], "a.exr", Pass::Depth).is_err(), "{end}");
        }
        for index in 0..bytes.len() {
            let mut broken = bytes.clone();
            broken[index] ^= 0x5a;
            // Many are images of something else; none panics.
            let _ = decode_pass(&broken, "a.exr", Pass::Depth);
        }
    }
}
