//! Who may touch whom, for discs stored cell by cell.
//!
//! The list (Verlet 1967) holds every pair closer than touching plus a *skin* and stays good until
//! some disc has moved half a skin. Beside it stands, for each disc, in which of its pairs it takes
//! part, in ascending id of the partner: so its forces add up in one order, however the discs are
//! stored, listed or shared out.

mod make;
mod skin;
#[cfg(test)]
mod tests;

use std::ops::Range;

use glam::DVec2;

pub(super) use self::make::Listed;
pub(super) use self::skin::widest_skin;
use super::block::BLOCK;

/// Pairs are walked by so many; those of a block are filled up to whole groups.
pub(super) const GROUP: usize = 8;

/// Parts kept for each disc; the few that have more have them in a list of their own.
pub(super) const PARTS: usize = 6;

/// Discs of a near pair are stored no further apart than this; others are far.
const SPAN: u32 = 8192;

/// Pairs in the ring at most: two entries each, and two for no force, are numbered in 16 bits.
const LONGEST_RING: usize = (1 << 15) - GROUP;

/// NeighbourList pairs of discs stored cell by cell, and what a pass over them needs.
///
/// Forces of pairs lie in a buffer, two entries each, that on its first disc and that on its second: first a ring
/// of `ring_length` pairs, in which pair k has place k modulo its length; then two entries of no
/// force; then the far pairs, one after the other.
#[derive(Default)]
pub(super) struct NeighbourList {
    /// Places (in storage) of two discs that may touch, the lower first; ascending. Places are counted
    /// from the first disc of the block of the lower. Each block has whole groups of them: its last pair
    /// is repeated.
    pub pairs: Vec<[u16; 2]>,
    /// Where in `pairs` those of each block of discs begin, by their first disc, and the end.
    pub first_pair: Vec<u32>,
    /// Pairs of discs that are stored further apart than `span`: places, the lower first; ascending.
    pub far: Vec<[u32; 2]>,
    /// The span limit of near pairs, places; as large as the ring allows.
    span: u32,
    /// For each disc the entries of its parts, in ascending id of the partner, filled up with no force. All
    /// are no force for those that have `more`.
    pub parts: Vec<[u16; PARTS]>,
    /// Discs with more parts than that, or with far ones; ascending.
    pub more: Vec<More>,
    /// The entries of their parts, disc by disc, in ascending id of the partner.
    pub more_parts: Vec<u32>,
    /// The first pair that discs of each block, or of one after it, take part in, or one of its group.
    pub reaches_back_to: Vec<u32>,
    /// One after the last place that near pairs of each block, or of one before it, reach.
    reaches_ahead_to: Vec<u32>,
    /// Pairs that are still needed when those of a block have been walked, at most: the ring's length, in
    /// whole groups.
    pub ring_length: usize,
    /// Places of the discs that may touch a wall, ascending.
    pub at_wall: Vec<u32>,
    /// Places of the discs that may reach a periodic edge, ascending.
    pub at_edge: Vec<u32>,
    /// Where those of each block begin in `more`, `at_wall` and `at_edge`, and the ends.
    begins: Vec<Begins>,
    /// Where each disc was when the list was made, m.
    pub reference_positions: Vec<DVec2>,
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

/// All parts of a disc that has many, or far ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct More {
    /// Where the disc is stored.
    pub place: u32,
    /// Where its parts begin in `more_parts`, and where they end.
    pub parts: [u32; 2],
}

/// Where the discs of a block begin among those that need a closer look.
#[derive(Clone, Copy, Default)]
struct Begins {
    more: u32,
    at_wall: u32,
    at_edge: u32,
}

impl NeighbourList {
    /// Forgets the list: the next step makes a new one.
    pub fn forget(&mut self) {
        self.limit_squared = -1.0;
        self.is_there = false;
    }

    /// Forgets all but how many lists there have been: the discs are others.
    pub fn clear(&mut self) {
        *self = Self { made: self.made, ..Self::default() };
    }

    /// Has no pairs any more.
    pub fn clear_pairs(&mut self) {
        self.pairs.clear();
        self.far.clear();
        self.first_pair.clear();
    }

    /// Which of the `pairs` are those of a block.
    pub fn pairs_of(&self, block: usize) -> Range<usize> {
        self.first_pair[block] as usize..self.first_pair[block + 1] as usize
    }

    /// Which of the `pairs` are those of these blocks.
    pub fn pairs_of_run(&self, blocks: &Range<usize>) -> Range<usize> {
        self.first_pair[blocks.start] as usize..self.first_pair[blocks.end] as usize
    }

    /// One after the last place that pairs of a block, or of one before it, name, counted from its first disc.
    pub fn reach_of(&self, block: usize) -> usize {
        (self.reaches_ahead_to[block] as usize).saturating_sub(block * BLOCK)
    }

    /// The discs that are looked at both by those who serve the blocks up to `block` and by those who begin
    /// there: the first block, and all their places.
    pub fn halo_at(&self, block: usize) -> (usize, Range<usize>) {
        let middle = block * BLOCK;
        let back = self.first_pair.partition_point(|&first| first <= self.reaches_back_to[block]);
        let ahead = &self.reaches_ahead_to[..block];
        let ahead_from = ahead.partition_point(|&end| end as usize <= middle);
        let end = ahead.last().map_or(0, |&end| end as usize).max(middle);
        let first_block = back.saturating_sub(1).min(ahead_from);
        (first_block, first_block * BLOCK..end)
    }

    /// The entry of no force.
    pub fn no_force(&self) -> usize {
        2 * self.ring_length
    }

    /// The pairs of a block, each once.
    pub fn distinct_pairs_of(&self, block: usize) -> &[[u16; 2]] {
        let pairs = &self.pairs[self.pairs_of(block)];
        let Some(last) = pairs.last() else { return pairs };
        let more = pairs.iter().rev().skip(1).take_while(|pair| *pair == last).count();
        &pairs[..pairs.len() - more]
    }

    /// The discs of a block that have more parts than there is room for, or far ones.
    pub fn more_of(&self, block: usize) -> &[More] {
        &self.more[self.begins[block].more as usize..self.begins[block + 1].more as usize]
    }

    /// The discs of a block that are near walls.
    pub fn at_wall_of(&self, block: usize) -> &[u32] {
        let [begin, end] = [block, block + 1].map(|block| self.begins[block].at_wall as usize);
        &self.at_wall[begin..end]
    }

    /// The discs of a block that are near a periodic edge.
    pub fn at_edge_of(&self, block: usize) -> &[u32] {
        let [begin, end] = [block, block + 1].map(|block| self.begins[block].at_edge as usize);
        &self.at_edge[begin..end]
    }

    /// Notes where the discs of each block begin among those that need a closer look.
    fn note_begins(&mut self, discs: usize) {
        self.begins.clear();
        for block in 0..=discs.div_ceil(BLOCK) {
            let from = |places: &[u32]| places.partition_point(|&at| (at as usize) < block * BLOCK);
            let more = self.more.partition_point(|of| (of.place as usize) < block * BLOCK);
            let (at_wall, at_edge) = (from(&self.at_wall) as u32, from(&self.at_edge) as u32);
            self.begins.push(Begins { more: more as u32, at_wall, at_edge });
        }
    }
}
