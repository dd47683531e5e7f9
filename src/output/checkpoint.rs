//! Checkpoints in the folder of a run: a fresh run must not destroy one it does not know.
//!
//! A checkpoint is a file `parsim2d*.ckpt` whose first line is `parsim2d checkpoint` and the number
//! of its format. This version writes none, so every one it meets is of another version, and its
//! run could still be continued by that version.

use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;

use super::OutputError;

/// The words before the format's number in the first line.
const MAGIC: &str = "parsim2d checkpoint ";

/// Refuses to run in a `folder` that holds a checkpoint of another version.
pub fn refuse_foreign(folder: &Path) -> Result<(), OutputError> {
    let Ok(entries) = fs::read_dir(folder) else {
        return Ok(()); // no folder yet, no checkpoints
    };
    let mut ours =
        entries.filter_map(|entry| Some(entry.ok()?.path())).filter(|path| is_ours(path));
    match ours.next() {
        None => Ok(()),
        Some(path) => {
            let format = format(&path).ok().flatten();
            let format = format.map_or("unknown format".to_owned(), |k| format!("format {k}"));
            Err(OutputError::ForeignCheckpoint { path, format })
        }
    }
}

fn is_ours(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    name.starts_with("parsim2d") && name.ends_with(".ckpt")
}

/// The format's number, if the file begins as a checkpoint does.
fn format(path: &Path) -> io::Result<Option<u32>> {
    let mut line = Vec::new();
    BufReader::new(File::open(path)?).take(100).read_until(b'\n', &mut line)?;
    let line = String::from_utf8_lossy(&line).into_owned();
    Ok(line.strip_prefix(MAGIC).and_then(|rest| rest.split_whitespace().next()?.parse().ok()))
}
