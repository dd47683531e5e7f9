//! Sums over all discs: block by block, by all threads, added in the order of the blocks, so that they do
//! not depend on who did which.

use super::{BLOCK, Crowd, LaneLaw};
use crate::particle::{Contact, Particle};
use crate::work::Sum;

impl<L: LaneLaw + Sync> Crowd<L> {
    /// The sum of `quantity` over all discs.
    pub(super) fn sum_of_discs(&self, quantity: &(dyn Fn(&Particle) -> f64 + Sync)) -> f64 {
        self.sum_of_blocks(|block| {
            let rest = &self.particles[block * BLOCK..];
            rest[..rest.len().min(BLOCK)].iter().map(quantity).sum()
        })
    }

    /// Energy stored in all contacts, J.
    pub(super) fn energy_stored(&self) -> f64 {
        let at = |place: u32| &self.particles[place as usize];
        let contacts = self.near.far.iter().filter_map(|&[a, b]| Contact::between(at(a), at(b)));
        let far: f64 = contacts.map(|contact| self.law.stored_energy(&contact)).sum();
        far + self.sum_of_blocks(|block| self.energy_stored_in(block))
    }

    fn sum_of_blocks(&self, of_block: impl Fn(usize) -> f64 + Sync) -> f64 {
        let mut blocks = vec![0.0; self.particles.len().div_ceil(BLOCK)];
        self.team.pieces(&mut blocks, |first, sums| {
            sums.iter_mut().zip(first..).for_each(|(sum, block)| *sum = of_block(block));
        });
        let mut total = Sum::default();
        blocks.iter().for_each(|sum| total.add(*sum));
        total.value()
    }

    /// Energy stored in the contacts of the discs of a block with walls and with discs ahead, J.
    fn energy_stored_in(&self, block: usize) -> f64 {
        let ahead = &self.particles[block * BLOCK..];
        let first = block * BLOCK;
        let places = first..(first + BLOCK).min(self.particles.len());
        let mut stored = 0.0;
        for &place in self.near.at_wall_among(&places) {
            let disc = &self.particles[place as usize];
            for plane in &self.planes {
                let distance = plane.distance(disc.position);
                if let Some(contact) = Contact::with_wall(disc, distance, plane.normal) {
                    stored += self.law.stored_energy(&contact);
                }
            }
        }
        for &[a, b] in self.near.distinct_pairs_of(block) {
            if let Some(contact) = Contact::between(&ahead[a as usize], &ahead[b as usize]) {
                stored += self.law.stored_energy(&contact);
            }
        }
        stored
    }
}
