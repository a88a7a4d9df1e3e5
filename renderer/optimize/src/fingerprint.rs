//! A hash that tells problems apart.

use std::fmt;

/// A 64-bit FNV-1a hash, the same for the same input on every machine and with every compiler,
/// which the hasher of the standard library does not promise. It guards against mistakes, not
/// against malice. Displays as 16 hexadecimal digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fingerprint(u64);

impl Default for Fingerprint {
    fn default() -> Self {
        Self::new()
    }
}

impl Fingerprint {
    /// The fingerprint of nothing yet.
    pub fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Adds bytes, and their number, so that `ab`, `c` and `a`, `bc` differ.
    pub fn bytes(self, bytes: &[u8]) -> Self {
        self.length(bytes.len()).raw(bytes)
    }

    /// Adds a text.
    pub fn text(self, text: &str) -> Self {
        self.bytes(text.as_bytes())
    }

    /// Adds numbers, by their bits.
    pub fn numbers(self, numbers: &[f64]) -> Self {
        let start = self.length(numbers.len());
        numbers.iter().fold(start, |hash, number| hash.raw(&number.to_bits().to_le_bytes()))
    }

    fn length(self, length: usize) -> Self {
        self.raw(&(length as u64).to_le_bytes())
    }

    fn raw(self, bytes: &[u8]) -> Self {
        Self(bytes.iter().fold(self.0, |hash, &byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
        }))
    }
}

impl fmt::Display for Fingerprint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_fnv_1a() {
        // From the reference test vectors of FNV-1a.
        assert_eq!(Fingerprint::new().raw(b"foobar").to_string(), "85944171f73967e8");
        assert_eq!(Fingerprint::new().raw(b"").to_string(), "cbf29ce484222325");
    }

    #[test]
    fn tells_boundaries_and_signs_apart() {
        let new = Fingerprint::new;
        assert_ne!(new().text("ab").text("c"), new().text("a").text("bc"));
        assert_ne!(new().numbers(&[0.0]), new().numbers(&[-0.0]));
        assert_ne!(new().numbers(&[]).numbers(&[1.0]), new().numbers(&[1.0]).numbers(&[]));
    }
}
