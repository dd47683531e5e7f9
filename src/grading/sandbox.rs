//! From the folder that a student hands in to the frames that the program writes, safely.
//!
//! Student code and its Makefile are hostile until shown otherwise. A [`Sandbox`] copies a
//! [`Submission`] into a private folder, builds it there in a sandbox ([`Sandbox::prepare`]), runs what was
//! built ([`Workspace::run`]) and keeps every frame that it writes to `out.txt` ([`Captured`]). What is said about a
//! submission follows from what is read here, never from what the program claims.
//!
//! The sandbox is the best [`Tier`] that the machine offers; [`Sandbox::tier`] and [`Sandbox::refused`] say which,
//! and why no better one. Building and running need Linux on x86-64 or aarch64; elsewhere
//! [`Sandbox::open`] says so, and frames that exist already can still be graded.
//!
//! This room knows nothing of physics, rubrics or marks.

mod outcome;
mod request;
mod tier;

#[cfg(not(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64"))))]
mod elsewhere;
#[cfg(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64")))]
mod linux;

#[cfg(not(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64"))))]
pub use elsewhere::{PrivateFolder, Sandbox, Workspace, jail_if_asked, remove_private_folders};
#[cfg(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64")))]
pub use linux::{PrivateFolder, Sandbox, Workspace, jail_if_asked, remove_private_folders};
pub use outcome::{Build, Captured, Outcome, Run};
pub use request::{Invocation, Limits, Options, Submission};
pub use tier::{Refused, SandboxError, Tier};
