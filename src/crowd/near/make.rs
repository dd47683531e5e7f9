//! The making of a list: pairs, who takes part in which, and in which order.

use std::mem::take;

use super::Near;
use crate::crowd::BLOCK;
use crate::crowd::cells::Cells;
use crate::crowd::team::Team;
use crate::discs::Snapshot;
use crate::force::HalfPlane;
use crate::neighbours::largest_radius;
use crate::particle::Particle;

/// Half of the spacing of numbers in [1, 2) that a reference position is kept in.
const REFERENCE_ROUNDING: f64 = f32::EPSILON as f64;

/// Blocks of discs for which one thread looks for pairs before all join what they have found, at most: so
/// that pairs do not lie in memory twice.
const BLOCKS_AT_A_TIME: usize = 64;

/// What a list is made of.
#[derive(Clone, Copy)]
pub(in crate::crowd) struct Listed<'a> {
    /// The discs as they are stored, and their ids.
    pub particles: &'a [Particle],
    pub ids: &'a [u32],
    pub planes: &'a [HalfPlane],
}

impl Near {
    /// A new list. `cells` tells where the discs, now stored cell by cell, lie; `skin` in m.
    pub fn make(&mut self, listed: Listed, cells: &Cells, skin: f64, team: &Team) {
        self.skin = skin;
        self.list_pairs(listed.particles, cells, skin, team);
        self.list_the_rest(listed, skin, team);
        self.refer_to(listed.particles);
        self.made += 1;
        self.is_there = true;
    }

    /// A list for discs to which `snapshot` goes back. They lie about where they were listed, so the skin
    /// is twice as wide; the next list is made at the same step as the first time.
    pub fn restore(&mut self, snapshot: &Snapshot, listed: Listed, team: &Team) {
        let Snapshot { listed_at, skin, limit_squared, .. } = snapshot;
        self.skin = *skin;
        self.limit_squared = *limit_squared;
        self.listed_at.clone_from(listed_at);
        self.list_anywhere(listed, team);
    }

    /// Lists discs that are not stored cell by cell, with a skin twice as wide, and refers to no new
    /// positions.
    pub fn list_anywhere(&mut self, listed: Listed, team: &Team) {
        let skin = 2.0 * self.skin;
        self.list_pairs_anywhere(listed, skin);
        self.list_the_rest(listed, skin, team);
        self.is_there = true;
    }

    fn list_the_rest(&mut self, listed: Listed, skin: f64, team: &Team) {
        let Listed { particles, ids, planes } = listed;
        self.list_parts(particles.len());
        self.order_parts(ids, team);
        self.pairs_at_a_time = self.most_pairs_at_a_time();
        self.place_parts_in_ring();
        self.count_places_from_blocks();
        let may_touch =
            |p: &Particle| planes.iter().any(|plane| plane.distance(p.position) < p.radius + skin);
        self.at_wall.clear();
        let places = (0..particles.len() as u32).zip(particles);
        self.at_wall.extend(places.filter(|(_, p)| may_touch(p)).map(|(place, _)| place));
    }

    fn list_pairs(&mut self, particles: &[Particle], cells: &Cells, skin: f64, team: &Team) {
        self.pairs.clear();
        self.first_pair.clear();
        let blocks = particles.len().div_ceil(BLOCK);
        let each = blocks.div_ceil(team.threads()).clamp(1, BLOCKS_AT_A_TIME);
        let mut found = vec![Vec::new(); team.threads() * each];
        for first in (0..blocks).step_by(found.len()) {
            let now = found.len().min(blocks - first);
            let shares = found[..now].chunks_mut(each).enumerate();
            let shares = shares.map(|(k, found)| (first + k * each, found)).collect();
            team.each(shares, |(first, found): (usize, &mut [Vec<_>])| {
                for (block, pairs) in (first..).zip(found) {
                    find_pairs(block, particles, cells, skin, pairs);
                }
            });
            for pairs in &found[..now] {
                self.first_pair.push(self.pairs.len() as u32);
                self.pairs.extend_from_slice(pairs);
            }
        }
        self.first_pair.push(self.pairs.len() as u32);
    }

