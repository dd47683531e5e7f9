//! The rows of a frame, written fast: at a frame of a hundred thousand discs a run waits for this.

use std::io::{self, Write};

use super::head::{Columns, Head};
use crate::output::number::push_g9;

/// Text is handed on from so many bytes on: no less than any buffer behind holds, which need not copy it.
const TEXT: usize = 1 << 16;

/// Discs are fetched so many at a time.
const ROWS: usize = 256;

/// More bytes than a row of six numbers takes.
const LONGEST_ROW: usize = 128;

/// The columns of the radius and the mass.
const RADIUS: usize = 2;
const MASS: usize = 5;

/// Writes one frame: its `head`, then `rows` of these `columns`.
pub fn write_rows<const N: usize>(
    out: &mut impl Write,
    head: Head,
    columns: Columns,
    mut rows: impl Iterator<Item = [f64; N]>,
) -> io::Result<()> {
    let mut text = Vec::with_capacity(TEXT + ROWS * LONGEST_ROW);
    head.push(&mut text, columns);
    let (mut radius, mut mass) = (SameText::default(), SameText::default());
    let mut some = Vec::with_capacity(ROWS);
    loop {
        // Rows lie anywhere in memory: fetched together, they are waited for together.
        some.clear();
        some.extend(rows.by_ref().take(ROWS));
        if some.is_empty() {
            return out.write_all(&text);
        }
        for row in &some {
            push_row_of_disc(&mut text, row, &mut radius, &mut mass);
        }
        if text.len() >= TEXT {
            out.write_all(&text)?;
            text.clear();
        }
    }
}

fn push_row_of_disc<const N: usize>(
    text: &mut Vec<u8>,
    row: &[f64; N],
    radius: &mut SameText,
    mass: &mut SameText,
) {
    for (column, &value) in row.iter().enumerate() {
        if column > 0 {
            text.push(b' ');
        }
        match column {
            RADIUS => text.extend_from_slice(radius.of(value)),
            MASS => text.extend_from_slice(mass.of(value)),
            _ => push_g9(text, value),
        }
    }
    text.push(b'\n');
}

/// The text of a radius or a mass, kept for the next row, which nearly always has the same.
#[derive(Default)]
struct SameText {
    bits: Option<u64>,
    text: Vec<u8>,
}

impl SameText {
    fn of(&mut self, value: f64) -> &[u8] {
        if self.bits != Some(value.to_bits()) {
            self.bits = Some(value.to_bits());
            self.text.clear();
            push_g9(&mut self.text, value);
        }
        &self.text
    }
}

/// Appends numbers with blanks between them.
pub(super) fn push_values(text: &mut Vec<u8>, values: &[f64]) {
    for (column, &value) in values.iter().enumerate() {
        if column > 0 {
            text.push(b' ');
        }
        push_g9(text, value);
    }
}
