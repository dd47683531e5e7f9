//! Text of strangers: without what a terminal, a page or a spreadsheet would obey.

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};

/// The longest text of a tool that is repeated in a sheet, bytes.
pub const LONGEST: usize = 4096;
/// The longest name of a file, characters, without its ending.
const LONGEST_NAME: usize = 60;

/// `text` without terminal codes, control characters and marks that turn the direction of writing; lines end
/// with `\n`.
///
/// ```
/// use parsim2d::grading::feedback::plain::plain;
/// assert_eq!(plain("\x1b[31merror\x1b[0m:\r\n\x07 \u{202e}no"), "error:\n no");
/// ```
pub fn plain(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut characters = text.chars().peekable();
    while let Some(c) = characters.next() {
        match c {
            '\x1b' | '\u{9b}' => skip_code(c, &mut characters),
            '\r' if characters.peek() == Some(&'\n') => {}
            '\r' | '\u{85}' | '\u{2028}' | '\u{2029}' | '\x0b' | '\x0c' => plain.push('\n'),
            '\n' | '\t' => plain.push(c),
            c if c.is_control() || is_invisible(c) => {}
            c => plain.push(c),
        }
    }
    plain
}

/// Skips a terminal code of which the first character was read: CSI to its letter, OSC to its end.
fn skip_code(first: char, rest: &mut std::iter::Peekable<std::str::Chars>) {
    let kind = if first == '\x1b' { rest.next() } else { Some('[') };
    let is_end = |c: char| match kind {
        Some('[') => ('@'..='~').contains(&c),
        _ => c == '\x07' || c == '\\' || c == '\n',
    };
    if matches!(kind, Some('[' | ']' | 'P' | '_' | '^' | 'X')) {
        // A code that never ends would swallow the text: none is longer than this.
        let _ = rest.take(256).find(|&c| is_end(c));
    }
}

/// Marks that reorder or hide text, and what XML forbids.
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{fffe}' | '\u{ffff}')
}

/// The same in one line.
///
/// ```
/// use parsim2d::grading::feedback::plain::one_line;
/// assert_eq!(one_line("Grade\n :=>>\t100 "), "Grade :=>> 100");
/// ```
pub fn one_line(text: &str) -> String {
    plain(text).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The beginning of a plain text, and whether that is not all.
pub fn beginning(text: &str, longest: usize) -> (&str, bool) {
    if text.len() <= longest {
        return (text, false);
    }
    let end = (0..=longest).rev().find(|&k| text.is_char_boundary(k)).unwrap_or(0);
    (&text[..end], true)
}

/// A cell that no spreadsheet takes for a formula.
///
/// ```
/// use parsim2d::grading::feedback::plain::cell;
/// assert_eq!(cell("=HYPERLINK(\"http://x\")"), "'=HYPERLINK(\"http://x\")");
/// assert_eq!(cell("Rossi, Mario"), "Rossi, Mario");
/// ```
pub fn cell(text: &str) -> String {
    let text = one_line(text);
    match text.starts_with(['=', '+', '-', '@', '|', '%', '＝', '＋', '－', '＠']) {
        true => format!("'{text}"),
        false => text,
    }
}

/// A name of a file for each submission, without ending: letters, digits, `-`, `_`, `.`; no two alike on any file
/// system, none that means something to one.
///
/// ```
/// use parsim2d::grading::feedback::plain::file_names;
/// let names = ["../etc/passwd", "Rossi, Mario", "rossi, mario", "CON", "class", ""];
/// let files = ["etc_passwd", "Rossi_Mario", "rossi_mario-2", "student-CON", "class-2", "submission"];
/// assert_eq!(file_names(names.into_iter()), files);
/// ```
pub fn file_names<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut taken = BTreeSet::from(["class".to_owned()]);
    let own = |name: &str| {
        let base = file_name(name);
        let numbered = (2..).map(|k| format!("{base}-{k}"));
        let mut free = std::iter::once(base.clone()).chain(numbered);
        let name = free.find(|name| taken.insert(name.to_lowercase()));
        name.unwrap_or(base)
    };
    names.map(own).collect()
}

/// Names of submissions from their paths: without the folders above, or, where these alone tell two apart, without those
/// that all have in common.
///
/// ```
/// use parsim2d::grading::feedback::plain::short_names;
/// let short = |paths: [&str; 2]| short_names(&paths.map(str::to_owned));
/// assert_eq!(short(["class/Ada", "class/late/Bob"]), ["Ada", "Bob"]);
/// assert_eq!(short(["class/Ada/out.txt", "class/Bob/out.txt"]), ["Ada/out.txt", "Bob/out.txt"]);
/// ```
pub fn short_names(paths: &[String]) -> Vec<String> {
    let parts: Vec<Vec<Component>> =
        paths.iter().map(|path| Path::new(path).components().collect()).collect();
    let without = |count: usize, parts: &Vec<Component>| {
        let short: PathBuf = parts.iter().skip(count.min(parts.len().saturating_sub(1))).collect();
        short.to_string_lossy().into_owned()
    };
    let last: Vec<String> = parts.iter().map(|parts| without(usize::MAX, parts)).collect();
    if last.iter().map(|name| name.to_lowercase()).collect::<BTreeSet<_>>().len() == last.len() {
        return last;
    }
    let is_shared = |k: &usize| parts.iter().all(|own| own.get(*k) == parts[0].get(*k));
    let longest = parts.iter().map(Vec::len).max().unwrap_or(0);
    let shared = (0..longest).take_while(is_shared).count();
    parts.iter().map(|parts| without(shared, parts)).collect()
}

/// Windows takes these for devices, whatever follows a dot.
const DEVICES: [&str; 6] = ["con", "prn", "aux", "nul", "com", "lpt"];

fn file_name(name: &str) -> String {
    let mut file = String::new();
    for c in one_line(name).chars().take(LONGEST_NAME) {
        match c {
            c if c.is_alphanumeric() || c == '-' || c == '.' => file.push(c),
            _ if file.ends_with('_') => {}
            _ => file.push('_'),
        }
    }
    let file = file.trim_matches(['.', '_', '-']);
    // The ending and the name of a temporary file must fit in 255 bytes.
    let (file, _) = beginning(file, 180);
    let first = file.split('.').next().unwrap_or_default().to_lowercase();
    match DEVICES.contains(&first.trim_end_matches(|c: char| c.is_numeric())) {
        true => format!("student-{file}"),
        false if file.is_empty() => "submission".to_owned(),
        false => file.to_owned(),
    }
}
