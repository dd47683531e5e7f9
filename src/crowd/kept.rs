//! What a crowd keeps of itself to come back to within a run: half of a [`Snapshot`].
//!
//! Radii and masses stay what they are, and springs' forces follow from where the discs are. Forces
//! follow too, unless velocities have changed since (velocity Verlet).

use glam::DVec2;

use super::motion::Move;
use super::near::Listed;
use super::{Crowd, LaneLaw};
use crate::discs::columns::Columns;
use crate::discs::{Discs, LeanSnapshot, Snapshot};
use crate::particle::Particle;

/// What the discs have done since the forces in them were added up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Since {
    /// Nothing.
    Still,
    /// Their velocities have changed.
    Kicked,
    /// More than that, or nobody knows what.
    Unknown,
}

impl Since {
    /// The same with `moves` after it.
    pub fn and_then(self, moves: &[Move]) -> Self {
        let is_kick = |to_do: &Move| matches!(to_do, Move::Kick(_));
        match self {
            _ if moves.is_empty() => self,
            Self::Still | Self::Kicked if moves.iter().all(is_kick) => Self::Kicked,
            _ => Self::Unknown,
        }
    }
}

/// A disc whose size was changed by hand, and what it was.
pub(super) struct Resized {
    id: u32,
    radius: f64, // m
    mass: f64,   // kg
}

impl Resized {
    /// The change of the disc `id`, if there was one.
    pub fn between(id: u32, was: &Particle, is: &Particle) -> Option<Self> {
        let Particle { radius, mass, .. } = *was;
        ((radius, mass) != (is.radius, is.mass)).then_some(Self { id, radius, mass })
    }
}

impl<L: LaneLaw + Clone + Sync + 'static> Crowd<L> {
    pub(super) fn keep_in(&self, kept: &mut LeanSnapshot) {
        let has_list = self.near.limit_squared >= 0.0;
        if self.since_forces == Since::Unknown || !has_list {
            *kept = LeanSnapshot::default(); // gone before the next is made
            kept.snapshot = self.remembered().copied();
            return;
        }
        let LeanSnapshot { snapshot, moving, forces, has_ledger, resized } = kept;
        if moving.is_empty() {
            *snapshot = Snapshot::default(); // a whole one
        }
        snapshot.columns.copy_from(self.remembered().columns, &["springs"]);
        *has_ledger = self.has_ledger();
        *resized = self.resized.len();
        moving.clear();
        moving.extend(self.particles.iter().map(|p| [p.position, p.velocity]));
        forces.clear();
        if self.since_forces == Since::Kicked {
            forces.extend(self.particles.iter().map(|p| p.force));
        }
    }

    pub(super) fn go_back_to(&mut self, kept: &LeanSnapshot) {
        let LeanSnapshot { snapshot, moving, forces, has_ledger, resized } = kept;
        if moving.is_empty() {
            return self.restore(snapshot);
        }
        self.moves.clear();
        self.forces_are_wanted = false;
        self.store_as(&snapshot.columns.ids);
        self.undo_resizing(*resized);
        for (disc, [position, velocity]) in self.particles.iter_mut().zip(moving) {
            (disc.position, disc.velocity) = (*position, *velocity);
        }
        self.columns.copy_from(snapshot.columns.view(), &["listed_at", "springs"]);
        let n = if *has_ledger { self.particles.len() } else { 0 };
        self.columns.springs.resize(n, DVec2::ZERO);
        self.restore_list(&snapshot.columns);
        self.forces_are_wanted = true;
        self.settle();
        if !forces.is_empty() {
            self.particles.iter_mut().zip(forces).for_each(|(disc, force)| disc.force = *force);
            self.since_forces = Since::Kicked;
        }
        self.columns.overlaps = snapshot.columns.overlaps;
        self.in_id_order.take();
        self.places.take();
    }

    /// Goes back to the list that these columns remember.
    pub(super) fn restore_list(&mut self, remembered: &Columns) {
        let Self { particles, columns: Columns { ids, .. }, planes, .. } = self;
        self.near.restore(remembered, Listed { particles, ids, planes }, &self.team);
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
        for Resized { id, radius, mass } in self.resized.drain(kept..).rev() {
            let disc = &mut self.particles[places[id as usize]];
            (disc.radius, disc.mass) = (radius, mass);
        }
    }
}
