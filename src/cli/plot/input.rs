//! The files that pictures are drawn from.

use std::cell::{Cell, RefCell};
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use super::error::{bad_file, too_many, unreadable};
use super::progress::Progress;
use crate::analysis::energy::LedgerRow;
use crate::cli::failure::Failure;
use crate::cli::file_kind::FileKind;
use crate::cli::refusal::Refusal;
use crate::cli::say::say;
use crate::cli::typed::quoted;
use crate::echo;
use crate::figure::{energy, gnuplot};
use crate::number::counted;
use crate::output::frames::layout::Layout;
use crate::output::frames::{Frame, Frames, Reading};
use crate::output::place::{plain_file, plain_text};
use crate::output::record;
use crate::scenario::file;

/// The one file of a picture that shows one.
pub(super) fn one_file<'a>(kind: &'static str, files: &'a [PathBuf]) -> Result<&'a Path, Refusal> {
    match files {
        [file] => Ok(file),
        _ => Err(too_many(kind, files.len())),
    }
}

/// Says something that is no failure.
pub(super) fn remark(text: &str) {
    say("note", text);
}

fn open(path: &Path, command: &str) -> Result<File, Refusal> {
    // A picture goes through its file more than once, and its script once more.
    plain_file(path).map_err(|source| unreadable(path, &source, command))
}

/// What to do with a file that is not what was wanted.
fn advice(path: &Path) -> Option<String> {
    FileKind::of(path).map(|kind| format!("this is {}: {}", kind.name(), kind.picture(path)))
}

const REPEAT: &str = "repeat the run that wrote it";

/// Reads a csv file for a picture of this `kind`.
pub(super) fn read_table<T>(
    path: &Path,
    kind: &'static str,
    read: impl FnOnce(BufReader<File>) -> Result<Vec<T>, String>,
) -> Result<Vec<T>, Failure> {
    let command = if kind == "drift" { "parsim2d drift" } else { "parsim2d" };
    let rows = read(BufReader::new(open(path, command)?)).map_err(|why| {
        let advice = advice(path).filter(|_| why.starts_with("its columns"));
        bad_file(path, &why, advice.as_deref().unwrap_or(REPEAT))
    })?;
    if rows.is_empty() {
        return Err(bad_file(path, "it holds no rows", REPEAT).into());
    }
    Ok(rows)
}

/// A file of frames.
pub struct FrameFile {
    /// Its path as said.
    pub path: PathBuf,
    reading: Reading,
    /// What has been said of it.
    told: RefCell<Vec<String>>,
    /// Whether gnuplot reads it as it was read here.
    is_plain: Cell<bool>,
    /// Whether the record of the run beside it says that there are no walls: frames name the side of the box only.
    is_open: bool,
}

impl FrameFile {
    /// The file at `path`.
    pub fn named(path: &Path) -> Self {
        Self::with_columns(path, None)
    }

    /// The same, with these columns if they are said by hand.
    pub fn with_columns(path: &Path, columns: Option<Layout>) -> Self {
        let record = path.with_file_name(record::FILE);
        let said = plain_text(&record).ok().and_then(|text| file::parse(&text, &record).ok());
        let said = said.unwrap_or_default();
        Self {
            path: path.to_owned(),
            reading: Reading { columns, ..Reading::default() },
            told: RefCell::default(),
            is_plain: Cell::new(true),
            is_open: said.walls == Some(false) || said.no_walls == Some(true),
        }
    }

    /// `frame` as it is drawn.
    fn drawn(&self, mut frame: Frame) -> Frame {
        if self.is_open {
            frame.side = None;
        }
        frame
    }

    /// Says once what is to be said of how the file was read.
    fn tell(&self, frames: &Frames<BufReader<File>>) {
        self.is_plain.set(self.is_plain.get() && frames.are_plain());
        let mut told = self.told.borrow_mut();
        for text in frames.remarks() {
            if !told.contains(text) {
                remark(&format!("{}: {text}", self.path.display()));
                told.push(text.clone());
            }
        }
    }

