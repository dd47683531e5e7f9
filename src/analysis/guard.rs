//! The guard of a run: notices when it has gone wrong, and finds the step at which it did.
//!
//! It looks every [`EVERY`] steps, which costs little, and keeps a state from time to time. Once
//! something is wrong it goes back to the last state kept and looks after every single step.

mod memory;
mod wrong;

use glam::DVec2;

pub use self::memory::Memory;
pub use self::wrong::{BEYOND, CROSSED, GROWTH, Wrong};
use self::wrong::{Look, dissipated};
use super::energy::MechanicalEnergy;
use crate::particle::Particle;
use crate::simulation::Simulation;
use crate::simulation::restore_point::RestorePoint;

/// Steps between two looks.
pub const EVERY: u64 = 64;

/// Looks between two states kept.
const LOOKS_PER_STATE: u64 = 16;

/// What went wrong, when, and with whom.
#[derive(Clone, Debug, PartialEq)]
pub struct Trouble {
    /// In what way.
    pub wrong: Wrong,
    /// The first step after which it was so.
    pub step: u64,
    /// Its time, s.
    pub time: f64,
    /// Ids of the discs in question: two that crossed, the one beyond the wall, or the fastest.
    pub discs: Vec<usize>,
    /// The wall in question: left, right, lower or upper.
    pub wall: Option<&'static str>,
    /// The deepest overlap of that disc or pair over the (smaller) radius.
    pub overlap: f64,
    /// Speed of the first of `discs`, m/s.
    pub speed: f64,
    /// Mechanical energy at the start, J.
    pub energy_at_start: f64,
    /// The same a step before, J.
    pub energy_before: f64,
    /// The same after that step, J.
    pub energy_after: f64,
    /// What damping took until then, J, if there is a ledger; less than nothing where it gives.
    pub dissipated: Option<f64>,
}

/// Watches one run.
pub struct Guard {
    side: Option<f64>, // m, of the box, if it has walls
    watched: Vec<Wrong>,
    memory: Memory,
    kept: RestorePoint,
    looks: u64,
}

impl Guard {
    /// A guard of `simulation` from now on, which looks for what is to be `watched`, in this order; `side` (m) of its
    /// box, if it has walls.
    pub fn new(simulation: &Simulation, side: Option<f64>, watched: Vec<Wrong>) -> Self {
        let start = MechanicalEnergy::of(simulation);
        let height = height_to_fall(simulation, side);
        let movable = start.kinetic + start.elastic + height;
        let memory = Memory { start, movable, supplied: simulation.supplied(), grown_at: None };
        Self::continued(simulation, side, watched, memory)
    }

    /// A guard that goes on where another, whose `memory` it has, left a good state: it finds the same
    /// trouble at the same step, for none began before that state.
    pub fn continued(
        simulation: &Simulation,
        side: Option<f64>,
        watched: Vec<Wrong>,
        memory: Memory,
    ) -> Self {
        let mut kept = RestorePoint::default();
        simulation.keep(&mut kept);
        Self { side, watched, memory, kept, looks: 0 }
    }

    /// What another guard must know to go on.
    pub fn memory(&self) -> Memory {
        self.memory
    }

    /// Whether nothing is wrong with the present state. Changes nothing.
    pub fn finds_good(&self, simulation: &Simulation) -> bool {
        self.wrong(simulation).is_none()
    }

    /// The step at which to look next.
    pub fn next_look(&self, simulation: &Simulation) -> u64 {
        (simulation.steps() / EVERY + 1) * EVERY
    }

    /// Looks. If something is wrong, goes back with `simulation` to the last good step, the one before
    /// the trouble began.
    pub fn look(&mut self, simulation: &mut Simulation) -> Option<Trouble> {
        let grown_at = self.memory.grown_at.take();
        self.look_back(simulation, grown_at)
    }

    /// The last look at a run, at its end: no other will confirm that the energy has grown. Half the
    /// steps between two looks must do, more than any contact lasts whose step is so coarse.
    pub fn look_last(&mut self, simulation: &mut Simulation) -> Option<Trouble> {
        let half_a_look = simulation.steps().saturating_sub(EVERY / 2);
        let grown_at = self.memory.grown_at.take().unwrap_or(half_a_look);
        self.look_back(simulation, Some(grown_at))
    }

