//! CodeGrade's custom test: what it reads from file descriptor 3.

use serde_json::json;

use super::Graded;

/// A line of JSON: the part of the points, 0 to 1.
pub fn codegrade(graded: &Graded) -> String {
    let part = (1e4 * graded.report.percent() / 100.0).floor() / 1e4;
    format!("{}\n", json!({"tag": "points", "points": part.to_string()}))
}
