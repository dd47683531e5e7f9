//! Keeps what a program writes to `out.txt`, frame by frame.

use std::collections::HashMap;
use std::fs::{self, File, Metadata};
use std::io::{self, Read};
use std::os::fd::OwnedFd;
use std::os::unix::fs::MetadataExt;
use std::path::Path;

use nix::fcntl::{OFlag, openat};
use nix::sys::stat::{Mode, fchmod};

use super::stops::{About, FILE};
use crate::grading::sandbox::Captured;

/// Sees `out.txt` of one folder.
pub(super) struct FrameCapture {
    folder: OwnedFd,
    identity: Metadata,
    frames: Vec<Vec<u8>>,
    /// The last frame stayed in the file, so that it may be seen once more and is no second one then.
    was_left: bool,
    /// Bytes of all frames.
    held: usize,
    /// How much may be captured.
    limits: CaptureLimits,
    /// Frames were seen at any moment, not at stops.
    is_from_outside: bool,
    torn: usize,
}

/// How much may be captured.
#[derive(Debug, Clone, Copy)]
pub(super) struct CaptureLimits {
    /// Frames.
    pub frames: usize,
    /// Bytes of all frames together.
    pub bytes: usize,
    /// Bytes of one file.
    pub file: u64,
}

impl FrameCapture {
    /// On `out.txt` of `folder`.
    pub fn on(folder: &Path, limits: CaptureLimits) -> io::Result<Self> {
        let identity = fs::symlink_metadata(folder)?;
        let folder = File::open(folder)?.into();
        Ok(Self {
            folder,
            identity,
            frames: Vec::new(),
            was_left: false,
            held: 0,
            limits,
            is_from_outside: false,
            torn: 0,
        })
    }

    /// The folder, by which the tracer knows it again.
    pub fn identity(&self) -> &Metadata {
        &self.identity
    }

    /// Frames kept so far.
    pub fn frames(&self) -> usize {
        self.frames.len()
    }

    /// Whether no more is kept: there are as many frames, or as many bytes, as may be.
    pub fn is_full(&self) -> bool {
        self.frames.len() >= self.limits.frames || self.held >= self.limits.bytes
    }

    /// Keeps what the file holds, if the program is about to replace it.
    pub fn look(&mut self, about: About) {
        if about == About::Other || self.is_full() {
            return;
        }
        let Some(bytes) = self.read().filter(|bytes| !bytes.is_empty()) else { return };
        let is_rewound = about == About::Rewinding;
        let is_same = self.frames.last() == Some(&bytes);
        if is_same && (is_rewound || self.was_left) {
            self.was_left = is_rewound;
            return;
        }
        self.was_left = is_rewound;
        self.keep(bytes);
    }

    /// Keeps what the file holds, seen at any moment, if it is new. Whether it was whole is told by all
    /// of them at the end.
    pub fn glance(&mut self) {
        if self.is_full() {
            return;
        }
        let Some(bytes) = self.read_undisturbed().filter(|bytes| !bytes.is_empty()) else { return };
        match self.frames.last_mut() {
            // Still the same, or longer: it was not all there yet, or frames are added.
            Some(last) if bytes.starts_with(last) => *last = bytes,
            _ => self.keep(bytes),
        }
        (self.was_left, self.is_from_outside) = (true, true);
    }

    /// Leaves out frames that are not like most: they were seen half-written.
    fn leave_out_torn(&mut self) {
        let mut counts = HashMap::new();
        self.frames.iter().for_each(|frame| *counts.entry(shape(frame)).or_insert(0) += 1);
        let most =
            counts.into_iter().max_by_key(|&(shape, count)| (count, shape)).map(|(shape, _)| shape);
        let before = self.frames.len();
        self.frames.retain(|frame| Some(shape(frame)) == most);
        self.torn += before - self.frames.len();
    }

    fn keep(&mut self, bytes: Vec<u8>) {
        self.held += bytes.len();
        self.frames.push(bytes);
    }

    /// What `out.txt` holds, if it is a regular file. Follows no link and waits for no pipe.
    fn read(&self) -> Option<Vec<u8>> {
        let mut file = self.file()?;
        let mut bytes = Vec::new();
        (&mut file).take(self.limits.file).read_to_end(&mut bytes).ok()?;
        Some(bytes)
    }

    /// What it holds, if nobody wrote to it meanwhile.
    fn read_undisturbed(&self) -> Option<Vec<u8>> {
        let state = || {
            self.file()?.metadata().ok().map(|found| (found.ino(), found.len(), found.ctime_nsec()))
        };
        let before = state()?;
        let bytes = self.read()?;
        (Some(before) == state() && before.1 == bytes.len() as u64).then_some(bytes)
    }

    fn file(&self) -> Option<File> {
        let flags = OFlag::O_RDONLY | OFlag::O_NOFOLLOW | OFlag::O_NONBLOCK | OFlag::O_CLOEXEC;
        let file = File::from(openat(&self.folder, FILE, flags, Mode::empty()).ok()?);
        file.metadata().ok()?.is_file().then_some(file)
    }

    /// What was captured, and how many frames were left out as half-written. What the file holds now counts as
    /// whole if the program `has_ended` by itself, and else if it looks so.
    pub fn into_captured(mut self, has_ended: bool) -> (Captured, usize) {
        // The program may have locked its folder.
        let _ = fchmod(&self.folder, Mode::S_IRWXU);
        let last = self.read();
        if self.is_from_outside {
            self.leave_out_torn();
        }
        let only = self.frames.first().filter(|_| self.frames.len() == 1 && self.was_left);
        let was_never_replaced =
            only.is_none_or(|only| last.as_ref().is_some_and(|last| last.starts_with(only)));
        if self.frames.is_empty() || only.is_some() && was_never_replaced {
            let captured = last.map_or(Captured::Nothing, |bytes| {
                Captured::File(if has_ended { bytes } else { up_to_a_line(bytes) })
            });
            return (captured, self.torn);
        }
        let is_new = |bytes: &Vec<u8>| {
            !bytes.is_empty() && (!self.was_left || self.frames.last() != Some(bytes))
        };
        let is_good = |bytes: &Vec<u8>| {
            has_ended || self.frames.last().is_some_and(|frame| is_whole(bytes, frame))
        };
        if let Some(bytes) = last.filter(is_new).filter(is_good).filter(|_| !self.is_full()) {
            self.keep(bytes);
        }
        (Captured::Snapshots(self.frames), self.torn)
    }
}

/// Whether `bytes` may be a whole frame, judged by another one.
fn is_whole(bytes: &[u8], other: &[u8]) -> bool {
    shape(bytes) == shape(other)
}

/// What whole frames of a program have in common: their number of lines, and whether the last one is ended.
fn shape(bytes: &[u8]) -> (usize, bool) {
    (bytes.iter().filter(|&&byte| byte == b'\n').count(), bytes.ends_with(b"\n"))
}

/// `bytes` without what follows the last end of a line, or the last blank line if there are any.
fn up_to_a_line(mut bytes: Vec<u8>) -> Vec<u8> {
    let ends =
        |what: &[u8]| bytes.windows(what.len()).rposition(|at| at == what).map(|k| k + what.len());
    let blank = ends(b"\n\n").max(ends(b"\n\r\n"));
    let end = blank.or_else(|| ends(b"\n")).unwrap_or(0);
    bytes.truncate(end);
    bytes
}
