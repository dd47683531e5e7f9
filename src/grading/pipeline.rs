//! A submission graded: built and run in the sandbox, judged by physics, and made into a sheet.
//!
//! Reading order: this file (one submission from folder to sheet), [`program`] (what the rubric says of
//! building and running), `runs` (what a run's end means), `quality` (warnings, sanitizer), `flags` (the submission's own, for
//! these), `interface` (unit tests).

mod flags;
mod grader;
mod interface;
pub mod program;
mod quality;
mod runs;

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use self::flags::Flags;
pub use self::grader::Grader;
use self::interface::interface;
use self::quality::{sanitizer, warnings};
use self::runs::{Ended, ended, footage, newly_written, prints_frames};
use crate::grading::feedback::Graded;
use crate::grading::judge::check::Check;
use crate::grading::judge::film::Film;
use crate::grading::judge::mistake::Mistake;
use crate::grading::judge::rubric::Rubric;
use crate::grading::judge::rubric::program::Program;
use crate::grading::judge::verdict::{Failure, Report, Status};
use crate::grading::judge::words::Note;
use crate::grading::judge::{add_film, add_many};
use crate::grading::sandbox::{Limits, Outcome, Run, SandboxError, Workspace};

impl Grader<'_> {
    /// Marks the submission in `folder`, and tells `seen` of the sheet so far whenever a check has ended.
    ///
    /// Fails if the machine does; what the submission does wrong is on the sheet.
    pub fn grade(&self, folder: &Path, seen: impl Fn(&Graded)) -> Result<Graded, SandboxError> {
        let started = Instant::now();
        // `.` has a name as well.
        let whole = fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned());
        let name = folder.file_name().or(whole.file_name()).unwrap_or_default().to_string_lossy();
        let report = Report::of_submission(&self.course.rubric);
        let mut graded = Graded::new(&name, &folder.display().to_string(), report);
        let tier = self.sandbox.tier();
        graded.tier = format!("tier {tier}: {}", tier.words());
        graded.is_partial = true;
        self.go_through(&self.inner(folder), &mut graded, &seen)?;
        graded.report.skip_the_rest();
        graded.report.in_order();
        graded.is_partial = false;
        graded.seconds = started.elapsed().as_secs_f64();
        Ok(graded)
    }

    /// Where the files are: in the folder, or in the only folder in it, or in the only one in that, as some
    /// programs unpack.
    fn inner(&self, folder: &Path) -> PathBuf {
        const DEEPEST: usize = 5;
        let has_some = |folder: &PathBuf| {
            self.course.program().files.iter().any(|file| folder.join(file).is_file())
        };
        let inner = std::iter::successors(Some(folder.to_owned()), only_folder_in);
        inner.take(DEEPEST).find(has_some).unwrap_or_else(|| folder.to_owned())
    }

    fn go_through(
        &self,
        folder: &Path,
        graded: &mut Graded,
        seen: &impl Fn(&Graded),
    ) -> Result<(), SandboxError> {
        let workspace = self.prepare(folder, &self.course.build)?;
        if let Some(build) = &workspace.build {
            graded.log.clone_from(&build.log);
        }
        graded.report.decide(Check::Files, || files(&workspace));
        graded.report.decide(Check::Builds, || self.builds(&workspace));
        if !graded.report.passed(Check::Builds) {
            return Ok(());
        }
        seen(graded);
        let is_old = self.is_handed_in(folder, &workspace);
        graded.report.notes.extend(is_old.then_some(Note::ProgramNotRebuilt));
        let run = self.film_of(&workspace, is_old, graded)?;
        seen(graded);
        if graded.report.passed(Check::Runs) {
            self.judge_motion(&run, graded);
            // Frames that hold too little, or too few discs, may want what was asked for.
            let is_poor = [Check::Frames, Check::Discs].map(|check| graded.report.failed(check));
            let is_poor = run.asked_for_more && is_poor.contains(&true);
            graded.report.notes.extend(is_poor.then_some(Note::AsksForInput));
            seen(graded);
            self.many(&workspace, graded)?;
            seen(graded);
        }
        let verdict = interface(self, folder)?;
        graded.report.decide(Check::Interface, || verdict);
        let flags = Flags::of(&workspace, &self.course.build, &self.course.limits())?;
        let verdict = warnings(self, folder, &workspace, &flags)?;
        graded.report.decide(Check::Warnings, || verdict);
        if graded.report.passed(Check::Runs) {
            let verdict = sanitizer(self, folder, &flags)?;
            graded.report.decide(Check::Sanitizer, || verdict);
        }
        Ok(())
    }

    fn builds(&self, workspace: &Workspace) -> Status {
        let program = self.course.program();
        let Some(build) = &workspace.build else { return self.is_there(workspace, "") };
        let failure = match build.outcome {
            Outcome::Ended(0) => return self.is_there(workspace, &build.log),
            Outcome::TimeUp | Outcome::CpuUp => {
                Failure::build_too_slow(program.build_seconds, &build.log)
            }
            _ => Failure::does_not_build(&build.log),
        };
        Status::Failed(failure)
    }

    /// Whether the program that is to be run has been workspace.
    fn is_there(&self, workspace: &Workspace, log: &str) -> Status {
        let program = self.course.run.first().map_or("", String::as_str);
        match program.strip_prefix("./") {
            Some(file) if !workspace.folder().join(file).is_file() => {
                let words = crate::grading::judge::words::ENGLISH.no_program;
                Status::Failed(Failure::does_not_build(&format!("{log}{words} {program}")))
            }
            _ => Status::Passed,
        }
    }

    /// Whether the program to be run is the one that was handed in: the build did not make it anew.
    fn is_handed_in(&self, folder: &Path, workspace: &Workspace) -> bool {
        let program = self.course.run.first().and_then(|program| program.strip_prefix("./"));
        let Some(program) = program.filter(|_| !self.course.build.is_empty()) else { return false };
        // A copy keeps the time.
        let age = |folder: &Path| {
            let found = fs::symlink_metadata(folder.join(program)).ok()?;
            Some((found.is_file(), found.len(), found.modified().ok()?))
        };
        age(folder).is_some_and(|age_of_old| age(&workspace.folder()) == Some(age_of_old))
    }

    /// Runs it as the rubric says, and decides `runs`. `is_old`: it was handed in.
    fn film_of(
        &self,
        workspace: &Workspace,
        is_old: bool,
        graded: &mut Graded,
    ) -> Result<Run, SandboxError> {
        let program = self.course.program();
        let before = newly_written(&workspace.folder(), &[]);
        let invocation = self.course.invocation(program.n, program.frames);
        let run = workspace.run(&invocation, &self.course.limits())?;
        let others = newly_written(&workspace.folder(), &before);
        graded.log.push_str(&run.log);
        let rubric = self.told(program.n, program.frames_at_least);
        graded.report.decide(Check::Runs, || {
            match ended(&run, &workspace.folder(), &others, &rubric) {
                Ended::Well => Status::Passed,
                Ended::Badly(failure) if is_old => Status::Failed(failure.of_a_program_handed_in()),
                Ended::Badly(failure) => Status::Failed(failure),
            }
        });
        Ok(run)
    }

    /// The rubric for a run that is told to take `n` discs, of which so many frames are enough.
    fn told(&self, n: usize, frames_at_least: usize) -> Rubric {
        let rubric = &self.course.rubric;
        let program = Program { frames_at_least, ..rubric.program.clone() };
        let n = if program.tells_n() { vec![n] } else { rubric.n.clone() };
        Rubric { n, program, ..rubric.clone() }
    }

    /// The checks of frames.
    fn judge_motion(&self, run: &Run, graded: &mut Graded) {
        let film: Option<Film> =
            add_film(&mut graded.report, footage(&run.captured), &self.course.rubric);
        graded.report.torn += run.torn;
        if run.captured.is_blank() && prints_frames(&run.log) {
            graded.report.blame(Check::Frames, Mistake::PrintedOnTheScreen);
        }
        *graded = graded.clone().with_pictures(film.as_ref());
    }

    /// A box of many, if the program can be told how many.
    fn many(&self, workspace: &Workspace, graded: &mut Graded) -> Result<(), SandboxError> {
        let program = self.course.program();
        let is_asked = program.many > 0 && program.tells_n();
        // What is wrong with a few is wrong with many: one mistake, one check.
        let wrong =
            graded.report.failures().map(|(check, _)| check).find(|check| check.is_of_frames());
        if let Some(root) = wrong {
            graded.report.push(Check::Many, Status::Skipped(root));
            return Ok(());
        }
        if graded.report.is_masked() {
            graded.report.push(Check::Many, Status::Masked);
            return Ok(());
        }
        if !is_asked || !graded.report.is_asked_for(Check::Many) {
            graded.report.decide(Check::Many, || Status::NotSeen);
            return Ok(());
        }
        let wall = Duration::from_secs_f64(program.many_seconds);
        let limits = Limits { run_wall: wall, ..self.course.limits() };
        let invocation = self.course.invocation(program.many, program.many_frames);
        let run = workspace.run(&invocation, &limits)?;
        match ended(&run, &workspace.folder(), &[], &self.told(program.many, 2)) {
            Ended::Badly(failure) => graded.report.decide(Check::Many, || Status::Failed(failure)),
            Ended::Well => {
                let footage = footage(&run.captured);
                add_many(&mut graded.report, footage, program.many, &self.course.rubric);
            }
        }
        Ok(())
    }
}

