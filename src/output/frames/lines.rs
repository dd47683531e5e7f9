//! The lines of a text, one after the other: they end in LF, CR LF, or CR alone.

use std::borrow::Cow;
use std::io::{BufRead, Read};

/// No line of a frame is so long, bytes; a file without lines is not read into memory.
const LONGEST_LINE: u64 = 1 << 16;

/// A text that is read line by line.
pub struct Lines<R> {
    input: R,
    /// What lines end in.
    end: u8,
    bytes: Vec<u8>,
    /// Number of the line that was read last, from 1.
    number: usize,
    /// Whether it is to be read again.
    is_put_back: bool,
}

/// A line without its end and the blanks around it.
pub struct Line<'a> {
    /// What it says.
    pub text: Cow<'a, str>,
    /// Its number, from 1.
    pub number: usize,
    /// Whether the file ends within it.
    pub is_cut: bool,
}

impl Line<'_> {
    /// What is wrong with this line.
    pub fn at(&self, why: impl AsRef<str>) -> String {
        format!("line {}: {}", self.number, why.as_ref())
    }
}

impl<R: BufRead> Lines<R> {
    /// The lines of `input`, which begins with `start`.
    pub fn of(input: R, start: &[u8]) -> Self {
        let count = |wanted: u8| start.iter().filter(|&&byte| byte == wanted).count();
        // As old Macintoshes wrote them; an LF at the end of the file changes nothing.
        let end = if count(b'\r') > 2 * count(b'\n') { b'\r' } else { b'\n' };
        Self { input, end, bytes: Vec::new(), number: 0, is_put_back: false }
    }

    /// The line that was read last comes again.
    pub fn put_back(&mut self) {
        self.is_put_back = true;
    }

    /// Number of the line that was read last, from 1.
    pub fn number(&self) -> usize {
        self.number
    }

    /// Whether lines end as programs of today expect it.
    pub fn are_usual(&self) -> bool {
        self.end == b'\n'
    }

    /// The next line, if there is one.
    pub fn next(&mut self) -> Result<Option<Line<'_>>, String> {
        if !std::mem::take(&mut self.is_put_back) {
            self.number += 1;
            self.bytes.clear();
            let number = self.number;
            self.read().map_err(|why| format!("line {number}: {why}"))?;
            if self.bytes.is_empty() {
                return Ok(None);
            }
        }
        let number = self.number;
        let text = match std::str::from_utf8(&self.bytes) {
            Ok(text) => Cow::Borrowed(text.trim_start_matches('\u{feff}').trim()),
            // A remark in the letters of an older system.
            Err(_) if self.bytes.starts_with(b"#") && !self.bytes.contains(&0) => {
                Cow::Owned(String::from_utf8_lossy(&self.bytes).trim().to_owned())
            }
            Err(_) => return Err(format!("line {number}: this is not text")),
        };
        let is_cut = self.bytes.last() != Some(&self.end);
        Ok(Some(Line { text, number, is_cut }))
    }

    /// Reads one line with its end; nothing at the end of the file.
    fn read(&mut self) -> Result<(), String> {
        let mut some = self.input.by_ref().take(LONGEST_LINE);
        let read = some.read_until(self.end, &mut self.bytes).map_err(|why| why.to_string())?;
        match read as u64 {
            LONGEST_LINE => {
                Err(format!("a line of {LONGEST_LINE} bytes: this is no file of frames"))
            }
            _ => Ok(()),
        }
    }
}
