//! The command line as it was typed.

use std::path::Path;

use crate::output::written::Written;

/// Flags that change no file of a run: where it writes, how often checkpoints, who computes it.
const ELSEWHERE: [&str; 3] = ["--out-dir", "--checkpoint-every", "--threads"];

/// The words behind the program's name, as they were typed.
pub(super) fn after_name() -> Vec<String> {
    std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect()
}

/// The words of the command as they were typed, without the folder it wrote to: the same command leaves the
/// same files in any folder.
fn words() -> Vec<String> {
    let words: Vec<String> = std::iter::once("parsim2d".to_owned()).chain(after_name()).collect();
    ELSEWHERE.iter().fold(words, |words, flag| without(words, flag))
}

/// The same with the seed that was drawn for them, if one was: as such they repeat the run.
pub(super) fn words_with(drawn: Option<u64>) -> Vec<String> {
    let seed = drawn.map(|seed| ["--seed".to_owned(), seed.to_string()]);
    words().into_iter().chain(seed.into_iter().flatten()).collect()
}

/// The words as one line for a shell.
pub(super) fn line(words: &[String]) -> String {
    words.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(" ")
}

/// The command that, from the start, leaves the files of a run with the end `time` (s) and the
/// intervals that it was begun with.
pub(super) fn with_new_end(command: &[String], time: f64, written: &Written) -> Vec<String> {
    let mut words = without(command.to_vec(), "--time");
    for (flag, steps) in
        [("--every", written.frame_every), ("--energy-every", written.energy_every)]
    {
        let is_said = |word: &String| word == flag || word.starts_with(&format!("{flag}="));
        if !words.iter().any(is_said) {
            words.extend([flag.to_owned(), steps.to_string()]);
        }
    }
    words.extend(["--time".to_owned(), format!("{time:?}")]);
    words
}

/// `words` without `flag` and its value.
fn without(words: Vec<String>, flag: &str) -> Vec<String> {
    let mut words = words.into_iter();
    let mut left = Vec::new();
    while let Some(word) = words.next() {
        if word == flag {
            words.next();
        } else if !word.starts_with(&format!("{flag}=")) {
            left.push(word);
        }
    }
    left
}

/// `word` as a shell takes it for one, on one line.
pub(super) fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "-_./:=+,%@".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        return word.to_owned();
    }
    let one_line = word.replace(|c: char| c.is_control(), " ");
    format!("'{}'", one_line.replace('\'', r"'\''"))
}

/// `path` as a person would type it.
pub(super) fn shown(path: &Path) -> String {
    let bare = path.strip_prefix(".").unwrap_or(path);
    let said = if bare.as_os_str().is_empty() { path } else { bare }; // `.` itself
    said.to_string_lossy().into_owned()
}
