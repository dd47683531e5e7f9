//! What discs remember, looked at where it lies.

use glam::DVec2;

use super::Snapshot;
use crate::force::Tally;
use crate::particle::Particle;
use crate::work::Works;

/// All that discs remember between two steps: a [`Snapshot`] that is not copied yet.
#[derive(Clone, Copy)]
pub struct Remembered<'a> {
    /// The discs, as they are stored.
    pub particles: &'a [Particle],
    /// Their ids; empty if they are stored in id order.
    pub ids: &'a [u32],
    /// Largest overlaps, and the contacts' shares if they are kept one by one.
    pub tally: &'a Tally,
    /// Works since the ledger was opened.
    pub works: Works,
    /// Energy stored in forces, J, if it is kept.
    pub stored_energy: f64,
    /// The springs' force on each disc as it is stored, N; empty where shares are kept.
    pub springs: &'a [DVec2],
    /// Where each disc, as it is stored, was when the present list of near pairs was made, m.
    pub listed_at: &'a [[f64; 2]],
    /// The skin of that list, m.
    pub skin: f64,
    /// The square of how far a disc may move before there is a new one, m2.
    pub limit_squared: f64,
}

impl Remembered<'_> {
    /// A copy, to come back to.
    pub fn copied(&self) -> Snapshot {
        Snapshot {
            particles: self.particles.to_vec(),
            ids: self.ids.to_vec(),
            tally: self.tally.clone(),
            works: self.works,
            stored_energy: self.stored_energy,
            springs: self.springs.to_vec(),
            listed_at: self.listed_at.to_vec(),
            skin: self.skin,
            limit_squared: self.limit_squared,
        }
    }
}

impl Snapshot {
    /// The same without a copy.
    pub fn remembered(&self) -> Remembered<'_> {
        Remembered {
            particles: &self.particles,
            ids: &self.ids,
            tally: &self.tally,
            works: self.works,
            stored_energy: self.stored_energy,
            springs: &self.springs,
            listed_at: &self.listed_at,
            skin: self.skin,
            limit_squared: self.limit_squared,
        }
    }
}
