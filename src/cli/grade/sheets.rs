//! Where results go: a line as each ends, sheets in a folder as each ends, one stream at the end.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::arguments::SheetArguments;
use super::error::GradeError;
use crate::cli::failure::Failure;
use crate::grading::feedback::classroom50::{Classroom, utc};
use crate::grading::feedback::folder::{Around, Folder, Format, write_whole};
use crate::grading::feedback::json::json_of_student;
use crate::grading::feedback::plain::{file_names, one_line, short_names};
use crate::grading::feedback::text::{causes, text_of_class, text_of_student};
use crate::grading::feedback::words::ENGLISH;
use crate::grading::feedback::{Entry, Graded, name_of};
use crate::number::cut;
use crate::output::OutputError;
use crate::output::place::is_same;

/// Where results go.
pub(super) struct Sheets {
    formats: Vec<Format>,
    out: Option<PathBuf>,
    folder: Option<Folder>,
    around: Around,
    bar: ProgressBar,
    /// What has ended, and the first file that could not be written.
    ended: Mutex<(Vec<Option<Entry>>, Option<OutputError>)>,
}

impl Sheets {
    /// Refuses what does not fit together, and what would be written over one of the `inputs`, before anything is
    /// graded.
    pub fn open(
        arguments: &SheetArguments,
        names: &[String],
        inputs: &[PathBuf],
    ) -> Result<Self, Failure> {
        let formats = arguments.formats();
        let count = names.len();
        if arguments.out_dir.is_none() {
            match formats.as_slice() {
                [format] if count > 1 && !format.is_of_class() => {
                    let format = format!("{format:?}").to_lowercase();
                    return Err(GradeError::OneOnly { format, count }.into());
                }
                [_, _, ..] => return Err(GradeError::ManyFormats { count: formats.len() }.into()),
                _ => {}
            }
        }
        let around = around(arguments.pictures)?;
        let open = |folder: &PathBuf| {
            let files = file_names(short_names(names).iter().map(String::as_str));
            Folder::open(folder, files, &formats)
        };
        if let Some(out) = arguments.out.as_ref().filter(|out| !can_appear(out)) {
            return Err(GradeError::NoPlace { path: out.clone() }.into());
        }
        let folder = arguments.out_dir.as_ref().map(open).transpose()?;
        let written = folder.iter().flat_map(Folder::paths).chain(arguments.out.clone());
        refuse_over_inputs(written, inputs)?;
        let others = folder.as_ref().map(Folder::others).unwrap_or_default();
        if let (Some(path), false, false) =
            (&arguments.out_dir, arguments.replace_class, others.is_empty())
        {
            return Err(GradeError::OtherClass { path: path.clone(), others }.into());
        }
        let ended = Mutex::new((names.iter().map(|_| None).collect(), None));
        Ok(Self { formats, out: arguments.out.clone(), folder, around, bar: bar(count), ended })
    }

    /// Writes down a submission of which checks are still to come.
    pub fn keep(&self, k: usize, graded: &Graded) {
        let written = || self.write_one(k, graded);
        if let Err(why) = written() {
            let mut ended = self.ended.lock().unwrap_or_else(PoisonError::into_inner);
            ended.1.get_or_insert(why);
        }
    }

    fn write_one(&self, k: usize, graded: &Graded) -> Result<(), OutputError> {
        if let Some(folder) = &self.folder {
            folder.write_student(k, graded, &self.around, &ENGLISH)?;
        } else if let (Some(out), [format]) = (&self.out, self.formats.as_slice()) {
            // Many go into one file when all have ended.
            if self.bar.length() == Some(1) {
                write_whole(out, &format.of_student(graded, &self.around, &ENGLISH))?;
            }
        }
        Ok(())
    }

    /// A submission has ended.
    pub fn add(&self, k: usize, entry: &Entry) {
        if let Ok(graded) = entry {
            self.keep(k, graded);
        }
        let mut ended = self.ended.lock().unwrap_or_else(PoisonError::into_inner);
        ended.0[k] = Some(entry.clone());
        if let Some(folder) = &self.folder {
            let so_far = ended.0.iter().enumerate();
            let so_far = so_far.filter_map(|(k, entry)| Some((k, entry.as_ref()?)));
            if let Err(why) = folder.write_class(so_far, &ENGLISH) {
                ended.1.get_or_insert(why);
            }
        }
        self.bar.inc(1);
        if let Some(all) = self.bar.length().filter(|all| *all > 1) {
            let line = format!("[{}/{all}] {}", self.bar.position(), line(entry));
            self.bar.suspend(|| {
                let _ = writeln!(io::stderr(), "{line}"); // nowhere left to say that this failed
            });
        }
    }

