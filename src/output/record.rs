//! `last-run.toml`: the scenario of the last run of a folder, to run again, and what came out of it.
//!
//! The results stand in comments, `# result: NAME = VALUE`, so that the file stays a scenario.

use std::io::Write;
use std::path::Path;

use super::OutputError;
use super::place::plain_text;
use super::replace::replace;

/// Its name in the output folder.
pub const FILE: &str = "last-run.toml";

/// The result that is the command as it was typed.
pub const COMMAND: &str = "command";

const RESULT: &str = "# result: ";

/// Whether a run has written this `text` of such a file.
pub fn is_one(text: &str) -> bool {
    text.starts_with("# parsim2d ")
}

/// Whether `folder` holds the record of a run.
pub fn is_there(folder: &Path) -> bool {
    std::fs::read_to_string(folder.join(FILE)).is_ok_and(|text| is_one(&text))
}

/// Whether `folder` holds a file of this name that no run has written: somebody's own. An empty one is
/// nobody's loss.
pub fn is_foreign(folder: &Path) -> bool {
    let text = plain_text(&folder.join(FILE));
    text.is_ok_and(|text| !text.trim().is_empty() && !is_one(&text))
}

/// Writes the scenario `text` and `results`, each `NAME = VALUE`, into `folder`.
pub fn write(folder: &Path, text: &str, results: &[String]) -> Result<(), OutputError> {
    replace(&folder.join(FILE), |out| {
        write!(out, "{text}")?;
        results.iter().try_for_each(|result| writeln!(out, "{RESULT}{result}"))
    })
}

/// The results in the text of such a file, as names and values; none if the run has not ended.
pub fn results(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.lines().filter_map(|line| line.strip_prefix(RESULT)?.split_once(" = "))
}
