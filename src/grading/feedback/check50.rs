//! JSON in the manner of check50, <https://cs50.readthedocs.io/projects/check50/en/latest/json_specification/>.

use serde_json::{Value, json};

use super::text::{found, lines, said};
use super::words::Words;
use super::{Graded, VERSION};
use crate::grading::judge::check::Check;
use crate::grading::judge::verdict::Status;

/// Passed is true, false, or null for what was not judged.
pub fn check50(graded: &Graded, words: &Words) -> Value {
    let results: Vec<Value> =
        graded.shown(true).map(|(check, status)| result(graded, *check, status, words)).collect();
    json!({"slug": "parsim2d/grade", "results": results, "version": VERSION})
}

fn result(graded: &Graded, check: Check, status: &Status, words: &Words) -> Value {
    let passed = match status {
        Status::Passed => Some(true),
        Status::Failed(_) => Some(false),
        Status::NotSeen | Status::Skipped(_) | Status::Masked => None,
    };
    let (mut cause, mut log) = (Value::Null, Vec::new());
    match status {
        Status::Passed => {}
        Status::NotSeen | Status::Skipped(_) | Status::Masked => {
            cause =
                json!({"rationale": lines(graded, check, status, words).join(" "), "help": null});
        }
        Status::Failed(failure) => {
            let table = words.grade;
            cause = json!({
                "rationale": found(failure, words),
                "expected": (table.finding)(failure.finding).expected,
                "help": failure.cause.map(|mistake| graded.report.hint(mistake, table)),
            });
            log = lines(graded, check, status, words);
            log.extend(
                said(failure, words).iter().flat_map(|said| said.lines()).map(str::to_owned),
            );
        }
    }
    let needs = check.needs().filter(|needed| graded.report.status(*needed).is_some());
    let (earned, lost) = graded.report.score(check, status);
    json!({
        "name": check.id(),
        "description": (words.grade.check)(check).title,
        "passed": passed,
        "log": log,
        "cause": cause,
        "data": {"score": earned, "max_score": earned + lost},
        "dependency": needs.map(Check::id),
    })
}
