//! Our own JSON: a submission (`parsim2d/grade/v1`) and a class (`parsim2d/class/v1`).

use serde_json::{Value, json};

use super::survey::{graded, median, mistakes};
use super::words::Words;
use super::{Entry, Graded, VERSION};
use crate::grading::judge::check::Check;

/// A submission: its report, with name, folder, tier, log, and pictures if asked for.
pub fn json_of_student(graded: &Graded, pictures: bool, words: &Words) -> Value {
    let mut value = graded.report.json(words.grade);
    value["version"] = VERSION.into();
    value["name"] = graded.name.as_str().into();
    value["file"] = graded.folder.as_str().into();
    value["tier"] = Some(&graded.tier).filter(|tier| !tier.is_empty()).cloned().into();
    value["log"] = graded.log.as_str().into();
    value["seconds"] = graded.seconds.into();
    value["partial"] = graded.is_partial.into();
    for (k, (check, _)) in graded.report.checks.iter().enumerate().filter(|_| pictures) {
        if let Some(picture) = graded.pictures.get(check) {
            value["checks"][k]["failure"]["picture"] = picture.as_str().into();
        }
    }
    value
}

/// A class: every submission, those that could not be graded, and which mistakes were made how often.
pub fn json_of_class(entries: &[Entry], words: &Words) -> Value {
    let submissions: Vec<_> =
        graded(entries).map(|graded| json_of_student(graded, false, words)).collect();
    let ungraded = entries.iter().filter_map(|entry| entry.as_ref().err());
    let ungraded: Vec<_> = ungraded.map(|u| json!({"name": u.name, "why": u.why})).collect();
    let mistakes = mistakes(entries).into_iter().map(|(mistake, checks, count)| {
        let checks: Vec<&str> = checks.into_iter().map(Check::id).collect();
        json!({"cause": mistake, "checks": checks, "submissions": count})
    });
    json!({
        "schema": "parsim2d/class/v1",
        "version": VERSION,
        "median_percent": median(entries),
        "mistakes": mistakes.collect::<Vec<_>>(),
        "submissions": submissions,
        "not_graded": ungraded,
    })
}
