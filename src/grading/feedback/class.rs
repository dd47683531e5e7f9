//! The page of a class: who has what, how points are spread, which mistakes to teach again.

use std::fmt::Write;

use super::document::{Paper, document, section, wide};
use super::number::percent;
use super::plain::one_line;
use super::student::legend;
use super::survey::{BINS, checks, distribution, graded, median, mistakes};
use super::text::{causes, face};
use super::words::Words;
use super::{Entry, Graded, VERSION};
use crate::figure::svg::{Anchor, Area, Svg};
use crate::grading::judge::check::Check;
use crate::page::html::escaped;

/// One self-contained page. `files` are the names of the students' pages beside it, in the order of the
/// entries; none for no links.
pub fn html_of_class(entries: &[Entry], files: &[String], words: &Words) -> String {
    let [one, several, middle] = words.class_line;
    let submissions = if entries.len() == 1 { one } else { several };
    let mut line = format!("{} {submissions}", entries.len());
    if let Some(median) = median(entries) {
        let _ = write!(line, "; {middle}: {}", percent(median));
    }
    let bins = bins(&distribution(entries));
    let caption = escaped(words.distribution_caption);
    let figure =
        format!("<figure class=\"bins\">\n{bins}<figcaption>{caption}</figcaption>\n</figure>\n");
    let mut body =
        format!("<h1>{}</h1>\n<p class=\"sum\">{}</p>\n", escaped(words.class), escaped(&line));
    body += &rows(entries, files, words);
    body += &legend(words);
    body += &ungraded(entries, words);
    body += &section(words.mistakes, &taught_again(entries, words));
    body += &section(words.distribution, &figure);
    let _ = writeln!(body, "<p class=\"legend\">parsim2d {VERSION}</p>");
    document(words.grade.code, words.class, Paper::Across, &body)
}

fn rows(entries: &[Entry], files: &[String], words: &Words) -> String {
    let checks = checks(entries);
    let [whose, part, looks_like] = words.class_head.map(escaped);
    let mut html = format!("<table>\n<thead><tr><th class=\"left\">{whose}</th><th>{part}</th>");
    for check in &checks {
        let _ = write!(html, "<th class=\"up\"><span>{}</span></th>", check.id());
    }
    let _ = writeln!(html, "<th class=\"left\">{looks_like}</th></tr></thead>\n<tbody>");
    for (k, entry) in entries.iter().enumerate() {
        if let Ok(graded) = entry {
            html += &row(graded, files.get(k), &checks, words);
        }
    }
    wide(&(html + "</tbody>\n</table>\n"))
}

fn row(graded: &Graded, file: Option<&String>, checks: &[Check], words: &Words) -> String {
    let name = escaped(&one_line(&graded.name));
    let name = match file {
        Some(file) => format!("<a href=\"{}.html\">{name}</a>", address(file)),
        None => name,
    };
    let part = percent(graded.report.percent());
    let mut html =
        format!("<tr><td class=\"left name\">{name}</td><td class=\"number\">{part}</td>");
    for check in checks {
        let Some(status) = graded.report.status(*check) else {
            html += "<td></td>";
            continue;
        };
        let face = face(&graded.report, *check, status);
        let said = escaped(&format!("{}: {}", check.id(), (words.face)(face)));
        let (class, sign) = (face.id(), face.sign());
        let _ = write!(html, "<td class=\"{class}\" title=\"{said}\">{sign}</td>");
    }
    let _ = writeln!(html, "<td class=\"left\">{}</td></tr>", escaped(&causes(graded).join(", ")));
    html
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

fn ungraded(entries: &[Entry], words: &Words) -> String {
    let rows: String = entries
        .iter()
        .filter_map(|entry| entry.as_ref().err())
        .map(|ungraded| {
            let [name, why] = [&ungraded.name, &ungraded.why].map(|text| escaped(&one_line(text)));
            format!("<p><strong>{name}</strong>: {why}</p>\n")
        })
        .collect();
    if rows.is_empty() { rows } else { section(words.ungraded, &rows) }
}

fn taught_again(entries: &[Entry], words: &Words) -> String {
    let all = mistakes(entries);
    if all.is_empty() {
        return format!("<p>{}</p>\n", escaped(words.no_mistakes));
    }
    let [what, count, check] = words.mistakes_head.map(escaped);
    let mut html = format!(
        "<table>\n<thead><tr><th class=\"left\">{what}</th><th>{count}</th><th class=\"left\">{check}</th></tr></thead>\n<tbody>\n"
    );
    let students = graded(entries).count();
    for (mistake, checks, count) in all {
        let what = match mistake {
            Some(mistake) => {
                format!("{} [{}]", (words.grade.mistake)(mistake).looks_like, mistake.id())
            }
            None => words.unknown_mistake.to_owned(),
        };
        let checks: Vec<&str> = checks.into_iter().map(Check::id).collect();
        let [what, checks] = [what, checks.join(", ")].map(|text| escaped(&text));
        let [of, ..] = words.grade.points;
        let _ = writeln!(
            html,
            "<tr><td class=\"left\">{what}</td><td>{count} {of} {students}</td><td class=\"left\">{checks}</td></tr>"
        );
    }
    wide(&(html + "</tbody>\n</table>\n"))
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