    /// Everything has ended: what goes to standard output or into one file; the first file that could not be
    /// written is an error.
    pub fn finish(self, entries: &[Entry], is_long: bool) -> Result<(), Failure> {
        self.bar.finish_and_clear();
        let (_, failed) = self.ended.into_inner().unwrap_or_else(PoisonError::into_inner);
        failed.map_or(Ok(()), Err)?;
        let text = match (self.formats.as_slice(), &self.folder) {
            ([format], None) => in_format(*format, entries, &self.around),
            _ => in_words(entries, is_long && self.folder.is_none()),
        };
        match &self.out {
            Some(_) if text.is_empty() => {}
            Some(out) => write_whole(out, &text)?,
            None => io::stdout().lock().write_all(text.as_bytes())?,
        }
        Ok(())
    }
}

/// Refuses to write over what is read.
fn refuse_over_inputs(
    mut written: impl Iterator<Item = PathBuf>,
    inputs: &[PathBuf],
) -> Result<(), GradeError> {
    match written.find(|out| inputs.iter().any(|input| is_same(input, out))) {
        Some(path) => Err(GradeError::OverInput { path }),
        None => Ok(()),
    }
}

/// Whether a file of that path can be made, as far as its folder tells.
fn can_appear(path: &Path) -> bool {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    folder.is_none_or(Path::is_dir) && !path.is_dir()
}

/// A line of a submission that has ended.
fn line(entry: &Entry) -> String {
    let name = one_line(name_of(entry));
    match entry {
        Ok(graded) => {
            let part = cut(graded.report.percent());
            format!("{name}: {part} %  {}", causes(graded).join(", ")).trim_end().to_owned()
        }
        Err(ungraded) => format!("{name} {}", one_line(&ungraded.why)),
    }
}

/// Texts one after another and the table, or one of them.
fn in_words(entries: &[Entry], is_long: bool) -> String {
    let mut text = String::new();
    if is_long || entries.len() == 1 {
        for graded in entries.iter().flatten() {
            text += &text_of_student(graded, &ENGLISH);
        }
    }
    if entries.len() > 1 {
        text += if text.is_empty() { "" } else { "\n" };
        text += &text_of_class(entries, &ENGLISH);
    }
    text
}

fn in_format(format: Format, entries: &[Entry], around: &Around) -> String {
    match (format, entries) {
        // A list, one object for each.
        (Format::Json, _) => {
            let object = |entry: &Entry| match entry {
                Ok(graded) => json_of_student(graded, around.pictures, &ENGLISH),
                Err(why) => serde_json::json!({"name": why.name, "not_graded": why.why}),
            };
            let list: serde_json::Value = entries.iter().map(object).collect();
            format!("{list:#}\n")
        }
        (Format::Text, _) => in_words(entries, true),
        (_, [Ok(graded)]) => format.of_student(graded, around, &ENGLISH),
        // Nothing, rather than a score of 0 that is not the student's fault.
        (format, [Err(_)]) if !format.is_of_class() => String::new(),
        (format, entries) => format.of_class(entries, &[], &ENGLISH).unwrap_or_default(),
    }
}

/// What the environment says of the platform.
fn around(pictures: bool) -> Result<Around, GradeError> {
    let said = |key: &str| std::env::var(key).unwrap_or_default();
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
    let classroom = Classroom {
        classroom: said("CLASSROOM"),
        assignment: said("ASSIGNMENT"),
        submission: said("SUBMISSION_TAG"),
        commit: said("COMMIT_URL"),
        release: said("RELEASE_URL"),
        review: said("REVIEW_URL"),
        datetime: utc(now.map_or(0, |time| time.as_secs())),
    };
    let grade = |key: &'static str, usual: f64| match said(key) {
        value if value.is_empty() => Ok(usual),
        value => value
            .parse()
            .ok()
            .filter(|v: &f64| v.is_finite())
            .ok_or(GradeError::Scale { key, value }),
    };
    let scale = [grade("VPL_GRADEMIN", 0.0)?, grade("VPL_GRADEMAX", 100.0)?];
    Ok(Around { classroom, scale, pictures })
}

/// Shown on terminals only, and not for one submission.
fn bar(count: usize) -> ProgressBar {
    let target = match count {
        0 | 1 => ProgressDrawTarget::hidden(),
        _ => ProgressDrawTarget::stderr_with_hz(10),
    };
    let style = ProgressStyle::with_template("{bar:40} {pos} of {len}  {eta} left")
        .expect("a fixed, tested template");
    ProgressBar::with_draw_target(Some(count as u64), target).with_style(style)
}
