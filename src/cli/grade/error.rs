//! Why nothing was graded.

use std::path::PathBuf;

use crate::grade::check::Check;
use crate::proof::DESCRIPTION;

/// Why nothing was graded: bad usage, every time.
#[derive(Debug, thiserror::Error)]
pub(in crate::cli) enum GradeError {
    #[error("the rubric {} cannot be used: {why}\n  way out: parsim2d grade --init-rubric prints one to begin with", path.display())]
    Rubric { path: PathBuf, why: String },
    #[error("there is no check `{id}`; checks are {}", ids().join(", "))]
    Check { id: String },
    #[error(
        "--format {format} is one file for one submission, and there are {count}\n  way out: --out-dir FOLDER"
    )]
    OneOnly { format: String, count: usize },
    #[error("the rubric cannot be used: {0}")]
    Command(String),
    #[error("{} is no folder of a submission\n  way out: parsim2d grade --frames FILE grades a file of frames", path.display())]
    NoFolder { path: PathBuf },
    #[error(
        "{} is no folder of described submissions: neither it nor a folder in it has a {DESCRIPTION}\n  \
         way out: leave out --proof to grade it; the format of {DESCRIPTION} is in tests/submissions/README.md of the sources",
        path.display()
    )]
    Undescribed { path: PathBuf },
    #[error(transparent)]
    Closed(crate::workshop::Closed),
    #[error(transparent)]
    Proof(crate::proof::ProofError),
    #[error(
        "{count} formats do not fit in one stream\n  way out: --out-dir FOLDER, or one --format"
    )]
    ManyFormats { count: usize },
    #[error("{key}={value} is not a number\n  way out: leave it out, or set what VPL sets")]
    Scale { key: &'static str, value: String },
}

fn ids() -> Vec<&'static str> {
    Check::ALL.into_iter().map(Check::id).collect()
}

impl GradeError {
    /// 3 where the machine is at fault, 2 for bad usage.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Closed(_) => 3,
            _ => 2,
        }
    }
}
