//! Scenario files: TOML whose keys are the long flag names with `_` for `-`.

use std::path::Path;

use super::error::ScenarioError;
use super::settings::Settings;

/// Reads the scenario file `path`.
///
/// Unknown keys are errors that name the nearest known one; mistakes are told with line and column.
pub fn read(path: &Path) -> Result<Settings, ScenarioError> {
    let text = std::fs::read_to_string(path).map_err(|source| ScenarioError::Unreadable {
        path: path.to_owned(),
        source,
    })?;
    parse(&text, path)
}

/// Reads a scenario from `text`; `path` is for messages only.
pub fn parse(text: &str, path: &Path) -> Result<Settings, ScenarioError> {
    toml::from_str(text).map_err(|error| {
        let (line, column) = line_and_column(text, error.span().map_or(0, |span| span.start));
        let message = message(error.message());
        ScenarioError::Malformed {
            path: path.to_owned(),
            line,
            column,
            message,
        }
    })
}

fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before = text.get(..offset).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    (
        before.matches('\n').count() + 1,
        before[line_start..].chars().count() + 1,
    )
}

/// The parser's message; for an unknown key, with the nearest known one.
fn message(original: &str) -> String {
    let mut quoted = original.split('`').skip(1).step_by(2);
    match (original.starts_with("unknown field"), quoted.next()) {
        (true, Some(unknown)) => {
            let known: Vec<&str> = quoted.collect();
            let advice = match did_you_mean(unknown, &known) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("known keys are {}", known.join(", ")),
            };
            format!("unknown key `{unknown}`; {advice}")
        }
        _ => original.trim_end().replace('\n', " "),
    }
}

/// The known word nearest to `word`, if one is near enough to be meant.
pub fn did_you_mean<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    let likeness = |known: &&str| strsim::jaro_winkler(&word.replace('-', "_"), known);
    known
        .iter()
        .copied()
        .max_by(|a, b| likeness(a).total_cmp(&likeness(b)))
        .filter(|near| likeness(near) > 0.75)
}
