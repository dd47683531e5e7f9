//! The checkpoints of a run: when one is due, and what goes into it.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use crate::analysis::guard::{Guard, Memory};
use crate::output::OutputError;
use crate::output::checkpoint::{self, Progress};
use crate::output::recorder::Recorder;
use crate::scenario::Scenario;
use crate::simulation::Simulation;

/// What a run was begun with, as long as it goes on.
#[derive(Clone, Debug, Default)]
pub struct Origin {
    /// The command, word by word.
    pub command: Vec<String>,
    /// The largest overlap at the start over the (smaller) radius.
    pub overlap: f64,
    /// The record of the run, if it goes on from a checkpoint.
    pub resumed: Option<PathBuf>,
}

/// The checkpoints of one run.
pub struct Checkpoints {
    folder: PathBuf,
    every: Option<Duration>,
    last_at: Instant,
    /// The step of the latest checkpoint, if it is one of this run and whole.
    last: Option<u64>,
    has_complained: bool,
}

impl Checkpoints {
    /// For a run of `scenario`; `last` is the step of the latest checkpoint in its folder, if it is one of
    /// this run.
    pub fn new(scenario: &Scenario, last: Option<u64>) -> Self {
        Self {
            folder: scenario.output.folder.clone(),
            every: scenario.output.checkpoint_every.map(Duration::from_secs_f64),
            last_at: Instant::now(),
            last,
            has_complained: false,
        }
    }

    /// Whether checkpoints were asked for, the last at the end of the run.
    pub fn is_asked(&self) -> bool {
        self.every.is_some()
    }

    /// Whether it is time for one.
    pub fn is_due(&self) -> bool {
        self.every.is_some_and(|every| self.last_at.elapsed() >= every)
    }

    /// Writes a checkpoint of the present state, which must be a good one.
    pub fn keep(
        &mut self,
        scenario: &Scenario,
        origin: &Origin,
        simulation: &Simulation,
        guard: &Guard,
        recorder: &mut Recorder,
    ) -> Result<(), OutputError> {
        self.last_at = Instant::now(); // also if it fails: no sooner again
        let progress = progress(origin, simulation, guard.memory(), recorder)?;
        let text = scenario.to_toml();
        // Looked at where they are: a copy of all discs would be the largest thing in memory.
        let arrays = scenario.arrays().into_iter().chain(simulation.arrays());
        let sections = checkpoint::sections(&text, &progress, arrays);
        checkpoint::write(&self.folder, &sections, self.last.is_some())?;
        self.last_at = Instant::now();
        self.last = Some(simulation.steps());
        Ok(())
    }

    /// What to say of a checkpoint that could not be written while the run goes on; once is enough.
    pub fn complaint(&mut self, why: &OutputError) -> Option<String> {
        let is_first = !std::mem::replace(&mut self.has_complained, true);
        let last = match self.last {
            Some(step) => format!("the last checkpoint, of step {step}, is whole"),
            None => "there is no checkpoint yet".to_owned(),
        };
        is_first.then(|| format!("{why}\n  the run goes on; {last}"))
    }

    /// The latest checkpoint and its step, if there is one and nobody has taken it away.
    pub fn latest(&self) -> Option<(PathBuf, u64)> {
        let path = self.folder.join(checkpoint::FILE);
        self.last.filter(|_| path.is_file()).map(|step| (path, step))
    }

    /// Removes the checkpoints of a run that is done.
    pub fn remove_all(&mut self) -> Result<(), OutputError> {
        self.last = None;
        checkpoint::remove(&self.folder)
    }
}

fn progress(
    origin: &Origin,
    simulation: &Simulation,
    memory: Memory,
    recorder: &mut Recorder,
) -> Result<Progress, OutputError> {
    let Memory { start, movable, supplied, grown_at } = memory;
    Ok(Progress {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        step: simulation.steps(),
        time_s: simulation.time(),
        state_hash: format!("{:016x}", simulation.state_hash()),
        command: origin.command.clone(),
        kinetic_at_start_J: start.kinetic,
        gravitational_at_start_J: start.gravitational,
        elastic_at_start_J: start.elastic,
        movable_at_start_J: movable,
        supplied_at_start_J: supplied,
        overlap_at_start: origin.overlap,
        grown_at,
        written: recorder.written()?,
    })
}
