//! The making of a list: pairs, and discs near walls. Who takes part in which pairs: [`parts`].

mod parts;

use std::mem::take;

use super::Near;
use crate::crowd::BLOCK;
use crate::crowd::cells::Cells;
use crate::crowd::sizes::Sizes;
use crate::crowd::team::Team;
use crate::discs::columns::Columns;
use crate::force::HalfPlane;
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
    /// A new list. `cells` tells where the discs, of these `sizes` and now stored cell by cell, lie;
    /// `skin` in m.
    pub fn make(&mut self, listed: Listed, cells: &Cells, sizes: &Sizes, skin: f64, team: &Team) {
        self.skin = skin;
        self.list_pairs(listed.particles, cells, skin, team);
        self.list_the_rest(listed, skin, team);
        self.refer_to(listed.particles, sizes, team);
        self.made += 1;
        self.is_there = true;
    }

    /// A list for discs that go back to what is `remembered`. They lie about where they were listed, so the skin
    /// is twice as wide; the next list is made at the same step as the first time.
    pub fn restore(&mut self, remembered: &Columns, listed: Listed, team: &Team) {
        let Columns { listed_at, list, .. } = remembered;
        [self.skin, self.limit_squared] = *list;
        self.listed_at.clone_from(listed_at);
        self.list_anywhere(listed, team);
    }

    /// Lists discs that are not stored cell by cell, with a skin twice as wide, and refers to no new
    /// positions.
    pub fn list_anywhere(&mut self, listed: Listed, team: &Team) {
        let skin = 2.0 * self.skin;
        self.list_pairs_anywhere(listed, skin, team);
        self.list_the_rest(listed, skin, team);
        self.is_there = true;
    }

    fn list_the_rest(&mut self, listed: Listed, skin: f64, team: &Team) {
        self.count_places_from_blocks(team);
        self.list_parts(listed.ids, team);
        self.list_at_wall(listed, skin, team);
    }

    fn list_at_wall(&mut self, listed: Listed, skin: f64, team: &Team) {
        let Listed { particles, planes, .. } = listed;
        let may_touch =
            |p: &Particle| planes.iter().any(|plane| plane.distance(p.position) < p.radius + skin);
        let mut blocks = vec![Vec::new(); particles.len().div_ceil(BLOCK)];
        team.pieces(&mut blocks, |first, blocks| {
            let mut places = (first * BLOCK) as u32..;
            for (block, discs) in blocks.iter_mut().zip(particles[first * BLOCK..].chunks(BLOCK)) {
                let near = discs.iter().zip(&mut places).filter(|(p, _)| may_touch(p));
                block.extend(near.map(|(_, place)| place));
            }
        });
        self.at_wall.clear();
        blocks.iter().for_each(|block| self.at_wall.extend_from_slice(block));
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
    fn list_pairs_anywhere(&mut self, listed: Listed, skin: f64, team: &Team) {
        let Listed { particles, ids, .. } = listed;
        let (sizes, mut cells) = (Sizes::of(particles, team), Cells::default());
        cells.lay_out(particles, &sizes, |_| 2.0 * sizes.largest_radius + skin);
        let order = cells.order(particles, ids, team);
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
    fn refer_to(&mut self, particles: &[Particle], sizes: &Sizes, team: &Team) {
        self.listed_at.resize(particles.len(), [0.0; 2]);
        team.pieces(&mut self.listed_at, |first, listed_at| {
            let discs = &particles[first..];
            listed_at
                .iter_mut()
                .zip(discs)
                .for_each(|(here, p)| *here = p.position.as_vec2().to_array());
        });
        // A little less than half the skin, for rounding, and what f32 takes off.
        let limit = 0.499 * self.skin - 2.0 * REFERENCE_ROUNDING * sizes.farthest;
        self.limit_squared = if limit > 0.0 { limit * limit } else { -1.0 };
    }

    /// Counts the places in pairs from the first disc of the block of the lower, and finds how far blocks
    /// reach ahead.
    fn count_places_from_blocks(&mut self, team: &Team) {
        let blocks = self.first_pair.len() - 1;
        self.reaches_ahead_to.clear();
        self.reaches_ahead_to.resize(blocks, 0);
        let each = blocks.div_ceil(team.threads()).max(1);
        let (mut pairs, first_pair) = (&mut self.pairs[..], &self.first_pair);
        let shares = self.reaches_ahead_to.chunks_mut(each).enumerate().map(|(k, ends)| {
            let first = k * each;
            let [start, end] = [first, first + ends.len()].map(|block| first_pair[block] as usize);
            let (mine, rest) = take(&mut pairs).split_at_mut(end - start);
            pairs = rest;
            (first, ends, mine)
        });
        team.each(shares.collect(), |(first, ends, mut pairs): (usize, _, &mut [[u32; 2]])| {
            for (block, end) in (first..).zip::<&mut [u32]>(ends) {
                let length = first_pair[block + 1] - first_pair[block];
                let (mine, rest) = take(&mut pairs).split_at_mut(length as usize);
                pairs = rest;
                let first = (block * BLOCK) as u32;
                for [a, b] in mine {
                    *end = (*end).max(*b + 1);
                    (*a, *b) = (*a - first, *b - first);
                }
            }
        });
        // Whoever is asked how far blocks up to one reach asks for all before it, too.
        let mut farthest = 0;
        for end in &mut self.reaches_ahead_to {
            farthest = farthest.max(*end);
            *end = farthest;
        }
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
