//! The discs of the engine as they are stored, and as particles where somebody looks at them.

use super::block::BLOCK;
use super::block_pairs::Fixed;
use super::pairs::Interaction;
use super::phase::{Phase, Size};
use super::stepper::Engine;
use crate::particle::Particle;

impl<I: Interaction> Engine<I> {
    /// Makes these the discs as they are stored.
    pub(super) fn take_in(&mut self, particles: &[Particle]) {
        let size = |p: &Particle| Size { radius: p.radius, mass: p.mass };
        self.phases.clear();
        self.phases.extend(particles.iter().map(Phase::from));
        self.sizes.clear();
        self.sizes.extend(particles.iter().map(size));
        self.forces.clear();
        self.forces.extend(particles.iter().map(|p| p.force));
        let size = self.sizes.first().copied().unwrap_or_default();
        self.equal = self.sizes.iter().all(|other| *other == size).then_some(size);
        self.forget_copies();
    }

    /// The discs have changed: what was made of them for those who look is no more.
    pub(super) fn forget_copies(&mut self) {
        self.in_id_order.take();
        self.live.take();
        self.as_stored.take();
    }

    /// What of the discs stays the same during a sweep.
    pub(super) fn bodies(&self) -> Fixed<'_> {
        Fixed {
            sizes: &self.sizes,
            equal: self.equal,
            ids: &self.columns.ids,
            kinds: &self.columns.kinds,
        }
    }

    /// The disc stored at this place.
    pub(super) fn particle_at(&self, place: usize) -> Particle {
        self.phases[place].particle(self.sizes[place], self.forces[place])
    }

    /// The discs as they are stored.
    pub(super) fn particles_as_stored(&self) -> &[Particle] {
        self.as_stored
            .get_or_init(|| (0..self.phases.len()).map(|place| self.particle_at(place)).collect())
    }

    /// The discs in id order.
    pub(super) fn particles_by_id(&self) -> Vec<Particle> {
        self.places().iter().map(|&place| self.particle_at(place as usize)).collect()
    }

    /// Where the disc of each id is stored.
    pub(super) fn places(&self) -> &[u32] {
        self.places.get_or_init(|| {
            let mut places = vec![0; self.columns.ids.len()];
            for (place, &id) in (0..).zip(&self.columns.ids) {
                places[id as usize] = place;
            }
            places
        })
    }

    /// Changes every disc, by all threads.
    pub(super) fn change_each(&mut self, change: &(dyn Fn(u32, &mut Particle) + Sync)) {
        let Self { phases, sizes, forces, columns, workers, .. } = self;
        let fixed = sizes.chunks(BLOCK).zip(columns.ids.chunks(BLOCK));
        let all = phases.chunks_mut(BLOCK).zip(forces.chunks_mut(BLOCK)).zip(fixed);
        let mut all: Vec<_> = all.collect();
        workers.pieces(&mut all, |_, blocks| {
            let discs = blocks.iter_mut().flat_map(|((phases, forces), (sizes, ids))| {
                phases.iter_mut().zip(forces.iter_mut()).zip(sizes.iter().zip(*ids))
            });
            for ((phase, force), (size, id)) in discs {
                let mut disc = phase.particle(*size, *force);
                change(*id, &mut disc);
                *phase = Phase::from(&disc);
                *force = disc.force;
            }
        });
        self.forget_copies();
    }
}
