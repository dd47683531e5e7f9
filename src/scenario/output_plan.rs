//! The plan of output that comes of what was said.

use super::{DiscSource, Scenario};
use crate::output::recorder::OutputPlan;
use crate::output::{energy, trajectory};

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
