//! Unit tests of a student's header: the instructor's probe, built beside it and asked case by case.

use std::path::Path;

use super::Marker;
use crate::grade::interface::verdict;
use crate::grade::verdict::{Failure, Status};
use crate::workshop::{Closed, Errand, Outcome};

/// Whether the functions that were declared give the right numbers; not seen if the rubric has no probe.
///
/// What is expected is compared here: it is never where the submission runs.
pub(super) fn interface(marker: &Marker, folder: &Path) -> Result<Status, Closed> {
    let Some(interface) = &marker.course.rubric.interface else { return Ok(Status::NotSeen) };
    let limits = marker.course.limits();
    let made = marker.make(folder, &[])?;
    made.add(interface.file_name(), &interface.source)?;
    let build = made.build_by(&interface.build, &limits)?;
    if build.outcome == Outcome::NotStarted {
        // The rubric's command, or the machine's compiler: no fault of the student's.
        let what = format!("start {:?}, which builds the probe", interface.build.join(" "));
        return Err(Closed::Broken { what, error: std::io::ErrorKind::NotFound.into() });
    }
    if !build.outcome.is_success() {
        return Ok(Status::Failed(Failure::interface_missing(&build.log)));
    }
    for case in &interface.case {
        let stdin = case.stdin.clone().into_bytes();
        let errand = Errand { command: interface.run.clone(), stdin, ..Errand::default() };
        let run = made.run(&errand, &limits)?;
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
