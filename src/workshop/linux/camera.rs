//! Keeps what a program writes to `out.txt`, frame by frame.

use std::fs::{self, File, Metadata};
use std::io::{self, Read};
use std::os::fd::OwnedFd;
use std::path::Path;

use nix::fcntl::{OFlag, openat};
use nix::sys::stat::{Mode, fchmod};

use super::stops::{About, FILE};
use crate::workshop::Film;

/// Sees `out.txt` of one folder.
pub(super) struct Camera {
    folder: OwnedFd,
    identity: Metadata,
    frames: Vec<Vec<u8>>,
    /// The last frame stayed in the file, so that it may be seen once more and is no second one then.
    was_left: bool,
    /// Bytes of all frames.
    held: usize,
    /// How much a film may be.
    bounds: Bounds,
    torn: usize,
}

/// How much a film may be.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    /// Frames.
    pub frames: usize,
    /// Bytes of all frames together.
    pub bytes: usize,
    /// Bytes of one file.
    pub file: u64,
}

impl Camera {
    /// On `out.txt` of `folder`.
    pub fn on(folder: &Path, bounds: Bounds) -> io::Result<Self> {
        let identity = fs::symlink_metadata(folder)?;
        let folder = File::open(folder)?.into();
        Ok(Self { folder, identity, frames: Vec::new(), was_left: false, held: 0, bounds, torn: 0 })
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
        self.frames.len() >= self.bounds.frames || self.held >= self.bounds.bytes
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

    /// Keeps what the file holds, seen at any moment, if it is new and looks whole.
    pub fn glance(&mut self) {
        if self.is_full() {
            return;
        }
        let Some(bytes) = self.read() else { return };
        if bytes.is_empty() || self.frames.last() == Some(&bytes) {
        } else if self.frames.last().is_none_or(|last| is_whole(&bytes, last))
            && bytes.ends_with(b"\n")
        {
            self.was_left = true;
            self.keep(bytes);
        } else {
            self.torn += 1;
        }
    }

    fn keep(&mut self, bytes: Vec<u8>) {
        self.held += bytes.len();
        self.frames.push(bytes);
    }

    /// What `out.txt` holds, if it is a regular file. Follows no link and waits for no pipe.
    fn read(&self) -> Option<Vec<u8>> {
        let flags = OFlag::O_RDONLY | OFlag::O_NOFOLLOW | OFlag::O_NONBLOCK | OFlag::O_CLOEXEC;
        let file = File::from(openat(&self.folder, FILE, flags, Mode::empty()).ok()?);
        if !file.metadata().ok()?.is_file() {
            return None;
        }
        let mut bytes = Vec::new();
        file.take(self.bounds.file).read_to_end(&mut bytes).ok()?;
        Some(bytes)
    }

    /// The film, and how many frames were left out as half-written. What the file holds now counts as
    /// whole if the program `has_ended` by itself, and else if it looks so.
    pub fn film(mut self, has_ended: bool) -> (Film, usize) {
        // The program may have locked its folder.
        let _ = fchmod(&self.folder, Mode::S_IRWXU);
        let last = self.read();
        if self.frames.is_empty() {
            let film = last.map_or(Film::Nothing, |bytes| {
                Film::File(if has_ended { bytes } else { up_to_a_line(bytes) })
            });
            return (film, self.torn);
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
        (Film::Snapshots(self.frames), self.torn)
    }
}

/// Whether `bytes` may be a whole frame, judged by another one: as many lines, the last one ended.
fn is_whole(bytes: &[u8], other: &[u8]) -> bool {
    let lines = |bytes: &[u8]| bytes.iter().filter(|&&byte| byte == b'\n').count();
    bytes.ends_with(b"\n") == other.ends_with(b"\n") && lines(bytes) == lines(other)
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
