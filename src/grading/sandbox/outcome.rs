//! How a build or a run ended, and what it left.

use std::time::Duration;

use serde::Serialize;

/// How a command ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// By itself, with this exit code.
    Ended(i32),
    /// By this signal, which was not sent by the sandbox: a crash, as a rule.
    Signal(i32),
    /// Stopped when it had written as many frames as were asked for. No failure.
    EnoughFrames,
    /// Stopped at the limit of wall time. No failure of a program that runs for ever, if it wrote frames.
    TimeUp,
    /// Stopped at the limit of processor time.
    CpuUp,
    /// Stopped when it had written more than it may.
    OutputTooLarge,
    /// Stopped when it took more memory than it may.
    MemoryUp,
    /// Stopped when there were more processes and threads than allowed.
    TooManyProcesses,
    /// The command could not be started: no such file, or not executable.
    NotStarted,
}

impl Outcome {
    /// Whether the command ended by itself, with exit code 0.
    pub fn is_success(self) -> bool {
        self == Self::Ended(0)
    }
}

/// A build that was tried.
#[derive(Debug, Clone)]
pub struct Build {
    /// How it ended.
    pub outcome: Outcome,
    /// What it printed on both streams: bounded, UTF-8, without terminal codes.
    pub log: String,
    /// Wall time.
    pub took: Duration,
}

/// A run that was tried.
#[derive(Debug, Clone)]
pub struct Run {
    /// How it ended.
    pub outcome: Outcome,
    /// What it printed on both streams: bounded, UTF-8, without terminal codes.
    pub log: String,
    /// Wall time.
    pub took: Duration,
    /// What it wrote to `out.txt`.
    pub captured: Captured,
    /// Frames that were left out because they were seen half-written. Never the student's fault.
    pub torn: usize,
    /// Whether it asked for more on its standard input than there is. Not known where nothing is traced.
    pub asked_for_more: bool,
    /// Whether every frame was seen; if not, some may be missing between two captured frames.
    pub every_frame: bool,
}

/// What a run wrote to `out.txt`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Captured {
    /// The contents of the file each time it was about to be replaced, and the last one: a frame each.
    Snapshots(Vec<Vec<u8>>),
    /// One file that was never replaced: it holds one frame or all of them, or is empty.
    File(Vec<u8>),
    /// There was no `out.txt`, or it was no regular file.
    Nothing,
}

impl Captured {
    /// Whether nothing but blanks was written.
    pub fn is_blank(&self) -> bool {
        let is_blank = |bytes: &[u8]| bytes.iter().all(u8::is_ascii_whitespace);
        match self {
            Self::Snapshots(all) => all.iter().all(|bytes| is_blank(bytes)),
            Self::File(bytes) => is_blank(bytes),
            Self::Nothing => true,
        }
    }

    /// What was kept of it, bytes.
    pub fn bytes(&self) -> u64 {
        match self {
            Self::Snapshots(all) => all.iter().map(|bytes| bytes.len() as u64).sum(),
            Self::File(bytes) => bytes.len() as u64,
            Self::Nothing => 0,
        }
    }
}
