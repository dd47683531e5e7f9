//! What of a disc changes in every step, as a pass over all discs reads and writes it.

use glam::DVec2;

use crate::particle::Particle;

/// Position (m) and velocity (m/s) of a disc, a point of its phase space: x, y, vx, vy in 32 bytes, two discs in a cache line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(32))]
pub struct Phase(pub [f64; 4]);

impl Phase {
    /// That of a disc at this `position` (m) with this `velocity` (m/s).
    pub fn new(position: DVec2, velocity: DVec2) -> Self {
        Self([position.x, position.y, velocity.x, velocity.y])
    }

    /// Position of the centre, m.
    #[inline(always)]
    pub fn position(&self) -> DVec2 {
        DVec2::new(self.0[0], self.0[1])
    }

    /// Velocity of the centre, m/s.
    #[inline(always)]
    pub fn velocity(&self) -> DVec2 {
        DVec2::new(self.0[2], self.0[3])
    }

    /// The disc of this size with this force (N) on it.
    #[inline(always)]
    pub fn particle(&self, Size { radius, mass }: Size, force: DVec2) -> Particle {
        Particle { position: self.position(), velocity: self.velocity(), force, radius, mass }
    }
}

impl From<&Particle> for Phase {
    fn from(disc: &Particle) -> Self {
        Self::new(disc.position, disc.velocity)
    }
}

/// Radius and mass of a disc: what stays the same from step to step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Size {
    /// Radius, m.
    pub radius: f64,
    /// Mass, kg.
    pub mass: f64,
}
