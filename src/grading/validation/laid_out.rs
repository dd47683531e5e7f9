//! A described submission as a folder, as a student would hand it in.

use std::fs;
use std::path::{Path, PathBuf};

use super::described::Described;
use super::{DESCRIPTION, ValidationError};

/// Makes the folder of `described` within `place`, and says where it is: the files of its base and that
/// one's edits first, then its own edits, then its own files over these.
///
/// `place` must be there. Fails where a text to be exchanged does not occur exactly once, or a file cannot be written.
pub fn lay_out(described: &Described, place: &Path) -> Result<PathBuf, ValidationError> {
    let folder = place.join(described.name());
    // Only the last part: if all is being removed, it must not come back.
    fs::create_dir(&folder).map_err(ValidationError::file(&folder))?;
    for base in described.bases.iter().rev() {
        lay_over(&Described::read(base)?, &folder)?;
    }
    lay_over(described, &folder)?;
    Ok(folder)
}

/// The edits and the files of one description, over what is there.
fn lay_over(described: &Described, folder: &Path) -> Result<(), ValidationError> {
    for edit in &described.replace {
        let path = folder.join(&edit.file);
        let text = fs::read_to_string(&path).map_err(ValidationError::file(&path))?;
        let times = text.matches(&edit.from).count();
        if times != 1 {
            let why = format!(
                "`from` must occur once in {}, and occurs {times} times: {:?}",
                edit.file.display(),
                edit.from
            );
            return Err(ValidationError::description(&described.path.join(DESCRIPTION), why));
        }
        let text = text.replacen(&edit.from, &edit.to, 1);
        fs::write(&path, text).map_err(ValidationError::file(&path))?;
    }
    for edit in &described.remove {
        let path = folder.join(&edit.file);
        fs::remove_file(&path).map_err(ValidationError::file(&path))?;
    }
    for link in &described.symlink {
        let path = folder.join(&link.file);
        make_link(&link.target, &path).map_err(ValidationError::file(&path))?;
    }
    copy_files(&described.path, folder)
}

/// Copies all files of a described folder but the description.
fn copy_files(from: &Path, to: &Path) -> Result<(), ValidationError> {
    for entry in fs::read_dir(from).map_err(ValidationError::file(from))? {
        let entry = entry.map_err(ValidationError::file(from))?;
        let (here, there) = (entry.path(), to.join(entry.file_name()));
        if here.is_dir() {
            if !there.is_dir() {
                fs::create_dir(&there).map_err(ValidationError::file(&there))?;
            }
            copy_files(&here, &there)?;
        } else if entry.file_name() != DESCRIPTION {
            fs::copy(&here, &there).map_err(ValidationError::file(&here))?;
        }
    }
    Ok(())
}

#[cfg(unix)]
fn make_link(target: &Path, path: &Path) -> std::io::Result<()> {
    std::os::unix::fs::symlink(target, path)
}

#[cfg(not(unix))]
fn make_link(_target: &Path, _path: &Path) -> std::io::Result<()> {
    Err(std::io::Error::other("symbolic links are made on Unix only"))
}
