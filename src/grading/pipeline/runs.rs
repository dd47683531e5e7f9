//! What the end of a run means.

use std::fs;
use std::path::{Path, PathBuf};

use crate::grading::judge::frames::{Footage, count};
use crate::grading::judge::rubric::Rubric;
use crate::grading::judge::verdict::Failure;
use crate::grading::sandbox::{Captured, Outcome, Run};

/// What is said of a run, before anybody looks into its frames.
pub(super) enum Ended {
    /// It may be looked at; what is not there is the frames' affair.
    Well,
    /// With this failure.
    Badly(Failure),
}

/// What is said of `run` in `folder`, which wrote these `other` files besides.
pub(super) fn ended(run: &Run, folder: &Path, others: &[PathBuf], rubric: &Rubric) -> Ended {
    let log = &run.log;
    let frames = || whole_frames(&run.captured, rubric);
    let failure = match run.outcome {
        // Whoever writes empty frames over and over does write.
        Outcome::Ended(0)
            if run.captured.is_blank()
                && frames() < 2
                && others.is_empty()
                && !prints_frames(log) =>
        {
            match run.asked_for_more {
                true => Failure::waits_for_input(run.took.as_secs_f64(), log),
                false => Failure::ends_without_frames(log),
            }
        }
        Outcome::Ended(0) | Outcome::EnoughFrames => return Ended::Well,
        Outcome::TimeUp | Outcome::CpuUp => {
            // A program that runs for ever is right, if it writes in time; one that prints or writes
            // elsewhere writes no frames.
            let is_elsewhere =
                run.captured.is_blank() && (!others.is_empty() || prints_frames(log));
            if is_elsewhere || frames() >= rubric.program.frames_at_least {
                return Ended::Well;
            }
            match run.asked_for_more {
                true => Failure::waits_for_input(run.took.as_secs_f64(), log),
                false => Failure::too_slow(run.took.as_secs_f64(), log),
            }
        }
        Outcome::Ended(_) if run.asked_for_more && run.captured.is_blank() => {
            Failure::waits_for_input(run.took.as_secs_f64(), log)
        }
        Outcome::Ended(code) => Failure::ends_with_code(code, log),
        Outcome::Signal(signal) => Failure::ends_by_signal(signal, log),
        Outcome::OutputTooLarge => too_large(run, folder),
        Outcome::MemoryUp | Outcome::TooManyProcesses => Failure::stopped_by_limits(log),
        Outcome::NotStarted => Failure::does_not_build(log),
    };
    Ended::Badly(failure)
}

/// What is said of a program that wrote too much: how much, and where most of it is.
fn too_large(run: &Run, folder: &Path) -> Failure {
    let size = |entry: fs::DirEntry| {
        let found = fs::symlink_metadata(entry.path()).ok().filter(fs::Metadata::is_file)?;
        Some((found.len(), entry.file_name().to_string_lossy().into_owned()))
    };
    let files = fs::read_dir(folder).into_iter().flatten().flatten().filter_map(size);
    let (bytes, name) = files.max().unwrap_or_default();
    match run.captured.bytes() {
        // What was written over and over is large as a whole only.
        all if all >= bytes => Failure::output_too_large(all),
        _ => Failure::output_too_large(bytes).saying(&name),
    }
}

/// Frames in a film, whole or cut.
fn whole_frames(film: &Captured, rubric: &Rubric) -> usize {
    match film {
        Captured::Snapshots(all) => all.len(),
        Captured::File(_) | Captured::Nothing => count(footage(film), rubric),
    }
}

/// Whether rows of numbers were printed where nobody reads them.
pub(super) fn prints_frames(log: &str) -> bool {
    let is_row = |line: &str| {
        let numbers = line.split_whitespace().map(str::parse::<f64>);
        let numbers: Vec<_> = numbers.take(3).collect();
        numbers.len() == 3 && numbers.iter().all(Result::is_ok)
    };
    log.lines().filter(|line| is_row(line)).count() >= 2
}

/// Files in `folder`, other than `out.txt`, that hold something and are not among those of `before`.
pub(super) fn newly_written(folder: &Path, before: &[PathBuf]) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let is_new = |path: &PathBuf| {
        let holds = fs::symlink_metadata(path).is_ok_and(|found| {
            let is_out = path.file_name().is_some_and(|name| name == "out.txt");
            // An out.txt that is no file is something else that was written.
            if is_out { !found.is_file() } else { found.is_file() && found.len() > 0 }
        });
        holds && !before.contains(path)
    };
    entries.filter_map(Result::ok).map(|entry| entry.path()).filter(is_new).collect()
}

/// What was captured, as the judge takes it.
pub(super) fn footage(captured: &Captured) -> Footage<'_> {
    match captured {
        Captured::Snapshots(all) => Footage::Snapshots(all),
        Captured::File(bytes) => Footage::File(bytes),
        Captured::Nothing => Footage::Nothing,
    }
}
