//! Moodle VPL: what `vpl_execution` prints, <https://vpl.dis.ulpgc.es>.
//!
//! VPL obeys lines that begin with `Comment :=>>` or `Grade :=>>`, and the last grade wins. So every line
//! that may hold words of a submission begins with `>`, which shows it as it is.

use std::fmt::Write;

use super::Graded;
use super::plain::one_line;
use super::text::{face, graded_by, lines, notes, said, sum};
use super::words::Words;
use crate::grading::judge::verdict::Status;
use crate::number::decimals;

/// The comments and, last, the grade on a scale from `scale[0]` to `scale[1]`.
pub fn vpl(graded: &Graded, scale: [f64; 2], words: &Words) -> String {
    let report = &graded.report;
    let mut text = format!("Comment :=>> {}\n<|--\n", sum(report, words));
    let shown = graded.shown(true).count();
    for (check, status) in graded.shown(true) {
        let sign = face(report, *check, status).sign();
        let title = (words.grade.check)(*check).title;
        let _ = writeln!(text, "-{sign} {}: {title}", check.id());
        for line in lines(graded, *check, status, words) {
            let _ = writeln!(text, "{}", as_it_is(&line));
        }
        if let Status::Failed(failure) = status {
            for line in said(failure, words).iter().flat_map(|said| said.lines()) {
                let _ = writeln!(text, "{}", as_it_is(line));
            }
        }
    }
    if shown < report.checks.len() {
        let _ = writeln!(
            text,
            "{}",
            as_it_is(&format!("{} {}", words.hidden, report.checks.len() - shown))
        );
    }
    for line in notes(report, words) {
        let _ = writeln!(text, "{}", as_it_is(&line));
    }
    let how = one_line(&graded_by(graded, words));
    let _ = writeln!(text, "{}\n--|>", as_it_is(&how));
    let grade = scale[0] + (scale[1] - scale[0]) * report.percent() / 100.0;
    let _ = writeln!(text, "Grade :=>> {}", decimals(grade, 2));
    text
}

/// A line that VPL shows and does not read.
fn as_it_is(line: &str) -> String {
    format!(">{line}")
}
