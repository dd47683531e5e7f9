//! Why a run cannot go on, and the one way out that works.

use std::path::{Path, PathBuf};

use crate::cli::failure::Failure;
use crate::cli::refusal::Refusal;
use crate::cli::typed::{quoted, shown};
use crate::echo;
use crate::output::OutputError;
use crate::output::checkpoint::container::Flaw;
use crate::output::checkpoint::{self, Checkpoint, CheckpointError};
use crate::output::place::{folder_of, plain_text};
use crate::output::record;

/// What to say instead of `why` the checkpoint `file` cannot be read, if the run there has reached its end and
/// left none: then there is nothing left to do.
pub(super) fn is_done(file: &Path) -> Option<Refusal> {
    if file.exists() || other(file).is_some() {
        return None;
    }
    end_of_run(file).filter(|(_, is_wrong)| !is_wrong).map(|(said, _)| said)
}

/// The checkpoint `file` cannot be read.
pub(super) fn unreadable(file: &Path, why: &CheckpointError) -> Failure {
    if matches!(why, CheckpointError::Flawed { flaw: Flaw::OtherFormat(_), .. }) {
        return Failure::Refused(Refusal {
            why: why.to_string(),
            way_out: "continue it with the version of parsim2d that wrote it".to_owned(),
        });
    }
    match (file.exists(), other(file), end_of_run(file)) {
        (false, None, Some((end, _))) => Failure::Refused(end),
        (false, None, None) => Failure::Refused(Refusal {
            why: why.to_string(),
            way_out: "name the checkpoint, parsim2d.ckpt, or the folder it lies in; it is written on Ctrl-C \
                      and by --checkpoint-every"
                .to_owned(),
        }),
        (_, other, _) => refusal(file, why.to_string(), other),
    }
}

/// What the checkpoint `file` holds does not fit together.
pub(super) fn unfit(file: &Path, why: &str) -> Failure {
    refusal(file, format!("cannot resume from {}: {why}", echo::path(file)), other(file))
}

/// The files of the run cannot be continued from the checkpoint `file`.
pub(super) fn not_continued(file: &Path, why: OutputError) -> Failure {
    if !matches!(why, OutputError::NotOfThatRun { .. }) {
        return Failure::Output(why);
    }
    let way_out = match other(file) {
        Some(other) => other.way_out(),
        None => format!(
            "put the file of that run back beside its checkpoint; if it is lost, {}",
            again(folder_of(file), true)
        ),
    };
    Failure::Refused(Refusal { why: why.to_string(), way_out })
}

fn refusal(file: &Path, why: String, other: Option<Other>) -> Failure {
    let way_out = match other {
        Some(other) => other.way_out(),
        None => {
            let again = again(folder_of(file), false);
            format!("there is no other whole checkpoint of these files beside it; {again}")
        }
    };
    Failure::Refused(Refusal { why, way_out })
}

/// Another checkpoint to go on from.
struct Other {
    path: PathBuf,
    step: u64,
}

impl Other {
    fn way_out(&self) -> String {
        format!(
            "the other checkpoint there is whole and fits the files, step {}: parsim2d resume {}",
            self.step,
            quoted(&shown(&self.path))
        )
    }
}

/// A whole checkpoint beside `file` that fits the files there.
fn other(file: &Path) -> Option<Other> {
    let folder = folder_of(file);
    let names = [checkpoint::FILE, checkpoint::PREVIOUS].map(|name| folder.join(name));
    names.into_iter().filter(|path| path.file_name() != file.file_name()).find_map(|path| {
        let progress = Checkpoint::read(&path).ok()?.progress;
        progress.written.check(folder).ok()?;
        Some(Other { path, step: progress.step })
    })
}

/// How to run the scenario of `folder` again; `is_whole` says whether its checkpoint can be read.
fn again(folder: &Path, is_whole: bool) -> String {
    let path = folder.join(record::FILE);
    match (record::is_there(folder), is_whole) {
        (true, _) => {
            format!("run the scenario again: parsim2d {} --out-dir again", quoted(&shown(&path)))
        }
        (_, true) => {
            "run the scenario again: it is in the first lines of the checkpoint".to_owned()
        }
        _ => "run the scenario again".to_owned(),
    }
}

/// What to say of a run that has ended and left no checkpoint `file`, by its record, and whether it went
/// wrong; nothing if checkpoints have another name.
fn end_of_run(file: &Path) -> Option<(Refusal, bool)> {
    let folder = folder_of(file);
    let is_named = |name: &str| file.file_name().is_some_and(|said| said == name);
    if record::is_foreign(folder)
        || ![checkpoint::FILE, checkpoint::PREVIOUS].into_iter().any(is_named)
    {
        return None;
    }
    let path = folder.join(record::FILE);
    let text = plain_text(&path).ok()?;
    let result = |name: &str| {
        record::results(&text).find_map(|(this, value)| (this == name).then(|| value.to_owned()))
    };
    let time = result("time_s")?;
    if result("interrupted").is_some() {
        return None;
    }
    let record = quoted(&shown(&path));
    let why = match result("went_wrong") {
        Some(what) => format!("the run there went wrong ({what}): there is nothing to go on from"),
        None => format!(
            "the run there is done, t = {time} s; it keeps a checkpoint of its end only with \
             --checkpoint-every"
        ),
    };
    let way_out = match result("went_wrong") {
        Some(_) => format!(
            "a new run with other parameters: parsim2d {record} --out-dir again --integrator \
             symplectic-euler, or what failure.json names"
        ),
        None => format!(
            "to a later end from the start: parsim2d {record} --out-dir again --time {:?}",
            2.0 * time.parse::<f64>().ok()?
        ),
    };
    Some((Refusal { why, way_out }, result("went_wrong").is_some()))
}
