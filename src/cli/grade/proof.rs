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
use super::sheets::Sheets;
use super::{exit_code, submissions};
use crate::cli::Failure;
use crate::grade::check::Check;
use crate::grade::rubric::program::Program;
use crate::grade::rubric::{Law, Rubric};
use crate::marking::Marker;
use crate::marking::program::Course;
use crate::proof::described::Described;
use crate::proof::laid_out::lay_out;
use crate::proof::outcome::{Outcome, matrix};
use crate::proof::{ProofError, folders_at};
use crate::sheet::Graded;
use crate::workshop::Workshop;

pub(super) fn run(arguments: &GradeArguments) -> Result<ExitCode, Failure> {
    let mut folders = Vec::new();
    for path in &arguments.submissions {
        folders.extend(folders_at(path).map_err(GradeError::Proof)?);
    }
    let read = |folder: &PathBuf| Described::read(folder);
    let described: Vec<Described> =
        folders.iter().map(read).collect::<Result<_, _>>().map_err(GradeError::Proof)?;
    let workshop = submissions::open(arguments)?;
    let place = Place::new().map_err(GradeError::Proof)?;
    let names: Vec<String> = folders.iter().map(|path| path.display().to_string()).collect();
    let sheets = Sheets::open(&arguments.sheets, &names)?;
    let outcomes: Mutex<BTreeMap<usize, Outcome>> = Mutex::default();
    let seed = arguments.seed.unwrap_or(Program::default().seed);
    let entries = grade_all(
        folders,
        arguments.jobs(),
        |k, _| {
            let graded = grade_one(&described[k], k, &place.0, &workshop, seed)?;
            let outcome = Outcome::of(&described[k], &graded.report);
            outcomes.lock().map_err(|why| why.to_string())?.insert(k, outcome);
            Ok(graded)
        },
        |k, entry| sheets.add(k, entry),
    );
    sheets.finish(&entries, true)?;
    let outcomes: Vec<Outcome> = outcomes.into_inner().unwrap_or_default().into_values().collect();
    let is_as_expected = write_outcomes(&mut io::stdout().lock(), &outcomes)?;
    let code = exit_code(&entries, arguments.fail_under);
    Ok(ExitCode::from(code.max(u8::from(!is_as_expected))))
}

/// Writes what is not as expected, and the matrix; says whether all is.
fn write_outcomes(out: &mut impl Write, outcomes: &[Outcome]) -> io::Result<bool> {
    let mut is_as_expected = true;
    for outcome in outcomes {
        for surprise in outcome.surprises() {
            is_as_expected = false;
            writeln!(out, "not as expected: {}/{}: {surprise}", outcome.group, outcome.name)?;
        }
    }
    writeln!(out, "\n{}", matrix(outcomes))?;
    Ok(is_as_expected)
}

fn grade_one(
    described: &Described,
    k: usize,
    place: &Path,
    workshop: &Workshop,
    seed: u64,
) -> Result<Graded, String> {
    let said = |why: ProofError| why.to_string();
    let folder = lay_out(described, &place.join(k.to_string())).map_err(said)?;
    let mut rubric = rubric_of(described);
    rubric.program.seed = seed;
    let course = Course::of(rubric)?;
    let marker = Marker { workshop, course: &course };
    let mut graded = marker.mark(&folder, |_| ()).map_err(|why| why.to_string())?;
    graded.name = format!("{}/{}", group(&described.path), described.name());
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
    let expected = described.expected.check.as_deref();
    let asks = |check: Check| expected == Some(check.id());
    let usual_program = Program::default();
    // Only make can be told to build otherwise.
    let otherwise = |commands: &[String], check| match described.build == "make" && asks(check) {
        true => commands.to_vec(),
        false => Vec::new(),
    };
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
            many: if asks(Check::Many) { usual_program.many } else { 0 },
            warnings: otherwise(&usual_program.warnings, Check::Warnings),
            sanitizer: otherwise(&usual_program.sanitizer, Check::Sanitizer),
            ..usual_program
        },
        ..usual
    }
}

/// A folder for the time of the proof.
struct Place(PathBuf);

impl Place {
    fn new() -> Result<Self, ProofError> {
        let path = std::env::temp_dir().join(format!("parsim2d-proof-{}", std::process::id()));
        match fs::create_dir_all(&path) {
            Ok(()) => Ok(Self(path)),
            Err(source) => Err(ProofError::File { path, source }),
        }
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0); // gone or not, it was temporary
    }
}
