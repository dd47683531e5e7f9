//! A run on its way: steps, files that are due, the guard, checkpoints, the wall clock, and who looks on.
//!
//! It knows no command line and no terminal: whoever runs a session is told through an [`Onlooker`] how far it is, and
//! stops it there.

pub mod checkpoints;
pub mod courses;
pub mod pace;

use std::time::Instant;

use self::checkpoints::{Checkpoints, Origin};
use self::pace::Pace;
use crate::analysis::guard::{EVERY, Guard, Memory};
use crate::output::OutputError;
use crate::output::failure::FailureReport;
use crate::output::recorder::Recorder;
use crate::scenario::Scenario;
use crate::simulation::Simulation;

/// Who looks on while a session runs: a terminal, a page, nobody.
pub trait Onlooker {
    /// Whether the run is to stop here; asked some hundred times a second.
    fn stops(&self) -> bool {
        false
    }

    /// Sees the present state, as often.
    fn see(&mut self, _simulation: &Simulation) {}

    /// Hears of something that goes wrong and does not end the run.
    fn hear(&mut self, _warning: &str) {}
}

/// Nobody: the run goes to its end.
impl Onlooker for () {}

/// A run under way, and what became of it.
pub struct Session<'a> {
    /// Its scenario.
    pub scenario: &'a Scenario,
    /// What it was begun with.
    pub origin: Origin,
    simulation: Simulation,
    /// Steps at the end of the run.
    end: u64,
    /// Its wall clock.
    pub pace: Pace,
    /// What went wrong, if something did.
    pub failure: Option<FailureReport>,
    /// Its checkpoints.
    pub checkpoints: Checkpoints,
    /// Its files, if it leaves any.
    recorder: Option<Recorder>,
    guard: Guard,
}

impl<'a> Session<'a> {
    /// A run of `scenario` that leaves no files, from the present state of `simulation` on.
    pub fn without_files(scenario: &'a Scenario, simulation: Simulation) -> Self {
        Self::new(scenario, simulation, None, Origin::default(), None)
    }

    /// A run of `scenario` about to begin, with its files created; or about to go on from a checkpoint, with its `past`:
    /// what its guard remembers, and the step of the latest checkpoint in its folder, if that is one of this run.
    pub fn new(
        scenario: &'a Scenario,
        simulation: Simulation,
        recorder: Option<Recorder>,
        origin: Origin,
        past: Option<(Memory, Option<u64>)>,
    ) -> Self {
        let (side, watched) = (scenario.walled_side(), scenario.watched());
        let (guard, last) = match past {
            Some((memory, last)) => (Guard::continued(&simulation, side, watched, memory), last),
            None => (Guard::new(&simulation, side, watched), None),
        };
        let pace = Pace::start(&simulation, scenario.output.slowdown, scenario.threads());
        let checkpoints = Checkpoints::new(scenario, last);
        let (end, failure) = (scenario.steps(), None);
        Self { scenario, origin, simulation, end, pace, failure, checkpoints, recorder, guard }
    }

    /// The simulation as it is now.
    pub fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// Mechanical energy at the start of the run, J.
    pub fn energy_at_start(&self) -> f64 {
        self.guard.memory().start.total()
    }

    /// Keeps the end that was just given, before the first step to it: a run that is killed goes on to that end.
    pub fn keep_end(&mut self, onlooker: &mut dyn Onlooker) {
        if !self.is_done() && self.is_good() {
            let kept = self.keep();
            self.complain(kept, onlooker);
        }
    }

    /// Steps to the end, or until the `onlooker` stops it or something goes wrong; every file then has the
    /// last good state, and there is a checkpoint if the run is to go on later.
    ///
    /// # Errors
    ///
    /// [`OutputError::Write`] of a file that could not be written.
    pub fn run(&mut self, onlooker: &mut dyn Onlooker) -> Result<(), OutputError> {
        // Its checkpoint, if there is one, is all there is to prolong it from.
        let had_something_to_do = !self.is_done();
        while !self.is_done() && !onlooker.stops() {
            let due = self.recorder.as_ref().map_or(self.end, Recorder::next_due).min(self.end);
            self.advance(self.pace.next_look(&self.simulation).min(due))?;
            if self.is_stopped() {
                break;
            }
            if let (None, Some(recorder)) = (self.scenario.output.every, &mut self.recorder) {
                self.pace.refresh_if_due(|| recorder.refresh_live(&self.simulation))?;
            }
            if self.checkpoints.is_due() && self.is_good() {
                let kept = self.keep();
                self.complain(kept, onlooker);
            }
            onlooker.see(&self.simulation);
            self.pace.keep(&self.simulation, || onlooker.stops());
        }
        // Before the files get their last state, which belongs to this end only.
        let kept = self.keep_last();
        let Some(recorder) = &mut self.recorder else { return kept };
        recorder.finish(&self.simulation)?;
        if had_something_to_do && self.is_done() && !self.checkpoints.is_asked() {
            self.checkpoints.remove_all()?;
        }
        kept
    }

