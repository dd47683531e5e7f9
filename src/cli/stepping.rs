//! A run on its way: steps, files that are due, the guard, the wall clock.

use super::Failure;
use super::watch::Watch;
use crate::analysis::guard::Guard;
use crate::output::failure::FailureReport;
use crate::output::recorder::Recorder;
use crate::scenario::Scenario;
use crate::simulation::Simulation;

/// Everything that a run needs while it is under way.
pub(super) struct Stepping<'a> {
    scenario: &'a Scenario,
    pub simulation: Simulation,
    pub watch: Watch,
    /// What went wrong, if something did.
    pub failure: Option<FailureReport>,
    recorder: Recorder,
    guard: Guard,
}

impl<'a> Stepping<'a> {
    /// A run of `scenario` about to begin, with its files created.
    pub fn begin(scenario: &'a Scenario, simulation: Simulation, recorder: Recorder) -> Self {
        let output = &scenario.output;
        let watch = Watch::start(&simulation, scenario.steps(), output.slowdown, output.quiet);
        let side = scenario.walls.then_some(scenario.side);
        let guard = Guard::new(&simulation, side, scenario.is_soft());
        Self { scenario, simulation, watch, failure: None, recorder, guard }
    }

    /// Steps to the end, or until `stop` says so or something goes wrong; every file then has the
    /// last good state.
    pub fn go(&mut self, stop: impl Fn() -> bool + Copy) -> Result<(), Failure> {
        let end = self.scenario.steps();
        while self.simulation.steps() < end && !stop() {
            let due = self.recorder.next_due().min(end);
            self.step_until(self.watch.next_look(&self.simulation).min(due))?;
            if self.is_stopped() {
                break;
            }
            self.recorder.record_due(&self.simulation)?;
            if self.scenario.output.every.is_none() {
                self.watch.refresh_if_due(|| self.recorder.refresh_live(&self.simulation))?;
            }
            self.watch.keep_pace(&self.simulation, stop);
        }
        self.recorder.finish(&self.simulation)?;
        self.watch.finish();
        Ok(())
    }

    /// Leaves `results` beside the scenario in the output folder.
    pub fn record_results(&self, results: &[String]) -> Result<(), Failure> {
        Ok(self.recorder.record_results(results)?)
    }

    /// Steps up to `until` while the guard looks on.
    fn step_until(&mut self, until: u64) -> Result<(), Failure> {
        let end = self.scenario.steps();
        while self.simulation.steps() < until && !self.is_stopped() {
            let look = self.guard.next_look(&self.simulation).min(end);
            self.watch.step_until(&mut self.simulation, look.min(until));
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
    fn look(&mut self) -> Result<(), Failure> {
        if self.failure.is_some() {
            return Ok(()); // once is enough
        }
        let seen_at = self.simulation.steps();
        let found = match seen_at == self.scenario.steps() {
            true => self.guard.look_last(&mut self.simulation),
            false => self.guard.look(&mut self.simulation),
        };
        let Some(trouble) = found else { return Ok(()) };
        let goes_on = self.scenario.allow_unstable;
        let report = self.scenario.post_mortem(&trouble, !goes_on);
        report.write(&self.scenario.output.folder)?;
        self.failure = Some(report);
        match goes_on {
            true => self.watch.step_until(&mut self.simulation, seen_at),
            // What was written since then is of no use.
            false => self.recorder.cut_back_to(self.simulation.steps())?,
        }
        Ok(())
    }
}