    /// The pairs of discs that are not stored cell by cell.
    fn list_pairs_anywhere(&mut self, listed: Listed, skin: f64) {
        let Listed { particles, ids, .. } = listed;
        let mut cells = Cells::default();
        cells.lay_out(particles, |_| 2.0 * largest_radius(particles) + skin);
        let order = cells.order(particles, ids);
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

    /// From now on discs are held against their present positions.
    fn refer_to(&mut self, particles: &[Particle]) {
        self.listed_at.clear();
        self.listed_at.extend(particles.iter().map(|p| p.position.as_vec2().to_array()));
        let farthest = particles.iter().map(|p| p.position.abs().max_element()).fold(0.0, f64::max);
        // A little less than half the skin, for rounding, and what f32 takes off.
        let limit = 0.499 * self.skin - 2.0 * REFERENCE_ROUNDING * farthest;
        self.limit_squared = if limit > 0.0 { limit * limit } else { -1.0 };
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
            (*first, end) = (end, end + first.div_ceil(3).max(1));
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
    fn order_parts(&mut self, ids: &[u32], team: &Team) {
        let Self { pairs, first_triple, triples, reaches_back_to, .. } = self;
        let partner = |part: u32| ids[pairs[part as usize / 2][1 - part as usize % 2] as usize];
        let blocks = ids.len().div_ceil(BLOCK);
        reaches_back_to.clear();
        reaches_back_to.resize(blocks, u32::MAX);
        let each = blocks.div_ceil(team.threads()).max(1);
        let mut triples = &mut triples[..];
        let shares = reaches_back_to.chunks_mut(each).enumerate().map(|(k, reaches_back_to)| {
            let places = k * each * BLOCK..((k + 1) * each * BLOCK).min(ids.len());
            let ends = &first_triple[places.start..=places.end];
            let length = first_triple[places.end] - first_triple[places.start];
            let (mine, rest) = take(&mut triples).split_at_mut(length as usize);
            triples = rest;
            (ends, mine, reaches_back_to)
        });
        team.each(shares.collect(), |(ends, triples, reaches_back_to)| {
            order(ends, triples, reaches_back_to, partner);
        });
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
        let n = self.first_triple.len() - 1;
        for (block, &from) in self.reaches_back_to.iter().enumerate() {
            let places = [block * BLOCK, ((block + 1) * BLOCK).min(n)];
            let [start, end] = places.map(|place| self.first_triple[place] as usize);
            // The block's parts are at most once around the ring after this.
            let round = if from == u32::MAX { 0 } else { 2 * from / ring * ring };
            for part in self.triples[start..end].as_flattened_mut() {
                *part = match *part {
                    u32::MAX => ring,
                    part if part - round < ring => part - round,
                    part => part - round - ring,
                };
            }
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

    fn most_pairs_at_a_time(&self) -> usize {
        let ends = self.first_pair.iter().skip(1);
        let needed = ends.zip(&self.reaches_back_to).map(|(&end, &from)| end.saturating_sub(from));
        needed.max().unwrap_or(0).max(4) as usize // four are put there at a time
    }
}

/// The near pairs of the discs of a block with discs ahead of them.
fn find_pairs(
    block: usize,
    particles: &[Particle],
    cells: &Cells,
    skin: f64,
    pairs: &mut Vec<[u32; 2]>,
) {
    pairs.clear();
    let places = block * BLOCK..((block + 1) * BLOCK).min(particles.len());
    for (place, p) in places.clone().zip(&particles[places]) {
        let reach = p.radius + skin;
        for run in cells.ahead_of(place, p.position) {
            for (other, q) in run.clone().zip(&particles[run]) {
                let reach = reach + q.radius;
                if p.position.distance_squared(q.position) < reach * reach {
                    pairs.push([place as u32, other as u32]);
                }
            }
        }
    }
}

/// Puts the parts of some discs into ascending id of the `partner`, and finds the first pair of each
/// block. `ends` tells where the discs' parts begin in all triples; `triples` are those of them.
fn order(
    ends: &[u32],
    triples: &mut [[u32; 3]],
    reaches_back_to: &mut [u32],
    partner: impl Fn(u32) -> u32,
) {
    let mut by_partner = Vec::new();
    for (k, of_one) in ends.windows(2).enumerate() {
        let of_one = (of_one[0] - ends[0]) as usize..(of_one[1] - ends[0]) as usize;
        let parts = triples[of_one].as_flattened_mut();
        let there = parts.iter().position(|&part| part == u32::MAX).unwrap_or(parts.len());
        let parts = &mut parts[..there]; // none at the end
        if let Some(first) = parts.first() {
            let lowest = &mut reaches_back_to[k / BLOCK];
            *lowest = (*lowest).min(first / 2);
        }
        by_partner.clear();
        let keys = parts.iter().map(|&part| u64::from(partner(part)) << 32 | u64::from(part));
        by_partner.extend(keys);
        by_partner.sort_unstable();
        parts.iter_mut().zip(&by_partner).for_each(|(part, &key)| *part = key as u32);
    }
}
