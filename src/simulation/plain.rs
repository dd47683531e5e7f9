//! The plain way to step discs, as a simulation sees it.

use std::any::Any;

use glam::DVec2;

use super::PlainDiscs;
use crate::discs::columns::Columns;
use crate::discs::{Discs, Remembered, Snapshot};
use crate::force::{Force, HalfPlane};
use crate::integrator::Motion;
use crate::neighbours::Neighbours;
use crate::particle::{ContactLaw, Particle};
use crate::work::{self, Channel, Share, Works};

impl<L> PlainDiscs<L> {
    /// Kicks by `dt` (s), and books the work of each force beside it.
    pub(super) fn kick_and_book(&mut self, dt: f64) {
        let Self { particles, gravity, forces, books, .. } = self;
        books.works.kick(particles, &books.shares, *gravity, !forces.is_empty(), dt);
    }
}

impl<L: ContactLaw + 'static> PlainDiscs<L> {
    /// Discs under `gravity` (m/s2) that touch each other and the `walls` by `law`.
    pub fn new(particles: Vec<Particle>, gravity: DVec2, law: L, walls: Vec<HalfPlane>) -> Self {
        Self::continued(particles, gravity, law, walls, Columns::default())
    }

    /// The same in a run that is under way and has these `books`.
    pub(crate) fn continued(
        particles: Vec<Particle>,
        gravity: DVec2,
        law: L,
        walls: Vec<HalfPlane>,
        books: Columns,
    ) -> Self {
        let neighbours = Neighbours::default();
        let mut discs =
            Self { particles, gravity, forces: Vec::new(), law, walls, neighbours, books };
        discs.update_forces();
        discs
    }

    /// Has `change` add or remove discs; books the energies that come with them, of which it tells the kinetic one, J.
    fn change_number(&mut self, change: impl FnOnce(&mut Vec<Particle>) -> f64) {
        let potential = self.potential_energy();
        let kinetic = change(&mut self.particles);
        if self.has_ledger() {
            self.books.shares.resize(self.particles.len(), Share::default());
        }
        self.update_forces();
        let brought = self.potential_energy() - potential;
        self.books.works[Channel::Inflow].work.add(kinetic);
        self.books.works[Channel::Inflow].beside.add(brought);
    }

    /// Has `change` alter what pushes the discs; books the energy that they have by it as given by hand.
    fn give(&mut self, change: impl FnOnce(&mut Self)) {
        let potential = self.potential_energy();
        change(self);
        self.update_forces();
        let brought = self.potential_energy() - potential;
        self.books.works[Channel::Hand].beside.add(brought);
    }
}

impl<L: ContactLaw + 'static> Discs for PlainDiscs<L> {
    fn as_motion(&mut self) -> &mut dyn Motion {
        self
    }

    fn settle(&mut self) {}

    fn insert(&mut self, disc: Particle) {
        self.change_number(|particles| {
            particles.push(disc);
            disc.kinetic_energy()
        });
    }

    fn remove(&mut self, id: usize) -> Particle {
        let disc = self.particles[id];
        self.change_number(|particles| {
            particles.remove(id);
            -disc.kinetic_energy()
        });
        disc
    }

    fn set_gravity(&mut self, gravity: DVec2) {
        if gravity != self.gravity {
            self.give(|discs| discs.gravity = gravity);
        }
    }

    fn set_law(&mut self, law: &mut dyn Any) {
        if let Some(law) = law.downcast_mut::<Option<L>>().and_then(Option::take) {
            self.give(|discs| discs.law = law);
        }
    }

    fn end_step(&mut self, dt: f64) {
        self.forces.iter_mut().for_each(|force| force.end_step(dt));
    }

    fn particles(&self) -> &[Particle] {
        &self.particles
    }

    fn particle(&self, id: usize) -> Particle {
        self.particles[id]
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
        self.books.stored_energy()
    }

    fn has_ledger(&self) -> bool {
        !self.books.shares.is_empty()
    }

    fn keep_work_ledger(&mut self) {
        self.books.works = Works::default();
        self.books.shares = vec![Share::default(); self.particles.len()];
        self.update_forces();
    }

    fn act(&mut self, change: &mut dyn FnMut(&mut [Particle])) {
        let (before, potential) = (self.particles.clone(), self.potential_energy());
        change(&mut self.particles);
        if self.particles == before {
            return;
        }
        let after = work::kinetic_energy(&self.particles);
        self.books.works[Channel::Hand].work.add(after - work::kinetic_energy(&before));
        self.update_forces();
        let lifted = self.potential_energy() - potential;
        self.books.works[Channel::Hand].beside.add(lifted);
    }

    /// Its work is booked from now on, with a ledger or without, so that what it supplies is known.
    fn add_force(&mut self, force: Box<dyn Force>) {
        self.give(|discs| {
            discs.forces.push(force);
            discs.books.shares = vec![Share::default(); discs.particles.len()];
        });
    }

    fn remembered(&self) -> Remembered<'_> {
        Remembered { particles: &self.particles, columns: self.books.view() }
    }

    fn restore(&mut self, snapshot: &Snapshot) {
        self.particles.clone_from(&snapshot.particles);
        self.books.copy_from(snapshot.columns.view(), &[]);
    }

    fn works(&self) -> &Works {
        &self.books.works
    }
}