    fn look_back(&mut self, simulation: &mut Simulation, grown_at: Option<u64>) -> Option<Trouble> {
        match self.wrong(simulation) {
            None => {
                self.looks += 1;
                if self.looks % LOOKS_PER_STATE == 0 {
                    simulation.keep(&mut self.kept);
                }
                None
            }
            Some(Wrong::EnergyGrown) if grown_at.is_none() => {
                self.memory.grown_at = Some(simulation.steps());
                None
            }
            Some(wrong) => self.first_trouble(simulation, wrong, grown_at),
        }
    }

    /// The last good step on the way from the state kept to the present one is where trouble began.
    /// Energy that had come back since the look at step `grown_at` was no trouble.
    fn first_trouble(
        &mut self,
        simulation: &mut Simulation,
        at_last: Wrong,
        grown_at: Option<u64>,
    ) -> Option<Trouble> {
        let mut seen = RestorePoint::default();
        simulation.keep(&mut seen);
        let last_good = self.last_good_step(simulation, seen.steps());
        if at_last == Wrong::EnergyGrown && grown_at.is_some_and(|step| last_good >= step) {
            simulation.go_back(&seen);
            self.memory.grown_at = Some(seen.steps());
            self.kept = seen;
            return None;
        }
        simulation.go_back(&self.kept);
        while simulation.steps() < last_good {
            simulation.step();
        }
        let mut before = RestorePoint::default();
        simulation.keep(&mut before);
        let energy_before = MechanicalEnergy::of(simulation).total();
        simulation.step();
        // A change from outside, or a force that remembers more than the state, may not come by the
        // trouble again: then what was seen holds.
        let wrong = self.wrong(simulation).unwrap_or_else(|| {
            simulation.go_back(&seen);
            at_last
        });
        let trouble = self.trouble(wrong, simulation, energy_before);
        simulation.go_back(&before);
        Some(trouble)
    }

    /// The last step before `end` after which nothing was wrong; that of the state kept at least.
    fn last_good_step(&self, simulation: &mut Simulation, end: u64) -> u64 {
        simulation.go_back(&self.kept);
        let mut last_good = simulation.steps();
        while simulation.steps() + 1 < end {
            simulation.step();
            if self.wrong(simulation).is_none() {
                last_good = simulation.steps();
            }
        }
        last_good
    }

    fn wrong(&self, simulation: &Simulation) -> Option<Wrong> {
        let look = Look::at(simulation, self.side, &self.memory);
        self.watched.iter().copied().find(|wrong| wrong.is_so(&look))
    }

    fn trouble(&self, wrong: Wrong, simulation: &Simulation, energy_before: f64) -> Trouble {
        let particles = simulation.particles();
        let (discs, wall, overlap) = wrong.whom(particles, self.side);
        let first = discs.first().map_or(f64::NAN, |&id| particles[id].velocity.length());
        Trouble {
            wrong,
            step: simulation.steps(),
            time: simulation.time(),
            discs,
            wall,
            overlap,
            speed: first,
            energy_at_start: self.memory.start.total(),
            energy_before,
            energy_after: MechanicalEnergy::of(simulation).total(),
            dissipated: dissipated(simulation),
        }
    }
}

/// What gravity can give the discs until the wall ends their fall, J; without walls nothing is
/// known of that.
fn height_to_fall(simulation: &Simulation, side: Option<f64>) -> f64 {
    let gravity = simulation.gravity();
    let all = |side| simulation.sum_over(|disc| height_of(disc, gravity, side)).max(0.0);
    side.map_or(0.0, all)
}

/// The same for one disc in a box of `side` (m).
fn height_of(disc: &Particle, gravity: DVec2, side: f64) -> f64 {
    let along = |g: f64, x: f64| g.abs() * if g > 0.0 { side - x } else { x };
    disc.mass * (along(gravity.x, disc.position.x) + along(gravity.y, disc.position.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gravity_can_give_what_lies_on_its_way_to_the_wall() {
        // One gram at (0.01, 0.03) m in a box of 0.04 m: m g times the way down, up, left, right.
        let cases = [
            (DVec2::new(0.0, -9.81), 0.03),
            (DVec2::new(0.0, 9.81), 0.01),
            (DVec2::new(-9.81, 0.0), 0.01),
            (DVec2::new(9.81, 0.0), 0.03),
        ];
        for (gravity, way) in cases {
            let disc = Particle::at_rest(DVec2::new(0.01, 0.03), 1e-4, 1e-3);
            let height = height_of(&disc, gravity, 0.04);
            assert!((height - 1e-3 * 9.81 * way).abs() < 1e-15, "{gravity}: {height}");
        }
    }
}
