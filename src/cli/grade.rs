//! `parsim2d grade`: judges frames that a submission wrote.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use serde_json::json;

use super::Failure;
use crate::grade::add_film;
use crate::grade::check::Check;
use crate::grade::frames::Footage;
use crate::grade::rubric::{COMMENTED, Rubric};
use crate::grade::verdict::{self, Report, Status};
use crate::grade::words::ENGLISH;

pub(super) const EXAMPLES: &str = "\
Examples:
  parsim2d grade --frames out.txt                    faces, points, causes and hints
  parsim2d grade --frames a.txt b.txt --json         for a script; ids are stable
  parsim2d grade --init-rubric > course.toml         the numbers and points of a course
  parsim2d grade --frames out.txt --rubric course.toml --fail-under 60
  parsim2d grade --explain free_flight               what a check measures, and why

Exit codes: 0 graded whatever the score, 1 below --fail-under, 2 usage or rubric error, 3 a file cannot be read.";

#[derive(Args)]
pub(super) struct GradeArguments {
    /// Files of frames, `x y r` a line, blank lines between frames
    #[arg(long, value_name = "FILE", num_args = 1..)]
    #[arg(required_unless_present_any = ["explain", "init_rubric"])]
    #[arg(conflicts_with_all = ["explain", "init_rubric"])]
    frames: Vec<PathBuf>,
    /// The numbers and points of the course
    #[arg(long, value_name = "RUBRIC.toml")]
    rubric: Option<PathBuf>,
    /// One JSON object for each file, in a list
    #[arg(long, requires = "frames")]
    json: bool,
    /// With a small picture of each failure, as SVG in the JSON
    #[arg(long, requires = "json")]
    pictures: bool,
    /// Exit with 1 if a file has less
    #[arg(long, value_name = "PERCENT", requires = "frames", value_parser = percent)]
    fail_under: Option<f64>,
    /// Say what a check measures, and why
    #[arg(long, value_name = "CHECK")]
    explain: Option<String>,
    /// Print a commented rubric with the usual numbers
    #[arg(long)]
    init_rubric: bool,
}

fn percent(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    match (0.0..=100.0).contains(&value) {
        true => Ok(value),
        false => Err("per cent, 0 to 100".to_owned()),
    }
}

/// Why nothing was graded.
#[derive(Debug, thiserror::Error)]
pub(super) enum GradeError {
    #[error("{} cannot be read: {source}", path.display())]
    Frames { path: PathBuf, source: io::Error },
    #[error("the rubric {} cannot be used: {why}\n  way out: parsim2d grade --init-rubric prints one to begin with", path.display())]
    Rubric { path: PathBuf, why: String },
    #[error("there is no check `{id}`; checks are {}", ids().join(", "))]
    Check { id: String },
}

impl GradeError {
    pub(super) fn exit_code(&self) -> u8 {
        match self {
            Self::Frames { .. } => 3,
            Self::Rubric { .. } | Self::Check { .. } => 2,
        }
    }
}

fn ids() -> Vec<&'static str> {
    Check::ALL.into_iter().map(Check::id).collect()
}

pub(super) fn run(arguments: &GradeArguments) -> Result<ExitCode, Failure> {
    let rubric = arguments.rubric.as_deref().map(rubric).transpose()?.unwrap_or_default();
    let mut out = io::stdout().lock();
    if arguments.init_rubric {
        write!(out, "{COMMENTED}")?;
        return Ok(ExitCode::SUCCESS);
    }
    if let Some(id) = &arguments.explain {
        explain(&mut out, id, &rubric)?;
        return Ok(ExitCode::SUCCESS);
    }
    let mut graded = Vec::new();
    for path in &arguments.frames {
        let bytes =
            fs::read(path).map_err(|source| GradeError::Frames { path: path.clone(), source })?;
        let mut report = Report::of_frames(&rubric);
        let film = add_film(&mut report, Footage::File(&bytes), &rubric);
        graded.push((path, report, film.filter(|_| arguments.pictures)));
    }
    if arguments.json {
        let all: Vec<_> = graded
            .iter()
            .map(|(path, report, film)| {
                let mut value = report.json_with_pictures(&ENGLISH, film.as_ref());
                value["file"] = json!(path.display().to_string());
                value
            })
            .collect();
        serde_json::to_writer_pretty(&mut out, &all).map_err(io::Error::from)?;
        writeln!(out)?;
    } else {
        for (path, report, _) in &graded {
            write_text(&mut out, path, report)?;
        }
    }
    let is_below = |limit: f64| graded.iter().any(|(_, report, _)| report.percent() < limit);
    Ok(ExitCode::from(u8::from(arguments.fail_under.is_some_and(is_below))))
}

