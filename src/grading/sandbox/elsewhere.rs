//! The sandbox where nothing can be built or run.

use std::convert::Infallible;
use std::ffi::OsString;
use std::marker::PhantomData;
use std::path::PathBuf;
use std::process::ExitCode;

use super::{Build, Invocation, Limits, Options, Refused, Run, SandboxError, Submission, Tier};

/// Builds and runs submissions; here there is none.
#[derive(Debug)]
pub struct Sandbox(Infallible);

/// A submission in its private folder; here there is none.
#[derive(Debug)]
pub struct Workspace<'a> {
    never: Infallible,
    sandbox: PhantomData<&'a Sandbox>,
    /// Files that were to be handed in and were not.
    pub missing: Vec<PathBuf>,
    /// What was handed in and not copied, with the reason.
    pub left_out: Vec<(PathBuf, &'static str)>,
    /// How the build went.
    pub build: Option<Build>,
}

impl Sandbox {
    /// # Errors
    ///
    /// Always: [`SandboxError::NotLinux`].
    pub fn open(_: &Options) -> Result<Self, SandboxError> {
        Err(SandboxError::NotLinux)
    }

    /// The sandbox that submissions are in.
    pub fn tier(&self) -> Tier {
        match self.0 {}
    }

    /// The better ones, and why they do not work here.
    pub fn refused(&self) -> &[Refused] {
        match self.0 {}
    }

    /// Whether submissions find this program.
    pub fn finds(&self, _: &str) -> bool {
        match self.0 {}
    }

    /// Where programs are looked for inside.
    pub fn path(&self) -> Vec<PathBuf> {
        match self.0 {}
    }

    /// Whether every frame is seen.
    pub fn is_traced(&self) -> bool {
        match self.0 {}
    }

    /// # Errors
    ///
    /// Cannot be called.
    pub fn private_folder(&self) -> Result<PrivateFolder, SandboxError> {
        match self.0 {}
    }

    /// # Errors
    ///
    /// Cannot be called.
    pub fn prepare(&self, _: &Submission, _: &Limits) -> Result<Workspace<'_>, SandboxError> {
        match self.0 {}
    }
}

/// A folder of the caller's own; here there is none.
#[derive(Debug)]
pub struct PrivateFolder(Infallible);

impl PrivateFolder {
    /// Where it is; cannot be called.
    pub fn path(&self) -> PathBuf {
        match self.0 {}
    }
}

impl Workspace<'_> {
    /// # Errors
    ///
    /// Cannot be called.
    pub fn add(&self, _: &str, _: &[u8]) -> Result<(), SandboxError> {
        match self.never {}
    }

    /// # Errors
    ///
    /// Cannot be called.
    pub fn build_by(&self, _: &[String], _: &Limits) -> Result<Build, SandboxError> {
        match self.never {}
    }

    /// Where it is; cannot be called.
    pub fn folder(&self) -> PathBuf {
        match self.never {}
    }

    /// # Errors
    ///
    /// Cannot be called.
    pub fn run(&self, _: &Invocation, _: &Limits) -> Result<Run, SandboxError> {
        match self.never {}
    }
}

/// There is no helper here.
pub fn jail_if_asked(_: impl Iterator<Item = OsString>) -> Option<ExitCode> {
    None
}

/// There are none here.
pub fn remove_private_folders() {}
