//! Gradescope's `results.json`:
//! <https://gradescope-autograders.readthedocs.io/en/latest/specs/>.

use serde_json::{Value, json};

use super::text::{all, causes, graded_by, notes, sum};
use super::words::Words;
use super::{Graded, VERSION};
use crate::grading::judge::check::Check;
use crate::grading::judge::verdict::Status;

/// Legal at any time, also while checks are still to come.
///
/// A check that is not judged carries no points. So the sum of the tests is what was earned, of what
/// could be judged; the score of the whole is the same part of the points of all checks, which is what the
/// assignment is worth. Until all checks are there, it is what was earned: nothing is given in advance.
pub fn gradescope(graded: &Graded, words: &Words) -> Value {
    let report = &graded.report;
    let score = match graded.is_partial {
        true => report.earned(),
        false => report.percent() / 100.0 * graded.all_points(),
    };
    let tests: Vec<Value> = report
        .checks
        .iter()
        .enumerate()
        .map(|(k, (check, status))| test(graded, k + 1, *check, status, words))
        .collect();
    json!({
        "score": exact(score),
        "execution_time": graded.seconds,
        "output": output(graded, words),
        "output_format": "text",
        "test_output_format": "text",
        "test_name_format": "text",
        "visibility": "visible",
        // What programs print could tell of hidden checks.
        "stdout_visibility": "hidden",
        "extra_data": {
            "schema": "parsim2d/grade/v1",
            "version": VERSION,
            "percent": report.percent(),
            "causes": causes(graded),
            "partial": graded.is_partial,
        },
        "tests": tests,
    })
}

fn test(graded: &Graded, k: usize, check: Check, status: &Status, words: &Words) -> Value {
    let report = &graded.report;
    let (earned, lost) = report.score(check, status);
    let cause = match status {
        Status::Failed(failure) => failure.cause,
        _ => None,
    };
    let mut test = json!({
        "name": (words.grade.check)(check).title,
        "number": k.to_string(),
        "output": all(graded, check, status, words),
        "tags": [check.id()],
        "visibility": report.rubric().visibility_of(check),
        "extra_data": {"id": check.id(), "cause": cause},
    });
    if earned + lost > 0.0 {
        test["score"] = exact(earned).into();
        test["max_score"] = exact(earned + lost).into();
    }
    match status {
        Status::Passed => test["status"] = "passed".into(),
        Status::Failed(_) => test["status"] = "failed".into(),
        Status::NotSeen | Status::Skipped(_) | Status::Masked => {}
    }
    test
}

fn output(graded: &Graded, words: &Words) -> String {
    let report = &graded.report;
    let mut lines = vec![sum(report, words)];
    if graded.is_partial {
        lines.push(words.partial.to_owned());
    } else if report.open() > 1e-9 {
        lines.push(words.scaled.to_owned());
    }
    lines.extend(notes(report, words));
    lines.push(graded_by(graded, words));
    lines.join("\n")
}

/// Without the dust of sums.
fn exact(points: f64) -> f64 {
    (1e6 * points).round() / 1e6 + 0.0
}
