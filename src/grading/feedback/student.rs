//! The sheet to hand back: a student's points, check by check.

use std::fmt::Write;

use super::Graded;
use super::document::{Paper, document, picture, printed, section};
use super::number::{percent, points};
use super::plain::{beginning, one_line, plain};
use super::text::{
    face, found, graded_by, is_kept_back, is_untold, is_without_tests, notes, numbers, said,
    said_by, sum,
};
use super::words::{Face, Words};
use crate::grading::judge::check::Check;
use crate::grading::judge::rubric::Rubric;
use crate::grading::judge::verdict::{Failure, Status};
use crate::page::html::{escaped, list};

/// The longest log of a page, bytes.
const LONGEST_LOG: usize = 16_384;

/// One self-contained page. Checks that the rubric hides are counted and not shown.
pub fn html_of_student(graded: &Graded, words: &Words) -> String {
    let title = format!("{} {}", words.sheet, one_line(&graded.name));
    let checks: String =
        graded.shown(false).map(|(check, status)| article(graded, *check, status, words)).collect();
    let hidden = graded.report.checks.len() - graded.shown(false).count();
    let hidden = match hidden {
        0 => String::new(),
        count => format!("<p>{} {count}</p>\n", escaped(words.hidden)),
    };
    let mut body = head(graded, &title, words);
    let notes = notes(&graded.report, words);
    if !notes.is_empty() {
        let notes: String =
            notes.iter().map(|note| format!("<p>{}</p>\n", escaped(note))).collect();
        body += &section(words.notes, &notes);
    }
    body += &section(words.checks, &(checks + &hidden));
    body += &log(graded, words);
    body += &section(words.how, &list(&how(graded, words)));
    body += &section(words.rubric, &list(&measures(graded.report.rubric(), words)));
    document(words.grade.code, &title, Paper::Upright, &body)
}

fn head(graded: &Graded, title: &str, words: &Words) -> String {
    let part = percent(graded.report.percent());
    let mut html = format!(
        "<h1>{}</h1>\n<p class=\"sum\">{}</p>\n<div class=\"bar\"><span style=\"width:{part}%\"></span></div>\n",
        escaped(title),
        escaped(&sum(&graded.report, words)),
    );
    if graded.is_partial {
        let _ = writeln!(html, "<p class=\"partial\">{}</p>", escaped(words.partial));
    }
    html
}

fn article(graded: &Graded, check: Check, status: &Status, words: &Words) -> String {
    let report = &graded.report;
    let face = face(report, check, status);
    let title = (words.grade.check)(check).title;
    let [of, _] = words.grade.points;
    let (earned, lost) = report.score(check, status);
    let all = report.points_of(check);
    let (all, name) = (points(all), words.grade.points_of(all));
    let score = match earned + lost > 0.0 {
        true => format!("{} {of} {all} {name}", points(earned)),
        false => (words.face)(face).to_owned(),
    };
    let inside = match status {
        Status::Passed => String::new(),
        Status::NotSeen if is_untold(report, check) => paragraph("kind", words.not_told),
        Status::NotSeen if is_without_tests(report, check) => paragraph("kind", words.no_interface),
        Status::NotSeen | Status::Masked => paragraph("kind", (words.kindly)(face)),
        Status::Skipped(root) if is_kept_back(graded, *root) => {
            paragraph("kind", (words.kindly)(Face::NotSeen))
        }
        Status::Skipped(root) => {
            let root = (words.grade.check)(*root).title;
            paragraph("kind", &format!("{} {root}.", (words.kindly)(face)))
        }
        Status::Failed(failure) => explained(graded, check, failure, words),
    };
    format!(
        "<article class=\"check {}\" id=\"{}\">\n<h3><span class=\"sign\" title=\"{said}\">{}</span>\
         <span class=\"title\">{}</span><span class=\"points\">{}</span></h3>\n{inside}</article>\n",
        face.id(),
        check.id(),
        face.sign(),
        escaped(title),
        escaped(&score),
        said = escaped((words.face)(face)),
    )
}

