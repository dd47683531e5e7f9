//! The workshop on Linux.

mod bubble;
mod call;
mod camera;
mod clock;
mod copy;
mod filter;
mod folder;
mod jail;
mod landlocked;
mod log;
mod made;
mod open;
mod private;
mod process;
mod stops;
mod supervise;
mod trace;
mod untraced;
mod warden;

pub use folder::remove_private_folders;
pub use jail::jail_if_asked;
pub use made::Made;
pub use open::Workshop;
pub use private::PrivateFolder;
