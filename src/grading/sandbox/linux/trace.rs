//! The tracer: sees every process of a submission begin and end, and stops it before it replaces `out.txt`.

use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use nix::libc;
use nix::sys::ptrace::{self, Options};
use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;

use super::frame_capture::FrameCapture;
use super::process::{Change, go_on, wait_any};
use super::stops::about;
use super::syscall::{Syscall, leave_out, syscall_of};
use super::syscall_policy::ruling;
use crate::grading::sandbox::Outcome;

/// What the tracer and the clock know of a submission that runs.
pub(super) struct Watched {
    inner: Mutex<Inner>,
    /// Frames kept.
    pub frames: AtomicUsize,
}

#[derive(Default)]
pub(super) struct Inner {
    /// All its processes and threads, and those of the sandbox.
    pub all: HashSet<Pid>,
    /// Those of the sandbox, which are not to be asked to end: they would take the others with them.
    pub wrappers: HashSet<Pid>,
    /// When the command itself began.
    pub began: Option<Instant>,
    /// Why it is to be stopped, and since when.
    pub stop: Option<(Outcome, Instant)>,
    /// Nothing is left to stop.
    pub is_over: bool,
}

impl Watched {
    /// Of a submission whose first process is `first`.
    pub fn new(first: Pid) -> Self {
        let inner = Inner { all: HashSet::from([first]), ..Inner::default() };
        Self { inner: Mutex::new(inner), frames: AtomicUsize::new(0) }
    }

    /// What is known now.
    pub fn lock(&self) -> MutexGuard<'_, Inner> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Has it stopped for `reason`, unless it is being stopped already.
    pub fn stop(&self, reason: Outcome) {
        self.lock().stop.get_or_insert((reason, Instant::now()));
    }
}

impl Inner {
    /// Kills all that there is.
    pub fn kill_all(&self) {
        for &pid in &self.all {
            let _ = kill(pid, Signal::SIGKILL);
        }
    }
}

/// How a command ended, as its tracer saw it.
#[derive(Debug, Default)]
pub(super) struct Ending {
    /// Of the command itself; `None`: it never began.
    pub change: Option<Change>,
    /// Some process wrote past the longest file allowed.
    pub wrote_too_much: bool,
    /// Some process used up its processor time.
    pub computed_too_long: bool,
    /// Bytes that were asked for on standard input before it was last read, which all processes share.
    pub asked_before: Option<u64>,
    /// Bytes that were asked for in all.
    pub asked: u64,
}

impl Ending {
    /// A process reads its standard input, which all processes share.
    fn reads(&mut self, call: &Syscall) {
        let wanted = match call.number {
            libc::SYS_read => call.arguments[2],
            _ => u64::from(u32::MAX), // how much is written in its memory: as good as all
        };
        self.asked_before = Some(self.asked);
        self.asked = self.asked.saturating_add(wanted);
    }
}

/// Traces `first` and all that come from it, until none is left.
pub(super) struct Tracer<'a> {
    watched: &'a Watched,
    capture: Option<&'a mut FrameCapture>,
    programs_before: usize,
    processes: usize,
    /// Where the submission may change modes.
    folders: &'a [PathBuf],
    command: Option<Pid>,
    ending: Ending,
    /// Those of whom their parents have told.
    announced: HashSet<Pid>,
    gone_unannounced: HashSet<Pid>,
}

/// Makes this thread the tracer of `pid`, a child of it, and of all that come from it; they die with it.
pub(super) fn seize(pid: Pid) -> nix::Result<()> {
    let follow = Options::PTRACE_O_TRACECLONE
        | Options::PTRACE_O_TRACEFORK
        | Options::PTRACE_O_TRACEVFORK
        | Options::PTRACE_O_TRACEEXEC;
    ptrace::seize(pid, follow | Options::PTRACE_O_TRACESECCOMP | Options::PTRACE_O_EXITKILL)
}

impl<'a> Tracer<'a> {
    /// `programs` begin until the command has: the sandbox if it is a program, the command. `processes`
    /// and threads are allowed at a time, those of the sandbox included.
    pub fn new(
        watched: &'a Watched,
        capture: Option<&'a mut FrameCapture>,
        programs: usize,
        processes: usize,
        folders: &'a [PathBuf],
    ) -> Self {
        let ending = Ending::default();
        Self {
            watched,
            capture,
            programs_before: programs,
            processes,
            folders,
            command: None,
            ending,
            announced: HashSet::new(),
            gone_unannounced: HashSet::new(),
        }
    }

