//! Waiting for traced processes, and letting them go on.
//!
//! `nix` does both, but knows no real-time signals: of a process that ends or stops by one it cannot even say
//! which it was. A hostile program could hide behind that, so these two calls are made here.

#![allow(unsafe_code)]

use nix::errno::Errno;
use nix::libc;
use nix::unistd::Pid;

/// What a process has done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Change {
    /// It ended with this exit code.
    Ended(i32),
    /// It was ended by this signal.
    Killed(i32),
    /// It stopped because this signal is about to reach it.
    Signal(i32),
    /// It stopped for the tracer, at this `PTRACE_EVENT`.
    Event(i32),
}

/// Waits for a child or tracee of this *thread*; children of other threads are left to them.
///
/// # Errors
///
/// `ECHILD` if there is none any more.
pub(super) fn wait_any() -> nix::Result<(Pid, Change)> {
    let mut status = 0;
    loop {
        let flags = libc::__WALL | libc::__WNOTHREAD;
        // SAFETY: `status` is a valid place for an int for the whole call.
        let pid = unsafe { libc::waitpid(-1, &raw mut status, flags) };
        match Errno::result(pid) {
            Err(Errno::EINTR) => {}
            result => return Ok((Pid::from_raw(result?), change(status))),
        }
    }
}

/// Lets a stopped tracee go on, with `signal` delivered to it (0: none). If it is gone meanwhile,
/// waiting will tell.
pub(super) fn go_on(pid: Pid, signal: i32) {
    let address = std::ptr::null_mut::<libc::c_void>();
    // SAFETY: PTRACE_CONT reads and writes no memory of this process; its last argument is a number.
    unsafe { libc::ptrace(libc::PTRACE_CONT, pid.as_raw(), address, libc::c_long::from(signal)) };
}

/// Makes the call before which `pid` is stopped another one; -1: none.
///
/// # Errors
///
/// If `pid` is not stopped, or gone.
#[cfg(target_arch = "aarch64")]
pub(super) fn set_call(pid: Pid, mut number: i32) -> nix::Result<()> {
    const NT_ARM_SYSTEM_CALL: libc::c_int = 0x404;
    let mut part = libc::iovec { iov_base: (&raw mut number).cast(), iov_len: size_of::<i32>() };
    // SAFETY: the kernel reads `number` through `part`; both live until the call returns.
    let result = unsafe {
        libc::ptrace(libc::PTRACE_SETREGSET, pid.as_raw(), NT_ARM_SYSTEM_CALL, &raw mut part)
    };
    Errno::result(result).map(drop)
}

fn change(status: i32) -> Change {
    if libc::WIFEXITED(status) {
        Change::Ended(libc::WEXITSTATUS(status))
    } else if libc::WIFSIGNALED(status) {
        Change::Killed(libc::WTERMSIG(status))
    } else {
        match status >> 16 {
            0 => Change::Signal(libc::WSTOPSIG(status)),
            event => Change::Event(event),
        }
    }
}
