//! Programs of which it is known what is wrong with them, by which a grader or a rubric is proved.
//!
//! A folder with a `submission.toml` says what is handed in (files, or those of another folder with a few
//! edits), how it is built and run, what the course asked for, and what is expected of the grader. The
//! format is told in `tests/submissions/README.md`. Reading order: [`described`] (the file), [`laid_out`]
//! (the folder made from it), [`comparison`] (what came out beside what was expected).

pub mod comparison;
pub mod described;
pub mod laid_out;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

/// The file that describes a submission.
pub const DESCRIPTION: &str = "submission.toml";

/// Why a described submission cannot be used.
#[derive(Debug, Error)]
pub enum ValidationError {
    /// A file or folder cannot be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The description is not as it should be.
    #[error("{}: {why}", path.display())]
    Description {
        /// The description.
        path: PathBuf,
        /// What is wrong, and what is wanted.
        why: String,
    },
}

impl ValidationError {
    fn file(path: &Path) -> impl FnOnce(io::Error) -> Self {
        move |source| Self::File { path: path.to_owned(), source }
    }

    fn description(path: &Path, why: impl Into<String>) -> Self {
        Self::Description { path: path.to_owned(), why: why.into() }
    }
}

/// The described submissions at `path`: itself, or all folders in it, in the order of their names.
/// A file is none.
pub fn folders_at(path: &Path) -> Result<Vec<PathBuf>, ValidationError> {
    if path.join(DESCRIPTION).is_file() {
        return Ok(vec![path.to_owned()]);
    }
    if !path.is_dir() {
        return Ok(Vec::new());
    }
    let mut found = Vec::new();
    for entry in fs::read_dir(path).map_err(ValidationError::file(path))? {
        let folder = entry.map_err(ValidationError::file(path))?.path();
        if folder.join(DESCRIPTION).is_file() {
            found.push(folder);
        }
    }
    found.sort();
    Ok(found)
}
