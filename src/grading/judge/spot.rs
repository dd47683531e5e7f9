//! A disc in a frame.

use glam::DVec2;

/// A disc in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Centre, m.
    pub position: DVec2,
    /// Radius, m.
    pub radius: f64,
}
