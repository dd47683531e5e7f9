//! The parameters of a run, from the text of its record: what a student looks up first.

use super::html::{self, escaped};
use super::words::Words;

/// Lines of listed discs and groups that a page has room for.
const MOST_LINES: usize = 24;

/// The keys of the record `text` with their values and units, and the time step `dt` (s).
pub fn list(text: &str, dt: Option<f64>, words: &Words) -> String {
    let keys = text.lines().take_while(|line| !line.starts_with("[["));
    let named = |line| {
        let (key, value) = parsed(line)?;
        let name = words.parameter_names.iter().find(|(known, _)| *known == key);
        Some((name.map_or(key, |(_, name)| name).to_owned(), value))
    };
    let mut rows: Vec<_> = keys.filter_map(named).collect();
    rows.extend(dt.map(|dt| (words.time_step.to_owned(), format!("{} s", number(dt, Some(6))))));
    html::list(&rows)
}

/// The discs and groups that the record lists, as far as there is room; nothing if there are none.
pub fn listed(text: &str, words: &Words) -> String {
    let lines: Vec<&str> = text.lines().skip_while(|line| !line.starts_with("[[")).collect();
    if lines.is_empty() {
        return String::new();
    }
    let shown = lines[..lines.len().min(MOST_LINES)].join("\n");
    let more = match lines.len().saturating_sub(MOST_LINES) {
        0 => String::new(),
        more => format!("<p>{}</p>\n", escaped(&words.more_lines.replace("{}", &more.to_string()))),
    };
    format!("<pre>{}</pre>\n{more}", escaped(&shown))
}

/// Key and value of a line `key = value # unit`; nothing for a remark or an empty line.
fn parsed(line: &str) -> Option<(&str, String)> {
    let (key, rest) = line.split_once(" = ").filter(|_| !line.starts_with('#'))?;
    if rest.starts_with(['"', '\'']) {
        return Some((key, rest.trim_matches(['"', '\'']).to_owned()));
    }
    let (value, unit) = rest.split_once(" # ").unwrap_or((rest, ""));
    // A remark on the direction follows some units.
    let unit = unit.split(',').next().unwrap_or_default();
    // A whole number, a seed of twenty digits say, stays as it is.
    let rounded = value.parse().ok().filter(|_| value.contains(['.', 'e']));
    let value = rounded.map_or(value.to_owned(), |value| number(value, None));
    Some((key, format!("{value} {unit}").trim_end().to_owned()))
}

/// A number of so many digits, or of as many as it takes.
fn number(value: f64, digits: Option<usize>) -> String {
    let value = match digits {
        Some(digits) => format!("{value:.*e}", digits - 1).parse().unwrap_or(value),
        None => value,
    };
    match value.abs() {
        size if size == 0.0 || (1e-3..1e16).contains(&size) => format!("{value}"),
        _ => format!("{value:e}"),
    }
}
