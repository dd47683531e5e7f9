//! How well a submission is shut in.

use std::fmt;

use serde::Serialize;
use thiserror::Error;

use crate::named::named;

named! {
    /// How well a submission is shut in, best first.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
    pub enum Tier, words {
        /// bubblewrap: its own file system, processes and (absent) network.
        A = "bubblewrap, seccomp and limits",
        /// Started by root: a uid that nobody uses, Landlock, seccomp and limits.
        B = "a uid of its own, Landlock, seccomp and limits",
        /// Not started by root: Landlock, seccomp and limits, under the caller's uid.
        C = "Landlock, seccomp and limits",
        /// Limits only (and seccomp where there is one), under the caller's uid; files are not protected.
        D = "limits only: not a sandbox",
    }
}

impl fmt::Display for Tier {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

/// Why a tier was not taken.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Refused {
    /// The tier.
    pub tier: Tier,
    /// Why, in words for a person.
    pub why: String,
}

/// Why nothing can be built or run, or one submission could not; never the fault of the student.
#[derive(Debug, Error)]
pub enum SandboxError {
    /// Building and running need Linux.
    #[error(
        "building and running submissions needs Linux on x86-64 or aarch64; frames that exist already can be graded \
         anywhere: parsim2d grade --frames FILE"
    )]
    NotLinux,
    /// No tier that was allowed works.
    #[error(
        "no sandbox works here, so student code is not run:{}\ninstall bubblewrap, or allow limits alone with \
         --allow-unsandboxed where only you and the student can suffer",
        listed(.0)
    )]
    NoTier(Vec<Refused>),
    /// Root without a sandbox.
    #[error(
        "student code is not run as root without a sandbox:{}\nrun as another user, install bubblewrap, or use a \
         kernel with Landlock",
        listed(.0)
    )]
    Root(Vec<Refused>),
    /// Something of the machine failed.
    #[error("the sandbox could not {what}: {error}")]
    Broken {
        /// What was being done.
        what: String,
        /// What the system says.
        error: std::io::Error,
    },
    /// The sandbox did not start the command.
    #[error("the sandbox did not start: {0}")]
    Jail(String),
}

impl SandboxError {
    /// That `what` failed with `error`.
    pub(super) fn broken(what: impl Into<String>) -> impl FnOnce(std::io::Error) -> Self {
        let what = what.into();
        move |error| Self::Broken { what, error }
    }
}

fn listed(refused: &[Refused]) -> String {
    refused.iter().map(|refused| format!("\n  tier {}: {}", refused.tier, refused.why)).collect()
}
