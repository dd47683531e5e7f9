//! The page of a class: who has what, how points are spread, which mistakes to teach again.

use std::fmt::Write;

use maud::{Markup, PreEscaped, html};

use super::document::{Paper, document, paragraph};
use super::plain::one_line;
use super::student::legend;
use super::survey::{BINS, checks, distribution, graded, median, mistakes};
use super::text::{causes, face};
use super::words::Words;
use super::{Entry, Graded, VERSION};
use crate::figure::svg::{Anchor, Area, Svg};
use crate::grading::judge::check::Check;
use crate::number::cut;
use crate::page::html::{section, wide};

/// One self-contained page. `files` are the names of the students' pages beside it, in the order of the
/// entries; none for no links.
pub fn html_of_class(entries: &[Entry], files: &[String], words: &Words) -> String {
    let [one, several, middle] = words.class_line;
    let submissions = if entries.len() == 1 { one } else { several };
    let mut line = format!("{} {submissions}", entries.len());
    if let Some(median) = median(entries) {
        let _ = write!(line, "; {middle}: {}", cut(median));
    }
    let body = html! {
        h1 { (words.class) }
        (paragraph("sum", &line))
        (rows(entries, files, words))
        (legend(words))
        (ungraded(entries, words))
        (section(words.mistakes, &taught_again(entries, words)))
        (section(words.distribution, &html! {
            figure.bins {
                (PreEscaped(bins(&distribution(entries))))
                figcaption { (words.distribution_caption) }
            }
        }))
        (paragraph("legend", &format!("parsim2d {VERSION}")))
    };
    document(words.grade.code, words.class, Paper::Across, &body)
}

fn rows(entries: &[Entry], files: &[String], words: &Words) -> Markup {
    let checks = checks(entries);
    let [whose, part, looks_like] = words.class_head;
    wide(&html! {
        table {
            thead {
                tr {
                    th.left { (whose) }
                    th { (part) }
                    @for check in &checks { th.up { span { (check.id()) } } }
                    th.left { (looks_like) }
                }
            }
            tbody {
                @for (k, entry) in entries.iter().enumerate() {
                    @if let Ok(graded) = entry { (row(graded, files.get(k), &checks, words)) }
                }
            }
        }
    })
}

fn row(graded: &Graded, file: Option<&String>, checks: &[Check], words: &Words) -> Markup {
    let name = one_line(&graded.name);
    html! {
        tr {
            td.left.name {
                @if let Some(file) = file { a href={ (address(file)) ".html" } { (name) } }
                @else { (name) }
            }
            td.number { (cut(graded.report.percent())) }
            @for check in checks {
                @if let Some(status) = graded.report.status(*check) {
                    @let face = face(&graded.report, *check, status);
                    td class=(face.id()) title={ (check.id()) ": " ((words.face)(face)) } { (face.sign()) }
                } @else {
                    td {}
                }
            }
            td.left { (causes(graded).join(", ")) }
        }
    }
}

/// A name of a file as part of an address.
fn address(file: &str) -> String {
    let mut address = String::new();
    for byte in file.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'_' | b'.' => {
                address.push(byte as char)
            }
            _ => {
                let _ = write!(address, "%{byte:02X}");
            }
        }
    }
    address
}

fn ungraded(entries: &[Entry], words: &Words) -> Markup {
    let all: Vec<_> = entries.iter().filter_map(|entry| entry.as_ref().err()).collect();
    html! {
        @if !all.is_empty() {
            (section(words.ungraded, &html! {
                @for ungraded in all {
                    p { strong { (one_line(&ungraded.name)) } ": " (one_line(&ungraded.why)) }
                }
            }))
        }
    }
}

fn taught_again(entries: &[Entry], words: &Words) -> Markup {
    let all = mistakes(entries);
    if all.is_empty() {
        return html! { p { (words.no_mistakes) } };
    }
    let [what, count, check] = words.mistakes_head;
    let students = graded(entries).count();
    let [of, ..] = words.grade.points;
    wide(&html! {
        table {
            thead { tr { th.left { (what) } th { (count) } th.left { (check) } } }
            tbody {
                @for (mistake, checks, count) in all {
                    tr {
                        td.left {
                            @if let Some(mistake) = mistake {
                                ((words.grade.mistake)(mistake).looks_like) " [" (mistake.id()) "]"
                            } @else {
                                (words.unknown_mistake)
                            }
                        }
                        td { (count) " " (of) " " (students) }
                        td.left { (checks.into_iter().map(Check::id).collect::<Vec<_>>().join(", ")) }
                    }
                }
            }
        }
    })
}

/// A bar for each ten per cent, with its count.
fn bins(counts: &[usize; BINS]) -> String {
    const HIGH: f64 = 120.0; // px
    const WIDE: f64 = 60.0; // px
    const BELOW: f64 = 24.0; // px, for the labels
    let mut svg = Svg::new(WIDE * BINS as f64, HIGH + 2.0 * BELOW);
    let most = counts.iter().copied().max().unwrap_or(0).max(1) as f64;
    for (k, &count) in counts.iter().enumerate() {
        let left = WIDE * k as f64;
        let height = HIGH * count as f64 / most;
        let top = BELOW + HIGH - height;
        let bar = Area { left: left + 3.0, top, width: WIDE - 6.0, height };
        svg.rectangle(bar, "fill=\"#3b6ea5\"");
        let middle = left + WIDE / 2.0;
        if count > 0 {
            svg.text((middle, top - 5.0), Anchor::Middle, &count.to_string());
        }
        let last = if k + 1 == BINS { 100 } else { 10 * k + 9 };
        svg.text((middle, HIGH + 2.0 * BELOW - 7.0), Anchor::Middle, &format!("{}–{last}", 10 * k));
    }
    svg.finish()
}
