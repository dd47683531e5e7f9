//! What a run writes, one file a format, writer and reader together.
//!
//! Nothing here is called from inside a step. Nothing written depends on wall time, host or path,
//! but for *when* `out.txt` is refreshed.

pub mod checkpoint;
pub mod drift;
pub mod energy;
pub mod failure;
pub mod frames;
pub mod live;
pub mod number;
pub mod record;
pub mod recorder;
pub mod replace;
pub mod summary;
pub mod trajectory;

use std::path::PathBuf;

use thiserror::Error;

/// A file that could not be written.
#[derive(Debug, Error)]
pub enum OutputError {
    /// Before the first step: nothing has been overwritten.
    #[error("cannot write to {}: {source}\n  way out: --out-dir with a folder that can be written", path.display())]
    Create {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// Before the first step: the folder holds a checkpoint of another version.
    #[error(
        "{} is a checkpoint of another version ({format}), and this run would make it useless\n  \
         way out: continue it with that version, remove it, or use another --out-dir",
        path.display()
    )]
    ForeignCheckpoint {
        /// The checkpoint.
        path: PathBuf,
        /// Its format, as far as it can be told.
        format: String,
    },
    /// A file of ours that does not hold what it should.
    #[error("cannot read {}: {why}\n  way out: write it anew with the command that wrote it", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What is wrong with it, and in which line.
        why: String,
    },
    /// During the run.
    #[error("writing {} failed: {source}\n  the run stops here; what was written before is kept", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
}
