//! The clock: looks every few milliseconds whether a submission has had enough of anything, and stops it.

use std::fs;
use std::os::unix::fs::FileExt;
use std::path::PathBuf;
use std::sync::atomic::Ordering;
use std::thread;
use std::time::{Duration, Instant};

use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;

use super::folder;
use super::stops::FILE;
use super::trace::{Inner, Watched};
use crate::grading::sandbox::Outcome;

/// Between two looks.
const TICK: Duration = Duration::from_millis(10);
/// Between being asked to end and being made to.
const GRACE: Duration = Duration::from_millis(500);
/// A submission is stopped before the disc has less left than this, bytes.
pub(super) const DISC_LEFT: u64 = 128 << 20;

/// How much a command may have, and where it writes.
pub(super) struct Watchdog<'a> {
    pub watched: &'a Watched,
    pub wall: Duration,
    pub memory: u64,
    /// Bytes of all its files together.
    pub files: u64,
    /// The folders it may write to.
    pub folders: Vec<PathBuf>,
    pub appended: Option<Appended>,
}

impl Watchdog<'_> {
    /// Until the submission is over.
    pub fn watch(mut self) {
        let spawned = Instant::now();
        for tick in 0_u64.. {
            thread::sleep(TICK);
            if self.enforce() {
                return;
            }
            if let Some(reason) = self.reason(spawned, tick) {
                self.watched.stop(reason);
            }
        }
    }

    /// Stops what is to be stopped; whether all is over.
    fn enforce(&self) -> bool {
        let known = self.watched.lock();
        if known.is_over {
            return true;
        }
        let Some((reason, since)) = known.stop else { return false };
        let is_gentle = matches!(reason, Outcome::EnoughFrames | Outcome::TimeUp);
        if !is_gentle || since.elapsed() > GRACE {
            known.kill_all();
        } else if since.elapsed() < 2 * TICK {
            ask_to_end(&known);
        }
        false
    }

    fn reason(&mut self, spawned: Instant, tick: u64) -> Option<Outcome> {
        let (began, pids) = {
            let known = self.watched.lock();
            if known.stop.is_some() {
                return None;
            }
            (known.began.unwrap_or(spawned), known.all.iter().copied().collect::<Vec<_>>())
        };
        if began.elapsed() > self.wall {
            return Some(Outcome::TimeUp);
        }
        if memory_of(&pids) > self.memory {
            return Some(Outcome::MemoryUp);
        }
        if tick % 5 == 0 && self.has_filled_the_disc() {
            return Some(Outcome::OutputTooLarge);
        }
        let has_all_frames = self.appended.as_mut().is_some_and(Appended::is_enough);
        // One: there may have been something before, or only its beginning was seen.
        let none_replaced = self.watched.frames.load(Ordering::Relaxed) <= 1;
        (has_all_frames && none_replaced).then_some(Outcome::EnoughFrames)
    }

    fn has_filled_the_disc(&self) -> bool {
        let used: u64 = self.folders.iter().map(|path| folder::used(path)).sum();
        used > self.files || self.folders.iter().any(|path| folder::left(path) < DISC_LEFT)
    }
}

fn ask_to_end(known: &Inner) {
    for &pid in known.all.difference(&known.wrappers) {
        let _ = kill(pid, Signal::SIGTERM);
    }
}

/// Resident memory of processes together, bytes; threads share theirs with their process.
fn memory_of(pids: &[Pid]) -> u64 {
    pids.iter().filter_map(|&pid| resident(pid)).sum()
}

fn resident(pid: Pid) -> Option<u64> {
    let status = fs::read_to_string(format!("/proc/{pid}/status")).ok()?;
    let value = |key: &str| {
        let line = status.lines().find_map(|line| line.strip_prefix(key))?;
        line.split_whitespace().next()?.parse::<u64>().ok()
    };
    (value("Tgid:")? == pid.as_raw() as u64).then_some(())?;
    Some(value("VmRSS:").or_else(|| resident_of_threads(pid))? * 1024)
}

/// What the threads have, kB, of a process whose first thread has ended: it says nothing itself.
fn resident_of_threads(pid: Pid) -> Option<u64> {
    let threads = fs::read_dir(format!("/proc/{pid}/task")).ok()?.flatten();
    let said = threads.filter_map(|thread| {
        let status = fs::read_to_string(thread.path().join("status")).ok()?;
        let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
        line.split_whitespace().next()?.parse().ok()
    });
    said.max() // they share it
}

/// Counts the frames of a program that adds them to one file.
pub(super) struct Appended {
    path: PathBuf,
    wanted: usize,
    /// Rows of a frame, if known.
    rows_of_a_frame: Option<usize>,
    read: u64,
    rows: usize,
    blocks: usize,
    is_in_block: bool,
    line_is_blank: bool,
}

impl Appended {
    /// In `out.txt` of `folder`, until there are more than `wanted`.
    pub fn new(folder: &std::path::Path, wanted: usize, rows_of_a_frame: Option<usize>) -> Self {
        let path = folder.join(FILE);
        Self {
            path,
            wanted,
            rows_of_a_frame,
            read: 0,
            rows: 0,
            blocks: 0,
            is_in_block: false,
            line_is_blank: true,
        }
    }

    /// Whether there are enough frames, with what was added since the last look.
    fn is_enough(&mut self) -> bool {
        let mut buffer = vec![0; 256 << 10];
        let Some(file) = folder::open_regular(&self.path) else { return false };
        while let Ok(count @ 1..) = file.read_at(&mut buffer, self.read) {
            self.read += count as u64;
            buffer[..count].iter().for_each(|&byte| self.take(byte));
        }
        let by_rows =
            self.rows_of_a_frame.is_some_and(|rows| self.rows >= rows.max(1) * self.wanted);
        self.blocks >= self.wanted || by_rows
    }

    fn take(&mut self, byte: u8) {
        match byte {
            b'\n' if self.line_is_blank => {
                self.blocks += usize::from(self.is_in_block);
                self.is_in_block = false;
            }
            b'\n' => {
                self.rows += 1;
                self.is_in_block = true;
                self.line_is_blank = true;
            }
            b' ' | b'\t' | b'\r' => {}
            _ => self.line_is_blank = false,
        }
    }
}
