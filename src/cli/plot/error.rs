//! Why a picture was not drawn, said to the person who wanted it.

use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::cli::claim::shown;
use crate::echo;

/// Nothing has been written when this is returned.
#[derive(Debug, Error)]
pub enum PlotError {
    /// A file that cannot be opened.
    #[error(
        "cannot read {}: {source}\n  way out: `{command}` writes it; or name another file",
        echo::path(path)
    )]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
        /// The command that makes such files.
        command: &'static str,
    },
    /// A file that cannot be drawn.
    #[error("cannot draw {}: {why}\n  way out: {way_out}", echo::path(path))]
    BadFile {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        why: String,
        /// What to do.
        way_out: String,
    },
    /// More files than one where one is drawn.
    #[error(
        "plot {kind} draws one file, and {n} were named\n  way out: one command a file; only `plot energy` draws several in one picture"
    )]
    TooMany {
        /// The kind of picture.
        kind: &'static str,
        /// How many files.
        n: usize,
    },
    /// A name that the picture cannot have.
    #[error("--out {} is not possible: {why}\n  way out: {way_out}", echo::path(path))]
    BadOut {
        /// The name said.
        path: PathBuf,
        /// What is wrong with it.
        why: String,
        /// What to do.
        way_out: String,
    },
}

impl PlotError {
    /// A [`BadFile`](Self::BadFile).
    pub fn bad_file(path: &Path, why: &str, way_out: &str) -> Self {
        Self::BadFile { path: path.to_owned(), why: why.to_owned(), way_out: way_out.to_owned() }
    }

    /// A file without the velocities that the picture shows; `or` is another way out, where there is one.
    pub fn no_velocities(path: &Path, or: &str) -> Self {
        let better = path.with_file_name("trajectory.txt");
        let way_out = match better.is_file() && better != path {
            true => format!("{}, which has them", shown(&better)),
            false => "the trajectory.txt of the run, which has them".to_owned(),
        };
        let or = if or.is_empty() { String::new() } else { format!("; or {or}") };
        Self::bad_file(
            path,
            "its frame has no velocities (columns `x y r`)",
            &format!("{way_out}{or}"),
        )
    }
}
