//! Which system calls a submission may not make, and at which it is stopped so that `out.txt` can be read.

use std::collections::BTreeMap;

use nix::libc;
use seccompiler::{
    BackendError, BpfProgram, SeccompAction, SeccompCmpArgLen, SeccompCmpOp, SeccompCondition,
    SeccompFilter, SeccompRule, sock_filter,
};

use super::syscall_policy::{MODES, SIGNALS};

type Rules = BTreeMap<i64, Vec<SeccompRule>>;

/// Calls that no student program needs: other processes, namespaces, the kernel, the clock,
/// sockets, and memory and messages that outlive a process.
const DENIED: &[i64] = &[
    libc::SYS_ptrace,
    libc::SYS_process_vm_readv,
    libc::SYS_process_vm_writev,
    libc::SYS_kcmp,
    libc::SYS_pidfd_getfd,
    libc::SYS_socket,
    libc::SYS_mount,
    libc::SYS_umount2,
    libc::SYS_pivot_root,
    libc::SYS_chroot,
    libc::SYS_open_tree,
    libc::SYS_move_mount,
    libc::SYS_fsopen,
    libc::SYS_fsconfig,
    libc::SYS_fsmount,
    libc::SYS_fspick,
    libc::SYS_mount_setattr,
    libc::SYS_setns,
    libc::SYS_unshare,
    libc::SYS_open_by_handle_at,
    libc::SYS_bpf,
    libc::SYS_perf_event_open,
    libc::SYS_userfaultfd,
    libc::SYS_kexec_load,
    libc::SYS_kexec_file_load,
    libc::SYS_init_module,
    libc::SYS_finit_module,
    libc::SYS_delete_module,
    libc::SYS_keyctl,
    libc::SYS_add_key,
    libc::SYS_request_key,
    libc::SYS_swapon,
    libc::SYS_swapoff,
    libc::SYS_reboot,
    libc::SYS_quotactl,
    libc::SYS_syslog,
    libc::SYS_acct,
    libc::SYS_settimeofday,
    libc::SYS_clock_settime,
    libc::SYS_adjtimex,
    libc::SYS_clock_adjtime,
    libc::SYS_sethostname,
    libc::SYS_setdomainname,
    libc::SYS_shmget,
    libc::SYS_msgget,
    libc::SYS_semget,
    libc::SYS_mq_open,
    libc::SYS_memfd_create, // memory that no limit counts
    libc::SYS_seccomp,      // a filter of its own could answer in the tracer's place
];

/// Calls that get round a filter; programs and C libraries do without if there are none.
const ABSENT: &[i64] = &[
    libc::SYS_clone3, // its flags lie in memory, where a filter cannot see them
    libc::SYS_io_uring_setup,
    libc::SYS_io_uring_enter,
    libc::SYS_io_uring_register,
];

/// Calls on paths that Landlock does not watch. Under a uid of its own a submission owns nothing
/// else; under the caller's it must not have them.
const DENIED_AS_CALLER: &[i64] = &[
    libc::SYS_truncate, // Landlock watches it since Linux 6.2 only
    libc::SYS_fchownat,
    libc::SYS_pidfd_open, // signals by number are watched
    libc::SYS_setxattr,
    libc::SYS_lsetxattr,
    libc::SYS_removexattr,
    libc::SYS_lremovexattr,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_chown,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_lchown,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_utime,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_utimes,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_futimesat,
];

/// Flags of clone(2) that make namespaces, and the one that gets a child away from its tracer.
const CLONE_FLAGS: [i32; 8] = [
    libc::CLONE_NEWUSER,
    libc::CLONE_NEWNS,
    libc::CLONE_NEWPID,
    libc::CLONE_NEWNET,
    libc::CLONE_NEWIPC,
    libc::CLONE_NEWUTS,
    libc::CLONE_NEWCGROUP,
    libc::CLONE_UNTRACED,
];

/// The option of prctl(2) that does what seccomp(2) does.
const PR_SET_SECCOMP: u64 = libc::PR_SET_SECCOMP as u64;

/// What is to be filtered.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub(super) struct Filters {
    /// Whether the submission has the uid of the caller (tiers C and D).
    pub as_caller: bool,
    /// Whether there is a tracer.
    pub is_traced: bool,
    /// Whether calls that replace a file, or read standard input, stop for the tracer.
    pub captures: bool,
}

