//! Restore points: states of one simulation for this to come back to, in little memory.

use super::Simulation;
use super::clock::Clock;
use crate::discs::LeanSnapshot;

/// A state of one simulation, for this to come back to.
#[derive(Default)]
pub struct RestorePoint {
    discs: LeanSnapshot,
    clock: Clock,
}

impl RestorePoint {
    /// Steps done until then.
    pub fn steps(&self) -> u64 {
        self.clock.steps()
    }
}

impl Simulation {
    /// Keeps the present state in `kept`, in place of what was there: for this simulation to come back
    /// to, in less memory than [`state`](Self::state) takes.
    pub fn keep(&self, kept: &mut RestorePoint) {
        self.discs.keep(&mut kept.discs);
        kept.clock = self.clock;
    }

    /// Goes back to the state that was `kept` of this simulation.
    pub fn go_back(&mut self, kept: &RestorePoint) {
        self.clock = kept.clock;
        self.discs.set_dt(self.clock.dt());
        self.discs.go_back(&kept.discs);
    }
}
