//! What a compiler and a sanitizer say of a submission that is right otherwise.

use std::fs;
use std::path::Path;

use super::flags::Flags;
use super::grader::Grader;
use crate::grading::judge::verdict::{Failure, Status};
use crate::grading::sandbox::{Build, Limits, SandboxError, Workspace};

/// Frames of a run with sanitizers, which is slow.
const FRAMES: usize = 40;

/// What is kept of a log for a student, lines.
const LINES: usize = 12;

/// Whether the compiler warns; `workspace` is the usual build, `flags` are its own.
pub(super) fn warnings(
    grader: &Grader,
    folder: &Path,
    workspace: &Workspace,
    flags: &Flags,
) -> Result<Status, SandboxError> {
    let mut built = workspace.build.clone().filter(|_| grader.course.warnings.is_empty());
    for command in &grader.course.warnings {
        let again = grader.prepare(folder, &flags.added_to(&with_sources(command, folder)))?.build;
        // A Makefile may know better than to listen; then its log does not have the word.
        built = again.filter(|build| build.outcome.is_success() && is_told(build, command));
        if built.is_some() {
            break;
        }
    }
    // A build that cannot be told to warn, or fails then, says nothing.
    let Some(Build { log, .. }) = built else { return Ok(Status::NotSeen) };
    let is_warning = |line: &&str| line.contains("warning:");
    Ok(match excerpt(&log, is_warning) {
        None => Status::Passed,
        Some(said) => Status::Failed(Failure::warned(&said)),
    })
}

/// Whether a compiler was told to warn: directly, or by a make that shows what it does.
fn is_told(build: &Build, command: &[String]) -> bool {
    command.first().is_some_and(|program| program != "make") || build.log.contains("-Wextra")
}

/// `command` with the sources of the submission in `folder`.
fn with_sources(command: &[String], folder: &Path) -> Vec<String> {
    let is_source = |name: &String| {
        let ending = Path::new(name).extension().and_then(|ending| ending.to_str());
        matches!(ending, Some("c" | "cc" | "cpp" | "cxx"))
    };
    let entries = fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok);
    let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
    // Not to be taken for flags.
    let mut sources: Vec<_> = names.filter(is_source).map(|name| format!("./{name}")).collect();
    sources.sort();
    let word = |word: &String| match word.as_str() {
        "{sources}" => sources.clone(),
        _ => vec![word.clone()],
    };
    command.iter().flat_map(word).collect()
}

/// Whether a run with sanitizers finds something.
pub(super) fn sanitizer(
    grader: &Grader,
    folder: &Path,
    flags: &Flags,
) -> Result<Status, SandboxError> {
    for command in &grader.course.sanitizer {
        let workspace = grader.prepare(folder, &flags.added_to(&with_sources(command, folder)))?;
        let is_built = workspace.build.as_ref().is_some_and(|build| build.outcome.is_success());
        if is_built && has_sanitizer(&workspace, grader.course.run.first()) {
            return run_with_sanitizer(grader, &workspace);
        }
    }
    Ok(Status::NotSeen)
}

fn run_with_sanitizer(grader: &Grader, workspace: &Workspace) -> Result<Status, SandboxError> {
    let course = grader.course;
    let mut invocation = course.invocation(course.program().n, FRAMES);
    // Leaks cannot be looked for in a program that is being watched.
    let before = ["env", "ASAN_OPTIONS=detect_leaks=0"].map(str::to_owned);
    invocation.command.splice(0..0, before);
    let run = workspace.run(&invocation, &Limits { address_space: None, ..course.limits() })?;
    let is_report =
        |line: &&str| line.contains("ERROR: AddressSanitizer") || line.contains("runtime error:");
    Ok(match excerpt(&run.log, is_report) {
        None => Status::Passed,
        Some(said) => Status::Failed(Failure::misused(&said)),
    })
}

/// Whether the program was really built with a sanitizer: a Makefile may know better.
fn has_sanitizer(workspace: &Workspace, run: Option<&String>) -> bool {
    let file = run.and_then(|run| run.strip_prefix("./")).map(|file| workspace.folder().join(file));
    let file = file.filter(|file| file.is_file()); // no pipe that was built to be waited for
    let bytes = file.and_then(|file| fs::read(file).ok()).unwrap_or_default();
    bytes.windows(6).any(|word| word == b"__asan")
}

/// Some lines from the first that is `wanted` on.
fn excerpt(log: &str, wanted: impl Fn(&&str) -> bool) -> Option<String> {
    let from = log.lines().position(|line| wanted(&line))?;
    Some(log.lines().skip(from).take(LINES).collect::<Vec<_>>().join("\n"))
}
