//! The helper: `parsim2d __jail` reads an [`Order`], shuts itself in, and becomes the student's command.
//!
//! It is a fresh process with one thread, so that none of this happens between fork and exec of a
//! process with many.

use std::error::Error;
use std::ffi::OsString;
use std::fs::File;
use std::io::{Read, Seek, Write};
use std::os::fd::{AsRawFd, OwnedFd};
use std::os::unix::process::CommandExt;
use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};

use nix::sys::memfd::{MFdFlags, memfd_create};
use nix::sys::prctl;
use nix::sys::resource::{Resource, setrlimit};
use nix::sys::stat::{Mode, umask};
use nix::unistd::{Gid, Uid, close, setgid, setgroups, setsid, setuid};
use seccompiler::BpfProgram;
use serde::{Deserialize, Serialize};

use super::landlock_rules;
use super::seccomp::{Filters, bytes_of, programs};

/// The word by which this program is asked to be the helper.
pub(super) const WORD: &str = "__jail";
/// What the helper prints when it is there, before it reads its order.
pub(super) const READY: [u8; 8] = *b"parsim2d";
/// Exit code of a helper that could not do what it was told.
pub(super) const FAILED: u8 = 125;

/// What the helper is to do, in order.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) struct Order {
    /// Where the command works, seen from outside.
    pub folder: PathBuf,
    /// What it reads.
    pub stdin: PathBuf,
    /// Its whole environment.
    pub environment: Vec<(String, String)>,
    pub limits: ResourceLimits,
    /// uid and gid to take; only root can.
    pub identity: Option<u32>,
    pub confinement: Confinement,
    /// `None`: no system calls are filtered.
    pub filters: Option<Filters>,
    /// The command, word by word.
    pub command: Vec<String>,
}

/// What one process may have.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(super) struct ResourceLimits {
    pub cpu: u64,
    pub file: u64,
    pub address_space: Option<u64>,
    /// Processes of the uid; `None` where the caller's own would count.
    pub processes: Option<u64>,
}

/// What hides the machine's files.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) enum Confinement {
    /// bubblewrap, and the words before the command.
    Bubblewrap { program: PathBuf, words: Vec<String> },
    /// Landlock.
    Landlock { readable: Vec<PathBuf>, writable: Vec<PathBuf> },
    /// Nothing.
    None,
}

/// Is the helper if the program was started as such: returns only if that failed, or if this is no helper.
pub fn jail_if_asked(mut arguments: impl Iterator<Item = OsString>) -> Option<ExitCode> {
    if arguments.nth(1)? != WORD {
        return None;
    }
    let Err(error) = become_the_command();
    let _ = writeln!(std::io::stderr(), "parsim2d: sandbox: {error}");
    Some(ExitCode::from(FAILED))
}

fn become_the_command() -> Result<std::convert::Infallible, Box<dyn Error>> {
    let mut stdout = std::io::stdout();
    stdout.write_all(&READY).and_then(|()| stdout.flush())?;
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text)?;
    let order: Order = serde_json::from_str(&text)?;
    close_what_was_inherited()?;
    let stdin = File::open(&order.stdin)?;
    let filters = order.filters.map(programs).transpose()?.unwrap_or_default();
    setsid()?;
    umask(Mode::from_bits_truncate(0o077));
    set_limits(order.limits)?;
    if let Some(id) = order.identity {
        setgroups(&[])?;
        setgid(Gid::from_raw(id))?;
        setuid(Uid::from_raw(id))?;
    }
    std::env::set_current_dir(&order.folder)?;
    prctl::set_no_new_privs()?;
    let (mut command, _handed_down) = shut_in(&order, &filters)?;
    command.env_clear().envs(order.environment).stdin(Stdio::from(stdin));
    let error = command.exec();
    Err(format!("{}: {error}", order.command[0]).into())
}

/// Closes every file but the standard ones: whoever started the grader may have left some open.
fn close_what_was_inherited() -> std::io::Result<()> {
    let entries = std::fs::read_dir("/proc/self/fd")?;
    let numbers: Vec<i32> = entries
        .filter_map(|entry| entry.ok()?.file_name().to_str()?.parse().ok())
        .filter(|number| *number > 2)
        .collect();
    for number in numbers {
        let _ = close(number); // the folder of the list itself is closed already
    }
    Ok(())
}

/// Shuts this process in as far as it does that itself; the command that is to follow, and the files that
/// must stay open until then.
fn shut_in(
    order: &Order,
    filters: &[BpfProgram],
) -> Result<(Command, Vec<OwnedFd>), Box<dyn Error>> {
    if let Confinement::Bubblewrap { program, words } = &order.confinement {
        let mut command = Command::new(program);
        command.args(words);
        let files = filters.iter().map(handed_down).collect::<Result<Vec<_>, _>>()?;
        for file in &files {
            command.args(["--add-seccomp-fd", &file.as_raw_fd().to_string()]);
        }
        command.arg("--").args(&order.command);
        return Ok((command, files));
    }
    if let Confinement::Landlock { readable, writable } = &order.confinement {
        landlock_rules::shut_in(readable, writable)?;
    }
    for filter in filters {
        seccompiler::apply_filter(filter)?;
    }
    let mut command = Command::new(&order.command[0]);
    command.args(&order.command[1..]);
    Ok((command, Vec::new()))
}

/// A filter as a file that stays open across exec.
fn handed_down(filter: &BpfProgram) -> Result<OwnedFd, Box<dyn Error>> {
    let mut file = File::from(memfd_create("filter", MFdFlags::empty())?);
    file.write_all(&bytes_of(filter))?;
    file.rewind()?;
    Ok(file.into())
}

fn set_limits(limits: ResourceLimits) -> nix::Result<()> {
    setrlimit(Resource::RLIMIT_CORE, 0, 0)?;
    // At the first the program gets SIGXCPU, at the second SIGKILL.
    setrlimit(Resource::RLIMIT_CPU, limits.cpu, limits.cpu + 1)?;
    setrlimit(Resource::RLIMIT_FSIZE, limits.file, limits.file)?;
    setrlimit(Resource::RLIMIT_NOFILE, 256, 256)?;
    if let Some(bytes) = limits.address_space {
        setrlimit(Resource::RLIMIT_AS, bytes, bytes)?;
    }
    if let Some(count) = limits.processes {
        setrlimit(Resource::RLIMIT_NPROC, count, count)?;
    }
    Ok(())
}
