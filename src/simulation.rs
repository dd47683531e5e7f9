//! The simulation: discs, the forces on them, the clock, and one time step.
//!
//! m a = m g + sum f_c: the [`Discs`] add the right-hand side up, an [`Integrator`] turns it into
//! motion. Here too: Eq. (2), the time step, and the placing of the discs.

pub mod state;

use std::f64::consts::PI;

use glam::DVec2;

use crate::discs::{Discs, Kept, PlainDiscs, Remembered, Snapshot};
use crate::force::Force;
use crate::integrator::Integrator;
use crate::particle::Particle;
use crate::placement::{self, PlacementError};
use crate::work::Works;

/// Eq. (2): dt = tau / N_t = pi sqrt(m / k_n) / N_t, in s.
///
/// tau is the time a disc of mass `mass` (kg) spends in an undamped contact with a wall of
/// stiffness `stiffness` (N/m); two equal discs part sooner, after tau / sqrt(2).
///
/// ```
/// let dt = parsim2d::simulation::time_step(1e-3, 5e4, 50.0);
/// assert!((dt - 8.8857658763e-6).abs() < 1e-15); // the guide's numbers
/// ```
pub fn time_step(mass: f64, stiffness: f64, steps_per_contact: f64) -> f64 {
    PI * (mass / stiffness).sqrt() / steps_per_contact
}

/// Places `n` discs of `radius` (m) and `mass` (kg), at rest, at random in the square from the
/// origin to (`side`, `side`) (m): uniform over the allowed region, no overlap, no wall contact.
///
/// The same `seed` gives the same discs. Fails, rather than loop for ever, when the box is too
/// full; `placement::lattice` goes denser.
pub fn place_discs(
    n: usize,
    radius: f64,
    mass: f64,
    side: f64,
    seed: u64,
) -> Result<Vec<Particle>, PlacementError> {
    let mut discs = vec![Particle::at_rest(DVec2::ZERO, radius, mass); n];
    placement::at_random(&mut discs, 0, side, &mut placement::generator(seed))?;
    Ok(discs)
}

/// A state of one simulation, for this to come back to.
#[derive(Default)]
pub struct KeptState {
    discs: Kept,
    steps: u64,
}

impl KeptState {
    /// Steps done until then.
    pub fn steps(&self) -> u64 {
        self.steps
    }
}

/// The state of a simulation between two steps.
#[derive(Clone)]
pub struct State {
    /// What the discs remember.
    pub(crate) discs: Snapshot,
    /// Steps done.
    pub(crate) steps: u64,
}

impl State {
    /// Steps done.
    pub fn steps(&self) -> u64 {
        self.steps
    }
}

/// Discs, an integrator and a clock.
pub struct Simulation {
    discs: Box<dyn Discs>,
    integrator: Box<dyn Integrator>,
    dt: f64, // s
    steps: u64,
}

impl Simulation {
    /// A simulation at t = 0, the plain way. `gravity` is the acceleration vector g in m/s2, `dt` the
    /// time step in s, `forces` the contacts; others join by [`add_force`](Self::add_force).
    pub fn new(
        particles: Vec<Particle>,
        gravity: DVec2,
        forces: Vec<Box<dyn Force>>,
        integrator: Box<dyn Integrator>,
        dt: f64,
    ) -> Self {
        let discs = PlainDiscs::new(particles, gravity, forces);
        Self::of(Box::new(discs), integrator, dt)
    }

    /// A simulation of these discs at t = 0.
    pub fn of(discs: Box<dyn Discs>, integrator: Box<dyn Integrator>, dt: f64) -> Self {
        Self { discs, integrator, dt, steps: 0 }
    }

    /// One time step.
    pub fn step(&mut self) {
        self.step_until(self.steps + 1);
    }

    /// Time steps until `end` steps are done: the same as so many times [`step`](Self::step), and
    /// faster for many discs.
    pub fn step_until(&mut self, end: u64) {
        while self.steps < end {
            self.integrator.step(self.discs.as_motion(), self.dt);
            self.discs.end_step(self.dt);
            self.steps += 1;
        }
        self.discs.settle();
    }

    /// Simulated time, s: steps done times the time step.
    pub fn time(&self) -> f64 {
        self.steps as f64 * self.dt
    }

