//! An array that is gone through where its numbers lie, without a copy of them.

use super::array::Array;
use super::row::Row;

/// What is shown some values at a time: counts, or the bits of numbers.
type See<'a> = &'a mut dyn FnMut(&[u64]);

/// Values of one kind, in order, made from what lies elsewhere while they are gone through.
pub struct ArrayView<'a> {
    has_counts: bool,
    length: usize,
    each_row: Box<dyn Fn(See) + 'a>,
}

impl<'a> ArrayView<'a> {
    /// The rows of a column.
    pub fn of_rows<T: Row + 'a>(rows: impl ExactSizeIterator<Item = T> + Clone + 'a) -> Self {
        Self {
            has_counts: T::HAS_COUNTS,
            length: T::WIDTH * rows.len(),
            each_row: Box::new(move |see| {
                let mut words = vec![0; T::WIDTH];
                for row in rows.clone() {
                    row.put(&mut words);
                    see(&words);
                }
            }),
        }
    }

    /// Whether these are counts, not numbers.
    pub fn has_counts(&self) -> bool {
        self.has_counts
    }

    /// How many values there are.
    pub fn len(&self) -> usize {
        self.length
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// Shows all values in order, some at a time: counts, or the bits of numbers.
    pub fn each_row(&self, see: See) {
        (self.each_row)(see);
    }

    /// A copy.
    pub fn to_array(&self) -> Array {
        let mut bits = Vec::with_capacity(self.length);
        self.each_row(&mut |row| bits.extend_from_slice(row));
        match self.has_counts {
            true => Array::Counts(bits),
            false => Array::Numbers(bits.into_iter().map(f64::from_bits).collect()),
        }
    }
}

impl<'a> From<&'a Array> for ArrayView<'a> {
    fn from(array: &'a Array) -> Self {
        match array {
            Array::Numbers(numbers) => Self::of_rows(numbers.iter().copied()),
            Array::Counts(counts) => Self::of_rows(counts.iter().copied()),
        }
    }
}