/// The programs of the filters, to be applied in order.
pub(super) fn programs(filters: Filters) -> Result<Vec<BpfProgram>, BackendError> {
    let mut denied: Rules = DENIED.iter().map(|&call| (call, Vec::new())).collect();
    let flags = CLONE_FLAGS.map(|flag| flag as u32);
    let clone = flags.into_iter().map(|flag| rule(&[bits(0, flag)])).collect::<Result<_, _>>()?;
    denied.insert(libc::SYS_clone, clone);
    // The limits of another process.
    denied.insert(libc::SYS_prlimit64, vec![rule(&[(0, SeccompCmpOp::Ne, 0)])?]);
    if filters.as_caller {
        denied.extend(DENIED_AS_CALLER.iter().map(|&call| (call, Vec::new())));
        // Without a path it is about a file that is open, which Landlock has seen.
        denied.insert(libc::SYS_utimensat, vec![rule(&[(1, SeccompCmpOp::Ne, 0)])?]);
    }
    denied.insert(libc::SYS_prctl, vec![rule(&[(0, SeccompCmpOp::Eq, PR_SET_SECCOMP)])?]);
    let absent = ABSENT.iter().map(|&call| (call, Vec::new())).collect();
    let mut programs = vec![program(absent, SeccompAction::Errno(libc::ENOSYS as u32))?];
    let mut traced = if filters.captures { watched()? } else { Rules::new() };
    if filters.as_caller && filters.is_traced {
        traced.extend(SIGNALS.iter().chain(MODES).map(|&call| (call, Vec::new())));
    }
    if !traced.is_empty() {
        programs.push(program(traced, SeccompAction::Trace(0))?);
    }
    // The last, for after it there can be no other.
    programs.push(program(denied, SeccompAction::Errno(libc::EPERM as u32))?);
    Ok(programs)
}

/// The calls by which a program replaces what a file holds, and reads its standard input.
fn watched() -> Result<Rules, BackendError> {
    let truncates = libc::O_TRUNC as u32;
    let mut rules = Rules::from([
        (libc::SYS_openat, vec![rule(&[bits(2, truncates)])?]),
        (libc::SYS_lseek, vec![rule(&[(1, SeccompCmpOp::Eq, 0), (2, SeccompCmpOp::Eq, 0)])?]),
        (libc::SYS_pwrite64, vec![rule(&[(3, SeccompCmpOp::Eq, 0)])?]),
        // Not of files, but as rare: what is asked for on standard input.
        (libc::SYS_read, vec![rule(&[(0, SeccompCmpOp::Eq, 0)])?]),
        (libc::SYS_readv, vec![rule(&[(0, SeccompCmpOp::Eq, 0)])?]),
    ]);
    let always = [
        libc::SYS_openat2,
        libc::SYS_truncate,
        libc::SYS_ftruncate,
        libc::SYS_renameat,
        libc::SYS_renameat2,
        libc::SYS_unlinkat,
    ];
    rules.extend(always.map(|call| (call, Vec::new())));
    #[cfg(target_arch = "x86_64")]
    {
        rules.insert(libc::SYS_open, vec![rule(&[bits(1, truncates)])?]);
        let older = [libc::SYS_creat, libc::SYS_rename, libc::SYS_unlink];
        rules.extend(older.map(|call| (call, Vec::new())));
    }
    Ok(rules)
}

/// That argument `k` has the bits `mask`.
fn bits(k: u8, mask: u32) -> (u8, SeccompCmpOp, u64) {
    (k, SeccompCmpOp::MaskedEq(mask.into()), mask.into())
}

/// A rule of conditions on arguments, all of which must hold.
fn rule(conditions: &[(u8, SeccompCmpOp, u64)]) -> Result<SeccompRule, BackendError> {
    let conditions = conditions.iter().map(|(k, operator, value)| {
        // Flags are 32 bits wide, and what stands above them does not count.
        let width = match operator {
            SeccompCmpOp::MaskedEq(_) => SeccompCmpArgLen::Dword,
            _ => SeccompCmpArgLen::Qword,
        };
        SeccompCondition::new(*k, width, operator.clone(), *value)
    });
    SeccompRule::new(conditions.collect::<Result<_, _>>()?)
}

fn program(rules: Rules, action: SeccompAction) -> Result<BpfProgram, BackendError> {
    let machine = std::env::consts::ARCH.try_into()?;
    let filter = SeccompFilter::new(rules, SeccompAction::Allow, action, machine)?;
    let mut program = BpfProgram::try_from(filter)?;
    if cfg!(target_arch = "x86_64") {
        program.splice(0..0, without_x32());
    }
    Ok(program)
}

/// The calls of x86-64 have second numbers, with bit 30 set, which rules by number would miss: absent.
fn without_x32() -> [sock_filter; 3] {
    const LOAD_NUMBER: u16 = 0x20; // BPF_LD | BPF_W | BPF_ABS, at offset 0 of seccomp_data
    const IF_AT_LEAST: u16 = 0x35; // BPF_JMP | BPF_JGE | BPF_K
    const RETURN: u16 = 0x06; // BPF_RET | BPF_K
    let enosys = libc::SECCOMP_RET_ERRNO | libc::ENOSYS as u32;
    [
        sock_filter { code: LOAD_NUMBER, jt: 0, jf: 0, k: 0 },
        sock_filter { code: IF_AT_LEAST, jt: 0, jf: 1, k: 0x4000_0000 },
        sock_filter { code: RETURN, jt: 0, jf: 0, k: enosys },
    ]
}

/// A program as the bytes that bubblewrap reads.
pub(super) fn bytes_of(program: &BpfProgram) -> Vec<u8> {
    let bytes = |step: &sock_filter| {
        let [a, b] = step.code.to_ne_bytes();
        let [c, d, e, f] = step.k.to_ne_bytes();
        [a, b, step.jt, step.jf, c, d, e, f]
    };
    program.iter().flat_map(bytes).collect()
}
