//! What is said of a check, in plain lines; and the same for a terminal.

use std::fmt::Write;

use super::plain::{LONGEST, beginning, one_line, plain};
use super::words::{Face, Words};
use super::{Entry, Graded, VERSION, name_of};
use crate::grading::judge::check::Check;
use crate::grading::judge::mistake::Mistake;
use crate::grading::judge::rubric::Visibility;
use crate::grading::judge::verdict::{Failure, Report, Status};
use crate::grading::judge::words::Finding;
use crate::number::{at_most, cut, decimals};

/// How a check came out.
pub fn face(report: &Report, check: Check, status: &Status) -> Face {
    match status {
        Status::Passed => Face::Passed,
        Status::Failed(_) if report.score(check, status).0 > 0.0 => Face::Partly,
        Status::Failed(_) => Face::Failed,
        Status::NotSeen => Face::NotSeen,
        Status::Skipped(_) => Face::Skipped,
        Status::Masked => Face::Masked,
    }
}

/// What was found, with frame and discs.
pub fn found(failure: &Failure, words: &Words) -> String {
    let words = words.grade;
    let mut line = (words.finding)(failure.finding).what.to_owned();
    if let Some(frame) = failure.frame {
        let _ = write!(line, "; {} {frame}", words.frame);
    }
    for disc in &failure.discs {
        let _ = write!(line, ", {} {disc}", words.discs);
    }
    if let Some(wall) = failure.wall {
        let _ = write!(line, ", {}", (words.wall)(wall));
    }
    line
}

/// Numbers of a failure, each with its name.
pub fn numbers<'a>(
    failure: &'a Failure,
    words: &'a Words,
) -> impl Iterator<Item = (&'static str, String)> + 'a {
    let named = |(quantity, value)| ((words.grade.quantity)(quantity), at_most(value, 4));
    failure.numbers.iter().copied().map(named)
}

/// What a tool printed, fit to be shown.
pub fn said(failure: &Failure, words: &Words) -> Option<String> {
    let text = plain(failure.said.as_deref()?);
    let (start, is_cut) = beginning(text.trim_end(), LONGEST);
    Some(if is_cut { format!("{start}\n{}", words.cut) } else { start.to_owned() })
}

/// The heading of what a tool printed; names of files and lines of frames have their own.
pub fn said_by(failure: &Failure, words: &Words) -> Option<&'static str> {
    let has_own =
        [Finding::FileMissing, Finding::NoRows, Finding::MostlyTorn, Finding::WritesTooMuch];
    (!has_own.contains(&failure.finding)).then_some(words.said)
}

/// Everything that is said of a check, but for its title and what a tool printed.
pub fn lines(graded: &Graded, check: Check, status: &Status, words: &Words) -> Vec<String> {
    match status {
        Status::Passed => Vec::new(),
        Status::NotSeen if is_untold(&graded.report, check) => {
            vec![words.grade.not_told.to_owned()]
        }
        Status::NotSeen if is_without_tests(&graded.report, check) => {
            vec![words.grade.no_interface.to_owned()]
        }
        Status::NotSeen => vec![words.grade.not_seen.to_owned()],
        Status::Masked => vec![words.grade.masked.to_owned()],
        // Not a word of a check that students are not to see.
        Status::Skipped(root) if is_kept_back(graded, *root) => {
            vec![words.grade.not_seen.to_owned()]
        }
        Status::Skipped(root) => vec![format!("{} {}", words.grade.skipped, root.id())],
        Status::Failed(failure) => failure_lines(graded, failure, words),
    }
}

/// Whether a check was not asked because the rubric has no unit tests.
pub fn is_without_tests(report: &Report, check: Check) -> bool {
    check == Check::Interface && report.rubric().interface.is_none()
}

/// Whether a check was not asked because the program is not told how many discs.
pub fn is_untold(report: &Report, check: Check) -> bool {
    let program = &report.rubric().program;
    check == Check::Many && program.many > 0 && !program.tells_n()
}

/// Whether students are not to see a check, now or ever.
pub fn is_kept_back(graded: &Graded, check: Check) -> bool {
    graded.report.rubric().visibility_of(check) != Visibility::Visible
}

fn failure_lines(graded: &Graded, failure: &Failure, words: &Words) -> Vec<String> {
    let said = words.grade;
    let mut lines = vec![found(failure, words)];
    lines.extend(numbers(failure, words).map(|(name, value)| format!("{name}: {value}")));
    let expected = (said.finding)(failure.finding).expected;
    lines.push(format!("{}: {expected}", said.expected));
    if let Some(mistake) = failure.cause {
        let looks_like = (said.mistake)(mistake).looks_like;
        lines.push(format!("{}: {looks_like} [{}]", said.looks_like, mistake.id()));
        let hint = one_line(graded.report.hint(mistake, said));
        lines.push(format!("{}: {hint}", said.hint));
    }
    lines
}

