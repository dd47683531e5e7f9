//! `parsim2d report`: one self-contained HTML page of a run, to hand in.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;

use super::answer;
use super::failure::Failure;
use super::plot::{FrameFile, bad_out, ledger};
use super::refusal::Refusal;
use super::say::say;
use super::told::{Told, Untold};
use super::typed::{quoted, shown};
use crate::analysis::energy::LedgerRow;
use crate::echo;
use crate::figure::Figure;
use crate::figure::frame::{self, Choice, ColourBy, fastest, has_velocities};
use crate::figure::speeds::{Histogram, Moments};
use crate::figure::survey::Survey;
use crate::figure::{energy, speeds, velocity};
use crate::output::failure;
use crate::output::frames::Frame;
use crate::output::place::plain_text;
use crate::output::record;
use crate::output::replace::replace;
use crate::page::film::Film;
use crate::page::gas::{NoGas, no_gas};
use crate::page::report::Report;
use crate::page::words::ENGLISH;

pub(super) const EXAMPLES: &str = "\
Examples:
  parsim2d report                          the run in this folder: report.html
  parsim2d report . -o handed_in.html      under another name
  parsim2d report --name Lovelace          with the author's name
  parsim2d report --help                   this text

The page needs no network: the run to look at, parameters, diagnosis, energy, frames, velocity field, speeds.
It prints on two sheets at most; name and answer can be written into it in the browser.";

#[derive(Args)]
pub(super) struct ReportArguments {
    /// Folder of the run
    #[arg(value_name = "DIR", default_value = ".")]
    folder: PathBuf,
    /// The page [default: report.html in that folder]
    #[arg(short, long, value_name = "FILE.html")]
    out: Option<PathBuf>,
    /// Who hands it in
    #[arg(long, value_name = "NAME")]
    name: Option<String>,
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
        return Err(bad_out(&out, "the report is a .html file", "--out report.html").into());
    }
    let report = Report { name: arguments.name.clone(), ..gathered(folder, &out)? };
    let html = report.html(&ENGLISH);
    replace(&out, |file| file.write_all(html.as_bytes()))?;
    writeln!(io::stdout(), "wrote {}", echo::path(&out))?;
    Ok(ExitCode::SUCCESS)
}

/// Everything there is to show of the run in `folder`, linked to from `out`.
fn gathered(folder: &Path, out: &Path) -> Result<Report, Failure> {
    let path = folder.join(record::FILE);
    let untold = |why: Untold| untold(&path, why);
    let told = Told::read(&path).map_err(untold)?;
    let frames = FrameFile::named(&folder.join("trajectory.txt"));
    let (whole, cut) = frames.whole()?;
    let last = frames.frame(Some(whole - 1))?.1;
    let Told { text, said } = told.of(&last, cut.is_none()).map_err(untold)?;
    let mut results: Vec<(String, String)> =
        record::results(&text).map(|(name, value)| (name.to_owned(), value.to_owned())).collect();
    let typed = results.iter().position(|(name, _)| name == record::COMMAND);
    let typed = typed.map(|k| results.remove(k).1);
    let scenario = said.map(|(_, scenario)| scenario);
    let seen = Seen::of(&frames, whole - 1)?;
    let (rows, no_rows) = rows_of(&folder.join("energy.csv"));
    let no_gas = scenario.as_ref().map_or(Some(NoGas::Unknown), |scenario| no_gas(scenario, &rows));
    Ok(Report {
        name: None,
        typed,
        repeats: format!("parsim2d {}", record::FILE),
        scenario: parameters(&text),
        results,
        answer: scenario.as_ref().map(answer::of).unwrap_or_default(),
        no_gas,
        diagnosis: scenario.map(|scenario| scenario.diagnosis()).map_err(|why| why.to_string()),
        failure: failure(folder),
        energy: (!rows.is_empty()).then(|| energy::figure(&rows)),
        no_rows,
        rows,
        frames: [picture(&seen.first), picture(&seen.last)],
        cut: cut.map(|why| format!("{}: {why}", whole)),
        velocity: (fastest(&seen.last) > 0.0).then(|| velocity::figure(&seen.last)),
        speeds: seen.speeds.map(|speeds| histogram(speeds, no_gas.is_none())),
        film: seen.film,
        data: data(folder, out),
    })
}

