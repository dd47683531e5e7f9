//! The container of a checkpoint: named sections of text or numbers, each with its checksum.
//!
//! ```text
//! parsim2d checkpoint 2
//! section scenario text 812 crc32 0a1b2c3d
//! ... 812 bytes of text, and a line end ...
//! section particles f64 12800 crc32 89abcdef
//! ... 12800 bytes: little-endian numbers, and a line end ...
//! end 7 crc32 01234567
//! ```
//!
//! Kinds are `text` (UTF-8), `f64` and `u64` (little-endian). Checksums are CRC-32 as in zip and PNG: of
//! a section its bytes, of the end line everything before it, so that no byte goes unchecked. Texts come
//! first, so that `head` shows them. A reader need not know what the sections are.

mod read;

use std::borrow::Cow;
use std::io::{self, Write};

use crc32fast::Hasher;

pub use self::read::{read, read_from};
use crate::simulation::state::{Array, ArrayView};

/// The words before the format's number in the first line.
pub const MAGIC: &str = "parsim2d checkpoint ";

/// The format written here.
pub const FORMAT: u32 = 2;

/// What a section held, read.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// Text.
    Text(String),
    /// Numbers or counts.
    Array(Array),
}

/// A section about to be written.
pub enum Section<'a> {
    /// Text.
    Text(Cow<'a, str>),
    /// Numbers or counts.
    Array(ArrayView<'a>),
}

impl Section<'_> {
    fn kind(&self) -> &'static str {
        match self {
            Self::Text(_) => "text",
            Self::Array(array) if array.has_counts() => "u64",
            Self::Array(_) => "f64",
        }
    }

    /// Number of bytes.
    fn length(&self) -> usize {
        match self {
            Self::Text(text) => text.len(),
            Self::Array(array) => 8 * array.len(),
        }
    }

    /// Hands all bytes to `put`, some at a time: they are made anew each time, and never all at once.
    fn put_bytes(&self, mut put: impl FnMut(&[u8]) -> io::Result<()>) -> io::Result<()> {
        const SOME: usize = 1 << 16;
        let array = match self {
            Self::Text(text) => return put(text.as_bytes()),
            Self::Array(array) => array,
        };
        let mut some = Vec::with_capacity(SOME);
        let mut outcome = Ok(());
        array.each_row(&mut |row| {
            some.extend(row.iter().flat_map(|word| word.to_le_bytes()));
            if some.len() + 8 * row.len() > SOME {
                outcome = std::mem::replace(&mut outcome, Ok(())).and_then(|()| put(&some));
                some.clear();
            }
        });
        outcome?;
        put(&some)
    }
}

impl<'a> From<&'a Content> for Section<'a> {
    fn from(content: &'a Content) -> Self {
        match content {
            Content::Text(text) => Self::Text(text.into()),
            Content::Array(array) => Self::Array(array.into()),
        }
    }
}

/// Writes `sections` to `out`, in order, in memory for none of them.
pub fn write(out: &mut impl Write, sections: &[(&str, Section)]) -> io::Result<()> {
    let mut sum = Hasher::new();
    let first = format!("{MAGIC}{FORMAT}\n");
    sum.update(first.as_bytes());
    out.write_all(first.as_bytes())?;
    for (name, section) in sections {
        // The checksum stands before the bytes, which are gone through twice for it.
        let mut of_section = Hasher::new();
        section.put_bytes(|bytes| {
            of_section.update(bytes);
            Ok(())
        })?;
        let crc = of_section.clone().finalize();
        let line = section_line(name, section.kind(), section.length(), crc);
        out.write_all(line.as_bytes())?;
        section.put_bytes(|bytes| out.write_all(bytes))?;
        out.write_all(b"\n")?;
        sum.update(line.as_bytes());
        sum.combine(&of_section);
        sum.update(b"\n");
    }
    out.write_all(end_line(sections.len(), sum.finalize()).as_bytes())
}

fn section_line(name: &str, kind: &str, bytes: usize, crc: u32) -> String {
    format!("section {name} {kind} {bytes} crc32 {crc:08x}\n")
}

fn end_line(sections: usize, crc: u32) -> String {
    format!("end {sections} crc32 {crc:08x}\n")
}

/// Why a file is no good as a checkpoint.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Flaw {
    /// Not a checkpoint at all.
    #[error("it is no checkpoint of parsim2d: its first line is not `{MAGIC}{FORMAT}`")]
    Foreign,
    /// A checkpoint of another format.
    #[error("it has format {0}; this version reads format {FORMAT} only")]
    OtherFormat(u32),
    /// Cut off, or changed.
    #[error("it is damaged: {0}")]
    Damaged(String),
}

impl Flaw {
    fn cut(at: u64) -> Self {
        Self::Damaged(format!("it ends after {at} bytes, in the middle"))
    }
}

/// The format's number in the first line of `bytes`, or why there is none.
pub fn format(bytes: &[u8]) -> Result<u32, Flaw> {
    let rest = bytes.strip_prefix(MAGIC.as_bytes()).ok_or(Flaw::Foreign)?;
    let line = rest.split(|&byte| byte == b'\n').next().unwrap_or_default();
    let number = std::str::from_utf8(line).ok().and_then(|line| line.parse().ok());
    number.ok_or(Flaw::Foreign)
}
