//! How a camera was held: the orientation of an Exif block.

/// Where the first row and the first column of the stored pixels are seen, as the tag `Orientation`
/// (0x0112) of Exif numbers it, less one: 0 for the top and the left.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Orientation(u8);

impl Orientation {
    /// The orientation that an Exif block holds; upright, if it says nothing that can be read.
    pub fn of(exif: Option<&[u8]>) -> Self {
        exif.and_then(tag)
            .and_then(|value| value.checked_sub(1))
            .filter(|&v| v < 8)
            .map_or_else(Self::default, |value| Self(value as u8))
    }

    /// The size of the picture that is seen.
    pub fn turned(self, width: u32, height: u32) -> (u32, u32) {
        if self.0 < 4 { (width, height) } else { (height, width) }
    }

    /// Where a stored pixel is seen.
    pub fn place(self, column: u32, row: u32, width: u32, height: u32) -> (u32, u32) {
        let (right, bottom) = (width - 1 - column, height - 1 - row);
        match self.0 {
            1 => (right, row),
            2 => (right, bottom),
            3 => (column, bottom),
            4 => (row, column),
            5 => (bottom, column),
            6 => (bottom, right),
            7 => (row, right),
            _ => (column, row),
        }
    }
}

/// The value of the tag `Orientation` in the first directory of a TIFF structure, which Exif is.
fn tag(exif: &[u8]) -> Option<u16> {
    let little = match exif.get(..2)? {
        b"II" => true,
        b"MM" => false,
        _ => return None,
    };
    let short = |at: usize| {
        let bytes = *exif.get(at..)?.first_chunk()?;
        Some(if little { u16::from_le_bytes(bytes) } else { u16::from_be_bytes(bytes) })
    };
    let long = |at: usize| {
        let bytes = *exif.get(at..)?.first_chunk()?;
        Some(if little { u32::from_le_bytes(bytes) } else { u32::from_be_bytes(bytes) })
    };
    let directory = long(4)? as usize;
    // After the number of entries come entries of 12 bytes: tag, type, count, value.
    (0..usize::from(short(directory)?))
        .map(|index| directory + 2 + 12 * index)
        .find(|&entry| short(entry) == Some(0x0112))
        .and_then(|entry| short(entry + 8))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tag_is_found_in_either_byte_order() {
        let little = b"II\x2a\0\x08\0\0\0\x02\0\x0f\x01\x03\0\x01\0\0\0\x09\0\0\0\
            \x12\x01\x03\0\x01\0\0\0\x06\0\0\0";
        let big = b"MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x08\0\0";
        assert_eq!(Orientation::of(Some(little)), Orientation(5));
        assert_eq!(Orientation::of(Some(big)), Orientation(7));
        for length in 0..little.len() - 4 {
            assert_eq!(Orientation::of(Some(&little[..length])), Orientation(0), "{length}");
        }
        assert_eq!(Orientation::of(Some(b"II\x2a\0\xff\xff\xff\xff")), Orientation(0));
        assert_eq!(Orientation::of(None), Orientation(0));
    }

    /// Every pixel is seen somewhere, and turning keeps the first pixel where the tag says.
    #[test]
    fn pixels_are_permuted() {
        let first = [(0, 0), (2, 0), (2, 1), (0, 1), (0, 0), (1, 0), (1, 2), (0, 2)];
        for (value, expected) in first.into_iter().enumerate() {
            let orientation = Orientation(value as u8);
            let (width, height) = orientation.turned(3, 2);
            let mut seen: Vec<(u32, u32)> =
                (0..6).map(|index| orientation.place(index % 3, index / 3, 3, 2)).collect();
            assert_eq!(seen[0], expected, "{value}");
            seen.sort_unstable();
            seen.dedup();
            assert_eq!(seen.len(), 6);
            assert!(seen.iter().all(|&(x, y)| x < width && y < height), "{value}: {seen:?}");
        }
    }
}
