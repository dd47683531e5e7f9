//! What the engine keeps of itself to come back to within a run: half of a [`Snapshot`].
//!
//! Radii and masses stay what they are, and springs' forces follow from where the discs are. Forces
//! follow too, unless velocities have changed since (velocity Verlet).

use glam::DVec2;

use super::moment::Moment;
use super::pairs::Interaction;
use super::phase::{Phase, Size};
use super::since::{Resized, Since};
use super::stepper::Engine;
use crate::discs::columns::Columns;
use crate::discs::{Discs, LeanSnapshot, Snapshot};

impl<I: Interaction> Engine<I> {
    pub(super) fn keep_in(&self, kept: &mut LeanSnapshot) {
        let has_list = self.list.limit_squared >= 0.0;
        if self.since_forces == Since::Unknown || !has_list {
            *kept = LeanSnapshot::default(); // gone before the next is made
            kept.snapshot = self.remembered().copied();
            return;
        }
        let LeanSnapshot { snapshot, moving, forces, has_ledger, resized } = kept;
        if moving.is_empty() {
            *snapshot = Snapshot::default(); // a whole one
        }
        snapshot.columns.copy_from(self.remembered_columns(), &["springs"]);
        *has_ledger = self.has_ledger();
        *resized = self.resized.len();
        moving.clear();
        moving.extend(self.phases.iter().map(|p| [p.position(), p.velocity()]));
        forces.clear();
        if self.since_forces == Since::Kicked {
            forces.extend_from_slice(&self.forces);
        }
    }

    pub(super) fn go_back_to(&mut self, kept: &LeanSnapshot) {
        let LeanSnapshot { snapshot, moving, forces, has_ledger, resized } = kept;
        if moving.is_empty() {
            return self.restore(snapshot);
        }
        self.moves.clear();
        self.forces_are_wanted = false;
        self.moment = Moment::of(snapshot.columns.times);
        self.store_as(&snapshot.columns.ids);
        self.undo_resizing(*resized);
        for (disc, &[position, velocity]) in self.phases.iter_mut().zip(moving) {
            *disc = Phase::new(position, velocity);
        }
        self.columns.copy_from(snapshot.columns.view(), &["reference_positions", "springs"]);
        let n = if *has_ledger { self.phases.len() } else { 0 };
        self.columns.springs.resize(n, DVec2::ZERO);
        self.restore_list(&snapshot.columns);
        self.forces_are_wanted = true;
        self.settle();
        if !forces.is_empty() {
            self.forces.clone_from(forces);
            self.since_forces = Since::Kicked;
        }
        self.columns.overlaps = snapshot.columns.overlaps;
        self.forget_copies();
        self.places.take();
    }

    /// Goes back to the list that these columns remember.
    pub(super) fn restore_list(&mut self, remembered: &Columns) {
        let ids = remembered.pair_ids.iter().copied();
        let live = ids.zip(remembered.pair_memory.iter().copied()).collect();
        self.list.clear_pairs();
        self.memory.remember(live);
        self.list_anywhere(|list, listed, workers| list.restore(remembered, listed, workers));
    }

    /// Stores the discs in the order of `ids`.
    fn store_as(&mut self, ids: &[u32]) {
        let mut places = vec![0; ids.len()];
        for (place, &id) in (0..).zip(&self.columns.ids) {
            places[id as usize] = place;
        }
        let mut order: Vec<u32> = ids.iter().map(|&id| places[id as usize]).collect();
        self.store(&mut order);
    }

    /// Takes back the changes of sizes after the first `kept`, the last first.
    fn undo_resizing(&mut self, kept: usize) {
        if self.resized.len() <= kept {
            return;
        }
        let mut places = vec![0; self.columns.ids.len()];
        for (place, &id) in self.columns.ids.iter().enumerate() {
            places[id as usize] = place;
        }
        self.equal = None;
        for Resized { id, radius, mass } in self.resized.drain(kept..).rev() {
            self.sizes[places[id as usize]] = Size { radius, mass };
        }
    }
}
