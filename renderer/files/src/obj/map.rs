//! Texture statements of a material library (`map_Kd` and the like).

use std::path::Path;

use glam::{DAffine2, DVec2};
use renderer_core::scene::Wrap;

use super::statements::number;
use crate::meshes::{Channel, TextureImage, TextureSource};

/// What a texture statement says.
#[derive(Debug)]
pub(super) struct Map {
    pub source: TextureSource,
    /// What its options `-s` and `-o` do to texture coordinates.
    pub placement: DAffine2,
    /// The options that would change the image, and are left out.
    pub left_out: Vec<&'static str>,
}

/// The options, how many words follow each at most (of three numbers the last two may be left out),
/// and the words that say nothing new.
const OPTIONS: [(&str, usize, &str); 13] = [
    ("-blendu", 1, "on"),
    ("-blendv", 1, "on"),
    ("-boost", 1, "0"),
    ("-bm", 1, "1"),
    ("-cc", 1, "off"),
    ("-clamp", 1, "off"),
    ("-imfchan", 1, "m"),
    ("-mm", 2, "0 1"),
    ("-o", 3, "0 0 0"),
    ("-s", 3, "1 1 1"),
    ("-t", 3, "0 0 0"),
    ("-texres", 1, ""),
    ("-type", 1, "sphere"),
];

impl Map {
    /// Reads what follows `keyword`: options, then the path, which may hold spaces and is relative to
    /// `folder`. `place` is the file and line.
    pub fn read(keyword: &str, rest: &str, folder: &Path, place: String) -> Result<Self, String> {
        let mut rest = rest.trim();
        let mut wrap = Wrap::Repeat;
        let (mut scale, mut offset) = (DVec2::ONE, DVec2::ZERO);
        let mut left_out = Vec::new();
        while let Some(&(option, most, neutral)) =
            OPTIONS.iter().find(|(option, ..)| rest.split_whitespace().next() == Some(option))
        {
            rest = rest[option.len()..].trim_start();
            let words;
            (words, rest) = option_words(rest, most);
            let refuse = |problem| format!("{keyword}: {option}: {problem}");
            match (option, &words[..]) {
                ("-s" | "-o" | "-t", []) => {
                    return Err(refuse("is followed by no number".to_owned()));
                }
                ("-s", words) => scale = pair(words, 1.0).map_err(refuse)?,
                ("-o", words) => offset = pair(words, 0.0).map_err(refuse)?,
                ("-clamp", ["on"]) => wrap = Wrap::Clamp,
                _ if is_same(&words, neutral) => {}
                _ => left_out.push(option),
            }
        }
        if rest.is_empty() {
            return Err(format!("{keyword} names no image"));
        }
        let channel = match &*keyword.to_ascii_lowercase() {
            "map_d" => Channel::Mask,
            "norm" | "map_kn" => Channel::Data,
            _ => Channel::Color,
        };
        // Exporters for Windows write its separators.
        let image = TextureImage::File(folder.join(rest.replace('\\', "/")));
        Ok(Self {
            source: TextureSource { image, channel, wrap, place },
            placement: DAffine2::from_scale_angle_translation(scale, 0.0, offset),
            left_out,
        })
    }
}

/// The words of an option, and what follows them.
fn option_words(mut rest: &str, most: usize) -> (Vec<&str>, &str) {
    let mut words = Vec::new();
    while words.len() < most {
        let (word, others) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
        if word.is_empty() || (most == 3 && word.parse::<f64>().is_err()) {
            break;
        }
        words.push(word);
        rest = others.trim_start();
    }
    (words, rest)
}

/// The first two numbers; `default` for what is left out.
fn pair(words: &[&str], default: f64) -> Result<DVec2, String> {
    let numbers = words.iter().map(|word| number(word)).collect::<Result<Vec<_>, _>>()?;
    let [u, v] = [0, 1].map(|i| numbers.get(i).copied().unwrap_or(default));
    Ok(DVec2::new(u, v))
}

/// Whether words begin as `neutral` does, numbers compared by value.
fn is_same(words: &[&str], neutral: &str) -> bool {
    words.iter().zip(neutral.split_whitespace()).all(|(word, neutral)| {
        match (word.parse::<f64>(), neutral.parse::<f64>()) {
            (Ok(word), Ok(neutral)) => word == neutral,
            _ => *word == neutral,
        }
    })
}
