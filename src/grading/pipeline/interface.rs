//! Unit tests of a student's header: the instructor's probe, built beside it and asked case by case.

use std::path::Path;

use super::grader::Grader;
use crate::grading::judge::interface::verdict;
use crate::grading::judge::verdict::{Failure, Status};
use crate::grading::sandbox::{Invocation, Outcome, SandboxError};

/// Whether the functions that were declared give the right numbers; not seen if the rubric has no probe.
///
/// What is expected is compared here: it is never where the submission runs.
pub(super) fn interface(grader: &Grader, folder: &Path) -> Result<Status, SandboxError> {
    let Some(interface) = &grader.course.rubric.interface else { return Ok(Status::NotSeen) };
    let limits = grader.course.limits();
    let workspace = grader.prepare(folder, &[])?;
    workspace.add(interface.file_name(), &interface.source)?;
    let build = workspace.build_by(&interface.build, &limits)?;
    if build.outcome == Outcome::NotStarted {
        // The rubric's command, or the machine's compiler: no fault of the student's.
        let what = format!("start {:?}, which builds the probe", interface.build.join(" "));
        return Err(SandboxError::Broken { what, error: std::io::ErrorKind::NotFound.into() });
    }
    if !build.outcome.is_success() {
        return Ok(Status::Failed(Failure::interface_missing(&build.log)));
    }
    for case in &interface.case {
        let stdin = case.stdin.clone().into_bytes();
        let invocation =
            Invocation { command: interface.run.clone(), stdin, ..Invocation::default() };
        let run = workspace.run(&invocation, &limits)?;
        let status = match run.outcome {
            Outcome::Ended(0) => verdict(case, &run.log),
            _ => Status::Failed(Failure::probe_ends_badly(case, &run.log)),
        };
        if status != Status::Passed {
            return Ok(status);
        }
    }
    Ok(Status::Passed)
}
