//! The bytes that a document refers to.

use std::path::Path;

use renderer_core::Error;

use super::document::{BufferView, Document, get};
use crate::disk::read;

pub(super) const MAGIC: &[u8] = b"glTF";
pub(super) const JSON_CHUNK: u32 = 0x4E4F_534A;
pub(super) const BINARY_CHUNK: u32 = 0x004E_4942;

/// The document of a file, and the bytes that a `.glb` brings along.
pub(super) fn split(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), String> {
    let Some(rest) = bytes.strip_prefix(MAGIC) else { return Ok((bytes, None)) };
    let cut_short = || "is cut short".to_owned();
    let (version, rest) = take_u32(rest).ok_or_else(cut_short)?;
    if version != 2 {
        return Err(format!("is binary glTF of version {version}; version 2 is read"));
    }
    let (length, _) = take_u32(rest).ok_or_else(cut_short)?;
    let chunks = bytes
        .get(12..length as usize)
        .ok_or_else(|| format!("says that it has {length} bytes; it has {}", bytes.len()))?;
    let (json, rest) = take_chunk(chunks, JSON_CHUNK).ok_or("has no chunk of JSON")?;
    Ok((json, take_chunk(rest, BINARY_CHUNK).map(|(binary, _)| binary)))
}

fn take_u32(bytes: &[u8]) -> Option<(u32, &[u8])> {
    let (first, rest) = bytes.split_first_chunk()?;
    Some((u32::from_le_bytes(*first), rest))
}

/// The content of a chunk of the given kind, and what follows it.
fn take_chunk(bytes: &[u8], wanted: u32) -> Option<(&[u8], &[u8])> {
    let (length, rest) = take_u32(bytes)?;
    let (kind, rest) = take_u32(rest)?;
    (kind == wanted).then(|| rest.split_at_checked(length as usize)).flatten()
}

/// The content of every buffer.
pub(super) struct Buffers(Vec<Vec<u8>>);

impl Buffers {
    pub fn load(
        document: &Document,
        binary: Option<&[u8]>,
        folder: &Path,
        place: &str,
    ) -> Result<Self, Error> {
        let mut buffers = Vec::new();
        for (i, buffer) in document.buffers.iter().enumerate() {
            let refuse = |problem: &str| Error::new(format!("{place}: buffers[{i}]"), problem);
            let content = match buffer.uri.as_deref() {
                None if i == 0 => binary.ok_or_else(|| refuse("has no uri"))?.to_vec(),
                None => return Err(refuse("has no uri")),
                Some(uri) => match embedded(uri) {
                    Some(data) => data.map_err(|problem| refuse(&problem))?,
                    None => read(&folder.join(percent_decoded(uri)))?,
                },
            };
            if content.len() < buffer.byte_length {
                let (there, said) = (content.len(), buffer.byte_length);
                return Err(refuse(&format!("says that it has {said} bytes; it has {there}")));
            }
            buffers.push(content);
        }
        Ok(Self(buffers))
    }

    /// The bytes of a view.
    pub fn view(&self, view: &BufferView) -> Result<&[u8], String> {
        let buffer = get(&self.0, view.buffer, "buffers")?;
        let end = view.byte_offset.checked_add(view.byte_length);
        end.and_then(|end| buffer.get(view.byte_offset..end)).ok_or_else(|| {
            format!(
                "{} bytes from byte {} on are not within its buffer of {}",
                view.byte_length,
                view.byte_offset,
                buffer.len()
            )
        })
    }
}

/// The bytes that a URI holds; nothing if it names a file instead.
pub(super) fn embedded(uri: &str) -> Option<Result<Vec<u8>, String>> {
    let data = uri.strip_prefix("data:")?.split_once(";base64,");
    let bytes = data.and_then(|(_, data)| base64(data));
    Some(bytes.ok_or_else(|| "its data is not base64".to_owned()))
}

/// Decodes base64 (RFC 4648), with or without padding.
fn base64(text: &str) -> Option<Vec<u8>> {
    let digits = text.trim_end_matches('=').as_bytes();
    let mut bytes = Vec::with_capacity(digits.len() / 4 * 3 + 2);
    for group in digits.chunks(4) {
        let mut bits = 0;
        for digit in group {
            let value = match digit {
                b'A'..=b'Z' => digit - b'A',
                b'a'..=b'z' => digit - b'a' + 26,
                b'0'..=b'9' => digit - b'0' + 52,
                b'+' => 62,
                b'/' => 63,
                _ => return None,
            };
            bits = bits << 6 | u32::from(value);
        }
        // Four digits are three bytes, three two, two one; one is nothing.
        let count = group.len().checked_sub(1).filter(|&count| count > 0)?;
        bits <<= 6 * (4 - group.len());
        bytes.extend_from_slice(&bits.to_be_bytes()[1..=count]);
    }
    Some(bytes)
}

/// A relative path, its `%20` and the like decoded.
pub(super) fn percent_decoded(uri: &str) -> String {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let Some((&byte, after)) = rest.split_first() {
        let code = match after {
            [high, low, ..] if byte == b'%' => {
                let digit = |byte: u8| char::from(byte).to_digit(16);
                digit(*high).zip(digit(*low)).map(|(high, low)| (16 * high + low) as u8)
            }
            _ => None,
        };
        bytes.push(code.unwrap_or(byte));
        rest = if code.is_some() { &after[2..] } else { after };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_that_of_the_standard() {
        // The test vectors of RFC 4648.
        for (text, bytes) in [
            ("", ""),
            ("Zg==", "f"),
            ("Zm8=", "fo"),
            ("Zm9v", "foo"),
            ("Zm9vYg==", "foob"),
            ("Zm9vYmE=", "fooba"),
            ("Zm9vYmFy", "foobar"),
            ("Zm9vYmE", "fooba"),
        ] {
            assert_eq!(base64(text).as_deref(), Some(bytes.as_bytes()), "{text}");
        }
        assert_eq!(base64("+/+/"), Some(vec![0xfb, 0xff, 0xbf]));
        for broken in ["Z", "Zm9vY", "Zm9v!A==", "Zm 9", "é"] {
            assert_eq!(base64(broken), None, "{broken}");
        }
    }

    #[test]
    fn paths_are_decoded() {
        assert_eq!(percent_decoded("a%20b%C3%A9.bin"), "a bé.bin");
        assert_eq!(percent_decoded("100%.bin%2"), "100%.bin%2");
    }
}
