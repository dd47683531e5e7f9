//! What pushes the discs beside their weight and contacts: forces of your own, and where walls stand.

use glam::DVec2;

use crate::particle::Particle;

/// Something that pushes discs: a force of your own. Weight and contacts are there already.
pub trait Force: Send + Sync {
    /// Adds this force (N) to [`force`](Particle::force) of every disc it acts on and returns the energy it stores, J.
    ///
    /// A force that returns 0 stores nothing: what it does is booked as supplied from outside (taken, if it is drag).
    /// One that returns what it stores must do nothing else: of a spring with drag make two, or return 0.
    fn apply(&mut self, particles: &mut [Particle]) -> f64;

    /// Moves what the force itself remembers past a completed step of `dt` s.
    fn end_step(&mut self, _dt: f64) {}
}

/// A wall: everything beyond a straight line. A centre beyond it is still pushed back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfPlane {
    /// A point on the line.
    pub point: DVec2, // m
    /// Unit vector n_ib from the inside to the wall.
    pub normal: DVec2,
}

impl HalfPlane {
    /// Left, right, lower and upper wall of the square from the origin to (`side`, `side`), m.
    pub fn square(side: f64) -> [Self; 4] {
        let low = DVec2::ZERO;
        let high = DVec2::splat(side);
        [(low, DVec2::NEG_X), (high, DVec2::X), (low, DVec2::NEG_Y), (high, DVec2::Y)]
            .map(|(point, normal)| Self { point, normal })
    }

    /// How far `position` (m) is inside the wall's line, m; negative beyond it.
    #[inline]
    pub fn distance(&self, position: DVec2) -> f64 {
        (self.point - position).dot(self.normal)
    }
}
