//! The system call at which a traced process is stopped: what it is, and how not to let it happen.

use std::ffi::c_void;

use nix::libc;
use nix::sys::ptrace;
use nix::unistd::Pid;

/// The number and arguments of a system call.
pub(super) struct Syscall {
    pub number: i64,
    pub arguments: [u64; 6],
}

/// The system call before which `pid` is stopped.
#[cfg(target_arch = "x86_64")]
pub(super) fn syscall_of(pid: Pid) -> Option<Syscall> {
    let r = ptrace::getregs(pid).ok()?;
    let arguments = [r.rdi, r.rsi, r.rdx, r.r10, r.r8, r.r9];
    Some(Syscall { number: r.orig_rax as i64, arguments })
}

/// The system call before which `pid` is stopped.
#[cfg(target_arch = "aarch64")]
pub(super) fn syscall_of(pid: Pid) -> Option<Syscall> {
    let r = ptrace::getregs(pid).ok()?.regs;
    Some(Syscall { number: r[8] as i64, arguments: [r[0], r[1], r[2], r[3], r[4], r[5]] })
}

/// Leaves the call out; the process gets `result` for it.
#[cfg(target_arch = "x86_64")]
pub(super) fn leave_out(pid: Pid, result: i64) -> nix::Result<()> {
    let mut registers = ptrace::getregs(pid)?;
    registers.orig_rax = u64::MAX;
    registers.rax = result as u64;
    ptrace::setregs(pid, registers)
}

/// Leaves the call out; the process gets `result` for it.
#[cfg(target_arch = "aarch64")]
pub(super) fn leave_out(pid: Pid, result: i64) -> nix::Result<()> {
    let mut registers = ptrace::getregs(pid)?;
    registers.regs[0] = result as u64;
    ptrace::setregs(pid, registers)?;
    super::process::set_call(pid, -1)
}

/// The string at `address`, without its final zero.
pub(super) fn text(pid: Pid, address: u64) -> Option<Vec<u8>> {
    let mut text = Vec::new();
    // Words, so that none crosses into a page that may not be there.
    let first = address & !7;
    for k in 0..libc::PATH_MAX as u64 / 8 {
        let skip = if k == 0 { (address - first) as usize } else { 0 };
        for byte in word(pid, first + 8 * k)?.to_ne_bytes().into_iter().skip(skip) {
            if byte == 0 {
                return Some(text);
            }
            text.push(byte);
        }
    }
    None
}

/// The eight bytes at `address`. By ptrace and not from `/proc`, for which root in a container may
/// lack the right.
pub(super) fn word(pid: Pid, address: u64) -> Option<u64> {
    ptrace::read(pid, address as *mut c_void).ok().map(|word| word as u64)
}
