//! The largest overlaps of a run, noted by those who compute contacts.

use crate::force::Tally;

/// The largest overlaps met so far.
#[derive(Clone, Default)]
pub(super) struct Largest {
    pub tally: Tally,
    /// An overlap over the smaller radius up to which there is nothing to note: a little less than
    /// the largest so far, for rounding, and never above 1, where centres may have met.
    pub notable: f64,
}

impl Largest {
    pub fn of(tally: &Tally) -> Self {
        let tally = Tally { shares: None, ..tally.clone() };
        let notable = tally.largest_pair_overlap.min(1.0) * (1.0 - 4.0 * f64::EPSILON);
        Self { tally, notable }
    }

    /// Takes the larger of both.
    pub fn join(&mut self, other: &Self) {
        let (mine, other) = (&mut self.tally, &other.tally);
        mine.largest_pair_overlap = mine.largest_pair_overlap.max(other.largest_pair_overlap);
        mine.largest_sinking = mine.largest_sinking.max(other.largest_sinking);
        mine.largest_wall_overlap = mine.largest_wall_overlap.max(other.largest_wall_overlap);
    }

    /// Notes an overlap, m, of discs of these radii, m.
    #[cold]
    pub fn note(&mut self, overlap: f64, radius: f64, other: f64) {
        if overlap > 0.0 {
            let relative_overlap = overlap / radius.min(other);
            self.tally.largest_pair_overlap = self.tally.largest_pair_overlap.max(relative_overlap);
            if relative_overlap > 1.0 {
                let sinking = overlap / (radius + other);
                self.tally.largest_sinking = self.tally.largest_sinking.max(sinking);
            }
            self.notable = Self::of(&self.tally).notable;
        }
    }
}
