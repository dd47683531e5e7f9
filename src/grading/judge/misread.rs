//! How a film was written where it was not written as asked.

use glam::DVec2;

/// How a film was written instead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Misread {
    /// x, y and r stand in these columns, from 0.
    Columns([usize; 3]),
    /// All lengths are so many times what they are in m.
    Unit(f64),
    /// The lower left corner of the box is so far from the rubric's, m.
    Shifted(DVec2),
}
