//! Who may touch whom, for discs stored cell by cell.
//!
//! The list (Verlet 1967) holds every pair closer than touching plus a *skin* and stays good until
//! some disc has moved half a skin. Beside it stands, for each disc, in which of its pairs it takes
//! part, in ascending id of the partner: so its forces add up in one order, however the discs are
//! stored, listed or shared out.

use std::ops::Range;

use glam::DVec2;

use super::BLOCK;
use super::cells::Cells;
use crate::discs::Snapshot;
use crate::force::HalfPlane;
use crate::neighbours::largest_radius;
use crate::particle::Particle;

/// What a walk over one near pair costs in a step, over what making the list costs a disc. Measured
/// once; it decides the skin, and no result depends on it.
const COST_OF_PAIR: f64 = 0.028;

/// Bounds of the skin, in mean radii.
const SKIN: Range<f64> = 0.05..4.0;

/// Half of the spacing of numbers in [1, 2) that a reference position is kept in.
const REFERENCE_ROUNDING: f64 = f32::EPSILON as f64;

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
    /// The parts of each disc, by threes, so that a processor can guess how many there are: where in
    /// the ring of forces they lie, twice the number of the pair (in the ring) and one more if the disc
    /// is the second of the two; or at its end, where there is no force, to fill the last three.
    triples: Vec<[u32; 3]>,
    /// The first pair that discs of each block, or of one after it, take part in.
    pub reaches_back_to: Vec<u32>,
    /// One after the last place that pairs of each block, or of one before it, reach.
    reaches_ahead_to: Vec<u32>,
    /// Pairs that are still needed when those of a block have been walked, at most; a power of two.
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
    /// A new list. `cells` tells where the discs, now stored cell by cell, lie; `skin` in m.
    pub fn make(
        &mut self,
        particles: &[Particle],
        ids: &[u32],
        planes: &[HalfPlane],
        cells: &Cells,
        skin: f64,
    ) {
        self.skin = skin;
        self.list_pairs(particles, cells, skin);
        self.list_the_rest(particles, ids, planes, skin);
        self.refer_to(particles);
        self.made += 1;
        self.is_there = true;
    }

    /// A list for discs to which `snapshot` goes back. They lie about where they were listed, so the skin
    /// is twice as wide; the next list is made at the same step as the first time.
    pub fn restore(
        &mut self,
        snapshot: &Snapshot,
        particles: &[Particle],
        ids: &[u32],
        planes: &[HalfPlane],
    ) {
        let Snapshot { listed_at, skin, limit_squared, .. } = snapshot;
        self.skin = *skin;
        self.limit_squared = *limit_squared;
        self.listed_at.clone_from(listed_at);
        self.list_anywhere(particles, ids, planes);
    }

    /// Lists discs that are not stored cell by cell, with a skin twice as wide, and refers to no new
    /// positions.
    pub fn list_anywhere(&mut self, particles: &[Particle], ids: &[u32], planes: &[HalfPlane]) {
        let skin = 2.0 * self.skin;
        self.list_pairs_anywhere(particles, skin);
        self.list_the_rest(particles, ids, planes, skin);
        self.is_there = true;
    }

    fn list_the_rest(
        &mut self,
        particles: &[Particle],
        ids: &[u32],
        planes: &[HalfPlane],
        skin: f64,
    ) {
        self.list_parts(particles.len());
        self.order_parts(ids);
        self.pairs_at_a_time = self.most_pairs_at_a_time();
        self.place_parts_in_ring();
        self.count_places_from_blocks();
        let may_touch =
            |p: &Particle| planes.iter().any(|plane| plane.distance(p.position) < p.radius + skin);
        self.at_wall.clear();
        let places = (0..particles.len() as u32).zip(particles);
        self.at_wall.extend(places.filter(|(_, p)| may_touch(p)).map(|(place, _)| place));
    }

    /// The pairs of discs that are not stored cell by cell.
    fn list_pairs_anywhere(&mut self, particles: &[Particle], skin: f64) {
        let mut cells = Cells::default();
        cells.lay_out(particles, |_| 2.0 * largest_radius(particles) + skin);
        let order = cells.order(particles);
        self.pairs.clear();
        for (at, &place) in order.iter().enumerate() {
            let p = &particles[place as usize];
            for &other in cells.ahead_of(at, p.position).into_iter().flat_map(|run| &order[run]) {
                let q = &particles[other as usize];
                let reach = p.radius + q.radius + skin;
                if p.position.distance_squared(q.position) < reach * reach {
                    self.pairs.push([place.min(other), place.max(other)]);
                }
            }
        }
        self.pairs.sort_unstable();
        let starts = (0..particles.len()).step_by(BLOCK);
        let first =
            |place: usize| self.pairs.partition_point(|pair| (pair[0] as usize) < place) as u32;
        self.first_pair = starts.map(first).collect();
        self.first_pair.push(self.pairs.len() as u32);
    }

    /// Forgets the list: the next step makes a new one.
    pub fn forget(&mut self) {
        self.limit_squared = -1.0;
        self.is_there = false;
    }

    /// From now on discs are held against their present positions.
    fn refer_to(&mut self, particles: &[Particle]) {
        self.listed_at.clear();
        self.listed_at.extend(particles.iter().map(|p| p.position.as_vec2().to_array()));
        let farthest = particles.iter().map(|p| p.position.abs().max_element()).fold(0.0, f64::max);
        // A little less than half the skin, for rounding, and what f32 takes off.
        let limit = 0.499 * self.skin - 2.0 * REFERENCE_ROUNDING * farthest;
        self.limit_squared = if limit > 0.0 { limit * limit } else { -1.0 };
    }

    fn list_pairs(&mut self, particles: &[Particle], cells: &Cells, skin: f64) {
        self.pairs.clear();
        self.first_pair.clear();
        for (place, p) in particles.iter().enumerate() {
            if place % BLOCK == 0 {
                self.first_pair.push(self.pairs.len() as u32);
            }
            let reach = p.radius + skin;
            for run in cells.ahead_of(place, p.position) {
                for (other, q) in run.clone().zip(&particles[run]) {
                    let reach = reach + q.radius;
                    if p.position.distance_squared(q.position) < reach * reach {
                        self.pairs.push([place as u32, other as u32]);
                    }
                }
            }
        }
        self.first_pair.push(self.pairs.len() as u32);
    }

    /// Fills in who takes part in which pairs, in the order of the pairs.
    fn list_parts(&mut self, n: usize) {
        let first = &mut self.first_triple;
        first.clear();
        first.resize(n + 1, 0);
        for place in self.pairs.as_flattened() {
            first[*place as usize] += 1;
        }
        let mut end = 0;
        for first in first.iter_mut() {
            (*first, end) = (end, end + first.div_ceil(3));
        }
        let mut next: Vec<u32> = first.iter().map(|first| 3 * first).collect();
        self.triples.clear();
        self.triples.resize(end as usize, [u32::MAX; 3]);
        let parts = self.triples.as_flattened_mut();
        for (part, place) in (0..).zip(self.pairs.as_flattened()) {
            let next = &mut next[*place as usize];
            parts[*next as usize] = part;
            *next += 1;
        }
    }

    /// Puts every disc's parts into ascending id of the partner.
    fn order_parts(&mut self, ids: &[u32]) {
        let Self { pairs, first_triple, triples, reaches_back_to, .. } = self;
        reaches_back_to.clear();
        let partner = |part: u32| match part {
            u32::MAX => u32::MAX, // none: at the end
            _ => ids[pairs[part as usize / 2][1 - part as usize % 2] as usize],
        };
        let mut by_partner = Vec::new();
        for (place, ends) in first_triple.windows(2).enumerate() {
            let parts = triples[ends[0] as usize..ends[1] as usize].as_flattened_mut();
            if place % BLOCK == 0 {
                reaches_back_to.push(u32::MAX);
            }
            if let (Some(first), Some(lowest)) = (parts.first(), reaches_back_to.last_mut()) {
                *lowest = (*lowest).min(first / 2);
            }
            by_partner.clear();
            by_partner
                .extend(parts.iter().map(|&part| u64::from(partner(part)) << 32 | u64::from(part)));
            by_partner.sort_unstable();
            parts.iter_mut().zip(&by_partner).for_each(|(part, &key)| *part = key as u32);
        }
        // Whoever begins at a block has all later ones to do, too.
        let mut lowest = u32::MAX;
        for reach in reaches_back_to.iter_mut().rev() {
            lowest = lowest.min(*reach);
            *reach = lowest;
        }
    }

    /// Names parts by where in the ring they will lie.
    fn place_parts_in_ring(&mut self) {
        let ring = 2 * self.pairs_at_a_time as u32;
        for part in self.triples.as_flattened_mut() {
            *part = if *part == u32::MAX { ring } else { *part & (ring - 1) };
        }
    }

    fn count_places_from_blocks(&mut self) {
        self.reaches_ahead_to.clear();
        let mut end = 0;
        for block in 0..self.first_pair.len() - 1 {
            let (pairs, first) = (self.pairs_of(block), (block * BLOCK) as u32);
            for [a, b] in &mut self.pairs[pairs] {
                end = end.max(*b + 1);
                (*a, *b) = (*a - first, *b - first);
            }
            self.reaches_ahead_to.push(end);
        }
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

    fn most_pairs_at_a_time(&self) -> usize {
        let ends = self.first_pair.iter().skip(1);
        let needed = ends.zip(&self.reaches_back_to).map(|(&end, &from)| end.saturating_sub(from));
        (needed.max().unwrap_or(0) as usize + 1).next_power_of_two()
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
