//! `parsim2d report`: one self-contained HTML page of a run, to hand in.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;

use super::claim::shown;
use super::plot::{FrameFile, ledger, pooled_speeds};
use super::refusal::Refusal;
use super::typed::quoted;
use super::{Failure, answer};
use crate::figure::Figure;
use crate::figure::frame::{self, Choice, ColourBy, has_velocities};
use crate::figure::{energy, speeds};
use crate::output::failure;
use crate::output::record;
use crate::output::replace::replace;
use crate::page::report::Report;
use crate::page::words::ENGLISH;
use crate::scenario::Scenario;
use crate::scenario::file;

pub(super) const EXAMPLES: &str = "\
Examples:
  parsim2d report                          the run in this folder: report.html
  parsim2d report . -o handed_in.html      under another name
  parsim2d report --help                   this text

The page needs no network and prints well: parameters, diagnosis, energy, frames, speeds.";

#[derive(Args)]
pub(super) struct ReportArguments {
    /// Folder of the run
    #[arg(value_name = "DIR", default_value = ".")]
    folder: PathBuf,
    /// The page [default: report.html in that folder]
    #[arg(short, long, value_name = "FILE.html")]
    out: Option<PathBuf>,
}

/// Why there is no report. Nothing has been written when this is returned.
#[derive(Debug, thiserror::Error)]
pub(super) enum ReportError {
    #[error(
        "{} tells of no run: {source}\n  way out: run parsim2d in that folder first, or name another folder",
        path.display()
    )]
    NoRun { path: PathBuf, source: io::Error },
    #[error("--out {} is not possible: {why}\n  way out: --out report.html", path.display())]
    BadOut { path: PathBuf, why: &'static str },
}

pub(super) fn report(arguments: &ReportArguments) -> Result<ExitCode, Failure> {
    let folder = &arguments.folder;
    if folder.is_file() {
        let why = format!("{} is a file, not the folder of a run", shown(folder));
        let folder = folder.parent().filter(|above| !above.as_os_str().is_empty());
        let folder = folder.map_or(".".to_owned(), |folder| quoted(&shown(folder)));
        return Err(Refusal { why, way_out: format!("parsim2d report {folder}") }.into());
    }
    let out = arguments.out.clone().unwrap_or_else(|| folder.join("report.html"));
    if !out.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("html")) {
        return Err(ReportError::BadOut { path: out, why: "the report is a .html file" }.into());
    }
    let html = gathered(folder, &out)?.html(&ENGLISH);
    replace(&out, |file| file.write_all(html.as_bytes()))?;
    writeln!(io::stdout(), "wrote {}", out.display())?;
    Ok(ExitCode::SUCCESS)
}

/// Everything there is to show of the run in `folder`, linked to from `out`.
fn gathered(folder: &Path, out: &Path) -> Result<Report, Failure> {
    let path = folder.join(record::FILE);
    let text = fs::read_to_string(&path)
        .map_err(|source| ReportError::NoRun { path: path.clone(), source })?;
    let mut results: Vec<(String, String)> =
        record::results(&text).map(|(name, value)| (name.to_owned(), value.to_owned())).collect();
    let typed = results.iter().position(|(name, _)| name == record::COMMAND);
    let typed = typed.map(|k| results.remove(k).1);
    let frames = FrameFile::named(&folder.join("trajectory.txt"));
    let (whole, cut) = frames.whole()?;
    let scenario = file::read(&path).and_then(|settings| Scenario::resolve(&settings, || 0));
    let rows = ledger(&folder.join("energy.csv")).ok(); // none was kept, or it has one line only
    Ok(Report {
        typed,
        repeats: format!("parsim2d {}", record::FILE),
        scenario: text.lines().filter(|line| !line.starts_with("# result")).fold(
            String::new(),
            |mut text, line| {
                text.push_str(line);
                text.push('\n');
                text
            },
        ),
        results,
        answer: scenario.as_ref().map(answer::of).unwrap_or_default(),
        diagnosis: scenario.map(|scenario| scenario.diagnosis()).map_err(|why| why.to_string()),
        failure: failure(folder),
        energy: rows.map(|rows| energy::figure(&rows)),
        frames: [picture(&frames, 0)?, picture(&frames, whole - 1)?],
        cut: cut.map(|why| format!("{}: {why}", whole)),
        speeds: histogram(&frames, whole - 1)?,
        data: data(folder, out),
    })
}

/// What `failure.json` says, by its keys.
fn failure(folder: &Path) -> Vec<(String, String)> {
    let text = fs::read_to_string(folder.join(failure::FILE)).unwrap_or_default();
    let value: serde_json::Value = serde_json::from_str(&text).unwrap_or_default();
    let said = |value: &serde_json::Value| match value {
        serde_json::Value::String(text) => text.clone(),
        serde_json::Value::Array(all) if all.iter().all(serde_json::Value::is_string) => {
            let all: Vec<&str> = all.iter().filter_map(serde_json::Value::as_str).collect();
            all.join(", or ")
        }
        other => other.to_string(),
    };
    let keys = ["what", "step", "time_s", "discs", "fault", "value", "diagnosis", "ways_out"];
    let found = |key: &str| {
        let value = value.get(key).filter(|value| !value.is_null())?;
        Some((key.to_owned(), said(value)))
    };
    keys.into_iter().filter_map(found).collect()
}

fn picture(file: &FrameFile, index: usize) -> Result<Figure, Failure> {
    let (_, one) = file.frame(Some(index))?;
    let by = if has_velocities(&one) { ColourBy::Speed } else { ColourBy::Nothing };
    Ok(frame::figure(&one, Choice { by, vectors: false }))
}

/// The speeds of all frames up to number `last`; of a few discs there is nothing to be learnt from.
fn histogram(file: &FrameFile, last: usize) -> Result<Option<Figure>, Failure> {
    const FEWEST_DISCS: usize = 10;
    if file.frame(Some(0))?.1.rows.len() < FEWEST_DISCS {
        return Ok(None);
    }
    let histogram = pooled_speeds(file, Some(last))?;
    let title = histogram.title(None);
    Ok((!histogram.is_at_rest()).then(|| speeds::figure(&histogram, &title)))
}

/// The files of the run, as links from the folder of the page. A page elsewhere has none: they
/// would lead nowhere once it is handed in.
fn data(folder: &Path, out: &Path) -> Vec<(String, u64)> {
    let beside = out.parent().map(fs::canonicalize).and_then(Result::ok);
    let is_beside = out.parent() == Some(folder) || beside == fs::canonicalize(folder).ok();
    if !is_beside {
        return Vec::new();
    }
    let names = ["trajectory.txt", "energy.csv", "out.txt", record::FILE, failure::FILE];
    let size = |name: &str| Some((name.to_owned(), fs::metadata(folder.join(name)).ok()?.len()));
    names.into_iter().filter_map(size).collect()
}
