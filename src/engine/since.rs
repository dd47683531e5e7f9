//! What has become of the discs since their forces were added up, and since the start.

use super::moves::Move;
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
    pub id: u32,
    pub radius: f64, // m
    pub mass: f64,   // kg
}

impl Resized {
    /// The change of the disc `id`, if there was one.
    pub fn between(id: u32, was: &Particle, is: &Particle) -> Option<Self> {
        let Particle { radius, mass, .. } = *was;
        ((radius, mass) != (is.radius, is.mass)).then_some(Self { id, radius, mass })
    }
}