/// The folder in `folder`, if there is just one besides hidden ones and a Mac's own.
fn only_folder_in(folder: &PathBuf) -> Option<PathBuf> {
    let is_real = |entry: &fs::DirEntry| {
        let name = entry.file_name();
        let is_hidden = name.to_string_lossy().starts_with('.') || name == "__MACOSX";
        !is_hidden && entry.file_type().is_ok_and(|kind| kind.is_dir())
    };
    let mut folders = fs::read_dir(folder).into_iter().flatten().flatten().filter(is_real);
    let only = folders.next()?.path();
    folders.next().is_none().then_some(only)
}

/// Whether all that is asked for was handed in.
fn files(workspace: &Workspace) -> Status {
    // make takes these as well.
    let is_there = |name: &str| workspace.folder().join(name).is_file();
    let has_makefile = ["makefile", "GNUmakefile"].into_iter().any(is_there);
    let is_missing = |file: &&PathBuf| !(has_makefile && file.as_path() == Path::new("Makefile"));
    let missing = workspace.missing.iter().filter(is_missing);
    let missing: Vec<_> = missing.map(|file| file.to_string_lossy()).collect();
    let missing: Vec<&str> = missing.iter().map(AsRef::as_ref).collect();
    let packed = archives(&workspace.folder());
    let packed: Vec<&str> = packed.iter().map(String::as_str).collect();
    match missing[..] {
        [] => Status::Passed,
        _ => Status::Failed(Failure::files_missing(&missing, &packed)),
    }
}

/// Names of the archives in a folder.
fn archives(folder: &Path) -> Vec<String> {
    const ENDINGS: [&str; 9] = ["zip", "tar", "gz", "tgz", "bz2", "xz", "zst", "7z", "rar"];
    let is_archive = |name: &String| {
        let ending = Path::new(name).extension().and_then(|ending| ending.to_str());
        ending.is_some_and(|ending| ENDINGS.contains(&ending.to_lowercase().as_str()))
    };
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let files = entries.filter(|entry| entry.file_type().is_ok_and(|kind| kind.is_file()));
    let names = files.map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut archives: Vec<String> = names.filter(is_archive).collect();
    archives.sort();
    archives
}