/// The same with what a tool printed, as one text.
pub fn all(graded: &Graded, check: Check, status: &Status, words: &Words) -> String {
    let mut lines = lines(graded, check, status, words);
    if let Status::Failed(failure) = status {
        if let Some(text) = said(failure, words) {
            lines.extend(said_by(failure, words).map(|heading| format!("{heading}:")));
            lines.push(text);
        }
    }
    lines.join("\n")
}

/// What is good to know beside the checks.
pub fn notes(report: &Report, words: &Words) -> Vec<String> {
    let left_out = words.grade.left_out.into_iter().zip([report.torn, report.uneven]);
    let left_out = left_out.filter(|(_, count)| *count > 0);
    let left_out = left_out.map(|(name, count)| format!("{name} {count}"));
    let notes = report.notes.iter().map(|note| (words.grade.note)(*note).to_owned());
    left_out.chain(notes).collect()
}

/// Points and per cent.
pub fn sum(report: &Report, words: &Words) -> String {
    let [of, not_judged] = words.grade.points;
    let (earned, lost, open) = (report.earned(), report.lost(), report.open());
    let name = words.grade.points_of(earned + lost);
    let [earned, decided] = [earned, earned + lost].map(|points| decimals(points, 2));
    let mut line = format!("{earned} {of} {decided} {name} ({} %)", cut(report.percent()));
    let open = decimals(open, 2);
    if open != "0" {
        let _ = write!(line, "; {open} {not_judged}");
    }
    line
}

/// What graded it, for a student; and that nothing was run, if so. How it was kept apart is for instructors.
pub fn graded_by(graded: &Graded, words: &Words) -> String {
    match graded.tier.as_str() {
        "" => format!("parsim2d {VERSION}; {}", words.no_tier),
        _ => format!("parsim2d {VERSION}"),
    }
}

/// How it was kept apart.
pub fn tier<'a>(graded: &'a Graded, words: &'a Words) -> &'a str {
    if graded.tier.is_empty() { words.no_tier } else { &graded.tier }
}

/// A submission for a terminal.
pub fn text_of_student(graded: &Graded, words: &Words) -> String {
    let mut text = format!("{}\n", one_line(&graded.name));
    for (check, status) in &graded.report.checks {
        let face = match status {
            Status::Passed => ":)",
            Status::Failed(_) => ":(",
            Status::NotSeen | Status::Skipped(_) | Status::Masked => ":|",
        };
        let _ = writeln!(text, "{face} {}: {}", check.id(), (words.grade.check)(*check).title);
        for line in lines(graded, *check, status, words) {
            let _ = writeln!(text, "    {line}");
        }
        if let Status::Failed(failure) = status {
            for line in said(failure, words).iter().flat_map(|said| said.lines()) {
                let _ = writeln!(text, "    | {line}");
            }
        }
    }
    for line in notes(&graded.report, words) {
        let _ = writeln!(text, "{line}");
    }
    if !graded.tier.is_empty() {
        let _ = writeln!(text, "{}: {}", words.sandbox, one_line(&graded.tier));
    }
    let _ = writeln!(text, "{}", sum(&graded.report, words));
    text
}

/// The table of a class for a terminal: whose, per cent, what it looks like.
pub fn text_of_class(entries: &[Entry], words: &Words) -> String {
    let names: Vec<String> = entries.iter().map(|entry| one_line(name_of(entry))).collect();
    let [whose, part, looks_like] = words.class_head;
    let longest = names.iter().map(|name| name.chars().count()).max().unwrap_or(0);
    let width = longest.clamp(whose.chars().count(), 48);
    let mut text = format!("{whose:width$} {part:>6}  {looks_like}\n");
    for (name, entry) in names.iter().zip(entries) {
        let rest = match entry {
            Ok(graded) => {
                format!("{:>6}  {}", cut(graded.report.percent()), causes(graded).join(", "))
            }
            Err(ungraded) => format!("{:>6}  {}", "?", one_line(&ungraded.why)),
        };
        let _ = writeln!(text, "{}", format!("{name:width$} {rest}").trim_end());
    }
    text
}

/// Ids of the mistakes, or of the checks where no mistake is known, in order, each once.
pub fn causes(graded: &Graded) -> Vec<&'static str> {
    let mut causes = Vec::new();
    for (check, failure) in graded.report.failures() {
        let id = failure.cause.map_or(check.id(), Mistake::id);
        if !causes.contains(&id) {
            causes.push(id);
        }
    }
    causes
}
