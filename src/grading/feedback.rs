//! Sheets: what is written from graded submissions, for students, instructors and platforms.
//!
//! Every writer is a pure function of [`Graded`] submissions and [`words`]; [`folder`] alone writes
//! files. Reading order: [`text`] (what is said of a check), [`student`] and [`class`] (pages),
//! [`csv`], [`json`], then one file a platform. Names, logs and hints come from strangers:
//! [`plain`] takes out what a terminal or a page would obey, and each writer escapes for its format.

pub mod check50;
pub mod class;
pub mod classroom50;
pub mod codegrade;
pub mod csv;
pub mod document;
pub mod folder;
pub mod gradescope;
pub mod json;
pub mod junit;
pub mod plain;
pub mod student;
pub mod survey;
pub mod text;
pub mod vpl;
pub mod words;

use std::collections::BTreeMap;

use crate::grading::judge::add_film;
use crate::grading::judge::check::Check;
use crate::grading::judge::film::Film;
use crate::grading::judge::frames::Footage;
use crate::grading::judge::rubric::{Rubric, Visibility};
use crate::grading::judge::verdict::{Report, Status};

/// The version of the program that graded.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// A submission and what came out of grading it: what sheets are made of.
#[derive(Clone, Debug)]
pub struct Graded {
    /// Whose it is: the name of its folder, as it is.
    pub name: String,
    /// Where it lies.
    pub folder: String,
    /// What came out.
    pub report: Report,
    /// Pictures of failures, SVG.
    pub pictures: BTreeMap<Check, String>,
    /// How it was kept from doing harm; empty if nothing of it was run.
    pub tier: String,
    /// What build and run printed.
    pub log: String,
    /// How long grading took, s.
    pub seconds: f64,
    /// Whether checks are still to come.
    pub is_partial: bool,
}

impl Graded {
    /// A finished one of which nothing was run.
    pub fn new(name: &str, folder: &str, report: Report) -> Self {
        Self {
            name: name.to_owned(),
            folder: folder.to_owned(),
            report,
            pictures: BTreeMap::new(),
            tier: String::new(),
            log: String::new(),
            seconds: 0.0,
            is_partial: false,
        }
    }

    /// Grades the bytes of a file of frames.
    ///
    /// ```
    /// use parsim2d::grading::{feedback::Graded, judge::rubric::Rubric};
    /// let graded = Graded::of_frames("out.txt", b"", &Rubric::default());
    /// assert_eq!(graded.report.percent(), 0.0);
    /// ```
    pub fn of_frames(path: &str, bytes: &[u8], rubric: &Rubric) -> Self {
        let mut report = Report::of_frames(rubric);
        let film = add_film(&mut report, Footage::File(bytes), rubric);
        Self::new(path, path, report).with_pictures(film.as_ref())
    }

    /// With a picture of each failure that has a frame.
    pub fn with_pictures(mut self, film: Option<&Film>) -> Self {
        let failures = self.report.failures();
        // `many` is decided by another film.
        let failures = failures.filter(|(check, _)| check.is_of_frames());
        let drawn = film.map(|film| {
            failures.filter_map(|(check, why)| Some((check, why.picture(film)?))).collect()
        });
        self.pictures = drawn.unwrap_or_default();
        self
    }

    /// Points that are asked for: earned, lost and open.
    pub fn all_points(&self) -> f64 {
        self.report.earned() + self.report.lost() + self.report.open()
    }

    /// The checks that a student may see: at once, or when the sheet is handed back.
    pub(crate) fn shown(&self, at_once: bool) -> impl Iterator<Item = &(Check, Status)> {
        self.report.checks.iter().filter(move |(check, _)| {
            let visibility = self.report.rubric().visibility_of(*check);
            visibility == Visibility::Visible || (!at_once && visibility != Visibility::Hidden)
        })
    }
}

/// A submission that could not be graded, which is not the student's fault.
#[derive(Clone, Debug)]
pub struct Ungraded {
    /// Whose it is.
    pub name: String,
    /// What hindered it.
    pub why: String,
}

/// A submission of a class.
pub type Entry = Result<Graded, Ungraded>;

/// Whose it is.
pub fn name_of(entry: &Entry) -> &str {
    match entry {
        Ok(graded) => &graded.name,
        Err(ungraded) => &ungraded.name,
    }
}
