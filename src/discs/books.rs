//! What contacts and added forces report beside the forces they give, where discs are stepped the plain way: largest
//! overlaps, energy stored, and each disc's share of springs and dashpots for the ledger.

use glam::DVec2;

use super::columns::Columns;
use crate::force::Force;
use crate::particle::{Contact, ContactLaw, Particle};
use crate::work::Share;

/// Where `stored` keeps what walls, pairs, and added forces store.
const WALLS: usize = 0;
const PAIRS: usize = 1;
const ADDED: usize = 2;

impl Columns {
    /// Before forces are added up anew: what is stored and shared belongs to one state, overlaps to the whole run.
    pub fn begin_forces(&mut self) {
        self.shares.fill(Share::default());
        self.stored = [0.0; 3];
    }

    /// Has `force` act on `particles`. If it stores energy, what it does is booked as a spring's; else it is nobody's
    /// share, and supplied from outside.
    pub fn add_force(&mut self, force: &mut dyn Force, particles: &mut [Particle]) {
        let before: Vec<DVec2> = match self.shares.is_empty() {
            false => particles.iter().map(|disc| disc.force).collect(),
            true => Vec::new(),
        };
        let stored_energy = force.apply(particles);
        self.stored[ADDED] += stored_energy;
        if stored_energy != 0.0 {
            for ((share, disc), before) in self.shares.iter_mut().zip(particles).zip(before) {
                share.spring += disc.force - before;
            }
        }
    }

    /// Books the contact of `disc`, number `i`, with a wall, which pushes it by `push` (N).
    pub fn touch_wall(
        &mut self,
        (i, disc): (usize, &Particle),
        contact: &Contact,
        law: &impl ContactLaw,
        push: f64,
    ) {
        self.stored[WALLS] += law.stored_energy(contact);
        self.overlaps.note_wall(contact.overlap, disc.radius);
        if !self.shares.is_empty() {
            self.shares[i] -= Share::of(contact, law.spring(contact), push);
        }
    }

    /// Books the contact of discs number `i` and `j` of all `discs`, which pushes them by `push` (N).
    pub fn touch_pair(
        &mut self,
        (i, j, discs): (usize, usize, &[Particle]),
        contact: &Contact,
        law: &impl ContactLaw,
        push: f64,
    ) {
        self.stored[PAIRS] += law.stored_energy(contact);
        self.overlaps.note_pair(contact.overlap, discs[i].radius, discs[j].radius);
        if !self.shares.is_empty() {
            let share = Share::of(contact, law.spring(contact), push);
            self.shares[i] -= share;
            self.shares[j] += share;
        }
    }

    /// Energy stored at walls, in pairs, and by added forces, J.
    pub fn stored_energy(&self) -> f64 {
        self.stored[WALLS] + self.stored[PAIRS] + self.stored[ADDED]
    }
}
