//! Checkpoints: all that a run needs to go on, bit for bit, as if it had never been interrupted.
//!
//! `parsim2d.ckpt` in the folder of a run is the latest, `parsim2d.previous.ckpt` the one before it. A
//! checkpoint holds the scenario, the state as named arrays of raw numbers, how far the files of the run
//! had come, and what its guard and its ledger remember of the start. [`container`] is the format.
//!
//! Of the random numbers it holds the seed only: they place and throw the discs at the start, and none is
//! drawn after that.

pub mod container;
mod read;
mod write;

use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use thiserror::Error;

use self::container::{FORMAT, Flaw};
pub use self::write::{sections, write};
use super::OutputError;
use super::place::plain_file;
use super::written::Written;
use crate::echo;
use crate::simulation::state::Array;

/// Name of the latest checkpoint.
pub const FILE: &str = "parsim2d.ckpt";

/// Name of the one before it.
pub const PREVIOUS: &str = "parsim2d.previous.ckpt";

/// A checkpoint in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// The scenario, as a scenario file.
    pub scenario: String,
    /// Everything else that is not the state.
    pub progress: Progress,
    /// The state, as `State::arrays` gives it, and what else has to be kept as numbers.
    pub arrays: Vec<(String, Array)>,
}

/// How far a run has come, and what it remembers of its start.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case)] // a key's name ends with its unit
pub struct Progress {
    /// Version of the program.
    pub version: String,
    /// Steps done.
    pub step: u64,
    /// Simulated time, s.
    pub time_s: f64,
    /// Fingerprint of the state, 16 hexadecimal digits.
    pub state_hash: String,
    /// The command of the run, word by word.
    pub command: Vec<String>,
    /// The guard's: energies at the start, J.
    pub kinetic_at_start_J: f64,
    /// Gravitational energy at the start, J.
    pub gravitational_at_start_J: f64,
    /// Elastic energy at the start, J.
    pub elastic_at_start_J: f64,
    /// What could move the discs at the start, J.
    pub movable_at_start_J: f64,
    /// Energy supplied from outside until the start, J.
    pub supplied_at_start_J: f64,
    /// The largest overlap at the start over the (smaller) radius.
    pub overlap_at_start: f64,
    /// The step of the guard's last look, if the energy had grown then.
    pub grown_at: Option<u64>,
    /// How far the files of the run had come.
    pub written: Written,
}

/// A checkpoint that cannot be used.
#[derive(Debug, Error)]
pub enum CheckpointError {
    /// The file cannot be read.
    #[error("cannot read the checkpoint {}: {source}", echo::path(path))]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
    /// The file is not a good checkpoint.
    #[error("cannot resume from {}: {flaw}", echo::path(path))]
    Flawed {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        flaw: Flaw,
    },
}

/// Refuses to run in a `folder` that holds a checkpoint of another version, whose run could still be
/// continued by that version, or somebody's own file of such a name.
pub fn refuse_foreign(folder: &Path) -> Result<(), OutputError> {
    let Ok(entries) = fs::read_dir(folder) else {
        return Ok(()); // no folder yet, no checkpoints
    };
    let ours = entries.filter_map(|entry| Some(entry.ok()?.path())).filter(|path| is_ours(path));
    for path in ours {
        let (what, way_out) = match format(&path) {
            Ok(Some(FORMAT)) => continue,
            Ok(Some(format)) => (
                format!("is a checkpoint of another version (format {format})"),
                "continue it with that version, remove it, or use another --out-dir",
            ),
            Ok(None) => ("is no checkpoint of parsim2d".to_owned(), RENAME),
            Err(why) => (format!("is no checkpoint of parsim2d: {why}"), RENAME),
        };
        return Err(OutputError::ForeignCheckpoint { path, what, way_out });
    }
    Ok(())
}

const RENAME: &str = "give it another name, or use another --out-dir";

/// Whether the file at `path` begins as a checkpoint does, of whatever version.
pub fn is_one(path: &Path) -> bool {
    format(path).is_ok_and(|format| format.is_some())
}

/// Removes both checkpoints from `folder`: they are of a run whose files are gone, or that is done.
pub fn remove(folder: &Path) -> Result<(), OutputError> {
    for path in [FILE, PREVIOUS].map(|name| folder.join(name)) {
        match fs::remove_file(&path) {
            Err(source) if source.kind() != io::ErrorKind::NotFound => {
                return Err(OutputError::Create { path, source });
            }
            _ => {}
        }
    }
    Ok(())
}

fn is_ours(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    name.starts_with("parsim2d") && name.ends_with(".ckpt")
}

/// The format's number, if the file begins as a checkpoint does. An error if it is empty or no file.
fn format(path: &Path) -> io::Result<Option<u32>> {
    let mut begin = Vec::new();
    plain_file(path)?.take(100).read_to_end(&mut begin)?;
    if begin.is_empty() {
        return Err(io::Error::other("it is empty"));
    }
    Ok(container::format(&begin).ok())
}
