//! Which sandbox works on this machine, and how a command is shut into it.

use std::collections::HashSet;
use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;

use nix::unistd::{Pid, Uid, geteuid};

use super::bubblewrap;
use super::folder::Folder;
use super::jail::{Confinement, Order, ResourceLimits};
use super::seccomp::Filters;
use super::supervisor::spawn;
use super::trace::seize;
use crate::grading::sandbox::{
    Invocation, Limits, Options, Outcome, Refused, SandboxError, Submission, Tier,
};

/// uids of which one is taken for a submission: Debian and systemd give them to nobody.
const UIDS: std::ops::Range<u32> = 60_600..61_100;
/// Where programs are looked for inside, and bubblewrap outside.
const PATH: [&str; 3] = ["/usr/local/bin", "/usr/bin", "/bin"];

/// Builds and runs submissions, in the best sandbox that there is.
#[derive(Debug)]
pub struct Sandbox {
    tier: Tier,
    refused: Vec<Refused>,
    helper: PathBuf,
    readable: Vec<PathBuf>,
    is_traced: bool,
}

impl Sandbox {
    /// Tries the tiers from the best one down, each by a command that it must hold back.
    ///
    /// # Errors
    ///
    /// If no tier that `options` allows works here, with the reason for each.
    pub fn open(options: &Options) -> Result<Self, SandboxError> {
        let helper = match &options.helper {
            Some(helper) => helper.clone(),
            None => {
                std::env::current_exe().map_err(SandboxError::broken("find its own program"))?
            }
        };
        let is_traced = !options.untraced && can_trace(&helper);
        // Started by root, submissions have a uid that cannot enter every folder.
        let is_root = geteuid().is_root();
        let can_be_read = |folder: &&PathBuf| !is_root || is_open_to_all(folder);
        let readable = options.readable.iter().filter(can_be_read).cloned().collect();
        let mut sandbox = Self { tier: Tier::A, refused: Vec::new(), helper, readable, is_traced };
        for tier in
            Tier::ALL.into_iter().filter(|tier| options.tier.is_none_or(|wanted| wanted == *tier))
        {
            sandbox.tier = tier;
            match sandbox.is_shut(options.allow_unsandboxed) {
                Ok(()) => return Ok(sandbox),
                Err(why) => sandbox.refused.push(Refused { tier, why }),
            }
        }
        let refused = sandbox.refused;
        Err(if geteuid().is_root() {
            SandboxError::Root(refused)
        } else {
            SandboxError::NoTier(refused)
        })
    }

    /// The sandbox that submissions are in.
    pub fn tier(&self) -> Tier {
        self.tier
    }

    /// The better ones, and why they do not work here.
    pub fn refused(&self) -> &[Refused] {
        &self.refused
    }

    /// Whether every frame is seen (by ptrace); otherwise frames may be missed.
    pub fn is_traced(&self) -> bool {
        self.is_traced
    }

    /// Whether submissions find this program, the first word of a command. Programs of their own begin with `./`.
    pub fn finds(&self, program: &str) -> bool {
        program.contains('/') || self.path().iter().any(|folder| folder.join(program).is_file())
    }

    /// Where programs are looked for inside: the system's folders, then those that may be read.
    pub fn path(&self) -> Vec<PathBuf> {
        let own = self.readable.iter().map(|folder| {
            let bin = folder.join("bin");
            if bin.is_dir() { bin } else { folder.clone() }
        });
        PATH.iter().map(PathBuf::from).chain(own).collect()
    }

    pub(super) fn helper(&self) -> &Path {
        &self.helper
    }

    pub(super) fn is_wrapped(&self) -> bool {
        self.tier == Tier::A
    }

    /// Whether the present tier holds back what it should; if not, why.
    fn is_shut(&self, allow_unsandboxed: bool) -> Result<(), String> {
        let is_root = geteuid().is_root();
        match self.tier {
            Tier::A if bubblewrap().is_none() => return Err("bwrap is not installed".to_owned()),
            Tier::B if !is_root => return Err("not started by root".to_owned()),
            Tier::C if is_root => return Err("started by root".to_owned()),
            Tier::C if !self.is_traced => {
                return Err("ptrace is refused, and chmod could not be held back".to_owned());
            }
            Tier::D if is_root => return Err("started by root".to_owned()),
            Tier::D if !allow_unsandboxed => return Err("needs --allow-unsandboxed".to_owned()),
            _ => {}
        }
        self.try_out().map_err(|error| error.to_string())
    }

