//! Sums over all discs: block by block, by all threads, added in the order of the blocks, so that they do
//! not depend on who did which.

use super::block::BLOCK;
use super::pairs::Interaction;
use super::pairs::by_id;
use super::stepper::Engine;
use crate::pair::PairLaw;
use crate::particle::{Contact, ContactLaw, Particle};
use crate::work::Sum;

impl<I: Interaction> Engine<I> {
    /// The sum of `quantity` over all discs.
    pub(super) fn sum_of_discs(&self, quantity: &(dyn Fn(&Particle) -> f64 + Sync)) -> f64 {
        self.sum_of_blocks(|block| {
            let end = ((block + 1) * BLOCK).min(self.phases.len());
            (block * BLOCK..end).map(|place| quantity(&self.particle_at(place))).sum()
        })
    }

    /// Energy stored in all pairs, at walls and in added forces, J.
    pub(super) fn energy_stored(&self) -> f64 {
        let far = self.list.far.iter().zip(0..);
        let far: f64 = far
            .map(|(pair, k)| {
                self.stored_in(pair.map(|place| place as usize), self.memory.far.get(k))
            })
            .sum();
        far + self.sum_of_blocks(|block| self.energy_stored_in(block)) + self.added.stored_energy
    }

    fn sum_of_blocks(&self, of_block: impl Fn(usize) -> f64 + Sync) -> f64 {
        let mut blocks = vec![0.0; self.phases.len().div_ceil(BLOCK)];
        self.workers.pieces(&mut blocks, |first, sums| {
            sums.iter_mut().zip(first..).for_each(|(sum, block)| *sum = of_block(block));
        });
        let mut total = Sum::default();
        blocks.iter().for_each(|sum| total.add(*sum));
        total.value()
    }

    /// Energy stored in the pairs of the discs of a block with walls and with discs ahead, J.
    fn energy_stored_in(&self, block: usize) -> f64 {
        let first = block * BLOCK;
        let mut stored = 0.0;
        for &place in self.list.at_wall_of(block) {
            let disc = self.particle_at(place as usize);
            let law = self.interaction.at_walls();
            for wall in &self.walls {
                let nearest = wall.nearest(disc.position, self.moment.of_forces());
                let mut seen = disc;
                seen.velocity -= nearest.velocity;
                let contact = Contact::with_wall(&seen, nearest.distance, nearest.normal);
                stored += contact.map_or(0.0, |contact| law.stored_energy(&contact));
            }
            for plane in &self.planes {
                let distance = plane.distance(disc.position);
                let contact = Contact::with_wall(&disc, distance, plane.normal);
                stored += contact.map_or(0.0, |contact| law.stored_energy(&contact));
            }
        }
        let numbers = self.list.pairs_of(block);
        for (pair, k) in self.list.distinct_pairs_of(block).iter().zip(numbers) {
            let places = pair.map(|at| first + usize::from(at));
            stored += self.stored_in(places, self.memory.near.get(k));
        }
        stored
    }

    /// Energy stored between the discs at these places, J.
    fn stored_in(&self, places: [usize; 2], memory: Option<&f64>) -> f64 {
        let fixed = self.bodies();
        let (mut bodies, _) = by_id(places.map(|place| fixed.body(place, &self.phases[place])));
        self.boundary.bring_near(&mut bodies);
        let forces = self.interaction.pairs().forces(&bodies, memory.copied().unwrap_or(0.0));
        forces.map_or(0.0, |forces| forces.stored_energy)
    }
}
