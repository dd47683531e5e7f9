//! `parsim2d grade`: judges submissions, or frames that they wrote.

mod all;
mod arguments;
mod error;
mod exit_code;
mod explain;
mod proof;
mod sheets;
mod submissions;

use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use self::all::grade_all;
use self::exit_code::exit_code;
use self::explain::explain;
use self::sheets::Sheets;
use super::failure::Failure;
use crate::grading::feedback::Graded;
use crate::grading::feedback::plain::short_names;
use crate::grading::judge::rubric::{COMMENTED, Rubric};
use crate::output::OutputError;

pub(super) use self::arguments::GradeArguments;
pub(super) use self::error::GradeError;

pub(super) const EXAMPLES: &str = "\
Examples:
  parsim2d grade submissions/*                       builds and runs each in a sandbox; a table of the class
  parsim2d grade submissions/* --rubric course.toml --out-dir done -j 4
  parsim2d grade --frames out.txt                    faces, points, causes and hints
  parsim2d grade --frames a.txt b.txt --json         for a script; ids are stable
  parsim2d grade --frames a.txt b.txt --out-dir films  a page to hand back for each, and class.html, class.csv
  parsim2d grade --frames out.txt --format gradescope  results.json; also classroom50, junit, vpl, ...
  parsim2d grade --init-rubric > course.toml         the numbers and points of a course
  parsim2d grade --frames out.txt --rubric course.toml --fail-under 60
  parsim2d grade --explain free_flight               what a check measures, and why

Exit codes: 0 graded whatever the score, 1 below --fail-under, 2 usage or rubric error, 3 a sandbox or file failed.";

pub(super) fn run(arguments: &GradeArguments) -> Result<ExitCode, Failure> {
    graded(arguments).map_err(|why| match why {
        // 1 is for who is below --fail-under.
        Failure::Stdout(why) if why.kind() != io::ErrorKind::BrokenPipe => {
            Failure::Grade(GradeError::Unwritten(Failure::Stdout(why).to_string()))
        }
        Failure::Output(why @ OutputError::Write { .. }) => {
            Failure::Grade(GradeError::Unwritten(why.to_string()))
        }
        _ => why,
    })
}

fn graded(arguments: &GradeArguments) -> Result<ExitCode, Failure> {
    let rubric = arguments.rubric.as_deref().map(rubric).transpose()?.unwrap_or_default();
    let mut out = io::stdout().lock();
    if arguments.init_rubric {
        write!(out, "{COMMENTED}")?;
        return Ok(ExitCode::SUCCESS);
    }
    if let Some(id) = &arguments.explain {
        explain(&mut out, id, &rubric)?;
        return Ok(ExitCode::SUCCESS);
    }
    drop(out);
    match (arguments.proof, arguments.submissions.is_empty()) {
        (true, _) => proof::run(arguments),
        (_, false) => submissions::run(arguments, rubric),
        _ => grade_files(arguments, &rubric),
    }
}

/// Grades files of frames.
fn grade_files(arguments: &GradeArguments, rubric: &Rubric) -> Result<ExitCode, Failure> {
    let names: Vec<String> =
        arguments.frames.iter().map(|path| path.display().to_string()).collect();
    let short = short_names(&names);
    let sheets = Sheets::open(&arguments.sheets, &names, &arguments.inputs())?;
    let entries = grade_all(
        arguments.frames.iter().cloned(),
        arguments.jobs(),
        |k, path| Ok(Graded { name: short[k].clone(), ..grade_frames(path, rubric)? }),
        |k, entry| sheets.add(k, entry),
    );
    sheets.finish(&entries, true)?;
    Ok(ExitCode::from(exit_code(&entries, arguments.fail_under)))
}

/// Grades a file of frames.
fn grade_frames(path: &Path, rubric: &Rubric) -> Result<Graded, String> {
    let began = Instant::now();
    let bytes = read(path).map_err(|why| format!("cannot be read: {why}"))?;
    let mut graded = Graded::of_frames(&path.display().to_string(), &bytes, rubric);
    graded.seconds = began.elapsed().as_secs_f64();
    Ok(graded)
}

/// The bytes of a file, which may be a pipe and must come to an end.
fn read(path: &Path) -> io::Result<Vec<u8>> {
    const MOST_BYTES: u64 = 1 << 30;
    let mut bytes = Vec::new();
    File::open(path)?.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(io::Error::other("it has more than a gibibyte, or no end"));
    }
    Ok(bytes)
}

fn rubric(path: &Path) -> Result<Rubric, GradeError> {
    let refused = |why: String| GradeError::Rubric { path: path.to_owned(), why };
    let bytes = read(path).map_err(|why| refused(why.to_string()))?;
    let text = String::from_utf8(bytes).map_err(|_| refused("it is not text".to_owned()))?;
    let mut rubric = Rubric::parse(&text).map_err(refused)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    if let Some(interface) = &mut rubric.interface {
        interface.read(folder).map_err(refused)?;
    }
    Ok(rubric)
}
