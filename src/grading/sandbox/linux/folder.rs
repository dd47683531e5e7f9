//! A private folder: what is handed in is copied into it, built and run there, and it is removed at the end.

use std::collections::BTreeSet;
use std::fs::{self, DirBuilder, File, OpenOptions, Permissions};
use std::io;
use std::os::unix::fs::{DirBuilderExt, MetadataExt, OpenOptionsExt, PermissionsExt, chown};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use nix::libc;
use nix::sys::statvfs::statvfs;
use rand::TryRng;
use rand::rngs::SysRng;

/// Entries that are looked at when the use of a folder is added up; with more it counts as full.
const ENTRIES: usize = 20_000;

/// A folder that nobody else uses.
#[derive(Debug)]
pub(super) struct Folder {
    root: PathBuf,
}

impl Folder {
    /// A new one among the temporary files; what is in `work` and `scratch` belongs to `owner`.
    pub fn new(owner: Option<u32>) -> io::Result<Self> {
        // Others may pass through, for the uid of the submission must, but see nothing. Nobody can guess the
        // name and put something of that name there first.
        let make = || {
            let drawn = SysRng.try_next_u64().map_err(io::Error::other)?;
            let root = std::env::temp_dir().join(format!("parsim2d-{drawn:016x}"));
            DirBuilder::new().mode(0o711).create(&root).map(|()| root)
        };
        let mut there = there();
        let mut made = make();
        while matches!(&made, Err(why) if why.kind() == io::ErrorKind::AlreadyExists) {
            made = make();
        }
        let folder = Self { root: made? };
        there.insert(folder.root.clone());
        drop(there);
        fs::set_permissions(&folder.root, Permissions::from_mode(0o711))?;
        for path in [folder.work(), folder.scratch()] {
            DirBuilder::new().mode(0o700).create(&path)?;
            chown(&path, owner, owner)?;
        }
        Ok(folder)
    }

    /// Where the submission is built and run.
    pub fn work(&self) -> PathBuf {
        self.root.join("work")
    }

    /// Where it may put temporary files.
    pub fn scratch(&self) -> PathBuf {
        self.root.join("tmp")
    }

    /// A file that the submission cannot see, with these contents.
    pub fn file(&self, name: &str, contents: &[u8]) -> io::Result<PathBuf> {
        let path = self.root.join(name);
        fs::write(&path, contents)?;
        fs::set_permissions(&path, Permissions::from_mode(0o600))?;
        Ok(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = remove(&self.root);
        there().remove(&self.root);
    }
}

/// The folders that there are.
fn there() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    static THERE: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    THERE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes the private folders of all submissions: for who is about to end the program. After it no submission
/// can be made or dropped: that waits for ever.
pub fn remove_private_folders() {
    let there = there();
    for root in there.iter() {
        // What still runs there may write in between.
        let _ = remove(root).or_else(|_| remove(root));
    }
    // For good: nobody makes another before the program ends.
    std::mem::forget(there);
}

/// Removes `path`, whatever it is, even if it was locked or nested so deeply that paths get too
/// long. Follows no link.
pub(super) fn remove(path: &Path) -> io::Result<()> {
    let Ok(found) = fs::symlink_metadata(path) else { return Ok(()) };
    if !found.is_dir() {
        return fs::remove_file(path);
    }
    fs::set_permissions(path, Permissions::from_mode(0o700))?;
    // Folders inside folders are moved up to here, so that no path is long and nothing recurs.
    let mut moved = 0_u64;
    loop {
        let mut inner = Vec::new();
        for entry in fs::read_dir(path)? {
            let entry = entry?;
            if entry.file_type()?.is_dir() {
                inner.push(entry.path());
            } else {
                fs::remove_file(entry.path())?;
            }
        }
        if inner.is_empty() {
            return fs::remove_dir(path);
        }
        for folder in inner {
            moved = lift(&folder, path, moved)?;
            fs::remove_dir(&folder)?;
        }
    }
}

/// Empties `folder`: its folders go to `top` under new names, its files are removed.
fn lift(folder: &Path, top: &Path, mut moved: u64) -> io::Result<u64> {
    fs::set_permissions(folder, Permissions::from_mode(0o700))?;
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_type()?.is_dir() {
            // Moving a folder writes to it.
            fs::set_permissions(entry.path(), Permissions::from_mode(0o700))?;
            loop {
                moved += 1;
                let place = top.join(format!(".moved-{moved}"));
                if fs::symlink_metadata(&place).is_err() {
                    fs::rename(entry.path(), place)?;
                    break;
                }
            }
        } else {
            fs::remove_file(entry.path())?;
        }
    }
    Ok(moved)
}

/// `path` for reading, if it is a regular file; follows no link and waits for no pipe.
pub(super) fn open_regular(path: &Path) -> Option<File> {
    let flags = libc::O_NOFOLLOW | libc::O_NONBLOCK;
    let file = OpenOptions::new().read(true).custom_flags(flags).open(path).ok()?;
    file.metadata().ok()?.is_file().then_some(file)
}

/// Bytes on the disc of all below `path`; of a folder with very many entries, more than any limit.
pub(super) fn used(path: &Path) -> u64 {
    let mut waiting = vec![path.to_owned()];
    let (mut bytes, mut entries) = (0, 0);
    while let Some(folder) = waiting.pop() {
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            entries += 1;
            if entries > ENTRIES {
                return u64::MAX / 4;
            }
            let Ok(found) = entry.metadata() else { continue };
            bytes += found.blocks() * 512;
            if found.is_dir() {
                waiting.push(entry.path());
            }
        }
    }
    bytes
}

/// Bytes left on the disc of `path`.
pub(super) fn left(path: &Path) -> u64 {
    statvfs(path)
        .map_or(u64::MAX, |disc| disc.blocks_available().saturating_mul(disc.fragment_size()))
}
