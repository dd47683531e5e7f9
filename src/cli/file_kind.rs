//! What a file is that was named where another was wanted, by how it begins, and what can be done with it.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

use super::refusal::Refusal;
use super::typed::{quoted, shown};
use crate::grading::judge::rubric::Rubric;
use crate::named::named;
use crate::output::frames::read_frame;
use crate::output::{checkpoint, record};
use crate::scenario::file;

named! {
    /// Files that are known by how they begin.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub(super) enum FileKind, name {
        Folder = "a folder",
        Checkpoint = "a checkpoint",
        Frames = "a file of frames",
        Ledger = "an energy ledger",
        DriftStudy = "a drift study",
        DriftCurves = "the second file of a drift study",
        Scenario = "a scenario",
        Rubric = "a rubric for grading",
        Json = "JSON",
        Picture = "a page or picture",
        GnuplotScript = "a gnuplot script",
        RustExample = "source code",
        Source = "source code",
    }
}

impl FileKind {
    /// What the file at `path` is, if it is one of these.
    pub fn of(path: &Path) -> Option<Self> {
        if path.is_dir() {
            return Some(Self::Folder);
        }
        if !path.is_file() {
            return None; // a pipe would be waited for
        }
        if checkpoint::is_one(path) {
            return Some(Self::Checkpoint);
        }
        let start = start(path)?;
        of_start(&start).or_else(|| of_name(path)).or_else(|| of_all(path, &start))
    }

    /// What can be done with the file of this kind at `path`.
    pub fn way_out(self, path: &Path) -> String {
        let file = quoted(&shown(path));
        match self {
            Self::Folder => of_folder(path),
            Self::Checkpoint => format!("parsim2d resume {file}"),
            Self::Frames => format!(
                "a run that starts from it: parsim2d --start {file} --out-dir next; a picture: parsim2d plot \
                 frame {file}"
            ),
            Self::Ledger => format!("parsim2d plot energy {file}"),
            Self::DriftStudy => format!("parsim2d plot drift {file}"),
            Self::DriftCurves => {
                let study = quoted(&shown(&path.with_file_name("drift.csv")));
                format!("drift.csv beside it is the file to name: parsim2d plot drift {study}")
            }
            Self::Scenario => format!("parsim2d {file}"),
            Self::Rubric => format!("parsim2d grade --frames out.txt --rubric {file}"),
            Self::Json => "a scenario is TOML, as parsim2d --print-config prints it".to_owned(),
            Self::Picture => "open it in a browser".to_owned(),
            Self::GnuplotScript => format!("gnuplot {file}"),
            Self::RustExample => {
                let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
                format!("cargo run --example {}", quoted(&name))
            }
            Self::Source => {
                "parsim2d grade FOLDER builds, runs and grades what is in a folder".to_owned()
            }
        }
    }

    /// The same for somebody who wants a picture.
    pub fn picture(self, path: &Path) -> String {
        match self {
            Self::Frames => {
                let file = quoted(&shown(path));
                format!("parsim2d plot frame {file}; or trajectory, velocity, forces, speeds")
            }
            _ => self.way_out(path),
        }
    }

    /// What to say where the file at `path` was named as `wanted`, as "a scenario".
    pub fn in_place_of(self, wanted: &str, path: &Path) -> Refusal {
        let why = format!("{} is {}, not {wanted}", shown(path), self.name());
        Refusal { why, way_out: self.way_out(path) }
    }
}

/// The first line of a file, and some of what follows it.
fn start(path: &Path) -> Option<Vec<u8>> {
    let mut start = Vec::new();
    File::open(path).ok()?.take(1 << 10).read_to_end(&mut start).ok()?;
    Some(start)
}

