//! What a run writes, as said, and the plan that comes of it.

use std::path::PathBuf;

use super::{DiscSource, Scenario};
use crate::output::recorder::OutputPlan;
use crate::output::{energy, trajectory};

/// What is written, where and how often.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputChoices {
    /// Folder of the output files.
    pub folder: PathBuf,
    /// Steps between frames, if said.
    pub every: Option<u64>,
    /// Steps between ledger lines, if said; 0 for none.
    pub energy_every: Option<u64>,
    /// Wall seconds for a simulated second, if said.
    pub slowdown: Option<f64>,
    /// Threads that share the steps, if said.
    pub threads: Option<usize>,
    /// Seconds of wall time between checkpoints, if said.
    pub checkpoint_every: Option<f64>,
    /// Whether `out.txt` has the guide's border discs.
    pub border: bool,
    /// Summary as JSON.
    pub json: bool,
    /// Nothing but errors.
    pub quiet: bool,
}

impl Scenario {
    /// What to write where and how often, with the defaults filled in. The record is that of this
    /// scenario; of the discs of a frame that cannot be placed there is none.
    pub fn output_plan(&self) -> OutputPlan {
        let record = match &self.discs {
            DiscSource::Frame { .. } => self.place().map(|discs| self.record(&discs)),
            _ => Ok(self.record(&[])), // it says how to place them
        };
        self.output_plan_with(record.unwrap_or_default())
    }

    /// The same with this text as the record of the run; none is kept if it is empty.
    pub fn output_plan_with(&self, record: String) -> OutputPlan {
        let (n, steps, output) = (self.n(), self.steps(), &self.output);
        let frame_every = output.every.unwrap_or_else(|| trajectory::default_every(n, steps));
        OutputPlan {
            folder: output.folder.clone(),
            frame_every,
            live_follows_frames: output.every.is_some(),
            energy_every: output.energy_every.unwrap_or_else(|| energy::default_every(steps)),
            side: self.side,
            border: output.border.then_some(self.radius),
            record,
        }
    }
}
