//! What a run writes, one file a format, writer and reader together.
//!
//! Nothing here is called from inside a step. Nothing written depends on wall time, host or path,
//! but for *when* `out.txt` is refreshed.

pub mod energy;
pub mod frames;
pub mod live;
pub mod number;
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
    /// During the run.
    #[error("writing {} failed: {source}\n  the run stops here; what was written before is kept", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
}
