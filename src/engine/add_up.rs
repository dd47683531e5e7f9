//! How forces that are no contacts are added up.

use glam::DVec2;

use super::added::Start;
use super::pairs::Interaction;
use super::stepper::Engine;

impl<I: Interaction> Engine<I> {
    /// Has the added forces act on the discs, in id order and one after the other, from their weight on.
    pub(super) fn add_up_added(&mut self) {
        if self.added.forces.is_empty() && self.added.fields.is_empty() {
            return;
        }
        let time = self.moment.of_forces();
        let mut discs = self.particles_by_id();
        discs.iter_mut().for_each(|disc| disc.force = disc.mass * self.gravity);
        let mut springs = vec![DVec2::ZERO; discs.len()];
        self.added.stored_energy = 0.0;
        for field in &self.added.fields {
            for (id, (disc, spring)) in (0..).zip(discs.iter_mut().zip(&mut springs)) {
                let force = field.force(disc, id, time);
                disc.force += force;
                if let Some(energy) = field.stored_energy(disc, id, time) {
                    self.added.stored_energy += energy;
                    *spring += force;
                }
            }
        }
        for force in &mut self.added.forces {
            let before: Vec<_> = discs.iter().map(|disc| disc.force).collect();
            let stored_energy = force.apply(&mut discs);
            self.added.stored_energy += stored_energy;
            if stored_energy != 0.0 {
                let changed = discs.iter().zip(before).map(|(disc, before)| disc.force - before);
                springs.iter_mut().zip(changed).for_each(|(spring, change)| *spring += change);
            }
        }
        let start = |&id: &u32| {
            let (disc, spring) = (&discs[id as usize], springs[id as usize]);
            let field = disc.force - disc.mass * self.gravity - spring;
            Start { force: disc.force, spring, field }
        };
        self.added.starts = self.columns.ids.iter().map(start).collect();
    }
}
