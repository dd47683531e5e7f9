//! What a guard remembers.

use crate::analysis::energy::MechanicalEnergy;

/// What a guard knows of the past of its run, besides a good state: enough to go on guarding it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Memory {
    /// Energy at the start, J.
    pub start: MechanicalEnergy,
    /// What could move the discs at the start, J.
    pub movable: f64,
    /// Energy that had been supplied from outside at the start, J.
    pub supplied: f64,
    /// The step of the last look, if the energy had grown then.
    pub grown_at: Option<u64>,
}
