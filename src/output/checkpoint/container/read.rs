//! The reading of a container, section by section: of the file itself no copy is in memory.

use std::io::{self, BufRead, ErrorKind, Read};

use crc32fast::Hasher;

use super::{Content, FORMAT, Flaw, MAGIC, end_line, format, section_line};
use crate::simulation::state::Array;

/// A line of the container is not so long, bytes.
const LONGEST: u64 = 200;

/// Bytes of a section are fetched so many at a time; whole numbers.
const SOME: usize = 1 << 16;

/// Named sections, in the order of the file.
type Sections = Vec<(String, Content)>;

/// Reads the sections of a whole file, `bytes`. Nothing is believed that does not agree with its
/// checksum, and no memory is taken on the word of a length.
pub fn read(bytes: &[u8]) -> Result<Sections, Flaw> {
    let read = read_from(bytes, bytes.len() as u64);
    read.unwrap_or_else(|why| Err(Flaw::Damaged(why.to_string()))) // bytes in memory can be read
}

/// The same from `input`, a file of `size` bytes. The outer error is one of reading.
pub fn read_from(input: impl BufRead, size: u64) -> io::Result<Result<Sections, Flaw>> {
    match (Reader { input, size, at: 0, sum: Hasher::new() }).read() {
        Ok(sections) => Ok(Ok(sections)),
        Err(Stop::Flawed(flaw)) => Ok(Err(flaw)),
        Err(Stop::Unreadable(why)) if why.kind() == ErrorKind::UnexpectedEof => {
            Ok(Err(Flaw::cut(size))) // it has become shorter
        }
        Err(Stop::Unreadable(why)) => Err(why),
    }
}

/// Why reading ended early.
enum Stop {
    Flawed(Flaw),
    Unreadable(io::Error),
}

impl From<Flaw> for Stop {
    fn from(flaw: Flaw) -> Self {
        Self::Flawed(flaw)
    }
}

impl From<io::Error> for Stop {
    fn from(why: io::Error) -> Self {
        Self::Unreadable(why)
    }
}

fn damaged(what: String) -> Stop {
    Stop::Flawed(Flaw::Damaged(what))
}

struct Reader<R> {
    input: R,
    size: u64,
    /// Bytes that have been read, and their checksum.
    at: u64,
    sum: Hasher,
}

impl<R: BufRead> Reader<R> {
    fn read(mut self) -> Result<Sections, Stop> {
        let first = self.line_bytes()?;
        match format(&first)? {
            FORMAT => {}
            other => return Err(Flaw::OtherFormat(other).into()),
        }
        if first != format!("{MAGIC}{FORMAT}\n").as_bytes() {
            return Err(Flaw::cut(self.size).into());
        }
        self.book(&first);
        let mut sections = Vec::new();
        loop {
            let line = self.line()?;
            if line.starts_with("end ") {
                let right = end_line(sections.len(), self.sum.finalize());
                return match self.at + line.len() as u64 == self.size && line == right {
                    true => Ok(sections),
                    false => Err(damaged("the checksum of the whole does not agree".to_owned())),
                };
            }
            sections.push(self.section(&line)?);
        }
    }

    /// Counts `bytes` as read.
    fn book(&mut self, bytes: &[u8]) {
        self.at += bytes.len() as u64;
        self.sum.update(bytes);
    }

    /// The bytes up to the next line end, which is among them if there is one near.
    fn line_bytes(&mut self) -> io::Result<Vec<u8>> {
        let mut line = Vec::new();
        self.input.by_ref().take(LONGEST).read_until(b'\n', &mut line)?;
        Ok(line)
    }

    /// The next line, its end included.
    fn line(&mut self) -> Result<String, Stop> {
        let (line, at) = (self.line_bytes()?, self.at);
        if line.last() != Some(&b'\n') {
            return Err(match (line.len() as u64) < LONGEST {
                true => Flaw::cut(self.size).into(),
                false => damaged(format!("no line begins at byte {at}")),
            });
        }
        String::from_utf8(line).map_err(|_| damaged(format!("the line at byte {at} is no text")))
    }

    /// The section that `line` announces.
    fn section(&mut self, line: &str) -> Result<(String, Content), Stop> {
        let words: Vec<&str> = line.split_whitespace().collect();
        let ["section", name, kind, length, "crc32", _] = words[..] else {
            return Err(damaged(format!("no section begins at byte {}", self.at)));
        };
        let length: usize =
            length.parse().map_err(|_| damaged(format!("section {name} has no length")))?;
        self.book(line.as_bytes());
        if self.at.checked_add(length as u64).is_none_or(|end| end >= self.size) {
            return Err(Flaw::cut(self.size).into());
        }
        let mut sum = Hasher::new();
        let content = self.content(kind, length, &mut sum)?;
        self.at += length as u64;
        self.sum.combine(&sum);
        let mut end = [0];
        self.input.read_exact(&mut end)?;
        self.book(&end);
        if line != section_line(name, kind, length, sum.finalize()) || end != *b"\n" {
            return Err(damaged(format!("the checksum of section {name} does not agree")));
        }
        let content = content.ok_or_else(|| damaged(format!("section {name} is not {kind}")))?;
        Ok((name.to_owned(), content))
    }

    /// What `length` bytes hold, no more than there are in the file; `None` if it is not of this `kind`.
    /// Their checksum is added to `sum`.
    fn content(
        &mut self,
        kind: &str,
        length: usize,
        sum: &mut Hasher,
    ) -> io::Result<Option<Content>> {
        let is_whole = length % 8 == 0;
        Ok(match kind {
            "f64" if is_whole => {
                let numbers = self.words(length, sum, f64::from_le_bytes)?;
                Some(Content::Array(Array::Numbers(numbers)))
            }
            "u64" if is_whole => {
                let counts = self.words(length, sum, u64::from_le_bytes)?;
                Some(Content::Array(Array::Counts(counts)))
            }
            _ => {
                let bytes = self.words(length, sum, |[byte]| byte)?;
                String::from_utf8(bytes).ok().filter(|_| kind == "text").map(Content::Text)
            }
        })
    }

    /// `length` bytes as words of `N` bytes each.
    fn words<T, const N: usize>(
        &mut self,
        length: usize,
        sum: &mut Hasher,
        from: impl Fn([u8; N]) -> T,
    ) -> io::Result<Vec<T>> {
        let mut words = Vec::with_capacity(length / N);
        let mut some = vec![0; SOME.min(length)];
        let mut left = length;
        while left > 0 {
            some.truncate(left);
            self.input.read_exact(&mut some)?;
            sum.update(&some);
            let word = |word: &[u8]| from(word.try_into().expect("a chunk of N bytes"));
            words.extend(some.chunks_exact(N).map(word));
            left -= some.len();
        }
        Ok(words)
    }
}
