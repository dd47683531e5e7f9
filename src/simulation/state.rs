//! A state as named arrays, to be written down and read back with every bit.

use super::Simulation;
use super::clock::Clock;
pub use crate::discs::columns::{Array, ArrayView};
use crate::discs::columns::{Columns, rows};
use crate::discs::{Remembered, Snapshot};
use crate::particle::Particle;

/// The state of a simulation between two steps.
#[derive(Clone)]
pub struct State {
    discs: Snapshot,
    clock: Clock,
}

impl State {
    /// Steps done.
    pub fn steps(&self) -> u64 {
        self.clock.steps()
    }

    /// The discs, in id order.
    pub fn particles(&self) -> Vec<Particle> {
        let Snapshot { particles, columns } = &self.discs;
        let mut ordered = particles.clone();
        columns.ids.iter().zip(particles).for_each(|(&id, disc)| ordered[id as usize] = *disc);
        ordered
    }

    /// Whether it is the state of the engine, which has an order of its own, and works booked in it.
    pub fn is_of_engine(&self) -> bool {
        !self.discs.columns.ids.is_empty()
    }

    /// Everything in the state, by name. Whoever stores these need not know what they are.
    pub fn arrays(&self) -> Vec<(&'static str, Array)> {
        let views = views(self.discs.remembered(), self.clock).into_iter();
        views.map(|(name, view)| (name, view.to_array())).collect()
    }

    /// The state that [`arrays`](Self::arrays) came from. Names that belong to no state are left alone.
    ///
    /// # Errors
    ///
    /// Names the array that is missing or does not fit the others.
    pub fn from_arrays(mut arrays: Vec<(String, Array)>) -> Result<Self, String> {
        let arrays = &mut arrays;
        let clock = Clock::from_arrays(arrays)?;
        let particles: Vec<Particle> = rows(arrays, "particles", None)?;
        let is_sound = |p: &Particle| [p.radius, p.mass].iter().all(|x| *x > 0.0 && x.is_finite());
        if let Some(id) = particles.iter().position(|p| !is_sound(p)) {
            return Err(format!("array particles: radius or mass of disc {id} is not above 0"));
        }
        if particles.is_empty() {
            return Err("array particles: it has no disc".to_owned());
        }
        let columns = Columns::from_arrays(particles.len(), arrays)?;
        columns.check(particles.len())?;
        Ok(Self { discs: Snapshot { particles, columns }, clock })
    }
}

impl Simulation {
    /// All that is remembered between two steps, to come back to.
    pub fn state(&self) -> State {
        State { discs: self.discs.remembered().copied(), clock: self.clock }
    }

    /// Goes back to `state`: the steps from there on have the same bits as the first time.
    pub fn set_state(&mut self, state: &State) {
        self.clock = state.clock;
        self.discs.set_dt(self.clock.dt());
        self.discs.restore(&state.discs);
    }

    /// The arrays of the present [`state`](Self::state), without a copy of anything.
    pub fn arrays(&self) -> Vec<(&'static str, ArrayView<'_>)> {
        views(self.discs.remembered(), self.clock)
    }
}

/// The arrays of a state by name.
fn views(discs: Remembered, clock: Clock) -> Vec<(&'static str, ArrayView)> {
    let particles = ArrayView::of_rows(discs.particles.iter().copied());
    let first = clock.arrays().into_iter().chain([("particles", particles)]);
    first.chain(discs.columns.arrays()).collect()
}
