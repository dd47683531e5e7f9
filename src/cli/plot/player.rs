//! `parsim2d plot trajectory --html`: a page that plays the frames of a file.

use std::path::Path;

use super::arguments::TrajectoryArguments;
use super::input::{FrameFile, ledger, one_file, remark};
use super::progress::Progress;
use super::target::Target;
use crate::analysis::energy::LedgerRow;
use crate::cli::failure::Failure;
use crate::figure::survey::Survey;
use crate::output::frames::Frame;
use crate::page::film::Film;
use crate::page::player;
use crate::page::words::ENGLISH;

/// Writes the page.
pub(super) fn plot(arguments: &TrajectoryArguments) -> Result<(), Failure> {
    let file = FrameFile::named(one_file("trajectory", &arguments.files)?);
    let target = Target::new(arguments.out.as_deref(), "trajectory", "html")?;
    target.data(&file.path)?; // is read, and not what is to be written
    let film = film(&file, arguments)?;
    let rows = film.times().map_or_else(Vec::new, |times| ledger_of(&file.path, &times));
    target.write_page(&player::alone(&film, &rows, &ENGLISH))
}

/// The frames that were asked for, in two passes through the file.
fn film(file: &FrameFile, arguments: &TrajectoryArguments) -> Result<Film, Failure> {
    let every = arguments.every.get();
    let each = |see: &mut dyn FnMut(&Frame), progress: &Progress| {
        file.each_frame(arguments.until, |index, frame| {
            progress.advance();
            if index % every == 0 {
                see(&frame);
            }
            Ok(())
        })
    };
    let mut survey = Survey::begin();
    each(&mut |frame| survey.add(frame), &Progress::begin(None))?;
    let mut film = Film::begin(survey);
    each(&mut |frame| film.add(frame), &Progress::begin(Some(survey.frames * every)))?;
    Ok(film)
}

/// The ledger beside `file`, if it is of the same time as the frames at `times` (s).
fn ledger_of(file: &Path, times: &[f64]) -> Vec<LedgerRow> {
    let path = file.with_file_name("energy.csv");
    let rows = if path.exists() { ledger(&path).unwrap_or_default() } else { Vec::new() };
    let [Some(first), Some(last)] = [rows.first(), rows.last()] else { return Vec::new() };
    // Both are written at the start and at the end of a run; nine digits are left of a frame's time.
    let is_within = |time: &f64| *time >= first.time_s && *time <= last.time_s * (1.0 + 1e-8);
    if times.iter().all(is_within) {
        return rows;
    }
    remark(&format!("{} is of another time than the frames; it is left out", path.display()));
    Vec::new()
}
