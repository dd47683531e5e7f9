//! Folders handed in: built and run in the sandbox, graded, and written down as each check ends.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use super::all::grade_all;
use super::arguments::GradeArguments;
use super::error::GradeError;
use super::exit_code::exit_code;
use super::sheets::Sheets;
use crate::cli::failure::Failure;
use crate::cli::signals::heed;
use crate::echo;
use crate::grading::judge::rubric::Rubric;
use crate::grading::pipeline::Grader;
use crate::grading::pipeline::program::Course;
use crate::grading::sandbox::{Options, Sandbox, remove_private_folders};

pub(super) fn run(arguments: &GradeArguments, mut rubric: Rubric) -> Result<ExitCode, Failure> {
    rubric.program.seed = arguments.seed.unwrap_or(rubric.program.seed);
    let course = Course::of(rubric).map_err(GradeError::Command)?;
    let (of_a_mac, folders): (Vec<PathBuf>, Vec<PathBuf>) = arguments
        .submissions
        .iter()
        .filter(|path| path.is_dir())
        .cloned()
        .partition(|path| is_of_a_mac(path));
    if let Some(path) = of_a_mac.first() {
        eprintln!(
            "note: {} is left out: a Mac puts it into zips, nobody handed it in",
            echo::path(path)
        );
    }
    if let Some(path) = arguments.submissions.iter().find(|path| !path.exists()) {
        return Err(GradeError::NoFolder { path: path.clone() }.into());
    }
    if folders.is_empty() {
        let path = arguments.submissions[0].clone();
        return Err(GradeError::NoFolder { path }.into());
    }
    if let Some(class) = folders.iter().find(|folder| is_class(folder)) {
        eprintln!(
            "note: {} has folders and no files: are these the submissions? then {0}/*",
            echo::path(class)
        );
    }
    let sandbox = open(arguments)?;
    needs_tools(&sandbox, &course)?;
    let names: Vec<String> = folders.iter().map(|path| path.display().to_string()).collect();
    let sheets = Sheets::open(&arguments.sheets, &names, &arguments.inputs())?;
    let grader = Grader { sandbox: &sandbox, course: &course };
    let entries = grade_all(
        folders,
        arguments.jobs(),
        |k, folder| {
            grader.grade(folder, |graded| sheets.keep(k, graded)).map_err(|why| why.to_string())
        },
        |k, entry| sheets.add(k, entry),
    );
    sheets.finish(&entries, true)?;
    Ok(ExitCode::from(exit_code(&entries, arguments.fail_under)))
}

/// What the machine lacks is no mistake of a student's.
fn needs_tools(sandbox: &Sandbox, course: &Course) -> Result<(), GradeError> {
    let Some(program) = course.tools().find(|program| !sandbox.finds(program)) else {
        return Ok(());
    };
    let path: Vec<String> = sandbox.path().iter().map(|path| path.display().to_string()).collect();
    Err(GradeError::NoTool { program: program.clone(), path: path.join(", ") })
}

/// Whether a folder is what a Mac adds to a zip.
fn is_of_a_mac(folder: &Path) -> bool {
    folder.file_name().is_some_and(|name| name == "__MACOSX")
}

/// Whether a folder holds several folders and no files, as that of a whole class does.
fn is_class(folder: &Path) -> bool {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let kinds: Vec<_> = entries.filter_map(|entry| entry.file_type().ok()).collect();
    kinds.len() > 1 && kinds.iter().all(std::fs::FileType::is_dir)
}

/// The sandbox, with a word on what it is.
pub(super) fn open(arguments: &GradeArguments) -> Result<Sandbox, GradeError> {
    let (allow_unsandboxed, readable) = (arguments.allow_unsandboxed, arguments.tools.clone());
    let options = Options { allow_unsandboxed, readable, ..Options::default() };
    let sandbox = Sandbox::open(&options).map_err(GradeError::SandboxError)?;
    // Unheeded, a signal would leave copies of submissions behind.
    heed(|| {
        eprintln!("interrupted; sheets of what was graded are where they were to be written");
        remove_private_folders();
        std::process::exit(130);
    });
    let tier = sandbox.tier();
    eprintln!("sandbox: tier {tier} ({})", tier.words());
    for refused in sandbox.refused() {
        eprintln!("  not tier {}: {}", refused.tier, refused.why);
    }
    Ok(sandbox)
}
