//! Copies what was handed in: regular files and folders, nothing else, and not without end.

use std::fs::{self, DirBuilder, OpenOptions};
use std::io::{self, Read};
use std::os::unix::fs::{DirBuilderExt, MetadataExt, OpenOptionsExt, chown};
use std::path::{Path, PathBuf};

use super::folder::open_regular;

/// Folders inside folders, and entries altogether.
const DEPTH: usize = 16;
const ENTRIES: usize = 5_000;

/// Something that was handed in and not copied.
pub(super) type LeftOut = (PathBuf, &'static str);

/// Copies `from` into the empty folder `to`, all for `owner`; `limit` bytes in all.
pub(super) fn copy(
    from: &Path,
    to: &Path,
    owner: Option<u32>,
    limit: u64,
) -> io::Result<Vec<LeftOut>> {
    let mut copy = Copy { from, to, owner, room: limit, entries: 0, left_out: Vec::new() };
    let mut waiting = vec![PathBuf::new()];
    while let Some(folder) = waiting.pop() {
        let mut entries: Vec<_> = fs::read_dir(from.join(&folder))?.collect::<Result<_, _>>()?;
        entries.sort_by_key(fs::DirEntry::file_name);
        for entry in entries {
            let path = folder.join(entry.file_name());
            if let Some(folder) = copy.entry(path, entry.file_type()?)? {
                waiting.push(folder);
            }
        }
    }
    Ok(copy.left_out)
}

struct Copy<'a> {
    from: &'a Path,
    to: &'a Path,
    owner: Option<u32>,
    room: u64,
    entries: usize,
    left_out: Vec<LeftOut>,
}

impl Copy<'_> {
    /// Copies one entry; if it is a folder, that folder is to be gone through.
    fn entry(&mut self, path: PathBuf, kind: fs::FileType) -> io::Result<Option<PathBuf>> {
        self.entries += 1;
        let why = if self.entries > ENTRIES {
            "too many files"
        } else if kind.is_symlink() {
            "a link"
        } else if kind.is_dir() && path.components().count() > DEPTH {
            "too many folders inside one another"
        } else if kind.is_dir() {
            let target = self.to.join(&path);
            DirBuilder::new().mode(0o700).create(&target)?;
            chown(target, self.owner, self.owner)?;
            return Ok(Some(path));
        } else if !kind.is_file() {
            "no regular file"
        } else {
            match self.file(&path) {
                Ok(true) => return Ok(None),
                Ok(false) => "too large",
                Err(error) if error.kind() == io::ErrorKind::StorageFull => return Err(error),
                Err(_) => "unreadable",
            }
        };
        if self.left_out.len() < ENTRIES {
            self.left_out.push((path, why));
        }
        Ok(None)
    }

    /// Copies one file; whether there was room for it.
    fn file(&mut self, path: &Path) -> io::Result<bool> {
        let Some(source) = open_regular(&self.from.join(path)) else {
            return Err(io::ErrorKind::PermissionDenied.into());
        };
        let found = source.metadata()?;
        if found.len() > self.room {
            return Ok(false);
        }
        self.room -= found.len();
        let mode = if found.mode() & 0o100 == 0 { 0o600 } else { 0o700 };
        let mut target =
            OpenOptions::new().write(true).create_new(true).mode(mode).open(self.to.join(path))?;
        io::copy(&mut source.take(found.len()), &mut target)?;
        // make goes by these times.
        target.set_modified(found.modified()?)?;
        chown(self.to.join(path), self.owner, self.owner)?;
        Ok(true)
    }
}
