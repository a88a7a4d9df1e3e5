//! Text that takes no more memory than what is still to be read of it.

use std::io::{self, BufRead, Read};
use std::mem;
use std::vec;

/// How long a piece of text is, about.
const LENGTH: usize = 1 << 16;

/// Text in pieces.
#[derive(Default)]
pub(super) struct Chunks {
    full: Vec<String>,
    last: String,
}

impl Chunks {
    /// The text to append a line to.
    pub fn line(&mut self) -> &mut String {
        if self.last.len() >= LENGTH {
            // Room for one more line, mostly.
            let next = String::with_capacity(LENGTH + 256);
            self.full.push(mem::replace(&mut self.last, next));
        }
        &mut self.last
    }

    /// Reads the text, and gives up what has been read.
    pub fn drain(mut self) -> Drain {
        self.full.push(self.last);
        Drain { rest: self.full.into_iter(), current: String::new(), read: 0 }
    }
}

/// See [`Chunks::drain`].
pub(super) struct Drain {
    rest: vec::IntoIter<String>,
    current: String,
    /// How many bytes of it have been.
    read: usize,
}

impl BufRead for Drain {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        while self.read == self.current.len() {
            let Some(next) = self.rest.next() else { break };
            (self.current, self.read) = (next, 0);
        }
        Ok(&self.current.as_bytes()[self.read..])
    }

    fn consume(&mut self, count: usize) {
        self.read += count;
    }
}

impl Read for Drain {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_read_as_they_were_appended() {
        let line = |i: usize| format!("{i} {}\n", "x".repeat(i % 700));
        let mut chunks = Chunks::default();
        (0..1000).for_each(|i| chunks.line().push_str(&line(i)));
        assert!(chunks.full.len() > 3);
        let mut whole = String::new();
        chunks.drain().read_to_string(&mut whole).unwrap();
        assert_eq!(whole, (0..1000).map(line).collect::<String>());
        assert_eq!(Chunks::default().drain().lines().count(), 0);
    }
}
