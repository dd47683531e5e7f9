//! An array that is gone through where its numbers lie, without a copy of them.

use super::Array;

/// What is shown some values at a time: counts, or the bits of numbers.
type See<'a> = &'a mut dyn FnMut(&[u64]);

/// Values of one kind, in order, made from what lies elsewhere while they are gone through.
pub struct ArrayView<'a> {
    has_counts: bool,
    length: usize,
    each_row: Box<dyn Fn(See) + 'a>,
}

impl<'a> ArrayView<'a> {
    /// Numbers, as many in each row.
    pub fn of_numbers<const N: usize>(
        rows: impl ExactSizeIterator<Item = [f64; N]> + Clone + 'a,
    ) -> Self {
        Self {
            has_counts: false,
            length: N * rows.len(),
            each_row: Box::new(move |see| {
                rows.clone().for_each(|row| see(&row.map(f64::to_bits)));
            }),
        }
    }

    /// Counts.
    pub fn of_counts(counts: impl ExactSizeIterator<Item = u64> + Clone + 'a) -> Self {
        Self {
            has_counts: true,
            length: counts.len(),
            each_row: Box::new(move |see| counts.clone().for_each(|count| see(&[count]))),
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
            Array::Numbers(numbers) => Self::of_numbers(numbers.iter().map(|number| [*number])),
            Array::Counts(counts) => Self::of_counts(counts.iter().copied()),
        }
    }
}
