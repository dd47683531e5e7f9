//! The heading of a table: names of columns.

use crate::output::frames::layout::Layout;
use crate::output::frames::separator::{Separator, shortened};

/// The words of a heading; a unit of its own belongs to the name before it.
pub fn words_of(text: &str) -> Vec<String> {
    // A blank inside quotes parts nothing, and in a name it is as good as a line below.
    let in_quotes = |(k, part): (usize, &str)| match k % 2 {
        1 => part.replace(' ', "_"),
        _ => part.to_owned(),
    };
    let parts: Vec<String> = text.split('"').enumerate().map(in_quotes).collect();
    let text = parts
        .join("\"")
        .replace(" (", "(")
        .replace(" [", "[")
        .replace("_(", "(")
        .replace("_[", "[");
    let words: Vec<String> = match text.contains('\t') {
        true => text.split('\t').map(str::to_owned).collect(),
        false => Separator::of(&text).words(&text).map(str::to_owned).collect(),
    };
    words
}

/// The columns that a heading names; all discs have this `radius` (m) where none of them says it.
pub fn named(text: &str, radius: Option<f64>) -> Result<Layout, String> {
    let words = words_of(text);
    let heading = format!("heading `{}`", shortened(text));
    let layout = Layout::named(words.iter().map(String::as_str)).map_err(|why| {
        let columns = match words.len() {
            0..3 => "x,y with --radius 1e-3",
            3 => "x,y,r",
            _ => "x,y,-,r",
        };
        format!(
            "{why} ({heading})\n  way out: --columns {columns} says by hand which column is what"
        )
    })?;
    layout.with_radius(radius, &heading)
}
