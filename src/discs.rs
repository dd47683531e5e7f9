//! The discs and everything that pushes them: what a simulation steps.
//!
//! m a = m g + sum f_c: [`PlainDiscs::update_forces`](Motion::update_forces) adds the right-hand side
//! up, an integrator turns it into motion. [`PlainDiscs`] is the plain way, one thing after the other;
//! [`Crowd`](crate::crowd::Crowd) does the same for many discs, fast, and to the same bits.

mod remembered;

use glam::DVec2;

pub use self::remembered::Remembered;
use crate::force::{Force, Share, Tally};
use crate::integrator::Motion;
use crate::particle::Particle;
use crate::work::{self, Works};

/// Discs that can be moved, looked at, and put back.
pub trait Discs: Motion + Send {
    /// The same discs as an integrator sees them.
    fn as_motion(&mut self) -> &mut dyn Motion;
    /// Brings every disc up to date: what a step has asked for may have been put off until now.
    fn settle(&mut self);
    /// Moves what forces remember past a completed step of `dt` s.
    fn end_step(&mut self, _dt: f64) {}
    /// All discs, in id order.
    fn particles(&self) -> &[Particle];
    /// The disc of this id.
    fn particle(&self, id: usize) -> &Particle;
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
    /// Largest overlaps so far.
    fn tally(&self) -> &Tally;
    /// Works since the ledger was opened, if it was.
    fn works(&self) -> Option<&Works>;
    /// From now on, books the work of every force at every kick.
    fn keep_work_ledger(&mut self);
    /// Changes the discs by hand, in id order; books the energy it gives.
    fn act(&mut self, change: &mut dyn FnMut(&mut [Particle]));
    /// The same discs with one more force.
    fn with_force(self: Box<Self>, force: Box<dyn Force>) -> Box<dyn Discs>;
    /// All that is remembered between two steps, where it lies.
    fn remembered(&self) -> Remembered<'_>;
    /// A copy of it.
    fn snapshot(&self) -> Snapshot {
        self.remembered().copied()
    }
    /// Goes back to what was remembered.
    fn restore(&mut self, snapshot: &Snapshot);
    /// Keeps what [`go_back`](Self::go_back) needs in `kept`, in place of what was there.
    fn keep(&self, kept: &mut Kept) {
        *kept = Kept::default(); // gone before the next is made
        kept.snapshot = self.snapshot();
    }
    /// Goes back to what was kept of these discs.
    fn go_back(&mut self, kept: &Kept) {
        self.restore(&kept.snapshot);
    }
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
    /// Their ids; empty if they are stored in id order.
    pub ids: Vec<u32>,
    /// Largest overlaps, and the contacts' shares if they are kept one by one.
    pub tally: Tally,
    /// Works since the ledger was opened.
    pub works: Works,
    /// Energy stored in forces, J, if it is kept.
    pub stored_energy: f64,
    /// The springs' force on each disc as it is stored, N; empty where shares are kept.
    pub springs: Vec<DVec2>,
    /// Where each disc, as it is stored, was when the present list of near pairs was made, m.
    pub listed_at: Vec<[f64; 2]>,
    /// The skin of that list, m.
    pub skin: f64,
    /// The square of how far a disc may move before there is a new one, m2.
    pub limit_squared: f64,
}

/// The same for the discs of this run only, in less memory where that can be: what a run does not
/// change is not kept, nor what follows from the rest.
#[derive(Default)]
pub struct Kept {
    /// Everything else; without discs and springs if `moving` has them.
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

/// Discs in id order, one force after the other.
pub struct PlainDiscs {
    particles: Vec<Particle>,
    gravity: DVec2, // m/s2
    forces: Vec<Box<dyn Force>>,
    tally: Tally,
    works: Works,
    stored_energy: f64, // J
    /// So many of the forces are contacts; those after them were added.
    contacts: usize,
}

impl PlainDiscs {
    /// Discs under `gravity` (m/s2) and `forces`, the contacts.
    pub fn new(particles: Vec<Particle>, gravity: DVec2, forces: Vec<Box<dyn Force>>) -> Self {
        let mut discs = Self {
            particles,
            gravity,
            contacts: forces.len(),
            forces,
            tally: Tally::default(),
            works: Works::default(),
            stored_energy: 0.0,
        };
        discs.update_forces();
        discs
    }

