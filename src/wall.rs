//! Walls: where they are, which way they face, and how they move.

use glam::DVec2;

use crate::force::HalfPlane;

/// The point of a wall that is nearest to a disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// How far the disc's centre is inside the wall, m; negative beyond it.
    pub distance: f64,
    /// Unit vector from the disc to the wall.
    pub normal: DVec2,
    /// Velocity of that point of the wall, m/s.
    pub velocity: DVec2,
}

/// A wall, at rest or moving as it is told to: a body of infinite mass.
///
/// A pure function of place and time, so that any thread may ask and a run that goes back finds it where it was.
pub trait Wall: Send + Sync {
    /// The point nearest to `point` (m) at `time` (s).
    fn nearest(&self, point: DVec2, time: f64) -> Nearest;

    /// The highest speed of any point of it, m/s.
    fn top_speed(&self) -> f64 {
        0.0
    }
}

impl Wall for HalfPlane {
    fn nearest(&self, point: DVec2, _time: f64) -> Nearest {
        Nearest { distance: self.distance(point), normal: self.normal, velocity: DVec2::ZERO }
    }
}
