//! Sheets in a folder: each appears whole, as soon as its submission has been graded.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::class::html_of_class;
use super::classroom50::{Classroom, classroom50};
use super::csv::csv_of_class;
use super::json::{json_of_class, json_of_student};
use super::plain::{file_names, short_names};
use super::student::html_of_student;
use super::text::{text_of_class, text_of_student};
use super::words::Words;
use super::{Entry, Graded, check50, codegrade, gradescope, junit, vpl};
use crate::named::named;
use crate::output::OutputError;
use crate::output::place::plain_text;
use crate::output::replace::replace;

named! {
    /// A format of sheets, and how names of its files end.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
    pub enum Format, ending {
        /// For a terminal
        Text = "txt",
        /// Our own, with stable ids
        Json = "json",
        /// A page for a student, or of the class if there are more
        Html = "html",
        /// A table of the class
        Csv = "csv",
        /// Gradescope's results.json
        Gradescope = "gradescope.json",
        /// Classroom 50's result.json
        Classroom50 = "classroom50.json",
        /// JUnit XML: GitLab, GitHub, Jenkins, CodeGrade
        Junit = "junit.xml",
        /// What Moodle's VPL reads
        Vpl = "vpl.txt",
        /// JSON in the manner of check50
        Check50 = "check50.json",
        /// What CodeGrade reads from file descriptor 3
        Codegrade = "codegrade.json",
    }
}

/// What the platform around says.
#[derive(Clone, Debug)]
pub struct Around {
    /// Of Classroom 50.
    pub classroom: Classroom,
    /// Smallest and largest grade of Moodle's VPL.
    pub scale: [f64; 2],
    /// Whether JSON shall hold pictures.
    pub pictures: bool,
}

impl Default for Around {
    fn default() -> Self {
        Self { classroom: Classroom::default(), scale: [0.0, 100.0], pictures: false }
    }
}

impl Format {
    /// Whether it can hold more than one submission.
    pub fn is_of_class(self) -> bool {
        matches!(self, Self::Text | Self::Json | Self::Html | Self::Csv | Self::Junit)
    }

    /// A submission in it.
    pub fn of_student(self, graded: &Graded, around: &Around, words: &Words) -> String {
        let alone = || [Ok(graded.clone())];
        match self {
            Self::Text => text_of_student(graded, words),
            Self::Json => pretty(&json_of_student(graded, around.pictures, words)),
            Self::Html => html_of_student(graded, words),
            Self::Csv => csv_of_class(&alone()),
            Self::Gradescope => pretty(&gradescope::gradescope(graded, words)),
            Self::Classroom50 => pretty(&classroom50(graded, &around.classroom, words)),
            Self::Junit => junit::junit(&alone(), words),
            Self::Vpl => vpl::vpl(graded, around.scale, words),
            Self::Check50 => pretty(&check50::check50(graded, words)),
            Self::Codegrade => codegrade::codegrade(graded),
        }
    }

    /// A class in it, if it can hold one. `files` are the names of the students' files without ending.
    pub fn of_class(self, entries: &[Entry], files: &[String], words: &Words) -> Option<String> {
        match self {
            Self::Text => Some(text_of_class(entries, words)),
            Self::Json => Some(pretty(&json_of_class(entries, words))),
            Self::Html => Some(html_of_class(entries, files, words)),
            Self::Csv => Some(csv_of_class(entries)),
            Self::Junit => Some(junit::junit(entries, words)),
            _ => None,
        }
    }
}

fn pretty(value: &serde_json::Value) -> String {
    // Alternate Display of a Value is indented JSON and cannot fail.
    format!("{value:#}\n")
}

/// A folder of sheets: `NAME.html`, `NAME.json`, ..., `class.html`, `class.csv`, `class.json`, ...
pub struct Folder {
    folder: PathBuf,
    files: Vec<String>,
    formats: Vec<Format>,
}

impl Folder {
    /// What is always there.
    const USUAL: [Format; 3] = [Format::Html, Format::Json, Format::Csv];

    /// Opens a folder, made if need be, for submissions of these names, each already fit for a file.
    pub fn open(
        folder: &Path,
        files: Vec<String>,
        formats: &[Format],
    ) -> Result<Self, OutputError> {
        let refused = |source| OutputError::Create { path: folder.to_owned(), source };
        fs::create_dir_all(folder).map_err(refused)?;
        let more = formats.iter().copied().filter(|format| !Self::USUAL.contains(format));
        let formats = Self::USUAL.into_iter().chain(more).collect();
        Ok(Self { folder: folder.to_owned(), files, formats })
    }

    /// All files that are written.
    pub fn paths(&self) -> impl Iterator<Item = PathBuf> {
        let names = self.files.iter().map(String::as_str).chain(["class"]);
        names.flat_map(move |name| self.formats.iter().map(move |format| self.path(name, *format)))
    }

    fn path(&self, name: &str, format: Format) -> PathBuf {
        self.folder.join(format!("{name}.{}", format.ending()))
    }

    /// Names of the submissions in the tables of the class that are there already and that are none of these.
    pub fn others(&self) -> Vec<String> {
        let read = || {
            let text = plain_text(&self.folder.join("class.json")).ok()?;
            let class: serde_json::Value = serde_json::from_str(&text).ok()?;
            let names = |list: &str, key: &str| -> Vec<String> {
                let list = class[list].as_array().into_iter().flatten();
                list.filter_map(|one| one[key].as_str().map(str::to_owned)).collect()
            };
            Some([names("submissions", "file"), names("not_graded", "name")].concat())
        };
        let before = read().unwrap_or_default();
        let files = file_names(short_names(&before).iter().map(String::as_str));
        let is_other = |(_, file): &(String, String)| !self.files.contains(file);
        before.into_iter().zip(files).filter(is_other).map(|(name, _)| name).collect()
    }

    /// Writes the sheets of submission `k`.
    pub fn write_student(
        &self,
        k: usize,
        graded: &Graded,
        around: &Around,
        words: &Words,
    ) -> Result<(), OutputError> {
        for format in self.formats.iter().filter(|format| **format != Format::Csv) {
            let text = format.of_student(graded, around, words);
            self.write(&self.files[k], *format, &text)?;
        }
        Ok(())
    }

    /// Writes the sheets of the class: of the submissions graded so far, each with its number.
    pub fn write_class<'a>(
        &self,
        entries: impl Iterator<Item = (usize, &'a Entry)>,
        words: &Words,
    ) -> Result<(), OutputError> {
        let (files, entries): (Vec<_>, Vec<_>) =
            entries.map(|(k, entry)| (self.files[k].clone(), entry.clone())).unzip();
        for format in &self.formats {
            if let Some(text) = format.of_class(&entries, &files, words) {
                self.write("class", *format, &text)?;
            }
        }
        Ok(())
    }

    fn write(&self, name: &str, format: Format, text: &str) -> Result<(), OutputError> {
        write_whole(&self.path(name, format), text)
    }
}

/// Writes a file that appears whole: a reader never sees half of it. A link is refused: what is handed in may
/// have laid it.
pub fn write_whole(path: &Path, text: &str) -> Result<(), OutputError> {
    if path.is_symlink() {
        let source = io::Error::other("it is a link, and no sheet is written over a link");
        return Err(OutputError::InTheWay { path: path.to_owned(), source });
    }
    replace(path, |out| out.write_all(text.as_bytes()))
}
