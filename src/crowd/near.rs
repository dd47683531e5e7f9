//! Who may touch whom, for discs stored cell by cell.
//!
//! The list (Verlet 1967) holds every pair closer than touching plus a *skin* and stays good until
//! some disc has moved half a skin. Beside it stands, for each disc, in which of its pairs it takes
//! part, in ascending id of the partner: so its forces add up in one order, however the discs are
//! stored, listed or shared out.

mod make;

use std::ops::Range;

use glam::DVec2;

pub(super) use self::make::Listed;
use super::BLOCK;

/// What a walk over one near pair costs in a step, over what making the list costs a disc. Measured
/// once; it decides the skin, and no result depends on it.
const COST_OF_PAIR: f64 = 0.028;

/// Bounds of the skin, in mean radii.
const SKIN: Range<f64> = 0.05..4.0;

/// Near pairs of discs stored cell by cell, and what a pass over them needs.
#[derive(Default)]
pub(super) struct Near {
    /// Places (in storage) of two discs that may touch, the lower first; ascending. Places are counted
    /// from the first disc of the block of the lower.
    pub pairs: Vec<[u32; 2]>,
    /// Where in `pairs` those of each block of discs begin, by their first disc.
    first_pair: Vec<u32>,
    /// For each disc, where in `triples` its parts begin.
    first_triple: Vec<u32>,
    /// The parts of each disc, by threes and three at least, so that a processor can guess how many there are: where in
    /// the ring of forces they lie, twice the number of the pair (in the ring) and one more if the disc
    /// is the second of the two; or at its end, where there is no force, to fill the last three.
    triples: Vec<[u32; 3]>,
    /// The first pair that discs of each block, or of one after it, take part in.
    pub reaches_back_to: Vec<u32>,
    /// One after the last place that pairs of each block, or of one before it, reach.
    reaches_ahead_to: Vec<u32>,
    /// Pairs that are still needed when those of a block have been walked, at most: the ring's length.
    pub pairs_at_a_time: usize,
    /// Places of the discs that may touch a wall, ascending.
    pub at_wall: Vec<u32>,
    /// Where each disc was when the list was made, m.
    pub listed_at: Vec<[f32; 2]>,
    /// The skin, m.
    pub skin: f64,
    /// The square of how far a disc may move before the list is bad, m2; negative if it is to be
    /// renewed in any case.
    pub limit_squared: f64,
    /// Whether the list is good for the discs as they are stored.
    pub is_there: bool,
    /// Lists made so far.
    pub made: u64,
}

impl Near {
    /// Forgets the list: the next step makes a new one.
    pub fn forget(&mut self) {
        self.limit_squared = -1.0;
        self.is_there = false;
    }

    /// Which of the `pairs` are those of a block.
    pub fn pairs_of(&self, block: usize) -> Range<usize> {
        self.first_pair[block] as usize..self.first_pair[block + 1] as usize
    }

    /// The discs that are looked at both by those who serve the blocks up to `block` and by those who begin
    /// there: the first block, and all their places.
    pub fn seam_at(&self, block: usize) -> (usize, Range<usize>) {
        let middle = block * BLOCK;
        let back = self.first_pair.partition_point(|&first| first <= self.reaches_back_to[block]);
        let ahead = &self.reaches_ahead_to[..block];
        let ahead_from = ahead.partition_point(|&end| end as usize <= middle);
        let end = ahead.last().map_or(0, |&end| end as usize).max(middle);
        let first_block = back.saturating_sub(1).min(ahead_from);
        (first_block, first_block * BLOCK..end)
    }

    /// The parts of each of the discs at `places`.
    pub fn triples_of(&self, places: Range<usize>) -> impl Iterator<Item = &[[u32; 3]]> + Clone {
        let ends = self.first_triple[places.start..=places.end].windows(2);
        ends.map(|ends| &self.triples[ends[0] as usize..ends[1] as usize])
    }

    /// The discs near walls among `places`.
    pub fn at_wall_among(&self, places: &Range<usize>) -> &[u32] {
        let first = self.at_wall.partition_point(|&place| (place as usize) < places.start);
        let rest = &self.at_wall[first..];
        &rest[..rest.partition_point(|&place| (place as usize) < places.end)]
    }
}

/// The skin, m, at which walking the list and making it cost least together, for discs of mean radius
/// `radius` (m) that cover the fraction `density` of their ground and of which the fastest goes
/// `travel` m a step.
///
/// A disc has about density (2 + u)²/2 near pairs with a skin of u radii, and the list lasts
/// u radius / (2 travel) steps. The sum of the two costs is least where
/// c density (2 + u) u² = 2 travel / radius, c the cost of a pair over that of making a list.
pub(super) fn best_skin(radius: f64, density: f64, travel: f64) -> f64 {
    let wanted = 2.0 * travel / radius;
    let excess = |u: f64| COST_OF_PAIR * density * (2.0 + u) * u * u - wanted;
    let (mut low, mut high) = (SKIN.start, SKIN.end);
    for _ in 0..30 {
        let middle = 0.5 * (low + high);
        if excess(middle) < 0.0 { low = middle } else { high = middle }
    }
    radius * 0.5 * (low + high)
}

/// A position as it is kept for reference, m.
pub(super) fn reference(listed_at: [f32; 2]) -> DVec2 {
    DVec2::new(f64::from(listed_at[0]), f64::from(listed_at[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_skin_is_the_one_of_least_cost() {
        // What a step costs with a skin of u radii, in lists: pairs walked, and lists made.
        let (density, per_step) = (0.8, 1e-3);
        let cost =
            |u: f64| 0.5 * COST_OF_PAIR * density * (2.0 + u) * (2.0 + u) + 2.0 * per_step / u;
        let best = best_skin(1e-4, density, per_step * 1e-4) / 1e-4;
        // A parabola at its bottom: a hundredth to either side costs more.
        assert!(cost(best) < cost(0.99 * best) && cost(best) < cost(1.01 * best), "{best}");
    }

    #[test]
    fn the_skin_keeps_to_its_bounds_at_rest_and_at_any_speed() {
        for (travel, bound) in [(0.0, SKIN.start), (1e3, SKIN.end)] {
            let skin = best_skin(2.0, 0.8, travel);
            assert!((skin / (2.0 * bound) - 1.0).abs() < 1e-6, "{skin}"); // 30 halvings
        }
    }
}
