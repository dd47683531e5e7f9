//! The lines of a text, one after the other: they end in LF, CR LF, or CR alone.

use std::borrow::Cow;
use std::io::BufRead;

/// No line of a frame is so long, bytes; a file without lines is not read into memory.
const LONGEST_LINE: usize = 1 << 16;

/// A text that is read line by line.
pub struct Lines<R> {
    input: R,
    bytes: Vec<u8>,
    /// Number of the line that was read last, from 1.
    number: usize,
    /// Whether it is to be read again.
    is_put_back: bool,
    /// Whether it ended in CR, so that an LF may follow.
    after_cr: bool,
    /// Whether any line ended in CR alone.
    has_lone_cr: bool,
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
    /// The lines of `input`.
    pub fn of(input: R) -> Self {
        Self {
            input,
            bytes: Vec::new(),
            number: 0,
            is_put_back: false,
            after_cr: false,
            has_lone_cr: false,
        }
    }

    /// The line that was read last comes again.
    pub fn put_back(&mut self) {
        self.is_put_back = true;
    }

    /// Whether all lines so far end as programs of today expect it.
    pub fn are_usual(&self) -> bool {
        !self.has_lone_cr
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
        let is_cut = !matches!(self.bytes.last(), Some(b'\n' | b'\r'));
        Ok(Some(Line { text, number, is_cut }))
    }

    /// Reads one line with its end; nothing at the end of the file.
    fn read(&mut self) -> Result<(), String> {
        loop {
            let some = self.input.fill_buf().map_err(|why| why.to_string())?;
            if some.is_empty() {
                return Ok(());
            }
            if std::mem::take(&mut self.after_cr) {
                if some[0] == b'\n' {
                    self.input.consume(1);
                    continue;
                }
                self.has_lone_cr = true;
            }
            let end = some.iter().position(|&byte| byte == b'\n' || byte == b'\r');
            let taken = end.map_or(some.len(), |end| end + 1);
            self.bytes.extend_from_slice(&some[..taken]);
            self.after_cr = end.is_some() && some[taken - 1] == b'\r';
            self.input.consume(taken);
            if self.bytes.len() > LONGEST_LINE {
                return Err(format!(
                    "a line of more than {LONGEST_LINE} bytes: this is no file of frames"
                ));
            }
            if end.is_some() {
                return Ok(());
            }
        }
    }
}
