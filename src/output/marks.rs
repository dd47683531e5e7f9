//! Where the records of a growing file end, so that the last of them can be taken back.

use std::collections::VecDeque;
use std::fs::File;
use std::io::{self, Seek, SeekFrom};

/// Records remembered: more than a guard ever takes back.
const MOST: usize = 4096;

/// Ends of records, by the step they belong to.
#[derive(Default)]
pub struct Marks(VecDeque<(u64, u64)>);

impl Marks {
    /// The record of `step` ends where `file` ends now.
    pub fn add(&mut self, step: u64, mut file: &File) -> io::Result<()> {
        if self.0.len() == MOST {
            self.0.pop_front();
        }
        self.0.push_back((step, file.stream_position()?));
        Ok(())
    }

    /// Cuts `file` off after the last record of `step` or before, and returns the step of that record.
    pub fn cut_back_to(&mut self, step: u64, mut file: &File) -> io::Result<u64> {
        while self.0.len() > 1 && self.0.back().is_some_and(|&(last, _)| last > step) {
            self.0.pop_back();
        }
        let Some(&(last, end)) = self.0.back() else { return Ok(step) };
        file.set_len(end)?;
        file.seek(SeekFrom::Start(end))?;
        Ok(last)
    }
}
