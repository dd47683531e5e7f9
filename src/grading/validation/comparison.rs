//! What came out beside what was expected, and the table of both: the confusion matrix.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::described::{Described, Expected};
use crate::grading::judge::check::Check;
use crate::grading::judge::mistake::Mistake;
use crate::grading::judge::verdict::{Report, Status};

/// One described submission, graded.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Its folder's name, and that of the folder above.
    pub name: String,
    /// The group it is in: the name of the folder above.
    pub group: String,
    /// What was expected.
    pub expected: Expected,
    /// Checks that failed, with the mistake named.
    pub failed: Vec<(Check, Option<&'static str>)>,
    /// Earned of what was decided, per cent.
    pub percent: f64,
    /// Checks that were not decided for want of material.
    pub not_seen: Vec<Check>,
}

impl Comparison {
    /// The comparison of `report` for what is `described`.
    pub fn of(described: &Described, report: &Report) -> Self {
        let part = |path: Option<&std::path::Path>| {
            path.and_then(|path| path.file_name())
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned()
        };
        let failed = report.failures().map(|(check, why)| (check, why.cause.map(Mistake::id)));
        let not_seen = report.checks.iter().filter(|(_, status)| *status == Status::NotSeen);
        Self {
            name: part(Some(&described.path)),
            group: part(described.path.parent()),
            expected: described.expected.clone(),
            failed: failed.collect(),
            percent: report.percent(),
            not_seen: not_seen.map(|(check, _)| *check).collect(),
        }
    }

    /// What is not as expected; nothing if all is.
    pub fn surprises(&self) -> Vec<String> {
        let Expected { marks, check, cause, also } = &self.expected;
        let mut surprises = Vec::new();
        if marks.as_deref() == Some("full") && self.percent < 100.0 {
            surprises.push(format!("{:.0} % where full marks were expected", self.percent));
        }
        for (failed, named) in &self.failed {
            let is_expected = check.as_deref() == Some(failed.id());
            if !is_expected && !also.iter().any(|other| other == failed.id()) {
                surprises.push(format!("{} failed ({})", failed.id(), named.unwrap_or("-")));
            }
        }
        let Some(check) = check else { return surprises };
        match self.failed.iter().find(|(failed, _)| failed.id() == check) {
            None => surprises.push(format!("{check} did not fail")),
            Some((_, named)) if cause.is_some() && *named != cause.as_deref() => {
                let (named, wanted) = (named.unwrap_or("nothing"), cause.as_deref().unwrap_or("-"));
                surprises.push(format!("{check} named {named} where {wanted} is the mistake"));
            }
            Some(_) => {}
        }
        surprises
    }
}

/// The confusion matrix as a table in Markdown: for each mistake that was made (in a row), which checks
/// failed with which mistake named, and how often; then how many came out as expected.
pub fn matrix(comparisons: &[Comparison]) -> String {
    let mut rows: BTreeMap<String, (usize, usize, BTreeMap<String, usize>)> = BTreeMap::new();
    for comparison in comparisons {
        let Expected { check, cause, .. } = &comparison.expected;
        let made = match check {
            None => "(none)".to_owned(),
            Some(check) => format!("{check}: {}", cause.as_deref().unwrap_or("-")),
        };
        let (all, right, named) = rows.entry(made).or_default();
        *all += 1;
        *right += usize::from(comparison.surprises().is_empty());
        if comparison.failed.is_empty() {
            *named.entry("(full marks)".to_owned()).or_default() += 1;
        }
        for (check, cause) in &comparison.failed {
            *named.entry(format!("{}: {}", check.id(), cause.unwrap_or("-"))).or_default() += 1;
        }
    }
    let mut text = "| made | submissions | as expected | what the grader says, how often |\n\
                    |---|--:|--:|---|\n"
        .to_owned();
    for (made, (all, right, named)) in rows {
        let named: Vec<_> = named.iter().map(|(name, times)| format!("{name} ({times})")).collect();
        let _ = writeln!(text, "| {made} | {all} | {right} | {} |", named.join(", "));
    }
    let mut groups: BTreeMap<&str, [usize; 2]> = BTreeMap::new();
    for comparison in comparisons {
        let [all, right] = groups.entry(&comparison.group).or_default();
        *all += 1;
        *right += usize::from(comparison.surprises().is_empty());
    }
    for (group, [all, right]) in groups {
        let _ = write!(text, "\n{group}: {right} of {all} as expected\n");
    }
    text
}