fn of_start(start: &[u8]) -> Option<FileKind> {
    const PICTURES: [&[u8]; 4] = [b"\x89PNG", b"GIF8", b"%PDF", b"\xff\xd8\xff"];
    if PICTURES.iter().any(|begin| start.starts_with(begin)) {
        return Some(FileKind::Picture);
    }
    let text = String::from_utf8_lossy(start);
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let lower = text.to_ascii_lowercase();
    if ["<!doctype html", "<html", "<svg", "<?xml"].iter().any(|begin| lower.starts_with(begin)) {
        return Some(FileKind::Picture);
    }
    let first_rows = text.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#'));
    let is_row = |line: &str| {
        let words: Vec<&str> = line.split_whitespace().collect();
        words.len() > 1 && words.iter().all(|word| word.parse::<f64>().is_ok())
    };
    match text {
        _ if text.starts_with("step,time_s") => Some(FileKind::Ledger),
        _ if text.starts_with("case,integrator,restitution,nt,dt_s") => Some(FileKind::DriftStudy),
        _ if text.starts_with("case,integrator") => Some(FileKind::DriftCurves),
        _ if text.starts_with("# step ") => Some(FileKind::Frames),
        _ if first_rows.take(1).any(is_row) => Some(FileKind::Frames),
        _ if text.starts_with('{') => Some(FileKind::Json),
        _ => None,
    }
}

fn of_name(path: &Path) -> Option<FileKind> {
    let is_example = path.parent().is_some_and(|folder| folder.ends_with("examples"));
    match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
        "gp" | "plot" | "plt" | "gnuplot" => Some(FileKind::GnuplotScript),
        "rs" if is_example => Some(FileKind::RustExample),
        "rs" | "c" | "h" | "cpp" | "cc" | "cxx" | "hpp" | "py" | "java" => Some(FileKind::Source),
        _ => None,
    }
}

/// What only the whole file tells.
fn of_all(path: &Path, start: &[u8]) -> Option<FileKind> {
    const LONGEST: u64 = 1 << 20; // bytes; nobody writes longer scenarios and rubrics by hand
    let is_blank = start.iter().all(u8::is_ascii_whitespace);
    if !is_blank && std::fs::metadata(path).ok()?.len() <= LONGEST {
        if file::read(path).is_ok() {
            return Some(FileKind::Scenario);
        }
        if std::fs::read_to_string(path).is_ok_and(|text| Rubric::parse(&text).is_ok()) {
            return Some(FileKind::Rubric);
        }
    }
    // Frames of other programs, with headings that only their reader knows.
    if start.contains(&b'=') && start.contains(&b'[') {
        return None; // a scenario with a mistake in it
    }
    let input = BufReader::new(File::open(path).ok()?);
    is_frames(input).then_some(FileKind::Frames)
}

fn is_frames(input: impl BufRead) -> bool {
    read_frame(input, Some(0)).is_ok_and(|frame| !frame.rows.is_empty())
}

/// What can be done with the run in `folder`.
fn of_folder(folder: &Path) -> String {
    let names = |name: &str| {
        let path = folder.join(name);
        path.is_file().then(|| quoted(&shown(&path)))
    };
    match (names(checkpoint::FILE), names(record::FILE)) {
        (Some(checkpoint), _) => {
            format!("to go on with the run there: parsim2d resume {checkpoint}")
        }
        (None, Some(record)) => {
            format!("to repeat the run there: parsim2d {record} --out-dir again")
        }
        (None, None) => "the name of a file, as examples/settling.toml".to_owned(),
    }
}

/// A scenario file that was perhaps meant by the name `path`, which no file has: one beside it, or an example.
pub(super) fn near_scenario(path: &Path) -> Option<Refusal> {
    if path.exists() {
        return None;
    }
    let beside = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let beside = beside.unwrap_or(Path::new("."));
    let said = path.file_name()?.to_string_lossy().into_owned();
    let folders = [beside.to_owned(), beside.join("examples"), PathBuf::from("examples")];
    let named = folders.iter().flat_map(|folder| {
        let entries = std::fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok);
        let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
        names.filter(|name| name.ends_with(".toml")).map(|name| (folder.join(&name), name))
    });
    // Two letters off at most; the ending counts for nothing.
    let near = named.map(|(path, name)| (strsim::osa_distance(&said, &name), path));
    let (_, nearest) = near.filter(|(letters, _)| *letters <= 2).min()?;
    let why = format!("there is no file {}", shown(path));
    Some(Refusal { why, way_out: format!("parsim2d {}", quoted(&shown(&nearest))) })
}
