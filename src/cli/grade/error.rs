//! Why nothing was graded.

use std::path::PathBuf;

use crate::echo;
use crate::grading::feedback::plain::one_line;
use crate::grading::judge::check::Check;
use crate::grading::judge::mistake::Mistake;
use crate::grading::validation::DESCRIPTION;

/// Why nothing was graded: bad usage, every time.
#[derive(Debug, thiserror::Error)]
pub(in crate::cli) enum GradeError {
    #[error(
        "the rubric {} cannot be used: {why}\n  way out: parsim2d grade --init-rubric prints one to begin with",
        echo::path(path)
    )]
    Rubric { path: PathBuf, why: String },
    #[error("there is no check and no cause `{id}`{}\n  checks: {}\n  causes: {}", like(id), checks().join(", "), causes().join(", "))]
    Unexplained { id: String },
    #[error(
        "--format {format} is one file for one submission, and there are {count}\n  way out: --out-dir FOLDER"
    )]
    OneOnly { format: String, count: usize },
    #[error("the rubric cannot be used: {0}")]
    Command(String),
    #[error(
        "{} is no folder of a submission\n  way out: parsim2d grade --frames FILE grades a file of frames",
        echo::path(path)
    )]
    NoFolder { path: PathBuf },
    #[error(
        "{} is no folder of described submissions: neither it nor a folder in it has a {DESCRIPTION}\n  \
         way out: leave out --proof to grade it; the format of {DESCRIPTION} is in tests/submissions/README.md of the sources",
        echo::path(path)
    )]
    Undescribed { path: PathBuf },
    #[error(transparent)]
    SandboxError(crate::grading::sandbox::SandboxError),
    #[error(transparent)]
    Proof(crate::grading::validation::ValidationError),
    #[error(
        "{count} formats do not fit in one stream\n  way out: --out-dir FOLDER, or one --format"
    )]
    ManyFormats { count: usize },
    #[error(
        "--out {}: there is no such folder, or it is one itself; nothing was graded\n  way out: make the folder, or name a file in one that is there",
        echo::path(path)
    )]
    NoPlace { path: PathBuf },
    #[error(
        "{} is what is graded, or the rubric, and would be written over; nothing was graded\n  \
         way out: another --out or --out-dir",
        echo::path(path)
    )]
    OverInput { path: PathBuf },
    #[error("{0}")]
    Unwritten(String),
    #[error(
        "{} has a class of which not all are graded now ({} {others}); its tables would lose them, and nothing was graded\n  \
         way out: grade the whole class, or name another --out-dir; --replace-class gives them up",
        echo::path(path), "not now:", others = listed(others)
    )]
    OtherClass { path: PathBuf, others: Vec<String> },
    #[error(
        "submissions cannot use `{program}`, which the rubric asks for: there is none in {path}; nothing was graded\n  \
         way out: install it for all users, or --tools FOLDER (for Rust of rustup: --tools \"$(rustc --print sysroot)\"; as root, one that others may enter)"
    )]
    NoTool { program: String, path: String },
    #[error("{key}={value} is not a number\n  way out: leave it out, or set what VPL sets")]
    Scale { key: &'static str, value: String },
}

fn checks() -> [&'static str; Check::ALL.len()] {
    Check::ALL.map(Check::id)
}

fn causes() -> [&'static str; Mistake::ALL.len()] {
    Mistake::ALL.map(Mistake::id)
}

/// The first of some names.
fn listed(names: &[String]) -> String {
    const FIRST: usize = 5;
    let first: Vec<String> = names.iter().take(FIRST).map(|name| one_line(name)).collect();
    let more = if names.len() > FIRST { ", ..." } else { "" };
    first.join(", ") + more
}

/// A name that was perhaps meant by `id`.
fn like(id: &str) -> String {
    let names = checks().into_iter().chain(causes());
    let near = names.map(|name| (strsim::jaro_winkler(id, name), name));
    let best = near.filter(|(likeness, _)| *likeness > 0.8).max_by(|a, b| a.0.total_cmp(&b.0));
    best.map_or_else(String::new, |(_, name)| format!("; did you mean `{name}`?"))
}

impl GradeError {
    /// 3 where the machine is at fault, 2 for bad usage.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::SandboxError(_) | Self::NoTool { .. } | Self::Unwritten(_) => 3,
            _ => 2,
        }
    }
}
