//! A crowd as a simulation sees it: discs in id order, with their books.

use glam::DVec2;

use super::kept::{Resized, Since};
use super::near::Listed;
use super::{Crowd, LaneLaw};
use crate::discs::{Discs, Kept, PlainDiscs, Remembered, Snapshot};
use crate::force::{Contacts, Force, Tally, Walls};
use crate::integrator::Motion;
use crate::neighbours::Neighbours;
use crate::particle::Particle;
use crate::work::{Works, kinetic_energy};

impl<L: LaneLaw + Clone + Sync + 'static> Discs for Crowd<L> {
    fn as_motion(&mut self) -> &mut dyn Motion {
        self
    }

    fn settle(&mut self) {
        self.carry_out(true);
    }

    fn particles(&self) -> &[Particle] {
        if self.ids.is_sorted() {
            return &self.particles;
        }
        self.in_id_order.get_or_init(|| (0..self.count()).map(|id| *self.particle(id)).collect())
    }

    fn particle(&self, id: usize) -> &Particle {
        let places = self.places.get_or_init(|| {
            let mut places = vec![0; self.ids.len()];
            for (place, &id) in (0..).zip(&self.ids) {
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

    fn tally(&self) -> &Tally {
        &self.tally
    }

    fn works(&self) -> Option<&Works> {
        self.works.as_ref()
    }

    fn keep_work_ledger(&mut self) {
        self.settle();
        self.springs = vec![DVec2::ZERO; self.particles.len()];
        self.works = Some(Works::default());
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
        if let Some(works) = &mut self.works {
            works.external.add(given);
        }
        for (disc, &id) in self.particles.iter_mut().zip(&self.ids) {
            let (was, is) = (&before[id as usize], after[id as usize]);
            self.resized.extend(Resized::between(id, was, &is));
            *disc = is;
        }
        self.near.forget();
        self.update_forces();
        self.settle();
        let lifted = self.potential_energy() - potential;
        if let Some(works) = &mut self.works {
            works.by_hand.add(lifted);
        }
    }

    fn with_force(mut self: Box<Self>, force: Box<dyn Force>) -> Box<dyn Discs> {
        self.restore_id_order();
        let Self { law, planes, gravity, particles, tally, works, .. } = *self;
        let walls: Box<dyn Force> = Box::new(Walls { law: law.clone(), planes });
        let contacts = Box::new(Contacts { law, neighbours: Neighbours::default() });
        let discs = PlainDiscs::new(particles, gravity, vec![walls, contacts]);
        Box::new(discs.with_books(tally, works)).with_force(force)
    }

    fn remembered(&self) -> Remembered<'_> {
        Remembered {
            particles: &self.particles,
            ids: &self.ids,
            tally: &self.tally,
            works: self.works.unwrap_or_default(),
            stored_energy: 0.0,
            springs: &self.springs,
            listed_at: &self.near.listed_at,
            skin: self.near.skin,
            limit_squared: self.near.limit_squared,
        }
    }

    fn restore(&mut self, snapshot: &Snapshot) {
        let Snapshot { particles, ids, tally, works, springs, .. } = snapshot;
        self.particles.clone_from(particles);
        self.ids.clone_from(ids);
        self.springs.clone_from(springs);
        self.tally = tally.clone();
        self.works = (!springs.is_empty()).then_some(*works);
        self.moves.clear();
        self.forces_are_wanted = false;
        self.in_id_order.take();
        self.places.take();
        self.since_forces = Since::Unknown;
        let Self { particles, ids, planes, .. } = self;
        self.near.restore(snapshot, Listed { particles, ids, planes }, &self.team);
    }

    fn keep(&self, kept: &mut Kept) {
        self.keep_in(kept);
    }

    fn go_back(&mut self, kept: &Kept) {
        self.go_back_to(kept);
    }

    fn lists_made(&self) -> u64 {
        self.near.made
    }
}
