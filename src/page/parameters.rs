//! The parameters of a run, from the text of its record: what a student looks up first.

use maud::{Markup, html};

use super::html::{list as names_and_values, table};
use super::words::Words;
use crate::number::{shortest, time_step};

/// Listed discs and groups that a page has room for.
const MOST_LISTED: usize = 8;

/// Keys that tell nothing while they are off.
const OFF: [&str; 2] = ["allow_unstable", "border"];

/// The keys of the record `text` with their values and units, and the time step `dt` (s).
pub fn list(text: &str, dt: Option<f64>, words: &Words) -> Markup {
    let keys = text.lines().take_while(|line| !line.starts_with("[["));
    let named = |line| {
        let (key, value) = parsed(line)?;
        if value == "false" && OFF.contains(&key) {
            return None;
        }
        let name = words.parameter_names.iter().find(|(known, _)| *known == key);
        Some((name.map_or(key, |(_, name)| name).to_owned(), value))
    };
    let mut rows: Vec<_> = keys.filter_map(named).collect();
    rows.extend(dt.map(|dt| (words.time_step.to_owned(), time_step(dt))));
    names_and_values(&rows)
}

/// The discs and groups that the record lists, a line each, as far as there is room; nothing if there are
/// none.
pub fn listed(text: &str, words: &Words) -> Markup {
    let blocks: Vec<&str> = text.split("\n[[").skip(1).collect();
    let shown = &blocks[..blocks.len().min(MOST_LISTED)];
    let rows_of = |same: &[&str]| {
        let cells = |block: &&str| block.lines().filter_map(cell).collect::<Vec<_>>();
        let head = cells(&same[0]).into_iter().map(|(key, _)| key);
        let head = std::iter::once(kind(same[0]).to_owned()).chain(head).collect();
        let row = |(k, block): (usize, &&str)| {
            let values = cells(block).into_iter().map(|(_, value)| value);
            std::iter::once(k.to_string()).chain(values).collect()
        };
        std::iter::once(head).chain(same.iter().enumerate().map(row)).collect::<Vec<_>>()
    };
    let more = blocks.len() - shown.len();
    html! {
        @for same in shown.chunk_by(|a, b| kind(a) == kind(b)) { (table(&rows_of(same))) }
        @if more > 0 { p { (words.more_listed.replace("{}", &more.to_string())) } }
    }
}

/// `disc` or `population`.
fn kind(block: &str) -> &str {
    block.split("]]").next().unwrap_or_default()
}

/// Key with its unit, and value, of a line of a block.
fn cell(line: &str) -> Option<(String, String)> {
    let (key, rest) = line.split_once(" = ")?;
    let (value, unit) = rest.split_once(" # ").unwrap_or((rest, ""));
    let comma = if unit.is_empty() { "" } else { ", " };
    Some((format!("{key}{comma}{unit}"), value.to_owned()))
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
    let value = rounded.map_or(value.to_owned(), shortest);
    Some((key, format!("{value} {unit}").trim_end().to_owned()))
}