    /// The `script` that draws the file in gnuplot, or one that says why gnuplot cannot.
    pub fn script(&self, script: String) -> String {
        if self.is_plain.get() {
            return script;
        }
        let name = self.path.to_string_lossy();
        let why = format!(
            "gnuplot does not read {name} as x y r vx vy; a file that it reads: parsim2d convert {} frames.txt",
            quoted(&name)
        );
        remark(&format!("{why}; until then the script beside the picture says only this"));
        format!(
            "# {}\nprint {}\nexit status 1\n",
            why.replace(['\n', '\r'], " "),
            gnuplot::quoted(&why)
        )
    }

    fn frames(&self) -> Result<Frames<BufReader<File>>, Refusal> {
        let file = open(&self.path, "parsim2d")?;
        Ok(Frames::read_as(BufReader::with_capacity(1 << 16, file), &self.reading))
    }

    /// What is wrong with the file after `whole` good frames; `flag` names the last of these.
    fn bad(&self, why: &str, whole: usize, flag: &str) -> Refusal {
        if let Some((why, way_out)) = why.split_once("\n  way out: ") {
            return bad_file(&self.path, why, way_out);
        }
        let way_out = match (whole, advice(&self.path)) {
            (0, Some(advice)) if FileKind::of(&self.path) != Some(FileKind::Frames) => advice,
            (0, _) => "a file of frames, as `parsim2d` writes: out.txt, trajectory.txt. Of a run that went \
                       wrong, earlier frames are in trajectory.txt: --frame 0"
                .to_owned(),
            (_, _) => format!("frames 0 to {} are whole: {flag} {}", whole - 1, whole - 1),
        };
        bad_file(&self.path, why, &way_out)
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
        let mut frames = self.frames()?;
        for (index, frame) in frames.by_ref().enumerate() {
            let frame = self.drawn(frame.map_err(|why| self.bad(&why, index, "--frame"))?);
            progress.advance();
            let is_wanted = wanted == Some(index);
            last = Some((index, frame));
            if is_wanted {
                break;
            }
        }
        self.tell(&frames);
        match (wanted, last) {
            (None, Some(last)) => Ok(last),
            (Some(k), Some(last)) if last.0 == k => Ok(last),
            (Some(k), Some((last, _))) => {
                let why = format!("frame {k} was asked for; it holds frames 0 to {last}");
                Err(bad_file(&self.path, &why, &format!("--frame {last}")).into())
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
        let mut frames = self.frames()?;
        for (index, frame) in frames.by_ref().enumerate().take(wanted) {
            let frame = frame.map_err(|why| self.bad(&why, index, "--until"))?;
            see(index, self.drawn(frame))?;
            seen += 1;
        }
        self.tell(&frames);
        match (seen, until) {
            (0, _) => Err(self.bad("it holds no frame", 0, "").into()),
            (_, Some(last)) if seen <= last => {
                let why = format!("--until {last} was said; it holds frames 0 to {}", seen - 1);
                Err(bad_file(&self.path, &why, "leave out --until").into())
            }
            _ => Ok(()),
        }
    }
}

/// The finite rows of an energy ledger, at least two.
pub(in crate::cli) fn ledger(path: &Path) -> Result<Vec<LedgerRow>, Failure> {
    let mut rows = read_table(path, "energy", crate::output::energy::read)?;
    let read = rows.len();
    rows.retain(energy::is_finite);
    if rows.len() < 2 {
        let why = format!("{} of its {read} rows are finite; two are needed", rows.len());
        return Err(bad_file(path, &why, "another run, with a smaller time step").into());
    }
    if rows.len() < read {
        let left_out = read - rows.len();
        remark(&format!(
            "{}: {} left out, with numbers that are not finite",
            echo::path(path),
            counted(left_out, "row")
        ));
    }
    Ok(rows)
}
