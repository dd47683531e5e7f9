//! The class as a table for spreadsheets: a row a submission.

use super::plain::{cell, one_line};
use super::survey::checks;
use super::text::causes;
use super::{Entry, Graded};
use crate::grading::judge::check::Check;
use crate::number::{cut, decimals};

/// Columns before and after the checks.
const BEFORE: [&str; 5] = ["name", "percent", "earned", "lost", "open"];
const AFTER: [&str; 4] = ["causes", "tier", "seconds", "not_graded"];

/// Comma-separated values with a head; a check's column holds the points earned, and is empty where it was
/// not judged. Names that a spreadsheet would take for formulas begin with `'`.
pub fn csv_of_class(entries: &[Entry]) -> String {
    let checks = checks(entries);
    let mut out = ::csv::Writer::from_writer(Vec::new());
    let ids = checks.iter().map(|check| check.id());
    let mut rows = vec![BEFORE.into_iter().chain(ids).chain(AFTER).map(str::to_owned).collect()];
    rows.extend(entries.iter().map(|entry| row(entry, &checks)));
    let written = rows.iter().try_for_each(|row: &Vec<String>| out.write_record(row));
    // Memory takes everything, and all rows are equally long.
    debug_assert!(written.is_ok(), "{written:?}");
    String::from_utf8(out.into_inner().unwrap_or_default()).unwrap_or_default()
}

fn row(entry: &Entry, checks: &[Check]) -> Vec<String> {
    let graded = match entry {
        Ok(graded) => graded,
        Err(ungraded) => {
            let mut row = vec![cell(&ungraded.name)];
            row.resize(BEFORE.len() + checks.len() + AFTER.len() - 1, String::new());
            row.push(cell(&ungraded.why));
            return row;
        }
    };
    let report = &graded.report;
    let mut row = vec![cell(&graded.name), cut(report.percent())];
    row.extend([report.earned(), report.lost(), report.open()].map(without_dust));
    row.extend(checks.iter().map(|check| earned(graded, *check)));
    row.extend([
        causes(graded).join(";"),
        cell(&one_line(&graded.tier)),
        format!("{:.1}", graded.seconds),
        String::new(),
    ]);
    row
}

/// Points without the dust of sums.
fn without_dust(points: f64) -> String {
    decimals(points, 6)
}

fn earned(graded: &Graded, check: Check) -> String {
    let status = graded.report.status(check);
    let score = status.map(|status| graded.report.score(check, status));
    score
        .filter(|(earned, lost)| earned + lost > 0.0)
        .map_or_else(String::new, |(x, _)| without_dust(x))
}
