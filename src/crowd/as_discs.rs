//! A crowd as a simulation sees it: discs in id order, with their books.

use std::mem::take;

use glam::DVec2;

use super::kept::{Resized, Since};
use super::near::Near;
use super::{Crowd, LaneLaw};
use crate::discs::columns::{Columns, ColumnsView};
use crate::discs::{Discs, LeanSnapshot, Remembered, Snapshot};
use crate::force::Force;
use crate::integrator::Motion;
use crate::particle::Particle;
use crate::simulation::PlainDiscs;
use crate::work::{Channel, Works, kinetic_energy};

impl<L: LaneLaw + Clone + Sync + 'static> Discs for Crowd<L> {
    fn as_motion(&mut self) -> &mut dyn Motion {
        self
    }

    fn settle(&mut self) {
        self.carry_out(true);
    }

    fn particles(&self) -> &[Particle] {
        if self.columns.ids.is_sorted() {
            return &self.particles;
        }
        self.in_id_order.get_or_init(|| (0..self.count()).map(|id| *self.particle(id)).collect())
    }

    fn particle(&self, id: usize) -> &Particle {
        let places = self.places.get_or_init(|| {
            let mut places = vec![0; self.columns.ids.len()];
            for (place, &id) in (0..).zip(&self.columns.ids) {
                places[id as usize] = place;
            }
            places
        });
        &self.particles[places[id] as usize]
    }

    fn count(&self) -> usize {
        self.particles.len()
    }

    fn sum(&self, quantity: &(dyn Fn(&Particle) -> f64 + Sync)) -> f64 {
        self.sum_of_discs(quantity)
    }

    fn gravity(&self) -> DVec2 {
        self.gravity
    }

    fn stored_energy(&self) -> f64 {
        self.energy_stored()
    }

    fn set_dt(&mut self, dt: f64) {
        self.dt = dt;
    }

    fn has_ledger(&self) -> bool {
        !self.columns.springs.is_empty()
    }

    fn works(&self) -> &Works {
        &self.columns.works
    }

    fn keep_work_ledger(&mut self) {
        self.settle();
        self.columns.springs = vec![DVec2::ZERO; self.particles.len()];
        self.columns.works = Works::default();
        self.update_forces();
        self.settle();
    }

    fn act(&mut self, change: &mut dyn FnMut(&mut [Particle])) {
        let potential = self.potential_energy();
        let before = self.particles().to_vec();
        let mut after = before.clone();
        change(&mut after);
        if after == before {
            return;
        }
        let given = kinetic_energy(&after) - kinetic_energy(&before);
        self.columns.works[Channel::Hand].work.add(given);
        for (disc, &id) in self.particles.iter_mut().zip(&self.columns.ids) {
            let (was, is) = (&before[id as usize], after[id as usize]);
            self.resized.extend(Resized::between(id, was, &is));
            *disc = is;
        }
        self.near.forget();
        self.update_forces();
        self.settle();
        let lifted = self.potential_energy() - potential;
        self.columns.works[Channel::Hand].beside.add(lifted);
    }

    fn add_force(&mut self, force: Box<dyn Force>) -> Option<Box<dyn Discs>> {
        self.restore_id_order();
        let Self { law, planes, gravity, columns, .. } = self;
        let books =
            Columns { overlaps: columns.overlaps, works: columns.works, ..Columns::default() };
        let (particles, planes) = (take(&mut self.particles), take(planes));
        let mut discs = PlainDiscs::continued(particles, *gravity, law.clone(), planes, books);
        discs.add_force(force);
        Some(Box::new(discs))
    }

    fn remembered(&self) -> Remembered<'_> {
        let Near { listed_at, skin, limit_squared, .. } = &self.near;
        let list = [*skin, *limit_squared];
        let columns = ColumnsView { listed_at, list, ..self.columns.view() };
        Remembered { particles: &self.particles, columns }
    }

    fn restore(&mut self, snapshot: &Snapshot) {
        self.particles.clone_from(&snapshot.particles);
        self.columns.copy_from(snapshot.columns.view(), &["listed_at"]);
        self.moves.clear();
        self.forces_are_wanted = false;
        self.in_id_order.take();
        self.places.take();
        self.since_forces = Since::Unknown;
        self.restore_list(&snapshot.columns);
    }

    fn keep(&self, kept: &mut LeanSnapshot) {
        self.keep_in(kept);
    }

    fn go_back(&mut self, kept: &LeanSnapshot) {
        self.go_back_to(kept);
    }

    fn lists_made(&self) -> u64 {
        self.near.made
    }
}
