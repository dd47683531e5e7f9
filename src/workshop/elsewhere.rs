//! The workshop where nothing can be built or run.

use std::convert::Infallible;
use std::ffi::OsString;
use std::marker::PhantomData;
use std::path::PathBuf;
use std::process::ExitCode;

use super::{Choice, Closed, Errand, Limits, Refused, Run, Step, Submission, Tier};

/// Builds and runs submissions; here there is none.
#[derive(Debug)]
pub struct Workshop(Infallible);

/// A submission in its private folder; here there is none.
#[derive(Debug)]
pub struct Made<'a> {
    never: Infallible,
    workshop: PhantomData<&'a Workshop>,
    /// Files that were to be handed in and were not.
    pub missing: Vec<PathBuf>,
    /// What was handed in and not copied, with the reason.
    pub left_out: Vec<(PathBuf, &'static str)>,
    /// How the build went.
    pub build: Option<Step>,
}

impl Workshop {
    /// # Errors
    ///
    /// Always: [`Closed::NotLinux`].
    pub fn open(_: &Choice) -> Result<Self, Closed> {
        Err(Closed::NotLinux)
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
    pub fn private_folder(&self) -> Result<PrivateFolder, Closed> {
        match self.0 {}
    }

    /// # Errors
    ///
    /// Cannot be called.
    pub fn make(&self, _: &Submission, _: &Limits) -> Result<Made<'_>, Closed> {
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

impl Made<'_> {
    /// # Errors
    ///
    /// Cannot be called.
    pub fn add(&self, _: &str, _: &[u8]) -> Result<(), Closed> {
        match self.never {}
    }

    /// # Errors
    ///
    /// Cannot be called.
    pub fn build_by(&self, _: &[String], _: &Limits) -> Result<Step, Closed> {
        match self.never {}
    }

    /// Where it is; cannot be called.
    pub fn folder(&self) -> PathBuf {
        match self.never {}
    }

    /// # Errors
    ///
    /// Cannot be called.
    pub fn run(&self, _: &Errand, _: &Limits) -> Result<Run, Closed> {
        match self.never {}
    }
}

/// There is no helper here.
pub fn jail_if_asked(_: impl Iterator<Item = OsString>) -> Option<ExitCode> {
    None
}

/// There are none here.
pub fn remove_private_folders() {}
