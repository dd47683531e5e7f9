//! Files that take their places together while old ones go: all of them, or none.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::OutputError;
use super::replace::{NewFile, aside};

/// Gives every file of `new` its name and takes away the `stale` ones. If one of these steps fails, those
/// before it are undone: all that was there is there again.
pub fn take_places(new: Vec<NewFile>, stale: &[PathBuf]) -> Result<(), OutputError> {
    let mut done = Vec::new();
    let outcome = try_all(new, stale, &mut done);
    match outcome {
        Ok(()) => done.iter().for_each(Step::forget),
        Err(_) => done.iter().rev().for_each(Step::undo),
    }
    outcome
}

fn try_all(new: Vec<NewFile>, stale: &[PathBuf], done: &mut Vec<Step>) -> Result<(), OutputError> {
    for path in stale {
        let refuse = |source| OutputError::Create { path: path.clone(), source };
        done.extend(set_aside(path).map_err(refuse)?);
    }
    for mut file in new {
        let path = file.place().to_owned();
        let old = keep_aside(&path);
        if let Err(source) = file.take_place() {
            old.into_iter().for_each(|old| drop(fs::remove_file(old))); // a second name, no more
            return Err(OutputError::Create { path: file.path().to_owned(), source });
        }
        done.push(Step { path, old });
    }
    Ok(())
}

/// A name that another file has now, or none.
struct Step {
    path: PathBuf,
    /// Where the file is that had the name before.
    old: Option<PathBuf>,
}

impl Step {
    /// Gives the file that had the name before its name back.
    fn undo(&self) {
        let _ = match &self.old {
            Some(old) => fs::rename(old, &self.path),
            None => fs::remove_file(&self.path),
        };
    }

    /// Takes the file away that had the name before.
    fn forget(&self) {
        let _ = self.old.as_ref().map(fs::remove_file); // left over it is a nuisance, no more
    }
}

/// Takes the name from the file at `path`, if there is one.
fn set_aside(path: &Path) -> io::Result<Option<Step>> {
    match fs::symlink_metadata(path) {
        Err(why) if why.kind() == io::ErrorKind::NotFound => return Ok(None),
        Ok(found) if found.is_dir() => return Err(io::Error::other("it is a folder")),
        _ => {}
    }
    let old = aside(path);
    fs::rename(path, &old)?;
    Ok(Some(Step { path: path.to_owned(), old: Some(old) }))
}

/// Gives the file at `path`, if there is one, a second name, which is returned.
///
/// Where files cannot have two names there is no way back: then the name goes to the new file all the same.
fn keep_aside(path: &Path) -> Option<PathBuf> {
    let old = aside(path);
    let _ = fs::remove_file(&old); // of a process of the same number that was killed
    fs::hard_link(path, &old).is_ok().then_some(old)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder with an old `a`, `b` and `stale`.
    fn folder() -> tempfile::TempDir {
        let folder = tempfile::TempDir::new().unwrap();
        for name in ["a", "b", "stale"] {
            fs::write(folder.path().join(name), format!("old {name}")).unwrap();
        }
        folder
    }

    fn new(folder: &Path, name: &str) -> NewFile {
        let mut file = NewFile::create(&folder.join(name)).unwrap();
        file.write(format!("new {name}").as_bytes()).unwrap();
        file
    }

    /// Names and texts of all files there.
    fn texts(folder: &Path) -> Vec<(String, String)> {
        let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
        let file = |entry: fs::DirEntry| {
            let text = fs::read_to_string(entry.path()).unwrap_or_else(|_| "a folder".to_owned());
            (entry.file_name().into_string().unwrap(), text)
        };
        let mut texts: Vec<_> = entries.map(file).collect();
        texts.sort();
        texts
    }

    #[test]
    fn all_take_their_places_and_what_is_stale_goes() {
        let folder = folder();
        let path = folder.path();
        let files = ["a", "b", "c"].map(|name| new(path, name));
        take_places(files.into(), &[path.join("stale"), path.join("never")]).unwrap();
        let wanted = ["a", "b", "c"].map(|name| (name.to_owned(), format!("new {name}")));
        assert_eq!(texts(path), wanted);
    }

    #[test]
    fn if_one_cannot_everything_is_as_before() {
        let folder = folder();
        let path = folder.path();
        let files = ["a", "c", "b"].map(|name| new(path, name));
        // A folder comes in between: no file can be renamed over it.
        fs::remove_file(path.join("b")).unwrap();
        fs::create_dir(path.join("b")).unwrap();
        let before = ["a", "stale"].map(|name| (name.to_owned(), format!("old {name}")));
        let why = take_places(files.into(), &[path.join("stale")]).unwrap_err();
        assert!(why.to_string().contains("b: "), "{why}");
        let mut wanted = before.to_vec();
        wanted.insert(1, ("b".to_owned(), "a folder".to_owned()));
        assert_eq!(texts(path), wanted);

        let why = take_places(vec![new(path, "a")], &[path.join("stale"), path.join("b")]);
        assert!(why.unwrap_err().to_string().contains("it is a folder"));
        assert_eq!(texts(path), wanted);
    }
}
