//! From the folder that a student hands in to the frames that the program writes, safely.
//!
//! Student code and its Makefile are hostile until shown otherwise. A [`Workshop`] copies a
//! [`Submission`] into a private folder, builds it there in a sandbox ([`Workshop::make`]), runs what was
//! built ([`Made::run`]) and keeps every frame that it writes to `out.txt` as a [`Film`]. What is said about a
//! submission follows from what is read here, never from what the program claims.
//!
//! The sandbox is the best [`Tier`] that the machine offers; [`Workshop::tier`] and [`Workshop::refused`] say which,
//! and why no better one. Building and running need Linux on x86-64 or aarch64; elsewhere
//! [`Workshop::open`] says so, and frames that exist already can still be graded.
//!
//! This room knows nothing of physics, rubrics or marks.

mod choice;
mod outcome;
mod tier;

#[cfg(not(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64"))))]
mod elsewhere;
#[cfg(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64")))]
mod linux;

pub use choice::{Choice, Errand, Limits, Submission};
#[cfg(not(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64"))))]
pub use elsewhere::{Made, PrivateFolder, Workshop, jail_if_asked, remove_private_folders};
#[cfg(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64")))]
pub use linux::{Made, PrivateFolder, Workshop, jail_if_asked, remove_private_folders};
pub use outcome::{Film, Outcome, Run, Step};
pub use tier::{Closed, Refused, Tier};