    /// The same discs with the books of a run that is under way.
    pub(crate) fn with_books(mut self, tally: Tally, works: Option<Works>) -> Self {
        self.tally = tally;
        if let Some(works) = works {
            self.keep_work_ledger();
            self.works = works;
        }
        self
    }
}

impl Motion for PlainDiscs {
    fn kick(&mut self, dt: f64) {
        let (gravity, external) = (self.gravity, self.forces.len() > self.contacts);
        match &self.tally.shares {
            // The same kicks, with the work of each force booked beside them.
            Some(shares) => {
                let particles = &mut self.particles;
                self.works.kick(particles, shares, gravity, external, dt);
            }
            None => self.particles.iter_mut().for_each(|disc| disc.kick(dt)),
        }
    }

    fn drift(&mut self, dt: f64) {
        self.particles.iter_mut().for_each(|disc| disc.drift(dt));
    }

    /// The right-hand side of m a = m g + sum f_c.
    fn update_forces(&mut self) {
        for disc in &mut self.particles {
            disc.force = disc.mass * self.gravity;
        }
        self.tally.begin();
        self.stored_energy = 0.0;
        let (contacts, added) = self.forces.split_at_mut(self.contacts);
        for force in contacts {
            self.stored_energy += force.apply(&mut self.particles, &mut self.tally);
        }
        for force in added {
            self.stored_energy += self.tally.book(force.as_mut(), &mut self.particles);
        }
    }

    fn particles_mut(&mut self) -> &mut [Particle] {
        &mut self.particles
    }
}

impl Discs for PlainDiscs {
    fn as_motion(&mut self) -> &mut dyn Motion {
        self
    }

    fn settle(&mut self) {}

    fn end_step(&mut self, dt: f64) {
        self.forces.iter_mut().for_each(|force| force.end_step(dt));
    }

    fn particles(&self) -> &[Particle] {
        &self.particles
    }

    fn particle(&self, id: usize) -> &Particle {
        &self.particles[id]
    }

    fn count(&self) -> usize {
        self.particles.len()
    }

    fn sum(&self, quantity: &(dyn Fn(&Particle) -> f64 + Sync)) -> f64 {
        work::sum_over(&self.particles, quantity)
    }

    fn gravity(&self) -> DVec2 {
        self.gravity
    }

    fn stored_energy(&self) -> f64 {
        self.stored_energy
    }

    fn tally(&self) -> &Tally {
        &self.tally
    }

    fn works(&self) -> Option<&Works> {
        self.tally.shares.as_ref().map(|_| &self.works)
    }

    fn keep_work_ledger(&mut self) {
        self.tally.shares = Some(vec![Share::default(); self.particles.len()]);
        self.works = Works::default();
        self.update_forces();
    }

    fn act(&mut self, change: &mut dyn FnMut(&mut [Particle])) {
        let (before, potential) = (self.particles.clone(), self.potential_energy());
        change(&mut self.particles);
        if self.particles == before {
            return;
        }
        let after = work::kinetic_energy(&self.particles);
        self.works.external.add(after - work::kinetic_energy(&before));
        self.update_forces();
        self.works.by_hand.add(self.potential_energy() - potential);
    }

    fn with_force(mut self: Box<Self>, force: Box<dyn Force>) -> Box<dyn Discs> {
        let potential = self.potential_energy();
        self.forces.push(force);
        self.update_forces();
        self.works.by_hand.add(self.potential_energy() - potential);
        self
    }

    fn remembered(&self) -> Remembered<'_> {
        Remembered {
            particles: &self.particles,
            ids: &[],
            tally: &self.tally,
            works: self.works,
            stored_energy: self.stored_energy,
            springs: &[],
            listed_at: &[],
            skin: 0.0,
            limit_squared: 0.0,
        }
    }

    fn restore(&mut self, snapshot: &Snapshot) {
        let Snapshot { particles, tally, works, stored_energy, .. } = snapshot.clone();
        (self.particles, self.tally, self.works, self.stored_energy) =
            (particles, tally, works, stored_energy);
    }
}
