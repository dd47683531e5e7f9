//! Where ptrace is refused: looks from outside, and may miss frames, but takes no half-written one.

use std::collections::HashMap;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, ExitStatus};
use std::sync::atomic::Ordering;
use std::thread;
use std::time::{Duration, Instant};

use nix::libc;
use nix::unistd::Pid;

use super::frame_capture::FrameCapture;
use super::process::Change;
use super::trace::{Ending, Watched};
use crate::grading::sandbox::Outcome;

/// Between two looks.
const LOOK: Duration = Duration::from_millis(1);
/// Looks between two counts of processes.
const COUNT: u64 = 10;

/// Watches a submission without tracing it.
pub(super) struct Watcher<'a> {
    pub watched: &'a Watched,
    pub capture: Option<&'a mut FrameCapture>,
    /// Processes allowed at a time, those of the sandbox included.
    pub processes: usize,
    /// Whether the exit code is that of the sandbox, which tells signals as 128 and more.
    pub is_wrapped: bool,
}

impl Watcher<'_> {
    /// Until nothing is left of the submission.
    pub fn until_the_end(mut self, child: &mut Child) -> Ending {
        self.watched.lock().began = Some(Instant::now());
        for look in 0_u64.. {
            self.glance();
            if look % COUNT == 0 {
                self.count();
            }
            match child.try_wait() {
                Ok(None) => thread::sleep(LOOK),
                Ok(Some(status)) => return self.ending(status),
                Err(_) => break,
            }
        }
        Ending::default()
    }

    fn glance(&mut self) {
        let Some(capture) = self.capture.as_deref_mut() else { return };
        capture.glance();
        self.watched.frames.store(capture.frames(), Ordering::Relaxed);
        if capture.is_full() {
            self.watched.stop(Outcome::EnoughFrames);
        }
    }

    /// Finds what came from the processes that are known.
    fn count(&self) {
        let parents = parents();
        let mut known = self.watched.lock();
        known.all.retain(|pid| parents.contains_key(pid));
        loop {
            let before = known.all.len();
            let children = parents.iter().filter(|(_, parent)| known.all.contains(parent));
            let children: Vec<_> = children.map(|(&child, _)| child).collect();
            known.all.extend(children);
            if known.all.len() == before {
                break;
            }
        }
        if known.all.len() > self.processes {
            known.stop.get_or_insert((Outcome::TooManyProcesses, Instant::now()));
            known.kill_all();
        }
    }

    fn ending(&self, status: ExitStatus) -> Ending {
        // What it leaves behind was its child or grandchild when last counted.
        for _ in 0..3 {
            self.count();
            self.watched.lock().kill_all();
        }
        let signal = status.signal().or_else(|| {
            let code = status.code().filter(|_| self.is_wrapped)?;
            (code > 128).then_some(code - 128)
        });
        Ending {
            change: signal.map(Change::Killed).or(status.code().map(Change::Ended)),
            wrote_too_much: signal == Some(libc::SIGXFSZ),
            computed_too_long: signal == Some(libc::SIGXCPU),
            ..Ending::default()
        }
    }
}

/// The parent of every process.
fn parents() -> HashMap<Pid, Pid> {
    let entries = fs::read_dir("/proc").into_iter().flatten().flatten();
    let parent = |entry: fs::DirEntry| {
        let pid = entry.file_name().to_str()?.parse().ok()?;
        let stat = fs::read_to_string(entry.path().join("stat")).ok()?;
        // The name stands in brackets and may hold anything; the state and the parent follow.
        let parent = stat.rsplit_once(')')?.1.split_whitespace().nth(1)?.parse().ok()?;
        Some((Pid::from_raw(pid), Pid::from_raw(parent)))
    };
    entries.filter_map(parent).collect()
}
