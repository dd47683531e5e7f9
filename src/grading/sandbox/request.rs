//! What is to be built and run, and how much of everything it may have.

use std::path::PathBuf;
use std::time::Duration;

use super::tier::Tier;
use crate::table::table;

/// How a sandbox is to be opened.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// The tier that must be had; `None` takes the best.
    pub tier: Option<Tier>,
    /// Whether tier D may be taken if there is no better one.
    pub allow_unsandboxed: bool,
    /// The `parsim2d` program, which shuts itself in and then becomes the student's; `None`: the
    /// running program.
    pub helper: Option<PathBuf>,
    /// Further folders that submissions may read, such as a compiler's outside `/usr`.
    pub readable: Vec<PathBuf>,
    /// Whether to do without ptrace, and watch `out.txt` from outside. For trying that way.
    pub untraced: bool,
}

/// What a student handed in, and how it becomes a program.
#[derive(Debug, Clone)]
pub struct Submission {
    /// The folder handed in; only read.
    pub folder: PathBuf,
    /// Files that must be there, relative to the folder.
    pub files: Vec<PathBuf>,
    /// Command that builds, word by word, without a shell; empty: nothing to build.
    pub build: Vec<String>,
}

/// One run of what was built.
#[derive(Debug, Clone, Default)]
pub struct Invocation {
    /// Command and arguments, word by word, without a shell.
    pub command: Vec<String>,
    /// What the program reads on its standard input.
    pub stdin: Vec<u8>,
    /// Frames that are enough; the program is then asked to end. `None`: it runs to its end or its time limit.
    pub frames: Option<usize>,
    /// Rows of a frame, if known: for programs that append frames without a blank line between them.
    pub rows: Option<usize>,
}

const MIB: u64 = 1 << 20;

table! {
    /// How much of everything a submission may have.
    #[derive(Debug, Clone)]
    pub struct Limits, Default {
        /// Wall time of the build.
        build_wall: Duration = Duration::from_secs(60);
        /// Wall time of a run.
        run_wall: Duration = Duration::from_secs(20);
        /// Processor time of each process, seconds.
        cpu: u64 = 120;
        /// All files handed in together, bytes.
        copy: u64 = 64 * MIB;
        /// Length of any file that the build writes, and of all it writes together, bytes.
        build_files: u64 = 256 * MIB;
        /// Length of any file that a run writes, and of all it writes together, bytes.
        run_files: u64 = 64 * MIB;
        /// Resident memory of all processes together, bytes.
        memory: u64 = 2048 * MIB;
        /// Address space of each process, bytes; `None` for sanitizers, which reserve terabytes.
        address_space: Option<u64> = Some(16 * 1024 * MIB);
        /// Processes and threads at a time.
        processes: usize = 64;
        /// Kept of what is printed, bytes; the middle is left out.
        log: usize = 64 << 10;
        /// All frames kept together, bytes.
        captured: usize = 64 << 20;
    }
}
