//! A row of a column, as words of 64 bits: how it is written down, and read back.

use glam::DVec2;

/// What a column has for each disc (or pair, or once): some numbers, or some counts.
pub trait Row: Copy {
    /// How many of them.
    const WIDTH: usize;
    /// Whether they are counts.
    const HAS_COUNTS: bool;
    /// Writes them down: counts, or the bits of numbers.
    fn put(&self, words: &mut [u64]);
    /// The row that these words are of, if there is one.
    fn of_words(words: &[u64]) -> Option<Self>;
}

/// Says how a type is written as an array of numbers, and read from one.
macro_rules! row_of_numbers {
    ($row:ty, $width:expr, $to:expr, $from:expr) => {
        impl $crate::discs::columns::Row for $row {
            const WIDTH: usize = $width;
            const HAS_COUNTS: bool = false;

            fn put(&self, words: &mut [u64]) {
                let to: fn(&$row) -> [f64; $width] = $to;
                words.copy_from_slice(&to(self).map(f64::to_bits));
            }

            fn of_words(words: &[u64]) -> Option<Self> {
                let from: fn([f64; $width]) -> $row = $from;
                Some(from(std::array::from_fn(|k| f64::from_bits(words[k]))))
            }
        }
    };
}
pub(crate) use row_of_numbers;

row_of_numbers!(f64, 1, |number| [*number], |[number]| number);
row_of_numbers!(DVec2, 2, DVec2::to_array, DVec2::from_array);
row_of_numbers!([f32; 2], 2, |row| row.map(f64::from), |row| row.map(|number| number as f32));

impl<const N: usize> Row for [f64; N] {
    const WIDTH: usize = N;
    const HAS_COUNTS: bool = false;

    fn put(&self, words: &mut [u64]) {
        words.copy_from_slice(&self.map(f64::to_bits));
    }

    fn of_words(words: &[u64]) -> Option<Self> {
        Some(std::array::from_fn(|k| f64::from_bits(words[k])))
    }
}

impl Row for u64 {
    const WIDTH: usize = 1;
    const HAS_COUNTS: bool = true;

    fn put(&self, words: &mut [u64]) {
        words[0] = *self;
    }

    fn of_words(words: &[u64]) -> Option<Self> {
        Some(words[0])
    }
}

impl Row for u32 {
    const WIDTH: usize = 1;
    const HAS_COUNTS: bool = true;

    fn put(&self, words: &mut [u64]) {
        words[0] = u64::from(*self);
    }

    fn of_words(words: &[u64]) -> Option<Self> {
        words[0].try_into().ok()
    }
}

impl<const N: usize> Row for [u32; N] {
    const WIDTH: usize = N;
    const HAS_COUNTS: bool = true;

    fn put(&self, words: &mut [u64]) {
        words.iter_mut().zip(self).for_each(|(word, count)| *word = u64::from(*count));
    }

    fn of_words(words: &[u64]) -> Option<Self> {
        let mut row = [0; N];
        for (count, word) in row.iter_mut().zip(words) {
            *count = (*word).try_into().ok()?;
        }
        Some(row)
    }
}
