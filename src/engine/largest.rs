//! The largest overlaps of a run, noted by those who compute contacts.

use crate::discs::overlaps::Overlaps;

/// The largest overlaps met so far.
#[derive(Clone, Default)]
pub(super) struct Largest {
    pub overlaps: Overlaps,
    /// An overlap over the smaller radius up to which there is nothing to note: a little less than
    /// the largest so far, for rounding, and never above 1, where centres may have met.
    pub notable: f64,
}

impl Largest {
    pub fn of(overlaps: Overlaps) -> Self {
        let notable = overlaps.largest_pair_overlap.min(1.0) * (1.0 - 4.0 * f64::EPSILON);
        Self { overlaps, notable }
    }

    /// Takes the larger of both.
    pub fn join(&mut self, other: &Self) {
        let (mine, other) = (&mut self.overlaps, &other.overlaps);
        mine.largest_pair_overlap = mine.largest_pair_overlap.max(other.largest_pair_overlap);
        mine.largest_sinking = mine.largest_sinking.max(other.largest_sinking);
        mine.largest_wall_overlap = mine.largest_wall_overlap.max(other.largest_wall_overlap);
    }

    /// Notes an overlap, m, of discs of these radii, m.
    #[cold]
    pub fn note(&mut self, overlap: f64, radius: f64, other: f64) {
        if overlap > 0.0 {
            self.overlaps.note_pair(overlap, radius, other);
            self.notable = Self::of(self.overlaps).notable;
        }
    }
}