fn paragraph(class: &str, text: &str) -> String {
    format!("<p class=\"{class}\">{}</p>\n", escaped(text))
}

fn explained(graded: &Graded, check: Check, failure: &Failure, words: &Words) -> String {
    let table = words.grade;
    let mut html = named(words.found, &found(failure, words));
    let numbers: Vec<_> =
        numbers(failure, words).map(|(name, value)| (name.to_owned(), value)).collect();
    if !numbers.is_empty() {
        html += &list(&numbers);
    }
    html += &named(table.expected, (table.finding)(failure.finding).expected);
    if let Some(mistake) = failure.cause {
        html += &named(table.looks_like, (table.mistake)(mistake).looks_like);
        let hint = plain(graded.report.hint(mistake, table));
        let _ = writeln!(
            html,
            "<p class=\"hint\"><strong>{}:</strong> {}</p>",
            escaped(table.hint),
            escaped(&hint)
        );
    }
    if let Some(drawn) = graded.pictures.get(&check) {
        let k = Check::ALL.iter().position(|known| *known == check).unwrap_or(0);
        let figure = picture(k, drawn, words.picture);
        html = format!("<div class=\"beside\"><div>\n{html}</div>\n{figure}</div>\n");
    }
    match said(failure, words) {
        Some(text) => {
            let heading = said_by(failure, words).map(|heading| paragraph("kind", heading));
            html + &heading.unwrap_or_default() + &printed(&text)
        }
        None => html,
    }
}

fn named(name: &str, text: &str) -> String {
    format!("<p><strong>{}:</strong> {}</p>\n", escaped(name), escaped(text))
}

fn log(graded: &Graded, words: &Words) -> String {
    let text = plain(&graded.log);
    let (start, is_cut) = beginning(text.trim(), LONGEST_LOG);
    if start.is_empty() {
        return String::new();
    }
    let cut = if is_cut { paragraph("kind", words.cut) } else { String::new() };
    section(words.log, &(printed(start) + &cut))
}

/// What it was graded with.
fn how(graded: &Graded, words: &Words) -> Vec<(String, String)> {
    let report = &graded.report;
    let values = [
        graded_by(graded, words),
        report.frames.to_string(),
        report.discs.to_string(),
        format!("{:.1}", graded.seconds),
    ];
    let rows = words.how_rows.into_iter().zip(values);
    // Who was timed by nobody took no time.
    let rows = rows.take(if graded.seconds > 0.0 { 4 } else { 3 });
    rows.map(|(name, value)| (name.to_owned(), value)).collect()
}

/// The numbers of the rubric.
fn measures(rubric: &Rubric, words: &Words) -> Vec<(String, String)> {
    let any = |values: Vec<String>| match values.is_empty() {
        true => words.any.to_owned(),
        false => values.join(", "),
    };
    let e = |is_wall| {
        let (low, high) = rubric.expected_restitution(is_wall);
        match high - low < 5e-4 {
            true => format!("{low:.3}"),
            false => format!("{low:.3} … {high:.3}"),
        }
    };
    let values = [
        any(rubric.n.iter().map(usize::to_string).collect()),
        rubric.side.to_string(),
        any(rubric.radius.iter().map(|r| format!("{r:e}")).collect()),
        rubric.mass.to_string(),
        rubric.gravity.to_string(),
        format!("{:e}", rubric.kn),
        format!("{:e}", rubric.eta),
        e(true),
        e(false),
    ];
    words.rubric_rows.iter().map(|name| (*name).to_owned()).zip(values).collect()
}

/// What each sign means.
pub(super) fn legend(words: &Words) -> String {
    let said = Face::ALL.map(|face| format!("{} {}", face.sign(), (words.face)(face)));
    paragraph("legend", &said.join("   "))
}
