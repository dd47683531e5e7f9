//! A submission that was copied and built, and is run.

use std::fs::{self, OpenOptions, Permissions};
use std::io::Write;
use std::os::unix::fs::{OpenOptionsExt, PermissionsExt, chown};
use std::path::PathBuf;
use std::time::Duration;

use super::copy::{LeftOut, copy};
use super::folder::{Folder, remove};
use super::frame_capture::{CaptureLimits, FrameCapture};
use super::open::Sandbox;
use super::stops::FILE;
use super::supervisor::{Attempt, Job, attempt};
use super::watchdog::Appended;
use crate::grading::sandbox::{Build, Captured, Invocation, Limits, Run, SandboxError, Submission};

/// A submission in its private folder, which goes when this goes.
#[derive(Debug)]
pub struct Workspace<'a> {
    sandbox: &'a Sandbox,
    folder: Folder,
    owner: Option<u32>,
    /// Files that were to be handed in and were not, relative to the folder.
    pub missing: Vec<PathBuf>,
    /// What was handed in and not copied, with the reason: links, pipes, and what is too large.
    pub left_out: Vec<(PathBuf, &'static str)>,
    /// How the build went; `None`: there was nothing to build.
    pub build: Option<Build>,
}

impl Sandbox {
    /// Copies `submission` and builds it.
    ///
    /// # Errors
    ///
    /// If the machine fails; what a submission does wrong is in what is returned.
    pub fn prepare(
        &self,
        submission: &Submission,
        limits: &Limits,
    ) -> Result<Workspace<'_>, SandboxError> {
        let owner = self.new_owner()?;
        let folder = Folder::new(owner).map_err(SandboxError::broken("make a private folder"))?;
        let what = format!("copy {}", submission.folder.display());
        let left_out: Vec<LeftOut> = copy(&submission.folder, &folder.work(), owner, limits.copy)
            .map_err(SandboxError::broken(what))?;
        let is_there = |file: &PathBuf| {
            fs::symlink_metadata(folder.work().join(file)).is_ok_and(|found| found.is_file())
        };
        let missing = submission.files.iter().filter(|file| !is_there(file)).cloned().collect();
        let mut workspace =
            Workspace { sandbox: self, folder, owner, missing, left_out, build: None };
        if !submission.build.is_empty() {
            workspace.build = Some(workspace.build_by(&submission.build, limits)?);
        }
        Ok(workspace)
    }
}

/// A command of either kind.
struct Work<'a> {
    command: &'a [String],
    stdin: &'a [u8],
    wall: Duration,
    files: u64,
}

impl Workspace<'_> {
    /// Puts a file into it, in place of whatever has that name.
    ///
    /// # Errors
    ///
    /// If the machine fails.
    pub fn add(&self, name: &str, contents: &[u8]) -> Result<(), SandboxError> {
        let path = self.folder.work().join(name);
        let add = || {
            remove(&path)?;
            let mut options = OpenOptions::new();
            options.write(true).create_new(true).mode(0o600).open(&path)?.write_all(contents)?;
            chown(&path, self.owner, self.owner)
        };
        add().map_err(SandboxError::broken(format!("add {name} to a submission")))
    }

    /// Builds by one more command, word by word.
    ///
    /// # Errors
    ///
    /// If the machine fails; what a submission does wrong is in what is returned.
    pub fn build_by(&self, command: &[String], limits: &Limits) -> Result<Build, SandboxError> {
        let (wall, files) = (limits.build_wall, limits.build_files);
        let work = Work { command, stdin: &[], wall, files };
        let Attempt { outcome, log, took, .. } = self.attempt(&work, limits, None, None)?;
        Ok(Build { outcome, log, took })
    }

    /// Where it is; only for looking.
    pub fn folder(&self) -> PathBuf {
        self.folder.work()
    }

    /// Runs `invocation`, and keeps every frame of `out.txt`. An `out.txt` that is there before is removed.
    ///
    /// # Errors
    ///
    /// If the machine fails; what a submission does wrong is in what is returned.
    pub fn run(&self, invocation: &Invocation, limits: &Limits) -> Result<Run, SandboxError> {
        let place = self.folder.work();
        // The build, or a run before, may have locked it.
        fs::set_permissions(&place, Permissions::from_mode(0o700))
            .map_err(SandboxError::broken("unlock a folder"))?;
        remove(&place.join(FILE)).map_err(SandboxError::broken("remove an out.txt of before"))?;
        let frames = invocation.frames.unwrap_or(usize::MAX);
        let most = CaptureLimits { frames, bytes: limits.captured, file: limits.run_files };
        let capture =
            FrameCapture::on(&place, most).map_err(SandboxError::broken("watch a folder"))?;
        let appended =
            invocation.frames.map(|frames| Appended::new(&place, frames, invocation.rows));
        let work = Work {
            command: &invocation.command,
            stdin: &invocation.stdin,
            wall: limits.run_wall,
            files: limits.run_files,
        };
        let attempt = self.attempt(&work, limits, Some(capture), appended)?;
        let (captured, torn) = match attempt.capture {
            Some(capture) => capture.into_captured(attempt.has_ended),
            None => (Captured::Nothing, 0),
        };
        let stdin_bytes = invocation.stdin.len() as u64;
        let every_frame = self.sandbox.is_traced() || !matches!(captured, Captured::Snapshots(_));
        Ok(Run {
            outcome: attempt.outcome,
            log: attempt.log,
            took: attempt.took,
            captured,
            torn,
            asked_for_more: attempt.asked_before.is_some_and(|asked| asked >= stdin_bytes),
            every_frame,
        })
    }

    fn attempt(
        &self,
        work: &Work,
        limits: &Limits,
        capture: Option<FrameCapture>,
        appended: Option<Appended>,
    ) -> Result<Attempt, SandboxError> {
        let stdin = self
            .folder
            .file("stdin", work.stdin)
            .map_err(SandboxError::broken("write to a private folder"))?;
        let order = self.sandbox.order(
            &self.folder,
            self.owner,
            stdin,
            work.command,
            limits,
            work.files,
            capture.is_some(),
        );
        attempt(Job {
            helper: self.sandbox.helper(),
            order,
            is_traced: self.sandbox.is_traced(),
            is_wrapped: self.sandbox.is_wrapped(),
            wall: work.wall,
            memory: limits.memory,
            files: work.files,
            folders: vec![self.folder.work(), self.folder.scratch()],
            processes: limits.processes,
            log: limits.log,
            capture,
            appended,
        })
    }
}
