//! What a run writes, one file a format, writer and reader together.
//!
//! Nothing here is called from inside a step. Nothing written depends on wall time, host or path,
//! but for *when* `out.txt` is refreshed.

pub mod checkpoint;
pub mod drift;
pub mod energy;
pub mod failure;
pub mod frames;
pub mod growing;
pub mod live;
pub mod live_writer;
pub mod lock;
pub mod marks;
pub mod number;
pub mod place;
pub mod record;
pub mod recorder;
pub mod replace;
pub mod summary;
pub mod together;
pub mod trajectory;
pub mod written;

use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::echo;

/// A file that could not be written.
#[derive(Debug, Error)]
pub enum OutputError {
    /// Before the first step: nothing has been overwritten.
    #[error(
        "cannot write to {}: {source}\n  way out: --out-dir with a folder that can be written",
        echo::path(path)
    )]
    Create {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// Before the first step: something that is no file has a name that will be one's.
    #[error(
        "{} is in the way: {source}\n  way out: give it another name, or use another --out-dir",
        echo::path(path)
    )]
    InTheWay {
        /// What has the name.
        path: PathBuf,
        /// What it is.
        source: std::io::Error,
    },
    /// Before the first step: another process holds the lock of the folder.
    #[error(
        "another parsim2d is writing to {}\n  way out: wait until it has ended, or --out-dir with another \
         folder",
        echo::path(folder)
    )]
    Busy {
        /// The folder.
        folder: PathBuf,
    },
    /// Before the first step: something in the folder has the name of a checkpoint and is none of this version.
    #[error("{} {what}, and this run would replace it\n  way out: {way_out}", echo::path(path))]
    ForeignCheckpoint {
        /// What has the name.
        path: PathBuf,
        /// What it is.
        what: String,
        /// What to do.
        way_out: &'static str,
    },
    /// Before the first step: the folder holds a file of somebody's own where the record of the run goes.
    #[error(
        "{} was not written by a run, and this run would replace it\n  \
         way out: give it another name, or use another --out-dir",
        echo::path(path)
    )]
    ForeignRecord {
        /// The file.
        path: PathBuf,
    },
    /// Before a run goes on: a file is not the one that the run of the checkpoint wrote.
    #[error("cannot continue {}: {why}", echo::path(path))]
    NotOfThatRun {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        why: String,
    },
    /// During the run.
    #[error("writing {} failed: {source}\n  {}", echo::path(path), after_failure(path, source))]
    Write {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
}

/// What became of the files when writing to `path` failed, and the way out.
fn after_failure(path: &Path, source: &std::io::Error) -> String {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    if folder.is_some_and(|folder| !folder.is_dir()) {
        return "its folder is gone: what was written is where that was moved to, if it was; way out: leave a \
                folder where it is until its run has ended"
            .to_owned();
    }
    let room = if wants_room(source) { "more room, or " } else { "" };
    format!(
        "what was written before is kept; way out: {room}another folder, --out-dir (-o of a plot or a report)"
    )
}

/// Whether a write failed for want of room.
pub fn wants_room(why: &std::io::Error) -> bool {
    use std::io::ErrorKind::{FileTooLarge, QuotaExceeded, StorageFull};
    matches!(why.kind(), FileTooLarge | QuotaExceeded | StorageFull)
}

/// The rows of a csv file whose first line must be the first of `headers`, or one that older files have. Errors are sentences that name the line.
fn rows<T: serde::de::DeserializeOwned>(
    input: impl std::io::Read,
    headers: &[&str],
) -> Result<Vec<T>, String> {
    let mut reader = csv::Reader::from_reader(input);
    let said = reader.headers().map_err(|why| bad_row(&why))?;
    let said: Vec<String> = said.iter().map(|name| name.trim().to_owned()).collect();
    let said = said.join(",");
    if !headers.contains(&said.trim_start_matches('\u{feff}')) {
        let mut start: String = said.chars().take(160).collect();
        if start.len() < said.len() {
            start.push_str("...");
        }
        return Err(format!("its columns are {start}; they should be {}", headers[0]));
    }
    reader.deserialize().map(|row| row.map_err(|why| bad_row(&why))).collect()
}

/// What is wrong with a row, without the csv crate's counting of bytes.
fn bad_row(why: &csv::Error) -> String {
    let line = why.position().map_or(String::new(), |at| format!("line {}: ", at.line()));
    let what = match why.kind() {
        csv::ErrorKind::Utf8 { .. } => "this is not text".to_owned(),
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("{len} columns, not {expected_len}: the line is cut off")
        }
        csv::ErrorKind::Deserialize { err, .. } => format!("{}", err.kind()),
        _ => why.to_string(),
    };
    format!("{line}{what}")
}
