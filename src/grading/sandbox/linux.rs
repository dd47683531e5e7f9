//! The sandbox on Linux.

mod bubblewrap;
mod copy;
mod folder;
mod frame_capture;
mod jail;
mod landlock_rules;
mod log;
mod open;
mod private_folder;
mod process;
mod seccomp;
mod stops;
mod supervisor;
mod syscall;
mod syscall_policy;
mod trace;
mod untraced;
mod watchdog;
mod workspace;

pub use folder::remove_private_folders;
pub use jail::jail_if_asked;
pub use open::Sandbox;
pub use private_folder::PrivateFolder;
pub use workspace::Workspace;
