//! Files that appear whole: written under a temporary name in the same folder, then renamed, so
//! that a reader never sees half of one.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use super::OutputError;

/// A new file under its temporary name.
pub struct NewFile {
    path: PathBuf,
    file: File,
    is_in_place: bool,
}

impl NewFile {
    /// Creates the temporary file beside `path`. Whatever is at `path` stays as it is until
    /// [`take_place`](Self::take_place).
    pub fn create(path: &Path) -> Result<Self, OutputError> {
        let refuse = |source| OutputError::Create { path: path.to_owned(), source };
        if path.is_dir() {
            return Err(refuse(io::Error::from(io::ErrorKind::IsADirectory)));
        }
        let file = File::create(temporary(path)).map_err(refuse)?;
        Ok(Self { path: path.to_owned(), file, is_in_place: false })
    }

    /// A handle to write with, before and after the file takes its place.
    pub fn writer(&self) -> Result<File, OutputError> {
        self.file
            .try_clone()
            .map_err(|source| OutputError::Create { path: self.path.clone(), source })
    }

    /// Writes `text` into the file.
    pub fn write(&mut self, text: &[u8]) -> Result<(), OutputError> {
        let failed = |source| OutputError::Write { path: self.path.clone(), source };
        io::Write::write_all(&mut self.file, text).map_err(failed)
    }

    /// Gives the file its name; handles stay good for writing.
    pub fn take_place(mut self) -> Result<(), OutputError> {
        self.is_in_place = rename(&self.path)
            .map(|()| true)
            .map_err(|source| OutputError::Create { path: self.path.clone(), source })?;
        Ok(())
    }
}

impl Drop for NewFile {
    fn drop(&mut self) {
        if !self.is_in_place {
            let _ = fs::remove_file(temporary(&self.path)); // never took its place
        }
    }
}

/// Replaces the file at `path` by what `write` writes.
pub fn replace(
    path: &Path,
    write: impl FnOnce(&mut io::BufWriter<File>) -> io::Result<()>,
) -> Result<(), OutputError> {
    let whole = || {
        let mut out = io::BufWriter::new(File::create(temporary(path))?);
        write(&mut out)?;
        out.into_inner().map_err(io::IntoInnerError::into_error)?;
        rename(path)
    };
    whole().map_err(|source| {
        let _ = fs::remove_file(temporary(path)); // half a file helps nobody
        OutputError::Write { path: path.to_owned(), source }
    })
}

/// The same for a file that must outlive a power cut: on the disk before it takes its place, and its
/// place too. The file it replaces stays there under the name `previous`, if there is one.
pub fn replace_durably(
    path: &Path,
    previous: Option<&Path>,
    write: impl FnOnce(&mut io::BufWriter<File>) -> io::Result<()>,
) -> Result<(), OutputError> {
    let whole = || {
        let mut out = io::BufWriter::new(File::create(temporary(path))?);
        write(&mut out)?;
        out.into_inner().map_err(io::IntoInnerError::into_error)?.sync_all()?;
        if let Some(previous) = previous {
            keep_as(path, previous)?;
        }
        rename(path)?;
        sync_folder(path)
    };
    whole().map_err(|source| {
        let _ = fs::remove_file(temporary(path)); // half a file helps nobody
        OutputError::Write { path: path.to_owned(), source }
    })
}

/// Gives the file at `path`, if there is one, the name `previous` as well: at every moment there is a file
/// at `path`. Where files cannot have two names it is renamed.
fn keep_as(path: &Path, previous: &Path) -> io::Result<()> {
    if !path.exists() {
        return Ok(());
    }
    let second_name = temporary(previous);
    let _ = fs::remove_file(&second_name); // of a process of the same number that was killed
    match fs::hard_link(path, &second_name) {
        Err(_) => fs::rename(path, previous),
        Ok(()) => {
            rename(previous)?;
            // Where both were one file already, renaming does nothing.
            let _ = fs::remove_file(&second_name);
            Ok(())
        }
    }
}

/// Returns once the names in the folder of `path` are on the disk.
fn sync_folder(path: &Path) -> io::Result<()> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    // Windows opens no folders; its file systems keep names in a journal.
    if cfg!(unix) { File::open(folder)?.sync_all() } else { Ok(()) }
}

/// Removes from `folder` the temporary files that runs leave for the files of these `names` when they are
/// killed.
pub fn remove_temporaries(folder: &Path, names: &[&str]) {
    let is_left = |file: &str| {
        let process =
            |name: &&str| file.strip_prefix(*name)?.strip_prefix('.')?.strip_suffix(".tmp");
        let is_number = |text: &str| text.parse::<u32>().is_ok();
        names.iter().any(|name| process(name).is_some_and(is_number))
    };
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if is_left(&entry.file_name().to_string_lossy()) {
            let _ = fs::remove_file(entry.path()); // a nuisance, no more
        }
    }
}

fn temporary(path: &Path) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    // Two runs in one folder must not write into one file, nor into somebody's own out.txt.tmp.
    name.push(format!(".{}.tmp", std::process::id()));
    path.with_file_name(name)
}

/// Renames the temporary file to `path`. Windows refuses while another program has `path` open,
/// gnuplot for a moment at each redraw: wait and try again.
fn rename(path: &Path) -> io::Result<()> {
    let mut tries_left = if cfg!(windows) { 20 } else { 0 };
    loop {
        match fs::rename(temporary(path), path) {
            Err(error) if tries_left > 0 && is_held_open(&error) => {
                tries_left -= 1;
                std::thread::sleep(std::time::Duration::from_millis(10));
            }
            done => return done,
        }
    }
}

/// Windows: access denied (5) or a sharing violation (32).
fn is_held_open(error: &io::Error) -> bool {
    error.kind() == io::ErrorKind::PermissionDenied || error.raw_os_error() == Some(32)
}
