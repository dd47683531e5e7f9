//! The discs as a simulation sees them, whoever steps them: plainly, one thing after the other
//! ([`PlainDiscs`](crate::simulation)), or as a [`Engine`](crate::engine::Engine), fast, and to the same bits.

mod books;
pub mod columns;
pub mod overlaps;

use std::any::Any;

use glam::DVec2;

use self::columns::{Columns, ColumnsView};
use self::overlaps::Overlaps;
use crate::force::Force;
use crate::integrator::Motion;
use crate::particle::Particle;
use crate::work::Works;

/// Discs that can be moved, looked at, and put back.
pub trait Discs: Motion + Send {
    /// The same discs as an integrator sees them.
    fn as_motion(&mut self) -> &mut dyn Motion;
    /// Brings every disc up to date: what a step has asked for may have been put off until now.
    fn settle(&mut self);
    /// A step begins, which goes `from` one time `to` another, s.
    fn begin_step(&mut self, _from: f64, _to: f64) {}
    /// Moves what forces remember past a completed step of `dt` s.
    fn end_step(&mut self, _dt: f64) {}
    /// From now on a step takes `dt` s.
    fn set_dt(&mut self, _dt: f64) {}
    /// From now on discs fall by `gravity`, m/s2; books the energy that gives.
    fn set_gravity(&mut self, gravity: DVec2);
    /// Takes the law of contacts out of `law`, an `Option`, if it is of the type of the present one; books the energy that gives.
    fn set_law(&mut self, law: &mut dyn Any);
    /// All discs, in id order.
    fn particles(&self) -> &[Particle];
    /// The disc of this id.
    fn particle(&self, id: usize) -> Particle;
    /// Number of discs.
    fn count(&self) -> usize;
    /// The sum of `quantity` over all discs, in a fixed order.
    fn sum(&self, quantity: &(dyn Fn(&Particle) -> f64 + Sync)) -> f64;
    /// Acceleration of gravity, m/s2.
    fn gravity(&self) -> DVec2;
    /// Energy stored in contacts and other forces, J.
    fn stored_energy(&self) -> f64;
    /// Gravitational and stored energy, J.
    fn potential_energy(&self) -> f64 {
        let gravity = self.gravity();
        self.sum(&|disc| -disc.mass * gravity.dot(disc.position)) + self.stored_energy()
    }
    /// Whether the work of every force is booked at every kick.
    fn has_ledger(&self) -> bool;
    /// From now on it is, from nothing.
    fn keep_work_ledger(&mut self);
    /// Changes the discs by hand, in id order; books the energy it gives.
    fn act(&mut self, change: &mut dyn FnMut(&mut [Particle]));
    /// Puts one more disc in, with the highest id; books the energy it brings.
    fn insert(&mut self, disc: Particle);
    /// Takes the disc of this id out, and gives it back; higher ids move down by one. Books the energy it takes along.
    fn remove(&mut self, id: usize) -> Particle;
    /// Adds a force that is no contact; books the energy it brings.
    fn add_force(&mut self, force: Box<dyn Force>);
    /// All that is remembered between two steps, where it lies.
    fn remembered(&self) -> Remembered<'_>;
    /// Goes back to what was remembered.
    fn restore(&mut self, snapshot: &Snapshot);
    /// Keeps what [`go_back`](Self::go_back) needs in `kept`, in place of what was there.
    fn keep(&self, kept: &mut LeanSnapshot) {
        *kept = LeanSnapshot::default(); // gone before the next is made
        kept.snapshot = self.remembered().copied();
    }
    /// Goes back to what was kept of these discs.
    fn go_back(&mut self, kept: &LeanSnapshot) {
        self.restore(&kept.snapshot);
    }
    /// Largest overlaps so far.
    fn overlaps(&self) -> Overlaps {
        self.remembered().columns.overlaps
    }
    /// Energies booked: all since the ledger was opened, or what was supplied from outside at least.
    fn works(&self) -> &Works;
    /// Lists of near pairs made so far.
    fn lists_made(&self) -> u64 {
        0
    }
}

/// All that discs remember between two steps.
#[derive(Clone, Default)]
pub struct Snapshot {
    /// The discs, as they are stored.
    pub particles: Vec<Particle>,
    /// What lies beside them.
    pub columns: Columns,
}

/// The same, not copied yet.
#[derive(Clone, Copy)]
pub struct Remembered<'a> {
    /// The discs, as they are stored.
    pub particles: &'a [Particle],
    /// What lies beside them.
    pub columns: ColumnsView<'a>,
}

impl Remembered<'_> {
    /// A copy, to come back to.
    pub fn copied(&self) -> Snapshot {
        let mut columns = Columns::default();
        columns.copy_from(self.columns, &[]);
        Snapshot { particles: self.particles.to_vec(), columns }
    }
}

impl Snapshot {
    /// The same without a copy.
    pub fn remembered(&self) -> Remembered<'_> {
        Remembered { particles: &self.particles, columns: self.columns.view() }
    }
}

/// The same for the discs of this run only, in less memory where that can be: what a run does not
/// change is not kept, nor what follows from the rest.
#[derive(Default)]
pub struct LeanSnapshot {
    /// Everything else; without particles and springs if `moving` has them.
    pub snapshot: Snapshot,
    /// Position, m, and velocity, m/s, of each disc as it is stored.
    pub moving: Vec<[DVec2; 2]>,
    /// Force on each, N; empty if it follows from positions and velocities.
    pub forces: Vec<DVec2>,
    /// Whether there was a ledger.
    pub has_ledger: bool,
    /// Discs given another size by hand so far.
    pub resized: usize,
}
