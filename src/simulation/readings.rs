//! What can be read off a simulation between two steps.

use glam::DVec2;

use super::Simulation;
use crate::discs::Remembered;
use crate::particle::Particle;
use crate::work::Works;

impl Simulation {
    /// Simulated time, s.
    pub fn time(&self) -> f64 {
        self.clock.time()
    }

    /// The time step, s.
    pub fn dt(&self) -> f64 {
        self.clock.dt()
    }

    /// Steps done.
    pub fn steps(&self) -> u64 {
        self.clock.steps()
    }

    /// The discs, in id order.
    pub fn particles(&self) -> &[Particle] {
        self.discs.particles()
    }

    /// The discs one after the other, in id order; for many discs cheaper than
    /// [`particles`](Self::particles).
    pub fn each_particle(&self) -> impl Iterator<Item = Particle> {
        (0..self.discs.count()).map(|id| self.discs.particle(id))
    }

    /// The discs as they lie in memory, and the id of each; empty if they lie in id order.
    pub fn as_stored(&self) -> (&[Particle], &[u32]) {
        let Remembered { particles, columns } = self.discs.remembered();
        (particles, columns.ids)
    }

    /// Number of discs.
    pub fn n(&self) -> usize {
        self.discs.count()
    }

    /// The sum of `quantity` over all discs, added in a fixed order.
    pub fn sum_over(&self, quantity: impl Fn(&Particle) -> f64 + Sync) -> f64 {
        self.discs.sum(&quantity)
    }

    /// Acceleration of gravity as a vector, m/s2.
    pub fn gravity(&self) -> DVec2 {
        self.discs.gravity()
    }

    /// Energy stored in contacts (and other forces) in the present state, J.
    pub fn stored_energy(&self) -> f64 {
        self.discs.stored_energy()
    }

    /// The largest overlap so far, start included, as a fraction of the smaller radius.
    pub fn largest_overlap(&self) -> f64 {
        self.largest_pair_overlap().max(self.largest_wall_overlap())
    }

    /// The same between discs only.
    pub fn largest_pair_overlap(&self) -> f64 {
        self.discs.overlaps().largest_pair_overlap
    }

    /// How far the centres of two discs have come towards each other so far: their overlap over the
    /// sum of their radii, 1 once they meet; 0 as long as no overlap was larger than a radius.
    pub fn largest_sinking(&self) -> f64 {
        self.discs.overlaps().largest_sinking
    }

    /// The same at walls only.
    pub fn largest_wall_overlap(&self) -> f64 {
        self.discs.overlaps().largest_wall_overlap
    }

    /// From now on, books the work of every force at every kick.
    pub fn keep_work_ledger(&mut self) {
        self.discs.keep_work_ledger();
    }

    /// Energies booked since [`keep_work_ledger`](Self::keep_work_ledger), if it was called. (A force of your own
    /// opens the ledger too.)
    pub fn works(&self) -> Option<&Works> {
        self.discs.has_ledger().then(|| self.discs.works())
    }

    /// Energy supplied from outside since the start, or since the ledger was opened, J: by hand, and by forces that store
    /// nothing. Known without a ledger, too.
    pub fn supplied(&self) -> f64 {
        self.discs.works().supplied()
    }

    /// Lists of near pairs made so far, where discs are many enough for it to matter.
    pub fn lists_made(&self) -> u64 {
        self.discs.lists_made()
    }
}
