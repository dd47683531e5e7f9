//! Where a file is that has a name, and whether it is one.
//!
//! What a person names may be a pipe, and is waited for. What is only looked for in a folder must not keep anybody
//! waiting: it is opened by [`plain_file`] or not at all.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Where the file named `path` is or will be: a link is followed, also to a file that is not there yet, as a
/// shell's `>` does. Only a file can be replaced by one: a folder, a pipe or a device is refused.
pub fn place(path: &Path) -> io::Result<PathBuf> {
    const MOST_LINKS: usize = 40; // as many as Linux follows
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => return Err(io::Error::other("it is a folder")),
        Ok(found) if !found.is_file() => return Err(io::Error::other("it is a pipe or a device")),
        _ => {}
    }
    let mut place = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&place) {
            Ok(to) => place = folder_of(&place).join(to),
            Err(_) => return Ok(place), // no link: a file, or nothing yet
        }
    }
    Err(io::Error::other("it is a link that leads in a circle"))
}

/// The file at `path`, open to be read. A pipe, over which a reader waits, or a device, which never ends, is
/// not opened.
pub fn plain_file(path: &Path) -> io::Result<File> {
    fs::metadata(path)?;
    place(path).and_then(File::open)
}

/// Whether both are names of one file, or folder, that is there.
pub fn is_same(one: &Path, other: &Path) -> bool {
    matches!((fs::canonicalize(one), fs::canonicalize(other)), (Ok(one), Ok(other)) if one == other)
}

/// The folder that a file named `path` lies in.
pub fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// The text of the file at `path`, as [`plain_file`] opens it.
pub fn plain_text(path: &Path) -> io::Result<String> {
    let mut text = String::new();
    plain_file(path)?.read_to_string(&mut text)?;
    Ok(text)
}
