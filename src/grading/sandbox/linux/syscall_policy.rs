//! What a submission under the caller's uid may do to processes and to the modes of files.
//!
//! Landlock does not watch chmod(2), and signals only since Linux 6.12. So such calls stop for the tracer. A signal goes
//! through if it goes to a process of the submission. A mode is changed by the tracer, so that no thread can
//! change the path after it was looked at.

use std::collections::HashSet;
use std::fs::{self, File, OpenOptions, Permissions};
use std::io;
use std::os::fd::AsRawFd;
use std::os::unix::fs::{OpenOptionsExt, PermissionsExt};
use std::path::PathBuf;

use nix::libc;
use nix::unistd::Pid;

use super::syscall::{Syscall, text};

/// fchmodat2(2), Linux 6.6; the same number on every machine.
pub(super) const FCHMODAT2: i64 = 452;

/// Calls that send signals.
pub(super) const SIGNALS: &[i64] = &[
    libc::SYS_kill,
    libc::SYS_tkill,
    libc::SYS_tgkill,
    libc::SYS_rt_sigqueueinfo,
    libc::SYS_rt_tgsigqueueinfo,
];

/// Calls that change the mode of a file by its path.
pub(super) const MODES: &[i64] = &[
    libc::SYS_fchmodat,
    FCHMODAT2,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_chmod,
];

/// The result that `pid` gets instead of its call; `None`: the call may be made. `own` are the processes of the
/// submission, `folders` those it may write to.
pub(super) fn ruling(
    pid: Pid,
    call: &Syscall,
    own: &HashSet<Pid>,
    folders: &[PathBuf],
) -> Option<i64> {
    let [a, b, c, d, ..] = call.arguments;
    let is_own = |target: u64| own.contains(&Pid::from_raw(target as i32));
    let may = match call.number {
        libc::SYS_kill => match a as i32 {
            0 => true,
            group @ ..=-2 => is_own(u64::from(group.unsigned_abs())),
            _ => is_own(a),
        },
        libc::SYS_tkill | libc::SYS_rt_sigqueueinfo => is_own(a),
        libc::SYS_tgkill | libc::SYS_rt_tgsigqueueinfo => is_own(a) && is_own(b),
        libc::SYS_fchmodat => return Some(change(pid, a, b, c, folders)),
        FCHMODAT2 if d == 0 => return Some(change(pid, a, b, c, folders)),
        FCHMODAT2 => false,
        #[cfg(target_arch = "x86_64")]
        libc::SYS_chmod => return Some(change(pid, libc::AT_FDCWD as u64, a, b, folders)),
        _ => true,
    };
    (!may).then_some(-i64::from(libc::EPERM))
}

/// Changes the mode of the file at `path`, if it lies in one of `folders`; what the process is to be told.
fn change(pid: Pid, at: u64, path: u64, mode: u64, folders: &[PathBuf]) -> i64 {
    let changed = text(pid, path)
        .and_then(|path| String::from_utf8(path).ok())
        .ok_or(io::Error::from_raw_os_error(libc::ENOENT))
        .and_then(|path| change_in(pid, at as i32, &path, mode as u32 & 0o777, folders));
    changed.map_or_else(|error| -i64::from(error.raw_os_error().unwrap_or(libc::EPERM)), |()| 0)
}

fn change_in(pid: Pid, at: i32, path: &str, mode: u32, folders: &[PathBuf]) -> io::Result<()> {
    let base = match at {
        _ if path.starts_with('/') => "root".to_owned(),
        libc::AT_FDCWD => "cwd".to_owned(),
        fd => format!("fd/{fd}"),
    };
    let flags = libc::O_PATH | libc::O_CLOEXEC;
    let path = format!("/proc/{pid}/{base}/{path}");
    // Whatever it is and however it was reached, it is this from here on.
    let file: File = OpenOptions::new().read(true).custom_flags(flags).open(path)?;
    let name = format!("/proc/self/fd/{}", file.as_raw_fd());
    let place = fs::read_link(&name)?;
    if !folders.iter().any(|folder| place.starts_with(folder)) {
        return Err(io::Error::from_raw_os_error(libc::EPERM));
    }
    fs::set_permissions(name, Permissions::from_mode(mode))
}
