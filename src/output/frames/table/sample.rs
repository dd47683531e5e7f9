//! The rows of the first frame of a table without a heading, as numbers.

use std::io::BufRead;

use crate::output::frames::comment::{COMMENT, Comment};
use crate::output::frames::guess::Sample;
use crate::output::frames::lines::{Line, Lines};
use crate::output::frames::separator::{Separator, shortened};

/// In columns after these, words that are no numbers are nothing worse.
const READ: usize = 5;

/// Rows of equally many numbers.
#[derive(Debug, Default)]
pub struct Block {
    numbers: Vec<f64>,
    columns: usize,
    /// Line of the first row.
    line: usize,
    /// What is to be said of the first line, if that is none.
    pub remark: Option<String>,
    /// So many rows the first line says to follow.
    count: Option<usize>,
}

impl Block {
    /// Reads rows up to the end of the frame, at most as many as are `declared`.
    pub fn read<R: BufRead>(
        lines: &mut Lines<R>,
        separator: Separator,
        declared: Option<usize>,
    ) -> Result<Self, String> {
        let mut block = Self::default();
        while declared.is_none_or(|n| block.len() < n) {
            let Some(line) = lines.next()? else { break };
            let is_head = |comment: &str| Comment::of(comment).is_head;
            if line.text.is_empty() || line.text.strip_prefix(COMMENT).is_some_and(is_head) {
                lines.put_back();
                break;
            }
            if line.text.starts_with(COMMENT) {
                continue;
            }
            if line.is_cut && declared.is_some() {
                return Err(line.at("the line is cut off"));
            }
            block.add(&line, separator).map_err(|why| line.at(why))?;
        }
        block.remark.take_if(|_| block.count.is_none());
        match block.count {
            Some(n) if n != block.len() => {
                Err(format!("line {}: fewer or more columns than the line before", block.line))
            }
            _ => Ok(block),
        }
    }

    fn add(&mut self, line: &Line, separator: Separator) -> Result<(), String> {
        if self.numbers.is_empty() && separator.is_doubtful(&line.text) {
            let why = "its commas may part columns or stand before decimals";
            let way_out = "write decimals with points, or part columns by blanks or semicolons; if the commas part \
                           columns, --columns says so";
            return Err(format!("{why}\n  way out: {way_out}"));
        }
        let before = self.numbers.len();
        for (column, word) in separator.words(&line.text).enumerate() {
            match separator.number(word) {
                Ok(number) if number.is_finite() || column >= READ => self.numbers.push(number),
                Ok(_) => return Err(format!("`{word}` is not finite")),
                Err(_) if column >= READ => self.numbers.push(f64::NAN),
                Err(why) => return Err(why),
            }
        }
        let columns = self.numbers.len() - before;
        if self.columns == 0 {
            (self.columns, self.line) = (columns, line.number);
            self.remark = Some(format!(
                "its first line, `{}`, is taken for a count of its discs and what else goes with it",
                shortened(&line.text)
            ));
        } else if columns != self.columns {
            let count = self.numbers[0];
            let is_count = count.fract() == 0.0 && count >= 2.0;
            if before != self.columns || self.count.is_some() || !is_count {
                return Err("fewer or more columns than the line before".to_owned());
            }
            self.numbers.drain(..before);
            (self.columns, self.line, self.count) = (columns, line.number, Some(count as usize));
        }
        Ok(())
    }

    fn len(&self) -> usize {
        self.numbers.len().checked_div(self.columns).unwrap_or(0)
    }

    /// The rows.
    pub fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.numbers.chunks_exact(self.columns.max(1))
    }

    /// The rows, to guess from.
    pub fn sample(&self) -> Sample<'_> {
        Sample { numbers: &self.numbers, columns: self.columns.max(1) }
    }

    /// What is wrong with them.
    pub fn at(&self, why: &str) -> String {
        format!("line {}: {why}", self.line)
    }
}
