//! The growing list of operations of a thread.

use core::cell::{Cell, OnceCell};

/// An operation: the cotangent of its result, times `partials[i]`, goes to `operands[i]`.
#[derive(Clone, Copy)]
pub struct Node {
    pub partials: [f64; 2],
    pub operands: [u32; 2],
}

/// What constants share, at index 0: nothing ever asks for its cotangent.
const CONSTANT: Node = Node { partials: [0.0; 2], operands: [0; 2] };

/// The length of the first chunk, and of each further one relative to the one before.
const FIRST: u64 = 1 << 12;
const CHUNKS: usize = 21;

/// A list that grows by chunks, each as long as all before it together and none ever moved: so a
/// node is written through a shared reference, without asking whether someone reads.
pub struct List {
    len: Cell<u64>,
    chunks: [OnceCell<Box<[Cell<Node>]>>; CHUNKS],
}

impl List {
    /// A list with the node that constants share.
    pub const fn new() -> Self {
        Self { len: Cell::new(1), chunks: [const { OnceCell::new() }; CHUNKS] }
    }

    /// The number of nodes.
    #[inline(always)]
    pub fn len(&self) -> u64 {
        self.len.get()
    }

    /// Appends a node, and returns its index.
    #[inline(always)]
    pub fn push(&self, node: Node) -> u32 {
        let index = self.len.get();
        let (chunk, offset) = position(index);
        let Some(nodes) = self.chunks.get(chunk).and_then(OnceCell::get) else {
            self.grow(chunk);
            return self.push(node);
        };
        nodes[offset].set(node);
        self.len.set(index + 1);
        index as u32
    }

    #[cold]
    #[inline(never)]
    fn grow(&self, chunk: usize) {
        assert!(chunk < CHUNKS, "a tape holds no more than 4294967295 operations");
        let length = FIRST << chunk.saturating_sub(1);
        self.chunks[chunk].get_or_init(|| (0..length).map(|_| Cell::new(CONSTANT)).collect());
    }

    /// Forgets all nodes from `len` on; their memory is kept for the next ones.
    pub fn truncate(&self, len: u64) {
        self.len.set(len);
    }

    /// Calls `f` on the nodes from `end` - 1 down to `start`, with their indices.
    pub fn for_each_backwards(&self, start: u64, end: u64, mut f: impl FnMut(u64, Node)) {
        let mut end = end;
        while end > start {
            let (chunk, last) = position(end - 1);
            let nodes = self.chunks[chunk].get().map_or(&[][..], |nodes| &nodes[..=last]);
            let first = end - nodes.len() as u64;
            for node in nodes[start.saturating_sub(first) as usize..].iter().rev() {
                end -= 1;
                f(end, node.get());
            }
        }
    }
}

/// In which chunk an index lies, and where in it.
#[inline(always)]
fn position(index: u64) -> (usize, usize) {
    let chunk = (index / FIRST).checked_ilog2().map_or(0, |power| power as usize + 1);
    let first = if chunk == 0 { 0 } else { FIRST << (chunk - 1) };
    (chunk, (index - first) as usize)
}

#[cfg(test)]
mod tests {
    use super::{FIRST, List, Node, position};

    #[test]
    fn chunks_follow_each_other() {
        assert_eq!(position(0), (0, 0));
        assert_eq!(position(FIRST - 1), (0, FIRST as usize - 1));
        assert_eq!(position(FIRST), (1, 0));
        assert_eq!(position(2 * FIRST - 1), (1, FIRST as usize - 1));
        assert_eq!(position(2 * FIRST), (2, 0));
        assert_eq!(position(4 * FIRST), (3, 0));
        // The last index fits into the last chunk.
        assert_eq!(position(u64::from(u32::MAX)), (super::CHUNKS - 1, (1 << 31) - 1));
    }

    #[test]
    fn nodes_come_back_in_reverse_order() {
        let list = List::new();
        for i in 1..20_000 {
            assert_eq!(list.push(Node { partials: [f64::from(i), 0.0], operands: [0; 2] }), i);
        }
        let mut expected = 15_000;
        list.for_each_backwards(3, 15_000, |index, node| {
            expected -= 1;
            assert_eq!((index, node.partials[0]), (expected, expected as f64));
        });
        assert_eq!(expected, 3);
    }
}
