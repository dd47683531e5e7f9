//! The sheet to hand back: a student's points, check by check.

use maud::{Markup, html};

use super::Graded;
use super::document::{Paper, document, paragraph};
use super::plain::{beginning, one_line, plain};
use super::text::{
    face, found, graded_by, is_kept_back, is_untold, is_without_tests, notes, numbers, said,
    said_by, sum,
};
use super::words::{Face, Words};
use crate::grading::judge::check::Check;
use crate::grading::judge::rubric::Rubric;
use crate::grading::judge::verdict::{Failure, Status};
use crate::number::{cut, decimals, shortest};
use crate::page::html::{figure, list, section};

/// The longest log of a page, bytes.
const LONGEST_LOG: usize = 16_384;

/// One self-contained page. Checks that the rubric hides are counted and not shown.
pub fn html_of_student(graded: &Graded, words: &Words) -> String {
    let title = format!("{} {}", words.sheet, one_line(&graded.name));
    let notes = notes(&graded.report, words);
    let hidden = graded.report.checks.len() - graded.shown(false).count();
    let body = html! {
        (head(graded, &title, words))
        @if !notes.is_empty() {
            (section(words.notes, &html! { @for note in &notes { p { (note) } } }))
        }
        (section(words.checks, &html! {
            @for (check, status) in graded.shown(false) { (article(graded, *check, status, words)) }
            @if hidden > 0 { p { (words.hidden) " " (hidden) } }
        }))
        (log(graded, words))
        (section(words.how, &list(&how(graded, words))))
        (section(words.rubric, &list(&measures(graded.report.rubric(), words))))
    };
    document(words.grade.code, &title, Paper::Upright, &body)
}

fn head(graded: &Graded, title: &str, words: &Words) -> Markup {
    html! {
        h1 { (title) }
        p.sum { (sum(&graded.report, words)) }
        div.bar { span style={ "width:" (cut(graded.report.percent())) "%" } {} }
        @if graded.is_partial { (paragraph("partial", words.partial)) }
    }
}

fn article(graded: &Graded, check: Check, status: &Status, words: &Words) -> Markup {
    let report = &graded.report;
    let face = face(report, check, status);
    let title = (words.grade.check)(check).title;
    let [of, _] = words.grade.points;
    let (earned, lost) = report.score(check, status);
    let all = report.points_of(check);
    let (all, name) = (decimals(all, 2), words.grade.points_of(all));
    let score = match earned + lost > 0.0 {
        true => format!("{} {of} {all} {name}", decimals(earned, 2)),
        false => (words.face)(face).to_owned(),
    };
    let inside = match status {
        Status::Passed => html! {},
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
    html! {
        article class={ "check " (face.id()) } id=(check.id()) {
            h3 {
                span.sign title=((words.face)(face)) { (face.sign()) }
                span.title { (title) }
                span.points { (score) }
            }
            (inside)
        }
    }
}

fn explained(graded: &Graded, check: Check, failure: &Failure, words: &Words) -> Markup {
    let table = words.grade;
    let numbers: Vec<_> =
        numbers(failure, words).map(|(name, value)| (name.to_owned(), value)).collect();
    let text = html! {
        (named(words.found, &found(failure, words)))
        @if !numbers.is_empty() { (list(&numbers)) }
        (named(table.expected, (table.finding)(failure.finding).expected))
        @if let Some(mistake) = failure.cause {
            (named(table.looks_like, (table.mistake)(mistake).looks_like))
            p.hint { strong { (table.hint) ":" } " " (plain(graded.report.hint(mistake, table))) }
        }
    };
    html! {
        @if let Some(drawn) = graded.pictures.get(&check) {
            @let k = Check::ALL.iter().position(|known| *known == check).unwrap_or(0);
            div.beside { div { (text) } (figure(k, drawn, words.picture)) }
        } @else {
            (text)
        }
        @if let Some(text) = said(failure, words) {
            @if let Some(heading) = said_by(failure, words) { (paragraph("kind", heading)) }
            pre { (text) }
        }
    }
}

fn named(name: &str, text: &str) -> Markup {
    html! { p { strong { (name) ":" } " " (text) } }
}

fn log(graded: &Graded, words: &Words) -> Markup {
    let text = plain(&graded.log);
    let (start, is_cut) = beginning(text.trim(), LONGEST_LOG);
    html! {
        @if !start.is_empty() {
            (section(words.log, &html! {
                pre { (start) }
                @if is_cut { (paragraph("kind", words.cut)) }
            }))
        }
    }
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
        shortest(rubric.side),
        any(rubric.radius.iter().map(|r| shortest(*r)).collect()),
        shortest(rubric.mass),
        shortest(rubric.gravity),
        shortest(rubric.kn),
        shortest(rubric.eta),
        e(true),
        e(false),
    ];
    words.rubric_rows.iter().map(|name| (*name).to_owned()).zip(values).collect()
}

/// What each sign means.
pub(super) fn legend(words: &Words) -> Markup {
    let said = Face::ALL.map(|face| format!("{} {}", face.sign(), (words.face)(face)));
    paragraph("legend", &said.join("   "))
}
