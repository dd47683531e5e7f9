//! `grade --proof`: programs of which it is known what is wrong with them.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;

use super::all::grade_all;
use super::arguments::GradeArguments;
use super::error::GradeError;
use super::exit_code::exit_code;
use super::sheets::Sheets;
use super::submissions;
use crate::cli::failure::Failure;
use crate::grading::feedback::Graded;
use crate::grading::judge::rubric::program::Program;
use crate::grading::judge::rubric::{Law, Rubric};
use crate::grading::pipeline::Grader;
use crate::grading::pipeline::program::Course;
use crate::grading::sandbox::Sandbox;
use crate::grading::validation::comparison::{Comparison, matrix};
use crate::grading::validation::described::Described;
use crate::grading::validation::laid_out::lay_out;
use crate::grading::validation::{ValidationError, folders_at};

pub(super) fn run(arguments: &GradeArguments) -> Result<ExitCode, Failure> {
    let mut folders = Vec::new();
    for path in &arguments.submissions {
        let found = folders_at(path).map_err(GradeError::Proof)?;
        // A file beside the folders, as a README of theirs, is none of them.
        if found.is_empty() && !path.is_file() {
            return Err(GradeError::Undescribed { path: path.clone() }.into());
        }
        folders.extend(found);
    }
    if folders.is_empty() {
        return Err(GradeError::Undescribed { path: arguments.submissions[0].clone() }.into());
    }
    let read = |folder: &PathBuf| Described::read(folder);
    let described: Vec<Described> =
        folders.iter().map(read).collect::<Result<_, _>>().map_err(GradeError::Proof)?;
    let sandbox = submissions::open(arguments)?;
    let place = sandbox.private_folder().map_err(GradeError::SandboxError)?;
    let names: Vec<String> = folders.iter().map(|path| path.display().to_string()).collect();
    let sheets = Sheets::open(&arguments.sheets, &names, &arguments.inputs())?;
    let comparisons: Mutex<BTreeMap<usize, Comparison>> = Mutex::default();
    let seed = arguments.seed.unwrap_or(Program::default().seed);
    let entries = grade_all(
        folders,
        arguments.jobs(),
        |k, _| {
            let graded = grade_one(&described[k], k, &place.path(), &sandbox, seed)?;
            let comparison = Comparison::of(&described[k], &graded.report);
            comparisons.lock().map_err(|why| why.to_string())?.insert(k, comparison);
            Ok(graded)
        },
        |k, entry| sheets.add(k, entry),
    );
    sheets.finish(&entries, true)?;
    let comparisons: Vec<Comparison> =
        comparisons.into_inner().unwrap_or_default().into_values().collect();
    let is_as_expected = write_comparisons(&mut io::stdout().lock(), &comparisons)?;
    let code = exit_code(&entries, arguments.fail_under);
    Ok(ExitCode::from(code.max(u8::from(!is_as_expected))))
}

/// Writes what is not as expected, and the matrix; says whether all is.
fn write_comparisons(out: &mut impl Write, comparisons: &[Comparison]) -> io::Result<bool> {
    let mut is_as_expected = true;
    for comparison in comparisons {
        for surprise in comparison.surprises() {
            is_as_expected = false;
            writeln!(out, "not as expected: {}/{}: {surprise}", comparison.group, comparison.name)?;
        }
    }
    writeln!(out, "\n{}", matrix(comparisons))?;
    Ok(is_as_expected)
}

fn grade_one(
    described: &Described,
    k: usize,
    place: &Path,
    sandbox: &Sandbox,
    seed: u64,
) -> Result<Graded, String> {
    let said = |why: ValidationError| why.to_string();
    let own = place.join(k.to_string());
    fs::create_dir(&own).map_err(|why| format!("{}: {why}", own.display()))?;
    let folder = lay_out(described, &own).map_err(said)?;
    let mut rubric = rubric_of(described);
    rubric.program.seed = seed;
    let course = Course::of(rubric)?;
    let grader = Grader { sandbox, course: &course };
    let mut graded = grader.grade(&folder, |_| ()).map_err(|why| why.to_string())?;
    graded.name = format!("{}/{}", group(&described.path), described.name());
    // Where it was laid out means nothing afterwards.
    graded.folder = described.path.display().to_string();
    Ok(graded)
}

fn group(path: &Path) -> String {
    let above = path.parent().and_then(Path::file_name).unwrap_or_default();
    above.to_string_lossy().into_owned()
}

/// What the course of a described submission asks for.
fn rubric_of(described: &Described) -> Rubric {
    let physics = &described.physics;
    let usual = Rubric::default();
    let usual_program = Program::default();
    Rubric {
        n: vec![described.n],
        radius: physics.radius.map_or(usual.radius.clone(), |radius| vec![radius]),
        law: if physics.law.as_deref() == Some("hard") { Law::Hard } else { Law::Spring },
        eta: physics.eta.unwrap_or(usual.eta),
        restitution_wall: physics.restitution_wall,
        restitution_pair: physics.restitution_pair,
        program: Program {
            files: described.files.iter().map(|file| file.display().to_string()).collect(),
            build: described.build.clone(),
            run: described.run.clone(),
            arguments: described.arguments.clone(),
            n: described.n,
            frames: if described.frames == 0 { usual_program.frames } else { described.frames },
            extra_rows: described.extra_rows,
            ..usual_program
        },
        ..usual
    }
}