fn rubric(path: &Path) -> Result<Rubric, GradeError> {
    let refused = |why: String| GradeError::Rubric { path: path.to_owned(), why };
    let text = fs::read_to_string(path).map_err(|why| refused(why.to_string()))?;
    Rubric::parse(&text).map_err(refused)
}

fn explain(out: &mut impl Write, id: &str, rubric: &Rubric) -> Result<(), Failure> {
    let check = Check::named(id).ok_or_else(|| GradeError::Check { id: id.to_owned() })?;
    let (said, [points, after]) = ((ENGLISH.check)(check), ENGLISH.worth);
    writeln!(out, "{id}: {} ({} {points})", said.title, rubric.points_of(check))?;
    writeln!(out, "{}", said.explained)?;
    if let Some(needed) = check.needs() {
        writeln!(out, "{after}: {}", needed.id())?;
    }
    Ok(())
}

fn write_text(out: &mut impl Write, path: &Path, report: &Report) -> io::Result<()> {
    writeln!(out, "{}", path.display())?;
    for (check, status) in &report.checks {
        let title = (ENGLISH.check)(*check).title;
        let face = match status {
            Status::Passed => ":)",
            Status::Failed(_) => ":(",
            Status::NotSeen | Status::Skipped(_) => ":|",
        };
        writeln!(out, "{face} {}: {title}", check.id())?;
        match status {
            Status::Passed => {}
            Status::NotSeen => writeln!(out, "    {}", ENGLISH.not_seen)?,
            Status::Skipped(root) => writeln!(out, "    {} {}", ENGLISH.skipped, root.id())?,
            Status::Failed(failure) => write_failure(out, failure, report)?,
        }
    }
    for (name, count) in ENGLISH.left_out.into_iter().zip([report.torn, report.uneven]) {
        if count > 0 {
            writeln!(out, "{name} {count}")?;
        }
    }
    for note in &report.notes {
        writeln!(out, "{}", (ENGLISH.note)(*note))?;
    }
    let (earned, lost, open) = (report.earned(), report.lost(), report.open());
    let [of, points, not_judged] = ENGLISH.points;
    write!(out, "{earned} {of} {} {points} ({:.0} %)", earned + lost, report.percent())?;
    if open > 0.0 {
        write!(out, "; {open} {not_judged}")?;
    }
    writeln!(out)
}

fn write_failure(
    out: &mut impl Write,
    failure: &verdict::Failure,
    report: &Report,
) -> io::Result<()> {
    let found = (ENGLISH.finding)(failure.finding);
    write!(out, "    {}", found.what)?;
    if let Some(frame) = failure.frame {
        write!(out, "; {} {frame}", ENGLISH.frame)?;
    }
    for disc in &failure.discs {
        write!(out, ", {} {disc}", ENGLISH.discs)?;
    }
    writeln!(out)?;
    for (quantity, value) in &failure.numbers {
        writeln!(out, "    {}: {}", (ENGLISH.quantity)(*quantity), short(*value))?;
    }
    writeln!(out, "    {}: {}", ENGLISH.expected, found.expected)?;
    if let Some(mistake) = failure.cause {
        let looks_like = (ENGLISH.mistake)(mistake).looks_like;
        writeln!(out, "    {}: {looks_like} [{}]", ENGLISH.looks_like, mistake.id())?;
        writeln!(out, "    {}: {}", ENGLISH.hint, report.hint(mistake, &ENGLISH))?;
    }
    Ok(())
}

/// Four digits are enough to read.
fn short(value: f64) -> String {
    match value.abs() {
        size if size == 0.0 || (1e-3..1e5).contains(&size) => {
            format!("{:.4}", value).trim_end_matches('0').trim_end_matches('.').to_owned()
        }
        _ => format!("{value:.3e}"),
    }
}
