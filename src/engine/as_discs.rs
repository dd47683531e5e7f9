//! The engine as a simulation sees it: discs in id order, with their books.

use std::any::Any;

use glam::DVec2;

use super::moment::Moment;
use super::neighbour_list::NeighbourList;
use super::pairs::Interaction;
use super::since::{Resized, Since};
use super::stepper::Engine;
use crate::discs::columns::ColumnsView;
use crate::discs::overlaps::Overlaps;
use crate::discs::{Discs, LeanSnapshot, Remembered, Snapshot};
use crate::force::Force;
use crate::integrator::Motion;
use crate::particle::Particle;
use crate::work::{Channel, Works, kinetic_energy};

impl<I: Interaction> Discs for Engine<I> {
    fn as_motion(&mut self) -> &mut dyn Motion {
        self
    }

    fn settle(&mut self) {
        self.carry_out(true);
    }

    fn particles(&self) -> &[Particle] {
        self.in_id_order.get_or_init(|| self.particles_by_id())
    }

    fn particle(&self, id: usize) -> Particle {
        self.particle_at(self.places()[id] as usize)
    }

    fn count(&self) -> usize {
        self.phases.len()
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

    fn set_gravity(&mut self, gravity: DVec2) {
        self.give(|engine| {
            let before = std::mem::replace(&mut engine.gravity, gravity + DVec2::ZERO); // no -0.0, as at first
            before != gravity
        });
    }

    fn set_law(&mut self, law: &mut dyn Any) {
        self.give(|engine| engine.interaction.take_law(law));
    }

    fn has_ledger(&self) -> bool {
        !self.columns.springs.is_empty()
    }

    fn overlaps(&self) -> Overlaps {
        self.columns.overlaps
    }

    fn works(&self) -> &Works {
        &self.columns.works
    }

    fn keep_work_ledger(&mut self) {
        self.settle();
        self.columns.springs = vec![DVec2::ZERO; self.phases.len()];
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
        for &id in &self.columns.ids {
            let (was, is) = (&before[id as usize], &after[id as usize]);
            self.resized.extend(Resized::between(id, was, is));
        }
        let stored: Vec<_> = self.columns.ids.iter().map(|&id| after[id as usize]).collect();
        self.take_in(&stored);
        self.forget_list();
        self.update_forces();
        self.settle();
        let lifted = self.potential_energy() - potential;
        self.columns.works[Channel::Hand].beside.add(lifted);
    }

    fn add_force(&mut self, force: Box<dyn Force>) {
        self.give(|engine| {
            engine.added.forces.push(force);
            if !engine.has_ledger() {
                engine.columns.springs = vec![DVec2::ZERO; engine.phases.len()]; // so that what it supplies is known
            }
            true
        });
    }

    fn insert(&mut self, disc: Particle) {
        self.change_number(|discs, kinds| {
            discs.push(disc);
            if !kinds.is_empty() {
                kinds.push(0);
            }
            (disc.kinetic_energy(), None)
        });
    }

    fn remove(&mut self, id: usize) -> Particle {
        let disc = self.particle(id);
        self.change_number(|discs, kinds| {
            discs.remove(id);
            if !kinds.is_empty() {
                kinds.remove(id);
            }
            (-disc.kinetic_energy(), Some(id as u32))
        });
        disc
    }

    fn begin_step(&mut self, from: f64, to: f64) {
        self.moment.begin_step(from, to);
    }

    fn end_step(&mut self, dt: f64) {
        if !self.added.forces.is_empty() {
            self.settle(); // what they remember is of this step's forces
            self.added.forces.iter_mut().for_each(|force| force.end_step(dt));
        }
    }

    fn remembered(&self) -> Remembered<'_> {
        let columns = self.remembered_columns();
        Remembered { particles: self.particles_as_stored(), columns }
    }

    fn restore(&mut self, snapshot: &Snapshot) {
        self.take_in(&snapshot.particles);
        self.columns.copy_from(snapshot.columns.view(), &["reference_positions"]);
        self.moves.clear();
        self.forces_are_wanted = false;
        self.elapsed = 0.0;
        self.moment = Moment::of(snapshot.columns.times);
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
        self.list.made
    }
}

impl<I: Interaction> Engine<I> {
    /// Has `change` alter what pushes the discs, and books the energy that they have by it as given by hand; nothing if it says
    /// that it did not.
    fn give(&mut self, change: impl FnOnce(&mut Self) -> bool) {
        self.settle();
        let potential = self.potential_energy();
        if !change(self) {
            return;
        }
        self.update_forces();
        self.settle();
        let brought = self.potential_energy() - potential;
        self.columns.works[Channel::Hand].beside.add(brought);
    }

    /// Has `change` add or remove discs in id order, with their kinds if they have some, and books the energies that come
    /// with them. It tells the kinetic one, J, and which id is gone, if one is.
    fn change_number(
        &mut self,
        change: impl FnOnce(&mut Vec<Particle>, &mut Vec<u32>) -> (f64, Option<u32>),
    ) {
        self.settle();
        let potential = self.potential_energy();
        let mut discs = self.particles_by_id();
        let of_id = |place: &u32| self.columns.kinds.get(*place as usize).copied();
        let mut kinds: Vec<u32> = self.places().iter().filter_map(of_id).collect();
        let mut live = self.memory.live(&self.list, &self.columns.ids);
        let (kinetic, gone) = change(&mut discs, &mut kinds);
        if let Some(gone) = gone {
            live.retain(|(ids, _)| !ids.contains(&gone));
            let down = |id: u32| id - u32::from(id > gone);
            live.iter_mut().for_each(|(ids, _)| *ids = ids.map(down));
        }
        let n = discs.len();
        self.columns.ids = (0..n as u32).collect();
        self.columns.kinds = kinds;
        self.columns.springs.resize(if self.has_ledger() { n } else { 0 }, DVec2::ZERO);
        self.resized.clear();
        self.take_in(&discs);
        self.places.take();
        self.list.clear();
        self.memory.remember(live);
        self.start_anew();
        let brought = self.potential_energy() - potential;
        let inflow = &mut self.columns.works[Channel::Inflow];
        inflow.work.add(kinetic);
        inflow.beside.add(brought);
    }

    /// What is remembered beside the discs, where it lies.
    pub(super) fn remembered_columns(&self) -> ColumnsView<'_> {
        let NeighbourList { reference_positions, skin, limit_squared, .. } = &self.list;
        let (pair_ids, pair_memory) = self
            .live
            .get_or_init(|| self.memory.live(&self.list, &self.columns.ids).into_iter().unzip());
        let (list, times) = ([*skin, *limit_squared], self.moment.times());
        ColumnsView {
            reference_positions,
            list,
            times,
            pair_ids,
            pair_memory,
            ..self.columns.view()
        }
    }
}
