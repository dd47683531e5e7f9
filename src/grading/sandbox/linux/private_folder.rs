//! A private folder for who uses the sandbox.

use std::path::PathBuf;

use super::folder::Folder;
use super::open::Sandbox;
use crate::grading::sandbox::SandboxError;

/// A folder with a name that nobody can guess, which nobody else can look into and no submission can see. It goes
/// when this goes, or with those of submissions if the program is interrupted.
#[derive(Debug)]
pub struct PrivateFolder(Folder);

impl Sandbox {
    /// A new one, empty, among the temporary files.
    ///
    /// # Errors
    ///
    /// If it cannot be made.
    pub fn private_folder(&self) -> Result<PrivateFolder, SandboxError> {
        Folder::new(None).map(PrivateFolder).map_err(SandboxError::broken("make a private folder"))
    }
}

impl PrivateFolder {
    /// Where it is.
    pub fn path(&self) -> PathBuf {
        self.0.work()
    }
}