/// Why the record at `path` is of no use.
fn untold(path: &Path, why: Untold) -> Refusal {
    match why {
        Untold::Unreadable(source) => Refusal {
            why: format!("{} tells of no run: {source}", echo::path(path)),
            way_out: "run parsim2d in that folder first, or name another folder".to_owned(),
        },
        Untold::Unfit(why) => Refusal {
            why: format!("{} does not tell of the run in that folder: {why}", path.display()),
            way_out: "a folder as a run of parsim2d left it; pictures need no record: parsim2d plot trajectory \
                      trajectory.txt"
                .to_owned(),
        },
    }
}

/// The lines of a record without its results.
fn parameters(record: &str) -> String {
    let lines = record.lines().filter(|line| !line.starts_with("# result"));
    lines.map(|line| format!("{line}\n")).collect()
}

/// The ledger at `path`; what is wrong with it if it is there and cannot be drawn.
fn rows_of(path: &Path) -> (Vec<LedgerRow>, Option<String>) {
    // None was kept, or it has the start only.
    let has_rows = || plain_text(path).map_or(true, |text| text.lines().nth(2).is_some());
    let is_there = path.symlink_metadata().is_ok() && has_rows();
    match ledger(path) {
        Ok(rows) => (rows, None),
        Err(_) if !is_there => (Vec::new(), None),
        Err(why) => {
            let why = why.to_string();
            let why = why.lines().next().unwrap_or_default().to_owned();
            say("note", &why);
            (Vec::new(), Some(why))
        }
    }
}

/// What is seen of all frames, in two passes through the file.
struct Seen {
    first: Frame,
    last: Frame,
    film: Film,
    speeds: Option<Histogram>,
}

impl Seen {
    /// Of the frames up to number `last`.
    fn of(file: &FrameFile, last: usize) -> Result<Self, Failure> {
        let (mut survey, mut moments) = (Survey::begin(), Moments::default());
        file.each_frame(Some(last), |_, frame| {
            survey.add(&frame);
            moments.add(&frame);
            Ok(())
        })?;
        let (mut film, mut histogram) = (Film::begin(survey), Histogram::new(moments));
        let mut ends = [Frame::default(), Frame::default()];
        file.each_frame(Some(last), |index, frame| {
            film.add(&frame);
            histogram.add(&frame);
            ends[usize::from(index > 0)] = frame;
            Ok(())
        })?;
        let [first, last] = ends;
        let last = if survey.frames > 1 { last } else { first.clone() };
        // Of a few discs there is nothing to be learnt from.
        const FEWEST_DISCS: usize = 10;
        let has_speeds = survey.discs >= FEWEST_DISCS && !histogram.is_at_rest();
        Ok(Self { first, last, film, speeds: has_speeds.then_some(histogram) })
    }
}

/// What `failure.json` says, by its keys.
fn failure(folder: &Path) -> Vec<(String, String)> {
    let text = plain_text(&folder.join(failure::FILE)).unwrap_or_default();
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

fn picture(one: &Frame) -> Figure {
    let by = if has_velocities(one) { ColourBy::Speed } else { ColourBy::Nothing };
    frame::figure(one, Choice { by, vectors: false })
}

/// The picture of all speeds, with Maxwell's curve only if that says something.
fn histogram(histogram: Histogram, is_gas: bool) -> Figure {
    let title = histogram.title(None);
    let histogram = if is_gas { histogram } else { histogram.bare() };
    speeds::figure(&histogram, &title)
}

/// The files of the run, as links from the folder of the page. A page elsewhere has none: they
/// would lead nowhere once it is handed in.
fn data(folder: &Path, out: &Path) -> Vec<(String, u64)> {
    // A name alone lies in the present folder.
    let beside = out.parent().filter(|place| !place.as_os_str().is_empty());
    let place = beside.unwrap_or(Path::new("."));
    if place != folder && fs::canonicalize(place).ok() != fs::canonicalize(folder).ok() {
        return Vec::new();
    }
    let names = ["trajectory.txt", "energy.csv", "out.txt", record::FILE, failure::FILE];
    let size = |name: &str| Some((name.to_owned(), fs::metadata(folder.join(name)).ok()?.len()));
    names.into_iter().filter_map(size).collect()
}