    /// Until nothing is left of the submission.
    pub fn until_the_end(mut self) -> Ending {
        while let Ok((pid, change)) = wait_any() {
            match change {
                Change::Ended(_) | Change::Killed(_) => self.has_gone(pid, change),
                Change::Signal(signal) => {
                    self.notice(signal);
                    go_on(pid, signal);
                }
                Change::Event(event) => {
                    self.event(pid, event);
                    go_on(pid, 0);
                }
            }
        }
        self.ending
    }

    fn has_gone(&mut self, pid: Pid, change: Change) {
        if !self.announced.remove(&pid) {
            self.gone_unannounced.insert(pid);
        }
        let mut known = self.watched.lock();
        known.all.remove(&pid);
        if self.command == Some(pid) {
            self.ending.change = Some(change);
            // Nobody is left to wait for what it leaves behind.
            known.stop.get_or_insert((Outcome::Ended(0), Instant::now()));
            known.kill_all();
        }
    }

    fn notice(&mut self, signal: i32) {
        self.ending.wrote_too_much |= signal == libc::SIGXFSZ;
        self.ending.computed_too_long |= signal == libc::SIGXCPU;
    }

    fn event(&mut self, pid: Pid, event: i32) {
        match event {
            libc::PTRACE_EVENT_FORK | libc::PTRACE_EVENT_VFORK | libc::PTRACE_EVENT_CLONE => {
                let child = ptrace::getevent(pid).map(|child| Pid::from_raw(child as i32));
                child.into_iter().for_each(|child| self.is_announced(child));
            }
            libc::PTRACE_EVENT_STOP => self.has_come(pid),
            libc::PTRACE_EVENT_EXEC => self.has_become_another(pid),
            libc::PTRACE_EVENT_SECCOMP => self.look(pid),
            _ => {}
        }
    }

    /// A parent tells of its child: before the child's first step, or after its end.
    fn is_announced(&mut self, child: Pid) {
        if !self.gone_unannounced.remove(&child) {
            self.announced.insert(child);
            self.has_come(child);
        }
    }

    fn has_come(&self, pid: Pid) {
        let mut known = self.watched.lock();
        known.all.insert(pid);
        if known.all.len() > self.processes {
            known.stop.get_or_insert((Outcome::TooManyProcesses, Instant::now()));
        }
        // What is born while all are being killed must not be forgotten.
        let is_harsh = known
            .stop
            .is_some_and(|(reason, _)| !matches!(reason, Outcome::EnoughFrames | Outcome::TimeUp));
        if is_harsh {
            known.kill_all();
        }
    }

    fn has_become_another(&mut self, pid: Pid) {
        // A thread that becomes another program takes the place of its process.
        if let Some(thread) =
            ptrace::getevent(pid).ok().filter(|&thread| thread as i32 != pid.as_raw())
        {
            self.watched.lock().all.remove(&Pid::from_raw(thread as i32));
        }
        if self.command.is_some() {
            return;
        }
        self.programs_before = self.programs_before.saturating_sub(1);
        if self.programs_before == 0 {
            self.command = Some(pid);
            let mut known = self.watched.lock();
            known.wrappers = known.all.iter().copied().filter(|&other| other != pid).collect();
            known.began = Some(Instant::now());
        }
    }

    fn look(&mut self, pid: Pid) {
        let Some(call) = syscall_of(pid) else { return };
        if matches!(call.number, libc::SYS_read | libc::SYS_readv) {
            self.ending.reads(&call);
            return;
        }
        let ruling = ruling(pid, &call, &self.watched.lock().all, self.folders);
        if let Some(result) = ruling {
            // If that is impossible the process is not to go on.
            if leave_out(pid, result).is_err() {
                let _ = kill(pid, Signal::SIGKILL);
            }
            return;
        }
        let Some(capture) = self.capture.as_deref_mut() else { return };
        capture.look(about(pid, &call, capture.identity()));
        self.watched.frames.store(capture.frames(), Ordering::Relaxed);
        if capture.is_full() {
            self.watched.stop(Outcome::EnoughFrames);
        }
    }
}
