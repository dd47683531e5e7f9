//! What a traced process is about to do at a stop: which file it is going to replace.

use std::fs::{self, Metadata};
use std::io;
use std::os::unix::fs::MetadataExt;

use nix::libc;
use nix::unistd::Pid;

use super::syscall::{Syscall, text, word};

/// The name that matters.
pub(super) const FILE: &str = "out.txt";

/// What a stop means for `out.txt` of the folder with a given identity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum About {
    /// It is about to be replaced: what it holds is a whole frame.
    Replacing,
    /// It may be written over from its beginning; if it holds something new, that is a frame.
    Rewinding,
    /// Another file.
    Other,
}

/// What the system call at which `pid` is stopped is about; `folder` is that of `out.txt`.
pub(super) fn about(pid: Pid, call: &Syscall, folder: &Metadata) -> About {
    let [a, b, c, d, ..] = call.arguments;
    const HERE: u64 = libc::AT_FDCWD as u64;
    let named = |at: u64, path: u64| names(pid, at, path, folder);
    let is_about = match call.number {
        #[cfg(target_arch = "x86_64")]
        libc::SYS_open | libc::SYS_creat | libc::SYS_unlink => named(HERE, a),
        #[cfg(target_arch = "x86_64")]
        libc::SYS_rename => named(HERE, b) || named(HERE, a),
        libc::SYS_truncate => named(HERE, a),
        libc::SYS_openat | libc::SYS_unlinkat => named(a, b),
        libc::SYS_openat2 => {
            word(pid, c).is_some_and(|flags| flags & libc::O_TRUNC as u64 != 0) && named(a, b)
        }
        libc::SYS_renameat | libc::SYS_renameat2 => named(c, d) || named(a, b),
        libc::SYS_ftruncate => is_open(pid, a, folder),
        libc::SYS_lseek | libc::SYS_pwrite64 if is_open(pid, a, folder) => return About::Rewinding,
        _ => false,
    };
    if is_about { About::Replacing } else { About::Other }
}

/// Whether the path at `address` in the memory of `pid` names `out.txt` in `folder`.
fn names(pid: Pid, at: u64, address: u64, folder: &Metadata) -> bool {
    let Some(path) = text(pid, address) else { return false };
    let Some(parent) = path.strip_suffix(FILE.as_bytes()) else { return false };
    if !(parent.is_empty() || parent.ends_with(b"/")) {
        return false;
    }
    let Ok(parent) = std::str::from_utf8(parent) else { return false };
    let base = match at as i32 {
        _ if parent.starts_with('/') => "root".to_owned(),
        libc::AT_FDCWD => "cwd".to_owned(),
        fd => format!("fd/{fd}"),
    };
    // Only compared with the folder, so it does no harm that links in it are followed.
    match fs::metadata(format!("/proc/{pid}/{base}/{parent}")) {
        Ok(found) => is_same(&found, folder),
        // In a container root may lack the right to look there; the name alone must do then.
        Err(error) => error.kind() == io::ErrorKind::PermissionDenied,
    }
}

/// Whether `fd` of `pid` is `out.txt` of the folder, as far as its device and name tell.
fn is_open(pid: Pid, fd: u64, folder: &Metadata) -> bool {
    let link = format!("/proc/{pid}/fd/{}", fd as i32);
    let named =
        fs::read_link(&link).is_ok_and(|path| path.file_name().is_some_and(|name| name == FILE));
    named && fs::metadata(&link).is_ok_and(|file| file.dev() == folder.dev())
}

fn is_same(a: &Metadata, b: &Metadata) -> bool {
    a.dev() == b.dev() && a.ino() == b.ino()
}
