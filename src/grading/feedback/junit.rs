//! JUnit XML, as GitLab, GitHub, Jenkins and CodeGrade read it; there is no standard, and
//! <https://github.com/testmoapp/junitxml> is what all agree on.

use std::fmt::Write;

use maud::html;

use super::plain::one_line;
use super::text::{all, found, tier};
use super::words::Words;
use super::{Entry, Graded, VERSION};
use crate::grading::judge::check::Check;
use crate::grading::judge::mistake::Mistake;
use crate::grading::judge::rubric::Visibility;
use crate::grading::judge::verdict::Status;
use crate::number::cut;

/// A suite for each submission, a case for each check; one that could not be graded is an error.
pub fn junit(entries: &[Entry], words: &Words) -> String {
    let mut xml =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"parsim2d grade\">\n"
            .to_owned();
    for entry in entries {
        match entry {
            Ok(graded) => xml += &suite(graded, words),
            Err(ungraded) => {
                let [name, why] =
                    [&ungraded.name, &ungraded.why].map(|text| escaped(&one_line(text)));
                let _ = writeln!(
                    xml,
                    "<testsuite name=\"{name}\" tests=\"1\" failures=\"0\" errors=\"1\" skipped=\"0\" time=\"0\">\n\
                     <testcase name=\"grading\" classname=\"{name}\" time=\"0\"><error message=\"{why}\"/></testcase>\n</testsuite>"
                );
            }
        }
    }
    xml + "</testsuites>\n"
}

fn suite(graded: &Graded, words: &Words) -> String {
    let shown: Vec<_> = graded.shown(true).collect();
    let failures = shown.iter().filter(|(_, s)| matches!(s, Status::Failed(_))).count();
    let skipped = shown
        .iter()
        .filter(|(_, s)| matches!(s, Status::Skipped(_) | Status::NotSeen | Status::Masked))
        .count();
    let name = escaped(&one_line(&graded.name));
    let mut xml = format!(
        "<testsuite name=\"{name}\" tests=\"{}\" failures=\"{failures}\" errors=\"0\" skipped=\"{skipped}\" time=\"{:.3}\">\n<properties>\n",
        shown.len(),
        graded.seconds,
    );
    let properties = [
        ("percent", cut(graded.report.percent())),
        ("tier", one_line(tier(graded, words))),
        ("version", VERSION.to_owned()),
    ];
    for (key, value) in properties {
        let _ = writeln!(xml, "<property name=\"{key}\" value=\"{}\"/>", escaped(&value));
    }
    xml += "</properties>\n";
    for (check, status) in shown {
        xml += &case(graded, *check, status, &name, words);
    }
    xml + "</testsuite>\n"
}

fn case(graded: &Graded, check: Check, status: &Status, suite: &str, words: &Words) -> String {
    debug_assert_ne!(graded.report.rubric().visibility_of(check), Visibility::Hidden);
    let title = escaped(&format!("{}: {}", check.id(), (words.grade.check)(check).title));
    let text = escaped(&all(graded, check, status, words));
    let inside = match status {
        Status::Passed => String::new(),
        Status::Failed(failure) => {
            let message = escaped(&found(failure, words));
            let kind = failure.cause.map_or(check.id(), Mistake::id);
            format!("<failure message=\"{message}\" type=\"{kind}\">{text}</failure>")
        }
        Status::NotSeen | Status::Skipped(_) | Status::Masked => {
            format!("<skipped message=\"{text}\"/>")
        }
    };
    // Frames are judged together: no check has a time of its own.
    format!("<testcase name=\"{title}\" classname=\"{suite}\" time=\"0\">{inside}</testcase>\n")
}

/// Text as XML has it, in an attribute or between tags.
fn escaped(text: &str) -> String {
    html! { (text) }.into_string()
}
