//! The largest overlaps of a run, which contacts report beside the forces they give.

/// The largest overlaps so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Overlaps {
    /// Of two discs, as a fraction of the smaller radius.
    pub largest_pair_overlap: f64,
    /// The same as a fraction of the sum of the radii, where it is more than the smaller radius: 1
    /// once centres meet.
    pub largest_sinking: f64,
    /// With a wall, as a fraction of the radius.
    pub largest_wall_overlap: f64,
}

impl Overlaps {
    /// Notes an `overlap` (m) of two discs of these radii (m).
    pub fn note_pair(&mut self, overlap: f64, radius: f64, other: f64) {
        let relative_overlap = overlap / radius.min(other);
        self.largest_pair_overlap = self.largest_pair_overlap.max(relative_overlap);
        if relative_overlap > 1.0 {
            self.largest_sinking = self.largest_sinking.max(overlap / (radius + other));
        }
    }

    /// Notes an `overlap` (m) of a disc of this radius (m) with a wall.
    pub fn note_wall(&mut self, overlap: f64, radius: f64) {
        self.largest_wall_overlap = self.largest_wall_overlap.max(overlap / radius);
    }
}
