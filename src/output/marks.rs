//! Where the records of a growing file end, so that the last of them can be taken back.

use std::collections::VecDeque;
use std::io;

use super::growing::{Extent, GrowingFile};

/// Records remembered: more than a guard ever takes back.
const MOST: usize = 4096;

/// Ends of records, by the step they belong to.
#[derive(Default)]
pub struct Marks(VecDeque<(u64, Extent)>);

impl Marks {
    /// The record of `step` is the last of `extent`.
    pub fn add(&mut self, step: u64, extent: Extent) {
        if self.0.len() == MOST {
            self.0.pop_front();
        }
        self.0.push_back((step, extent));
    }

    /// Cuts `file` off after the last record of `step` or before, and returns the step of that record.
    pub fn cut_back_to(&mut self, step: u64, file: &mut GrowingFile) -> io::Result<u64> {
        while self.0.len() > 1 && self.0.back().is_some_and(|&(last, _)| last > step) {
            self.0.pop_back();
        }
        let Some(&(last, extent)) = self.0.back() else { return Ok(step) };
        file.cut_back(extent)?;
        Ok(last)
    }
}
