//! What goes wrong before there is a frame to look at: failures of handing in, building, running.
//!
//! Who builds and runs (the sandbox) finds them; here they get their causes, words and numbers.

use super::check::Check;
use super::mistake::Mistake;
use super::verdict::{Failure, Report, Status};
use super::words::{ENGLISH, Finding, Quantity};

impl Failure {
    /// Files that were not handed in, where these archives were.
    ///
    /// ```
    /// use parsim2d::grading::judge::{mistake::Mistake, verdict::Failure};
    /// assert_eq!(Failure::files_missing(&["Makefile"], &[]).cause, Some(Mistake::NoMakefile));
    /// assert_eq!(Failure::files_missing(&["particle.h"], &[]).cause, None);
    /// let packed = Failure::files_missing(&["Makefile", "particle.h"], &["Ada.zip"]);
    /// assert_eq!(packed.cause, Some(Mistake::ArchiveNotUnpacked));
    /// assert_eq!(packed.said.as_deref(), Some("missing: Makefile, particle.h\nstill packed: Ada.zip"));
    /// ```
    pub fn files_missing(names: &[&str], archives: &[&str]) -> Self {
        let cause = match archives {
            [] => names.contains(&"Makefile").then_some(Mistake::NoMakefile),
            _ => Some(Mistake::ArchiveNotUnpacked),
        };
        let [missing, packed] = ENGLISH.missing;
        let mut said = format!("{missing}: {}", names.join(", "));
        if !archives.is_empty() {
            said += &format!("\n{packed}: {}", archives.join(", "));
        }
        Self::of(Finding::FileMissing, cause).saying(&said)
    }

    /// The same failure of a program that was handed in and that the build did not make anew: what is in the
    /// sources was not run.
    #[must_use]
    pub fn of_a_program_handed_in(mut self) -> Self {
        self.cause = Some(Mistake::ProgramNotRebuilt);
        self
    }

    /// A program that asks for more on its standard input than there is, and wrote too little.
    pub fn waits_for_input(seconds: f64, log: &str) -> Self {
        let failure = Self::of(Finding::AsksForInput, Mistake::WaitsForInput).saying(log);
        failure.with(Quantity::Seconds, seconds)
    }

    /// A build that failed; `log` is what it printed.
    pub fn does_not_build(log: &str) -> Self {
        Self::of(Finding::BuildFails, Mistake::DoesNotBuild).saying(log)
    }

    /// A build that did not end in its time.
    pub fn build_too_slow(seconds: f64, log: &str) -> Self {
        let failure = Self::of(Finding::BuildTakesTooLong, Mistake::TooSlow).saying(log);
        failure.with(Quantity::Seconds, seconds)
    }

    /// A program that ended with an exit code other than 0.
    pub fn ends_with_code(code: i32, log: &str) -> Self {
        // A plain code is what the program itself chose to return.
        let cause = (code >= 128).then_some(Mistake::Crashes);
        let failure = Self::of(Finding::Crashed, cause).saying(log);
        failure.with(Quantity::ExitCode, f64::from(code))
    }

    /// A program that was ended by a signal which nobody sent it.
    pub fn ends_by_signal(signal: i32, log: &str) -> Self {
        let failure = Self::of(Finding::Crashed, Mistake::Crashes).saying(log);
        failure.with(Quantity::Signal, f64::from(signal))
    }

    /// A program that ended well and wrote nothing.
    pub fn ends_without_frames(log: &str) -> Self {
        Self::of(Finding::EndedWithoutFrames, Mistake::EndsWithoutFrames).saying(log)
    }

    /// A film of fewer frames than the rubric wants: nothing can be seen to move.
    pub fn too_few_frames(frames: usize, wanted: usize) -> Self {
        let cause = (frames == 1).then_some(Mistake::OnlyTheLastFrame);
        let failure = Self::of(Finding::TooFewFrames, cause);
        failure.with(Quantity::Frames, frames as f64).with(Quantity::FramesWanted, wanted as f64)
    }

    /// A program that wrote too few frames in the time it had.
    pub fn too_slow(seconds: f64, log: &str) -> Self {
        let failure = Self::of(Finding::TakesTooLong, Mistake::TooSlow).saying(log);
        failure.with(Quantity::Seconds, seconds)
    }

    /// A program that wrote more than there is room for.
    pub fn output_too_large(bytes: u64) -> Self {
        let failure = Self::of(Finding::WritesTooMuch, Mistake::OutputTooLarge);
        failure.with(Quantity::Bytes, bytes as f64)
    }

    /// A program that was stopped by a limit on memory, processes or processor time.
    pub fn stopped_by_limits(log: &str) -> Self {
        Self::of(Finding::Stopped, Mistake::StoppedByLimits).saying(log)
    }

    /// What the compiler warns of.
    pub fn warned(log: &str) -> Self {
        Self::of(Finding::Warned, None).saying(log)
    }

    /// What a sanitizer reports.
    pub fn misused(log: &str) -> Self {
        Self::of(Finding::Misused, None).saying(log)
    }
}

impl Report {
    /// Gives a failed check another cause: what is known of the run tells more than the frames.
    pub fn blame(&mut self, check: Check, cause: Mistake) {
        let own = self.checks.iter_mut().filter(|(known, _)| *known == check);
        for (_, status) in own {
            if let Status::Failed(failure) = status {
                failure.cause = Some(cause);
            }
        }
    }
}
