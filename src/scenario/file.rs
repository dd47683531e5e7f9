//! Scenario files: TOML whose keys are the long flag names with `_` for `-`.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::error::ScenarioError;
use super::malformed;
use super::nearest::did_you_mean;
use super::settings::Settings;
use super::wished::{Wish, wish};
use crate::echo;

/// Reads the scenario file `path`.
///
/// Unknown keys are errors that name the nearest known one, or say what is not there; mistakes are told with line and column.
pub fn read(path: &Path) -> Result<Settings, ScenarioError> {
    let unreadable = |source: io::Error| ScenarioError::Unreadable {
        path: path.to_owned(),
        source: match source.kind() {
            io::ErrorKind::InvalidData => {
                io::Error::other("it is not UTF-8, in which editors save plain text")
            }
            _ => source,
        },
    };
    let mut text = String::new();
    File::open(path)
        .and_then(|file| file.take(MOST_BYTES + 1).read_to_string(&mut text))
        .map_err(unreadable)?;
    if text.len() as u64 > MOST_BYTES {
        return Err(ScenarioError::TooLong { path: path.to_owned(), most: MOST_BYTES });
    }
    parse(&text, path)
}

/// The longest scenario file, bytes: some 400,000 listed discs, which take a gigabyte of memory to be understood.
const MOST_BYTES: u64 = 16_000_000;

/// Reads a scenario from `text`; `path` is for messages only.
pub fn parse(text: &str, path: &Path) -> Result<Settings, ScenarioError> {
    toml::from_str(text).map_err(|error| {
        let (line, column) = line_and_column(text, error.span().map_or(0, |span| span.start));
        let message = malformed::sentence(error.message(), text, line)
            .map_or_else(|| message(error.message()), |sentence| echo::sentence(&sentence));
        ScenarioError::Malformed { path: path.to_owned(), line, column, message }
    })
}

fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before = text.get(..offset).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}

/// The parser's message in the words of a person; for an unknown key or name, with the nearest
/// known one.
fn message(original: &str) -> String {
    let mut quoted = original.split('`').skip(1).step_by(2);
    let is_unknown_key = original.starts_with("unknown field");
    if let (true, Some(unknown)) =
        (is_unknown_key || original.starts_with("unknown variant"), quoted.next())
    {
        let kind = if is_unknown_key { "key" } else { "name" };
        if let Some(Wish { lacks, nearest, .. }) = wish(unknown) {
            return format!("unknown {kind} `{unknown}`: {lacks}\n  way out: {nearest}");
        }
        let known: Vec<&str> = quoted.collect();
        let advice = match did_you_mean(unknown, &known) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("known are {}", known.join(", ")),
        };
        return format!("unknown {kind} `{}`; {advice}", echo::value(unknown));
    }
    let plain = original.trim_end().replace('\n', " ").replace("i64", "a whole number");
    let plain = echo::sentence(&plain);
    if plain.contains("invalid type: map, expected a sequence") {
        return "a list of tables is wanted: write [[disc]] or [[population]], in two brackets"
            .into();
    }
    if plain.starts_with("expected [x, y], found 4 numbers") {
        return format!("{plain}; numbers take a dot, not a comma");
    }
    plain
}
