//! The numbers of objects, by the names of their fields.

use std::borrow::Cow;
use std::ops::Range;

use ad::{Field, Fields};

/// An object whose numbers have names.
pub trait Numbers {
    /// The names of the fields that are parameters, with how many numbers each has.
    fn fields(&self) -> Vec<Field>;

    /// The numbers of a field.
    fn get(&self, field: &str) -> Option<Cow<'_, [f64]>>;

    /// Replaces the numbers of a field, from the one at `first` on. The field exists and has as many.
    fn set(&mut self, field: &str, first: usize, numbers: &[f64]);
}

/// Where the numbers of a field are among those of all.
pub fn range_of(fields: &[Field], name: &str) -> Option<Range<usize>> {
    let mut start = 0;
    for field in fields {
        let end = start + field.len;
        if field.name == name {
            return Some(start..end);
        }
        start = end;
    }
    None
}

impl<T: Fields<f64>> Numbers for T {
    fn fields(&self) -> Vec<Field> {
        T::FIELDS.to_vec()
    }

    fn get(&self, field: &str) -> Option<Cow<'_, [f64]>> {
        let range = range_of(T::FIELDS, field)?;
        Some(range.map(|index| self.number(index)).collect())
    }

    fn set(&mut self, field: &str, first: usize, numbers: &[f64]) {
        if let Some(range) = range_of(T::FIELDS, field) {
            let first = range.start + first;
            let changed = |index: usize| index.checked_sub(first).and_then(|i| numbers.get(i));
            *self = T::from_fn(&mut |i| changed(i).copied().unwrap_or_else(|| self.number(i)));
        }
    }
}
