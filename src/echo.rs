//! What came from outside, made fit for a terminal: values, keys and names as they were said, with nothing in them
//! that a terminal would obey, and no longer than a person reads.
//!
//! Escaped, not left out: who looks for a mistake must see what is there. A sheet of a submission, which its author
//! reads, leaves such things out instead (`sheet::plain`).

use std::borrow::Cow;
use std::path::Path;

/// Characters of a value that are shown.
const VALUE: usize = 120;
/// Characters of a sentence.
const SENTENCE: usize = 600;
/// Characters of the path of a file.
const PATH: usize = 300;
/// Characters of a line of a message, and lines of a message.
const LINE: usize = 2_000;
const LINES: usize = 100;

/// A value, key or name, on one line.
///
/// ```
/// use parsim2d::echo::value;
/// assert_eq!(value("0.5 mm"), "0.5 mm");
/// assert_eq!(value("\x1b[31mred\n"), "\\u{1b}[31mred\\n");
/// assert_eq!(value(&"a".repeat(1_000)).matches('a').count(), 120);
/// assert!(value(&"a".repeat(1_000)).contains("a... 1000 bytes ...a"));
/// ```
pub fn value(text: &str) -> String {
    cut(text, VALUE)
}

/// A sentence with such words in it, on one line.
pub fn sentence(text: &str) -> String {
    cut(text, SENTENCE)
}

/// The path of a file, on one line.
pub fn path(path: impl AsRef<Path>) -> String {
    cut(&path.as_ref().to_string_lossy(), PATH)
}

/// A message of one or more lines that ours and others' words are in.
///
/// ```
/// use parsim2d::echo::message;
/// assert_eq!(message("is not possible: \x07\n  way out: none"), "is not possible: \\u{7}\n  way out: none");
/// ```
pub fn message(text: &str) -> String {
    let lines = text.split('\n').take(LINES).map(|line| cut(line, LINE));
    let lines: Vec<String> = lines.collect();
    lines.join("\n") + if text.split('\n').nth(LINES).is_some() { "\n..." } else { "" }
}

/// `text` escaped; of more than `most` characters the beginning and the end, for what is wrong may stand there.
fn cut(text: &str, most: usize) -> String {
    if text.char_indices().nth(most).is_none() {
        return escaped(text).into_owned();
    }
    let tail = most / 4;
    let end = text.char_indices().nth(most - tail).map_or(0, |(at, _)| at);
    let again = text.char_indices().nth_back(tail - 1).map_or(0, |(at, _)| at);
    let (head, tail) = (escaped(&text[..end]), escaped(&text[again..]));
    format!("{head}... {} bytes ...{tail}", text.len())
}

/// `text` with what is no plain character in the way of Rust and JavaScript: `\n`, `\u{1b}`.
fn escaped(text: &str) -> Cow<'_, str> {
    if !text.contains(is_obeyed) {
        return text.into();
    }
    let mut escaped = String::new();
    for c in text.chars() {
        match is_obeyed(c) {
            true => escaped.extend(c.escape_default()),
            false => escaped.push(c),
        }
    }
    escaped.into()
}

/// Whether a terminal does something else than to show `c`: control characters, and marks that turn the direction of
/// writing or end a line.
fn is_obeyed(c: char) -> bool {
    let is_mark = matches!(
        c,
        '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}'
    );
    c.is_control() || is_mark
}
