//! One command in the sandbox, from its start to the end of all that came from it.

use std::fs::File;
use std::io::{self, Read, Write};
use std::os::fd::OwnedFd;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use nix::fcntl::OFlag;
use nix::unistd::{Pid, pipe2};

use super::folder::left;
use super::frame_capture::FrameCapture;
use super::jail::{Order, READY, WORD};
use super::log::Log;
use super::process::Change;
use super::trace::{Ending, Tracer, Watched, seize};
use super::untraced::Watcher;
use super::watchdog::{Appended, DISC_LEFT, Watchdog};
use crate::grading::sandbox::{Outcome, SandboxError};

/// Processes of the sandbox itself, beside those of a submission.
const WRAPPERS: usize = 3;

/// A command and what it may have.
pub(super) struct Job<'a> {
    pub helper: &'a Path,
    pub order: Order,
    pub is_traced: bool,
    /// Whether the sandbox is a program of its own, which begins before the command does.
    pub is_wrapped: bool,
    pub wall: Duration,
    pub memory: u64,
    /// Bytes of all files together, and the folders where they are.
    pub files: u64,
    pub folders: Vec<PathBuf>,
    pub processes: usize,
    pub log: usize,
    pub capture: Option<FrameCapture>,
    pub appended: Option<Appended>,
}

/// What became of it.
pub(super) struct Attempt {
    pub outcome: Outcome,
    /// Whether it ended by itself.
    pub has_ended: bool,
    pub log: String,
    pub took: Duration,
    /// See [`Ending::asked_before`].
    pub asked_before: Option<u64>,
    pub capture: Option<FrameCapture>,
}

/// Does `job`. The tracer must be the thread that started the command, and waits for all children of its
/// own, so it is a thread that has no others.
pub(super) fn attempt(job: Job) -> Result<Attempt, SandboxError> {
    // It would be stopped for filling the disc, and it is not its fault.
    if let Some(full) = job.folders.iter().find(|path| left(path) < 2 * DISC_LEFT) {
        let what = format!("run anything in {}", full.display());
        return Err(SandboxError::Broken { what, error: io::ErrorKind::StorageFull.into() });
    }
    thread::scope(|scope| {
        let thread = thread::Builder::new().name("tracer".to_owned());
        let tracer = thread.spawn_scoped(scope, || follow(job));
        let tracer = tracer.map_err(SandboxError::broken("start a thread"))?;
        tracer.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}

fn follow(job: Job) -> Result<Attempt, SandboxError> {
    let start = Instant::now();
    let order =
        serde_json::to_vec(&job.order).map_err(|error| SandboxError::Jail(error.to_string()))?;
    let (mut child, printed) =
        spawn(job.helper).map_err(SandboxError::broken("start the sandbox"))?;
    let first = Pid::from_raw(child.id() as i32);
    let seized = if job.is_traced { seize(first) } else { Ok(()) };
    if let Err(error) = seized {
        let _ = child.kill().and_then(|()| child.wait());
        return Err(SandboxError::Jail(format!("it cannot be traced: {error}")));
    }
    let watched = Watched::new(first);
    let mut capture = job.capture;
    let folders = job.folders.clone();
    let clock = Watchdog {
        watched: &watched,
        wall: job.wall,
        memory: job.memory,
        files: job.files,
        folders: job.folders.clone(),
        appended: job.appended,
    };
    let (ending, log) = thread::scope(|scope| {
        let log = scope.spawn(|| Log::of(printed, job.log));
        scope.spawn(|| clock.watch());
        // Only now it begins. If it is gone already, waiting will tell.
        let _ = child.stdin.take().map(|mut stdin| stdin.write_all(&order));
        let (capture, wrapped) = (capture.as_mut(), job.is_wrapped);
        let processes = job.processes + WRAPPERS;
        let ending = if job.is_traced {
            let programs = 1 + usize::from(wrapped);
            Tracer::new(&watched, capture, programs, processes, &folders).until_the_end()
        } else {
            let watched = &watched;
            Watcher { watched, capture, processes, is_wrapped: wrapped }.until_the_end(&mut child)
        };
        watched.lock().is_over = true;
        (ending, log.join().unwrap_or_default())
    });
    let took = watched.lock().began.unwrap_or(start).elapsed();
    Ok(told(&watched, &ending, log.text(), took, capture))
}

fn told(
    watched: &Watched,
    ending: &Ending,
    log: String,
    took: Duration,
    capture: Option<FrameCapture>,
) -> Attempt {
    let stop = watched.lock().stop.map(|(reason, _)| reason);
    // That it ended is no reason for which it was stopped.
    let stop = stop.filter(|reason| *reason != Outcome::Ended(0));
    let has_ended = stop.is_none() && matches!(ending.change, Some(Change::Ended(_)));
    let asked_before = ending.asked_before;
    Attempt { outcome: outcome(ending, stop), has_ended, log, took, asked_before, capture }
}

fn outcome(ending: &Ending, stop: Option<Outcome>) -> Outcome {
    match (stop, ending.change) {
        (Some(reason), _) => reason,
        _ if ending.wrote_too_much => Outcome::OutputTooLarge,
        _ if ending.computed_too_long => Outcome::CpuUp,
        (_, Some(Change::Ended(code))) => Outcome::Ended(code),
        (_, Some(Change::Killed(signal))) => Outcome::Signal(signal),
        _ => Outcome::NotStarted,
    }
}

/// The helper, which waits for its order, and the end of a pipe where all comes out that is printed.
pub(super) fn spawn(helper: &Path) -> io::Result<(Child, File)> {
    let (printed, inlet) = pipe2(OFlag::O_CLOEXEC)?;
    let mut printed = File::from(printed);
    let other: OwnedFd = inlet.try_clone()?;
    let mut child = Command::new(helper)
        .arg(WORD)
        .stdin(Stdio::piped())
        .stdout(Stdio::from(inlet))
        .stderr(Stdio::from(other))
        .spawn()?;
    let mut greeting = [0; READY.len()];
    let is_there = printed.read_exact(&mut greeting).is_ok() && greeting == READY;
    if !is_there {
        child.kill().and_then(|()| child.wait())?;
        return Err(io::Error::other(format!("{} is not parsim2d", helper.display())));
    }
    Ok((child, printed))
}