    /// Whether the run has reached its end.
    pub fn is_done(&self) -> bool {
        self.simulation.steps() >= self.end
    }

    /// Steps up to `until` at most, and writes what is due there.
    fn advance(&mut self, until: u64) -> Result<(), OutputError> {
        let begun = Instant::now();
        self.step_until(until)?;
        if let (false, Some(recorder)) = (self.is_stopped(), &mut self.recorder) {
            recorder.record_due(&self.simulation)?;
        }
        self.pace.book_stepping(begun);
        Ok(())
    }

    /// Whether the present state may be kept: nothing has gone wrong, not even for a moment.
    fn is_good(&self) -> bool {
        self.failure.is_none() && self.guard.finds_good(&self.simulation)
    }

    /// The checkpoint of an interrupted run, or of one that is done and shall be prolonged. Where the present
    /// state is not a good one, a few more steps may lead to one.
    fn keep_last(&mut self) -> Result<(), OutputError> {
        let is_over = self.is_done() && !self.checkpoints.is_asked();
        if self.failure.is_some() || is_over || self.recorder.is_none() {
            return Ok(());
        }
        let latest = self.simulation.steps() + 2 * EVERY;
        while !self.is_good() && !self.is_done() && self.simulation.steps() < latest {
            self.advance(self.simulation.steps() + 1)?;
            if self.failure.is_some() {
                return Ok(());
            }
        }
        if self.is_good() { self.keep() } else { Ok(()) }
    }

    fn keep(&mut self) -> Result<(), OutputError> {
        let Self { scenario, simulation, origin, checkpoints, recorder, guard, .. } = self;
        let Some(recorder) = recorder else { return Ok(()) };
        checkpoints.keep(scenario, origin, simulation, guard, recorder)
    }

    /// A checkpoint that fails on the way is no reason to lose the run.
    fn complain(&mut self, kept: Result<(), OutputError>, onlooker: &mut dyn Onlooker) {
        if let Some(said) = kept.err().and_then(|why| self.checkpoints.complaint(&why)) {
            onlooker.hear(&said);
        }
    }

    /// Leaves `results` beside the scenario in the output folder.
    pub fn record_results(&self, results: &[String]) -> Result<(), OutputError> {
        self.recorder.as_ref().map_or(Ok(()), |recorder| recorder.record_results(results))
    }

    /// Steps up to `until` while the guard looks on.
    fn step_until(&mut self, until: u64) -> Result<(), OutputError> {
        while self.simulation.steps() < until && !self.is_stopped() {
            let look = self.guard.next_look(&self.simulation).min(self.end);
            self.simulation.step_until(look.min(until));
            if self.simulation.steps() == look {
                self.look()?;
            }
        }
        Ok(())
    }

    /// Whether something went wrong and the run was ended by it.
    pub fn is_stopped(&self) -> bool {
        self.failure.as_ref().is_some_and(|failure| failure.stopped)
    }

    /// Lets the guard look. What it finds is written at once; if the run is to go on all the same,
    /// it comes back to where it was.
    fn look(&mut self) -> Result<(), OutputError> {
        if self.failure.is_some() {
            return Ok(()); // once is enough
        }
        let seen_at = self.simulation.steps();
        let found = match seen_at == self.end {
            true => self.guard.look_last(&mut self.simulation),
            false => self.guard.look(&mut self.simulation),
        };
        let Some(trouble) = found else { return Ok(()) };
        let goes_on = self.scenario.allow_unstable;
        let report = self.scenario.post_mortem(&trouble, !goes_on);
        if let Some(recorder) = &mut self.recorder {
            report.write(&self.scenario.output.folder)?;
            if !goes_on {
                recorder.cut_back_to(self.simulation.steps())?; // what was written since is of no use
            }
        }
        self.failure = Some(report);
        if goes_on {
            self.simulation.step_until(seen_at);
        }
        Ok(())
    }
}
