//! `parsim2d report`: one self-contained HTML page of a run, to hand in.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;

use super::Failure;
use super::plot::{FrameFile, ledger, pooled_speeds};
use crate::figure::Figure;
use crate::figure::frame::{self, Choice, ColourBy, has_velocities};
use crate::figure::{energy, speeds};
use crate::output::failure;
use crate::output::record;
use crate::output::replace::replace;
use crate::page::report::Report;
use crate::page::words::ENGLISH;
use crate::scenario::Scenario;
use crate::scenario::diagnosis::Diagnosis;
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
    let has_ledger = folder.join("energy.csv").exists();
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
        diagnosis: diagnosis(&path),
        failure: fs::read_to_string(folder.join(failure::FILE)).ok(),
        energy: match has_ledger {
            true => Some(energy::figure(&ledger(&folder.join("energy.csv"))?)),
            false => None,
        },
        frames: [picture(&frames, Some(0))?, picture(&frames, None)?],
        speeds: histogram(&frames)?,
        data: data(folder, out),
    })
}

/// What the diagnosis says of the scenario at `path`, or why it says nothing.
fn diagnosis(path: &Path) -> Result<Diagnosis, String> {
    let scenario = file::read(path).and_then(|settings| Scenario::resolve(&settings, || 0));
    scenario.map(|scenario| scenario.diagnosis()).map_err(|error| error.to_string())
}

fn picture(file: &FrameFile, index: Option<usize>) -> Result<Figure, Failure> {
    let (_, one) = file.frame(index)?;
    let by = if has_velocities(&one) { ColourBy::Speed } else { ColourBy::Nothing };
    Ok(frame::figure(&one, Choice { by, vectors: false }))
}

fn histogram(file: &FrameFile) -> Result<Option<Figure>, Failure> {
    let histogram = pooled_speeds(file, None)?;
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
