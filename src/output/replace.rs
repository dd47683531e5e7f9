//! Files that appear whole: written under a temporary name in the same folder, then renamed, so
//! that a reader never sees half of one.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter};
use std::path::{Path, PathBuf};

use super::OutputError;
use super::place::{folder_of, place};

/// A new file under its temporary name.
pub struct NewFile {
    path: PathBuf,
    /// Where it will be: what `path` leads to.
    place: PathBuf,
    file: File,
    is_in_place: bool,
}

impl NewFile {
    /// Creates the temporary file beside `path`, or beside what it leads to if it is a link. Whatever is there
    /// stays as it is until [`take_places`](super::together::take_places).
    pub fn create(path: &Path) -> Result<Self, OutputError> {
        let refuse = |source| OutputError::Create { path: path.to_owned(), source };
        let place = place(path).map_err(refuse)?;
        let file = create_temporary(&place).map_err(refuse)?;
        Ok(Self { path: path.to_owned(), place, file, is_in_place: false })
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

    /// The name it was asked for by.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// The name it gets, which is no link.
    pub(super) fn place(&self) -> &Path {
        &self.place
    }

    /// Gives the file its name; handles stay good for writing.
    pub(super) fn take_place(&mut self) -> io::Result<()> {
        rename(&self.place)?;
        self.is_in_place = true;
        Ok(())
    }
}

impl Drop for NewFile {
    fn drop(&mut self) {
        if !self.is_in_place {
            let _ = fs::remove_file(temporary(&self.place)); // never took its place
        }
    }
}

/// A new file of the temporary name. Never one that is there already: that could be a link to somebody's file.
fn create_temporary(place: &Path) -> io::Result<File> {
    let name = temporary(place);
    let create = || OpenOptions::new().write(true).create_new(true).open(&name);
    create().or_else(|why| match why.kind() {
        // Of a process of the same number that was killed.
        io::ErrorKind::AlreadyExists => fs::remove_file(&name).and_then(|()| create()),
        _ => Err(why),
    })
}

/// Replaces the file at `path`, or what it leads to if it is a link, by what `write` writes.
pub fn replace(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), OutputError> {
    replaced(path, write, |_| Ok(()), rename)
}

/// The same for a file that is soon replaced again and that nobody needs after a power cut. Most file systems
/// put a file on the disk as it is renamed over another, so that one of the two outlives a power cut, and the
/// one who renames has to wait; the two exchange their names instead, where the system can do that.
pub fn replace_fleeting(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), OutputError> {
    let take_place = |place: &Path| match exchange(&temporary(place), place) {
        true => fs::remove_file(temporary(place)), // which now holds the frame before
        false => rename(place),
    };
    replaced(path, write, |_| Ok(()), take_place)
}

/// The same for a file that must outlive a power cut: on the disk before it takes its place, and its
/// place too. The file it replaces stays there under the name `previous`, if there is one.
pub fn replace_durably(
    path: &Path,
    previous: Option<&Path>,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), OutputError> {
    let take_place = |at: &Path| {
        if let Some(previous) = previous {
            keep_as(at, &place(previous)?)?;
        }
        rename(at)?;
        sync_folder(at)
    };
    replaced(path, write, File::sync_all, take_place)
}

/// A new file written by `write`, made `safe`, and put where `path` leads to by `take_place`.
fn replaced(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
    safe: impl FnOnce(&File) -> io::Result<()>,
    take_place: impl FnOnce(&Path) -> io::Result<()>,
) -> Result<(), OutputError> {
    let failed = |source| OutputError::Write { path: path.to_owned(), source };
    let place = place(path).map_err(failed)?;
    let whole = || {
        let mut out = BufWriter::new(create_temporary(&place)?);
        write(&mut out)?;
        safe(&out.into_inner().map_err(io::IntoInnerError::into_error)?)?;
        take_place(&place)
    };
    whole().map_err(|source| {
        let _ = fs::remove_file(temporary(&place)); // half a file helps nobody
        failed(source)
    })
}

/// Exchanges the names of two files in one step, and says whether it did: where there is no file at one of
/// the names, or the system knows no such step, nothing is changed.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
fn exchange(one: &Path, other: &Path) -> bool {
    use nix::fcntl::{AT_FDCWD, RenameFlags, renameat2};
    renameat2(AT_FDCWD, one, AT_FDCWD, other, RenameFlags::RENAME_EXCHANGE).is_ok()
}

/// Elsewhere there is no such step, or none that all systems name alike.
#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
fn exchange(_: &Path, _: &Path) -> bool {
    false
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
        // Links may have led to two file systems.
        Err(_) => fs::rename(path, previous).or_else(|_| {
            fs::copy(path, &second_name)?;
            rename(previous)
        }),
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
    // Windows opens no folders; its file systems keep names in a journal.
    if cfg!(unix) { File::open(folder_of(path))?.sync_all() } else { Ok(()) }
}

/// Removes from `folder` the temporary files that runs leave for the files of these `names` when they are
/// killed.
pub fn remove_temporaries(folder: &Path, names: &[&str]) {
    let is_left = |file: &str| {
        let process =
            |name: &&str| file.strip_prefix(*name)?.strip_prefix('.')?.strip_suffix(".tmp");
        let process = |name: &&str| process(name).map(|of| of.strip_suffix(".old").unwrap_or(of));
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
    // Two runs in one folder must not write into one file, nor into somebody's own out.txt.tmp.
    with_ending(path, &format!(".{}.tmp", std::process::id()))
}

/// The name of an old file while new ones take their places.
pub(super) fn aside(path: &Path) -> PathBuf {
    with_ending(path, &format!(".{}.old.tmp", std::process::id()))
}

fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(ending);
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
