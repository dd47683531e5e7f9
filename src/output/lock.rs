//! One run a folder: a lock that the system takes back when the process ends, however it ends.
//!
//! It is on a file of its own, `.parsim2d.lock`, for the files of a run are replaced on the way. Who only
//! reads does not ask for it.

use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

use fs4::{FileExt, TryLockError};

use super::OutputError;

/// The file that is locked.
pub const FILE: &str = ".parsim2d.lock";

/// A folder that no other run writes to while this is held.
pub struct FolderLock {
    path: PathBuf,
    /// The locked file; none where there can be no lock.
    file: Option<File>,
}

impl FolderLock {
    /// Takes the lock of `folder`, which must be there. Where the file cannot be made or the file system
    /// knows no locks, the run goes on without: what it may not write it will be told.
    ///
    /// # Errors
    ///
    /// [`OutputError::Busy`] if another process holds it, [`OutputError::InTheWay`] if something else has its name.
    pub fn take(folder: &Path) -> Result<Self, OutputError> {
        let path = folder.join(FILE);
        if fs::symlink_metadata(&path).is_ok_and(|found| !found.is_file()) {
            let source = io::Error::other("it is no file, and this name is that of a lock");
            return Err(OutputError::InTheWay { path, source });
        }
        loop {
            let Some(file) = open(&path) else { return Ok(Self { path, file: None }) };
            match FileExt::try_lock(&file) {
                Ok(()) if is_at(&file, &path) => return Ok(Self { path, file: Some(file) }),
                Ok(()) => {} // who held it has removed the file in the meantime: once more
                Err(TryLockError::WouldBlock) => {
                    let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
                    return Err(OutputError::Busy { folder });
                }
                Err(TryLockError::Error(_)) => return Ok(Self { path, file: None }),
            }
        }
    }
}

impl Drop for FolderLock {
    /// Removes the file before the lock goes: whoever opened it until now sees that it is not there any
    /// more. Where that cannot be seen it stays.
    fn drop(&mut self) {
        if cfg!(unix) && self.file.is_some() {
            let _ = fs::remove_file(&self.path); // an empty file left over does no harm
        }
    }
}

/// The file to lock: made if it is not there. That of another user may only be read, which is enough for
/// a lock.
fn open(path: &Path) -> Option<File> {
    let made = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path);
    made.or_else(|_| File::open(path)).ok()
}

/// Whether `file` is still the one at `path`.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    match (file.metadata(), fs::metadata(path)) {
        (Ok(this), Ok(that)) => (this.dev(), this.ino()) == (that.dev(), that.ino()),
        _ => false,
    }
}

/// Here it is never removed.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}
