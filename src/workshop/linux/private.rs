//! A private folder for who uses the workshop.

use std::path::PathBuf;

use super::folder::Folder;
use super::open::Workshop;
use crate::workshop::Closed;

/// A folder with a name that nobody can guess, which nobody else can look into and no submission can see. It goes
/// when this goes, or with those of submissions if the program is interrupted.
#[derive(Debug)]
pub struct PrivateFolder(Folder);

impl Workshop {
    /// A new one, empty, among the temporary files.
    ///
    /// # Errors
    ///
    /// If it cannot be made.
    pub fn private_folder(&self) -> Result<PrivateFolder, Closed> {
        Folder::new(None).map(PrivateFolder).map_err(Closed::broken("make a private folder"))
    }
}

impl PrivateFolder {
    /// Where it is.
    pub fn path(&self) -> PathBuf {
        self.0.work()
    }
}
