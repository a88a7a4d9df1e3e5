//! The data of a PLY file: numbers, one after the other, as text or as bytes.

#[derive(Clone, Copy)]
pub(super) enum Format {
    Ascii,
    LittleEndian,
    BigEndian,
}

impl Format {
    pub fn named(name: &str) -> Result<Self, String> {
        match name {
            "ascii" => Ok(Self::Ascii),
            "binary_little_endian" => Ok(Self::LittleEndian),
            "binary_big_endian" => Ok(Self::BigEndian),
            _ => Err(format!(
                "no format `{name}`; there is ascii, binary_little_endian, binary_big_endian"
            )),
        }
    }
}

/// The type of a number.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    /// The type of a name: the original one (`uchar`), or that of its width (`uint8`).
    pub fn named(name: &str) -> Result<Self, String> {
        match name {
            "char" | "int8" => Ok(Self::I8),
            "uchar" | "uint8" => Ok(Self::U8),
            "short" | "int16" => Ok(Self::I16),
            "ushort" | "uint16" => Ok(Self::U16),
            "int" | "int32" => Ok(Self::I32),
            "uint" | "uint32" => Ok(Self::U32),
            "float" | "float32" => Ok(Self::F32),
            "double" | "float64" => Ok(Self::F64),
            _ => Err(format!("no type `{name}`")),
        }
    }

    pub fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

#[derive(Clone, Copy)]
pub(super) enum Kind {
    Scalar(Scalar),
    List { count: Scalar, item: Scalar },
}

/// The numbers that have not been read yet.
pub(super) struct Source<'a> {
    rest: &'a [u8],
    format: Format,
    /// Of ASCII data, the line of the latest number, counted from 1.
    line: usize,
}

impl<'a> Source<'a> {
    /// `lines` are before `rest`.
    pub fn new(rest: &'a [u8], format: Format, lines: usize) -> Self {
        Self { rest, format, line: lines + 1 }
    }

    /// Where the latest number stands in `file`.
    pub fn place(&self, file: &str) -> String {
        match self.format {
            Format::Ascii => format!("{file}:{}", self.line),
            Format::LittleEndian | Format::BigEndian => file.to_owned(),
        }
    }

    /// The numbers of a property: those of a list, or one.
    pub fn list(&mut self, kind: Kind) -> Result<Vec<f64>, String> {
        let (count, item) = match kind {
            Kind::Scalar(scalar) => return Ok(vec![self.number(scalar)?]),
            Kind::List { count, item } => (self.number(count)?, item),
        };
        if count < 0.0 {
            return Err(format!("a list has {count} items"));
        }
        // As many as there are; the count may be a lie.
        (0..count as u64).map(|_| self.number(item)).collect()
    }

    /// The next number.
    pub fn number(&mut self, scalar: Scalar) -> Result<f64, String> {
        if let Format::Ascii = self.format {
            return self.word(scalar);
        }
        Ok(match scalar {
            Scalar::I8 => f64::from(i8::from_le_bytes(self.bytes()?)),
            Scalar::U8 => f64::from(u8::from_le_bytes(self.bytes()?)),
            Scalar::I16 => f64::from(i16::from_le_bytes(self.bytes()?)),
            Scalar::U16 => f64::from(u16::from_le_bytes(self.bytes()?)),
            Scalar::I32 => f64::from(i32::from_le_bytes(self.bytes()?)),
            Scalar::U32 => f64::from(u32::from_le_bytes(self.bytes()?)),
            Scalar::F32 => f64::from(f32::from_le_bytes(self.bytes()?)),
            Scalar::F64 => f64::from_le_bytes(self.bytes()?),
        })
    }

    /// The next `N` bytes, the lowest first.
    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], String> {
        let (bytes, rest) =
            self.rest.split_first_chunk().ok_or("the file ends before its data does")?;
        self.rest = rest;
        let mut bytes = *bytes;
        if let Format::BigEndian = self.format {
            bytes.reverse();
        }
        Ok(bytes)
    }

    /// The next word of ASCII data as a number.
    fn word(&mut self, scalar: Scalar) -> Result<f64, String> {
        while let Some((byte, rest)) = self.rest.split_first()
            && byte.is_ascii_whitespace()
        {
            self.line += usize::from(*byte == b'\n');
            self.rest = rest;
        }
        let end = self.rest.iter().position(u8::is_ascii_whitespace).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        if word.is_empty() {
            return Err("the file ends before its data does".to_owned());
        }
        self.rest = rest;
        let word = String::from_utf8_lossy(word);
        let number: f64 = word.parse().map_err(|_| format!("`{word}` is not a number"))?;
        if scalar.is_integer() && number.fract() != 0.0 {
            return Err(format!("`{word}` is not an integer"));
        }
        Ok(number)
    }
}