    /// The time step, s.
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// Steps done.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The discs, in id order.
    pub fn particles(&self) -> &[Particle] {
        self.discs.particles()
    }

    /// The discs one after the other, in id order; for many discs cheaper than
    /// [`particles`](Self::particles).
    pub fn each_particle(&self) -> impl Iterator<Item = &Particle> {
        (0..self.discs.count()).map(|id| self.discs.particle(id))
    }

    /// The discs as they lie in memory, and the id of each; empty if they lie in id order.
    pub fn as_stored(&self) -> (&[Particle], &[u32]) {
        let Remembered { particles, ids, .. } = self.discs.remembered();
        (particles, ids)
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
        self.discs.tally().largest_pair_overlap
    }

    /// How far the centres of two discs have come towards each other so far: their overlap over the
    /// sum of their radii, 1 once they meet; 0 as long as no overlap was larger than a radius.
    pub fn largest_sinking(&self) -> f64 {
        self.discs.tally().largest_sinking
    }

    /// The same at walls only.
    pub fn largest_wall_overlap(&self) -> f64 {
        self.discs.tally().largest_wall_overlap
    }

    /// Works gathered since [`keep_work_ledger`](Self::keep_work_ledger), if it was called.
    pub fn works(&self) -> Option<&Works> {
        self.discs.works()
    }

    /// Lists of near pairs made so far, where discs are many enough for it to matter.
    pub fn lists_made(&self) -> u64 {
        self.discs.lists_made()
    }

    /// From now on, books the work of every force at every kick.
    pub fn keep_work_ledger(&mut self) {
        self.discs.keep_work_ledger();
    }

    /// Steps with another integrator from now on.
    pub fn set_integrator(&mut self, integrator: Box<dyn Integrator>) {
        self.integrator = integrator;
    }

    /// Adds a force that is not a contact. If it stores energy its work is booked as a spring's is, else as
    /// external. From now on the discs are stepped the plain way, in id order.
    pub fn add_force(&mut self, force: Box<dyn Force>) {
        let none: Box<dyn Discs> = Box::new(PlainDiscs::new(Vec::new(), DVec2::ZERO, Vec::new()));
        let discs = std::mem::replace(&mut self.discs, none);
        self.discs = discs.with_force(force);
    }

    /// Changes the discs by hand between two steps. Forces follow the change (under velocity Verlet
    /// from the present velocity on), and the kinetic energy it gave is booked as external work, the rest
    /// as energy given by hand. A change that changes nothing leaves the run as it was, to the bit.
    pub fn act(&mut self, change: impl FnOnce(&mut [Particle])) {
        let mut change = Some(change);
        self.discs.act(&mut |particles| {
            if let Some(change) = change.take() {
                change(particles);
            }
        });
    }

    /// All that is remembered between two steps, to come back to.
    pub fn state(&self) -> State {
        State { discs: self.discs.snapshot(), steps: self.steps }
    }

    /// Goes back to `state`: the steps from there on have the same bits as the first time.
    pub fn set_state(&mut self, state: &State) {
        self.steps = state.steps;
        self.discs.restore(&state.discs);
    }

    /// Keeps the present state in `kept`, in place of what was there: for this simulation to come back
    /// to, in less memory than [`state`](Self::state) takes.
    pub fn keep(&self, kept: &mut KeptState) {
        self.discs.keep(&mut kept.discs);
        kept.steps = self.steps;
    }

    /// Goes back to the state that was `kept` of this simulation.
    pub fn go_back(&mut self, kept: &KeptState) {
        self.steps = kept.steps;
        self.discs.go_back(&kept.discs);
    }

    /// A 64-bit fingerprint of the state: FNV-1a (Fowler, Noll, Vo) over the step and then, in
    /// id order, x, y, vx, vy, r, m of each disc, all as little-endian bytes.
    pub fn state_hash(&self) -> u64 {
        let words = self.each_particle().flat_map(|p| {
            let (x, v) = (p.position, p.velocity);
            [x.x, x.y, v.x, v.y, p.radius, p.mass].map(f64::to_bits)
        });
        let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
        for byte in std::iter::once(self.steps).chain(words).flat_map(u64::to_le_bytes) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
        hash
    }
}