    /// Runs a command that tries to read and to write a file that it must not see.
    fn try_out(&self) -> Result<(), SandboxError> {
        let broken = || SandboxError::broken("try the sandbox");
        let outside = Folder::new(None).map_err(broken())?;
        let secret = outside.work().join("secret");
        fs::write(&secret, "secret").map_err(broken())?;
        let empty = Submission { folder: outside.scratch(), files: Vec::new(), build: Vec::new() };
        let limits = Limits::default();
        let workspace = self.prepare(&empty, &limits)?;
        let script =
            if self.tier == Tier::D { ":" } else { "! cat \"$0\" && ! (: > \"$0\") && : > here" };
        let words = ["/bin/sh", "-c", script, &secret.to_string_lossy()].map(str::to_owned);
        let run = workspace
            .run(&Invocation { command: words.to_vec(), ..Invocation::default() }, &limits)?;
        if run.outcome == Outcome::Ended(0) {
            return Ok(());
        }
        let said = run.log.lines().last().unwrap_or_default();
        Err(SandboxError::Jail(format!("{:?}: {said}", run.outcome)))
    }

    /// A uid for a submission, if it can have one of its own.
    pub(super) fn new_owner(&self) -> Result<Option<u32>, SandboxError> {
        if !geteuid().is_root() {
            return Ok(None);
        }
        let unused = unused_uid().ok_or_else(|| {
            SandboxError::Jail(format!(
                "all uids from {} to {} are in use",
                UIDS.start,
                UIDS.end - 1
            ))
        })?;
        Ok(Some(unused))
    }

    /// What the helper is told, to run `command` in `folder`.
    #[allow(clippy::too_many_arguments)]
    pub(super) fn order(
        &self,
        folder: &Folder,
        owner: Option<u32>,
        stdin: PathBuf,
        command: &[String],
        limits: &Limits,
        files: u64,
        captures: bool,
    ) -> Order {
        let (work, scratch) = (folder.work(), folder.scratch());
        let (home, temporary) = match self.tier {
            Tier::A => (bubblewrap::INSIDE.into(), "/tmp".into()),
            _ => (work.to_string_lossy(), scratch.to_string_lossy()),
        };
        let path = self.path();
        let path: Vec<_> = path.iter().map(|folder| folder.to_string_lossy()).collect();
        let path = path.join(":");
        let environment = [
            ("PATH", &*path),
            ("HOME", &home),
            ("PWD", &home),
            ("TMPDIR", &temporary),
            ("LANG", "C"),
        ];
        let own = owner.map(|_| limits.processes as u64 + 8);
        Order {
            folder: work.clone(),
            stdin,
            environment: environment.map(|(key, value)| (key.to_owned(), value.to_owned())).into(),
            limits: ResourceLimits {
                cpu: limits.cpu,
                file: files,
                address_space: limits.address_space,
                processes: own,
            },
            identity: owner,
            confinement: self.confinement(work, scratch),
            filters: Some(Filters {
                as_caller: owner.is_none() && self.tier != Tier::A,
                is_traced: self.is_traced,
                captures: captures && self.is_traced,
            }),
            command: command.to_vec(),
        }
    }

    fn confinement(&self, work: PathBuf, scratch: PathBuf) -> Confinement {
        let readable = self.readable.clone();
        match self.tier {
            Tier::A => {
                let words = bubblewrap::arguments(&work, &scratch, &readable);
                Confinement::Bubblewrap { program: bubblewrap().unwrap_or_default(), words }
            }
            Tier::B | Tier::C => Confinement::Landlock { readable, writable: vec![work, scratch] },
            Tier::D => Confinement::None,
        }
    }
}

fn bubblewrap() -> Option<PathBuf> {
    PATH.iter().map(|folder| Path::new(folder).join("bwrap")).find(|path| path.is_file())
}

/// Whether this process may trace its children.
fn can_trace(helper: &Path) -> bool {
    let may = || {
        let Ok((mut child, _printed)) = spawn(helper) else { return false };
        let may = seize(Pid::from_raw(child.id() as i32)).is_ok();
        let _ = child.kill().and_then(|()| child.wait());
        may
    };
    thread::scope(|scope| scope.spawn(may).join().unwrap_or(false))
}

/// A uid that no process has and that this process has not given before (until all were given).
fn unused_uid() -> Option<u32> {
    static NEXT: AtomicU32 = AtomicU32::new(0);
    let processes = fs::read_dir("/proc").into_iter().flatten().flatten();
    let used: HashSet<u32> =
        processes.filter_map(|entry| Some(entry.metadata().ok()?.uid())).collect();
    let count = UIDS.end - UIDS.start;
    // Several graders at a time begin at different places.
    let start = std::process::id().wrapping_mul(97);
    let uid = |_| UIDS.start + start.wrapping_add(NEXT.fetch_add(1, Ordering::Relaxed)) % count;
    (0..count).map(uid).find(|uid| !used.contains(uid) && Uid::from_raw(*uid) != geteuid())
}

/// Whether anybody may enter a folder and all those it lies in.
fn is_open_to_all(folder: &Path) -> bool {
    let enters = |folder: &Path| fs::metadata(folder).is_ok_and(|found| found.mode() & 1 == 1);
    folder.ancestors().all(enters)
}
