//! The container of a checkpoint: named sections of text or numbers, each with its checksum.
//!
//! ```text
//! parsim2d checkpoint 1
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

use std::io::{self, Write};

use crc32fast::Hasher;

use crate::simulation::state::Array;

/// The words before the format's number in the first line.
pub const MAGIC: &str = "parsim2d checkpoint ";

/// The format written here.
pub const FORMAT: u32 = 1;

/// What a section holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// Text.
    Text(String),
    /// Numbers or counts.
    Array(Array),
}

impl Content {
    fn kind(&self) -> &'static str {
        match self {
            Self::Text(_) => "text",
            Self::Array(Array::Numbers(_)) => "f64",
            Self::Array(Array::Counts(_)) => "u64",
        }
    }

    fn bytes(&self) -> Vec<u8> {
        match self {
            Self::Text(text) => text.as_bytes().to_vec(),
            Self::Array(Array::Numbers(numbers)) => {
                numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
            }
            Self::Array(Array::Counts(counts)) => {
                counts.iter().flat_map(|count| count.to_le_bytes()).collect()
            }
        }
    }

    fn from_bytes(kind: &str, bytes: &[u8]) -> Option<Self> {
        match kind {
            "text" => Some(Self::Text(std::str::from_utf8(bytes).ok()?.to_owned())),
            "f64" => Some(Self::Array(Array::Numbers(words(bytes, f64::from_le_bytes)?))),
            "u64" => Some(Self::Array(Array::Counts(words(bytes, u64::from_le_bytes)?))),
            _ => None,
        }
    }
}

/// Numbers of eight bytes each.
fn words<T>(bytes: &[u8], from: impl Fn([u8; 8]) -> T) -> Option<Vec<T>> {
    let (words, rest) = (bytes.chunks_exact(8), bytes.len() % 8);
    let word = |word: &[u8]| word.try_into().map(&from).ok();
    if rest == 0 { words.map(word).collect() } else { None }
}

/// Writes `sections` to `out`, in order.
pub fn write(out: &mut impl Write, sections: &[(String, Content)]) -> io::Result<()> {
    let mut sum = Hasher::new();
    let mut put = |bytes: &[u8]| {
        sum.update(bytes);
        out.write_all(bytes)
    };
    put(format!("{MAGIC}{FORMAT}\n").as_bytes())?;
    for (name, content) in sections {
        let bytes = content.bytes();
        put(section_line(name, content.kind(), bytes.len(), crc32fast::hash(&bytes)).as_bytes())?;
        put(&bytes)?;
        put(b"\n")?;
    }
    let crc = sum.finalize();
    out.write_all(end_line(sections.len(), crc).as_bytes())
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
    fn cut(at: usize) -> Self {
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

/// Reads the sections of a whole file, `bytes`. Nothing is believed that does not agree with its
/// checksum, and no memory is taken on the word of a length.
pub fn read(bytes: &[u8]) -> Result<Vec<(String, Content)>, Flaw> {
    match format(bytes)? {
        FORMAT => {}
        other => return Err(Flaw::OtherFormat(other)),
    }
    let first = format!("{MAGIC}{FORMAT}\n");
    let mut at = first.len();
    if !bytes.starts_with(first.as_bytes()) {
        return Err(Flaw::cut(bytes.len()));
    }
    let mut sections = Vec::new();
    loop {
        let line = line_at(bytes, at)?;
        if line.starts_with("end ") {
            let right = end_line(sections.len(), crc32fast::hash(&bytes[..at]));
            return match bytes.len() - at == right.len() && line == right {
                true => Ok(sections),
                false => Err(Flaw::Damaged("the checksum of the whole does not agree".to_owned())),
            };
        }
        at += line.len();
        let (section, length) = section_at(bytes, at, line)?;
        sections.push(section);
        at += length + 1;
    }
}

/// The line that begins `at`, its end included.
fn line_at(bytes: &[u8], at: usize) -> Result<&str, Flaw> {
    const LONGEST: usize = 200;
    let rest = bytes.get(at..).unwrap_or_default();
    let rest = &rest[..rest.len().min(LONGEST)];
    let Some(end) = rest.iter().position(|&byte| byte == b'\n') else {
        return match rest.len() < LONGEST {
            true => Err(Flaw::cut(bytes.len())),
            false => Err(Flaw::Damaged(format!("no line begins at byte {at}"))),
        };
    };
    std::str::from_utf8(&rest[..=end])
        .map_err(|_| Flaw::Damaged(format!("the line at byte {at} is no text")))
}

/// The section announced by `line`, whose bytes begin `at`; and how many they are.
fn section_at(bytes: &[u8], at: usize, line: &str) -> Result<((String, Content), usize), Flaw> {
    let damaged = |what: String| Flaw::Damaged(what);
    let words: Vec<&str> = line.split_whitespace().collect();
    let ["section", name, kind, length, "crc32", _] = words[..] else {
        return Err(damaged(format!("no section begins at byte {}", at - line.len())));
    };
    let length: usize =
        length.parse().map_err(|_| damaged(format!("section {name} has no length")))?;
    let end = at.checked_add(length).filter(|&end| end < bytes.len());
    let body = &bytes[at..end.ok_or_else(|| Flaw::cut(bytes.len()))?];
    let right = section_line(name, kind, length, crc32fast::hash(body));
    if line != right || bytes[at + length] != b'\n' {
        return Err(damaged(format!("the checksum of section {name} does not agree")));
    }
    let content = Content::from_bytes(kind, body)
        .ok_or_else(|| damaged(format!("section {name} is not {kind}")))?;
    Ok(((name.to_owned(), content), length))
}
