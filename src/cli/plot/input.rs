//! The files that pictures are drawn from.

use std::fs::File;
use std::io::{self, BufReader, Write};
use std::path::{Path, PathBuf};

use super::error::PlotError;
use super::progress::Progress;
use crate::cli::Failure;
use crate::cli::file_kind::FileKind;
use crate::output::frames::{Frame, Frames};

/// The one file of a picture that shows one.
pub(super) fn one_file<'a>(
    kind: &'static str,
    files: &'a [PathBuf],
) -> Result<&'a Path, PlotError> {
    match files {
        [file] => Ok(file),
        _ => Err(PlotError::TooMany { kind, n: files.len() }),
    }
}

/// Says something that is no failure.
pub(super) fn remark(text: &str) {
    let _ = writeln!(io::stderr(), "note: {text}"); // a closed stderr is no failure
}

fn open(path: &Path, command: &'static str) -> Result<File, PlotError> {
    let unreadable = |source| PlotError::Unreadable { path: path.to_owned(), source, command };
    if path.is_dir() {
        return Err(unreadable(io::ErrorKind::IsADirectory.into()));
    }
    File::open(path).map_err(unreadable)
}

/// What to do with a file that is not what was wanted.
fn advice(path: &Path) -> Option<String> {
    FileKind::of(path).map(|kind| format!("this is {}: {}", kind.name(), kind.picture(path)))
}

/// Reads a csv file for a picture of this `kind`.
pub(super) fn read_table<T>(
    path: &Path,
    kind: &'static str,
    read: impl FnOnce(BufReader<File>) -> Result<Vec<T>, String>,
) -> Result<Vec<T>, Failure> {
    let command = if kind == "drift" { "parsim2d drift" } else { "parsim2d" };
    let rows = read(BufReader::new(open(path, command)?)).map_err(|why| {
        let advice = advice(path).filter(|_| why.starts_with("its columns"));
        PlotError::bad_file(
            path,
            &why,
            &advice.unwrap_or("repeat the run that wrote it".to_owned()),
        )
    })?;
    if rows.is_empty() {
        let why = "it holds no rows";
        return Err(PlotError::bad_file(path, why, "repeat the run that wrote it").into());
    }
    Ok(rows)
}

/// A file of frames.
pub struct FrameFile {
    /// Its path as said.
    pub path: PathBuf,
}

impl FrameFile {
    /// The file at `path`.
    pub fn named(path: &Path) -> Self {
        Self { path: path.to_owned() }
    }

    fn frames(&self) -> Result<Frames<BufReader<File>>, PlotError> {
        let file = open(&self.path, "parsim2d")?;
        Ok(Frames::of(BufReader::with_capacity(1 << 16, file)))
    }

    /// What is wrong with the file after `whole` good frames; `flag` names the last of these.
    fn bad(&self, why: &str, whole: usize, flag: &str) -> PlotError {
        let way_out = match (whole, advice(&self.path)) {
            (0, Some(advice)) if FileKind::of(&self.path) != Some(FileKind::Frames) => advice,
            (0, _) => "a file of frames, as `parsim2d` writes: out.txt, trajectory.txt. Of a run that went \
                       wrong, earlier frames are in trajectory.txt: --frame 0"
                .to_owned(),
            (_, _) => format!("frames 0 to {} are whole: {flag} {}", whole - 1, whole - 1),
        };
        PlotError::bad_file(&self.path, why, &way_out)
    }

    /// How many frames are whole, at least one, and what is wrong with the one after them.
    pub fn whole(&self) -> Result<(usize, Option<String>), Failure> {
        let mut whole = 0;
        for frame in self.frames()? {
            match frame {
                Ok(_) => whole += 1,
                Err(why) if whole > 0 => return Ok((whole, Some(why))),
                Err(why) => return Err(self.bad(&why, 0, "").into()),
            }
        }
        match whole {
            0 => Err(self.bad("it holds no frame", 0, "").into()),
            _ => Ok((whole, None)),
        }
    }

    /// Frame number `wanted` from 0, or the last, and its number.
    pub fn frame(&self, wanted: Option<usize>) -> Result<(usize, Frame), Failure> {
        let progress = Progress::begin(None);
        let mut last = None;
        for (index, frame) in self.frames()?.enumerate() {
            let frame = frame.map_err(|why| self.bad(&why, index, "--frame"))?;
            progress.advance();
            if wanted == Some(index) {
                return Ok((index, frame));
            }
            last = Some((index, frame));
        }
        match (wanted, last) {
            (None, Some(last)) => Ok(last),
            (Some(k), Some((last, _))) => {
                let why = format!("frame {k} was asked for; it holds frames 0 to {last}");
                Err(PlotError::bad_file(&self.path, &why, &format!("--frame {last}")).into())
            }
            (_, None) => Err(self.bad("it holds no frame", 0, "").into()),
        }
    }

    /// Shows every frame with its number to `see`, up to number `until`.
    pub fn each_frame(
        &self,
        until: Option<usize>,
        mut see: impl FnMut(usize, Frame) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let wanted = until.map_or(usize::MAX, |last| last.saturating_add(1));
        let mut seen = 0;
        for (index, frame) in self.frames()?.enumerate().take(wanted) {
            see(index, frame.map_err(|why| self.bad(&why, index, "--until"))?)?;
            seen += 1;
        }
        match (seen, until) {
            (0, _) => Err(self.bad("it holds no frame", 0, "").into()),
            (_, Some(last)) if seen <= last => {
                let why = format!("--until {last} was said; it holds frames 0 to {}", seen - 1);
                Err(PlotError::bad_file(&self.path, &why, "leave out --until").into())
            }
            _ => Ok(()),
        }
    }
}
