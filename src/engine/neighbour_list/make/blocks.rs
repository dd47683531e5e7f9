//! NeighbourList pairs block by block, and how far each block reaches.

use std::ops::Range;

use super::Search;
use crate::boundary::Boundary;
use crate::engine::block::BLOCK;
use crate::engine::levels::Level;
use crate::engine::neighbour_list::{GROUP, LONGEST_RING, NeighbourList, SPAN};
use crate::engine::workers::Workers;

/// Blocks of discs for which one thread looks for pairs before all join what they have found, at most: so
/// that pairs do not lie in memory twice.
const BLOCKS_AT_A_TIME: usize = 64;

/// Blocks from that of the first disc of a pair to that of the second, both counted, at most.
const BLOCKS_REACHED: usize = (SPAN as usize).div_ceil(BLOCK) + 1;

/// What one thread has found about some blocks that follow each other.
#[derive(Default)]
struct Found {
    pairs: Vec<[u16; 2]>,
    far: Vec<[u32; 2]>,
    /// For each block where its pairs end, and one after the last place that they reach.
    blocks: Vec<[u32; 2]>,
    /// Blocks that pairs of another reach, or of the same, and the first such pair.
    reached: Vec<[u32; 2]>,
}

impl Found {
    fn clear(&mut self) {
        self.pairs.clear();
        self.far.clear();
        self.blocks.clear();
        self.reached.clear();
    }

    /// Takes the `pairs` of a block in: which of them are far is told.
    fn take_in(&mut self, block: usize, pairs: &[[u32; 2]], is_far: impl Fn(u32, u32) -> bool) {
        let (first, start) = ((block * BLOCK) as u32, self.pairs.len());
        let place = |[a, b]: [u32; 2]| [(a - first) as u16, (b - first) as u16];
        if pairs.iter().any(|&[a, b]| is_far(a, b)) {
            let (far, near): (Vec<_>, Vec<_>) = pairs.iter().partition(|[a, b]| is_far(*a, *b));
            self.far.extend(far);
            self.pairs.extend(near.into_iter().map(place));
        } else {
            self.pairs.extend(pairs.iter().copied().map(place));
        }
        let (mut seen, mut end) = ([false; BLOCKS_REACHED], 0);
        for (k, pair) in (start..).zip(&self.pairs[start..]) {
            let reached = usize::from(pair[1]) / BLOCK;
            if !seen[reached] {
                seen[reached] = true;
                let group = k / GROUP * GROUP; // walks begin with a whole group
                self.reached.push([(block + reached) as u32, group as u32]);
            }
            end = end.max(u32::from(pair[1]) + 1);
        }
        if let Some(&last) = self.pairs[start..].last() {
            self.pairs.resize(self.pairs.len().next_multiple_of(GROUP), last);
        }
        self.blocks.push([self.pairs.len() as u32, first + end]);
    }
}

impl NeighbourList {
    /// Lists all near pairs of discs of these `levels`.
    pub(super) fn list_pairs(
        &mut self,
        search: Search,
        boundary: Boundary,
        levels: &[Level],
        workers: &Workers,
    ) {
        let blocks = search.discs.count().div_ceil(BLOCK);
        let sorted = match levels {
            [level] if level.is_as_stored() => None,
            _ => Some(search.find_all(levels, workers)),
        };
        let find = |block: usize, pairs: &mut Vec<[u32; 2]>| {
            let places = block * BLOCK..((block + 1) * BLOCK).min(search.discs.count());
            match &sorted {
                None => search.find(levels, 0, places, pairs),
                Some(sorted) => {
                    pairs.clear();
                    pairs.extend_from_slice(of_places(sorted, &places));
                }
            }
        };
        self.span = 2 * SPAN;
        self.ring_length = usize::MAX;
        while self.ring_length > LONGEST_RING {
            self.span /= 2;
            let span = self.span;
            let at_edge =
                |place: u32| boundary.is_at_edge(search.discs.at(place as usize).0, search.skin);
            let is_open = boundary.is_open();
            let is_far = |a: u32, b: u32| b - a > span || !is_open && (at_edge(a) || at_edge(b));
            self.list_blocks(blocks, find, is_far, workers);
            let ends = self.first_pair.iter().skip(1).zip(&self.reaches_back_to);
            let longest = ends.map(|(end, from)| end - from).max().unwrap_or(0);
            self.ring_length = (longest as usize).max(GROUP);
        }
    }

    /// Lists what `find` finds for each block.
    fn list_blocks(
        &mut self,
        blocks: usize,
        find: impl Fn(usize, &mut Vec<[u32; 2]>) + Sync,
        is_far: impl Fn(u32, u32) -> bool + Sync,
        workers: &Workers,
    ) {
        let Self { pairs, far, first_pair, reaches_back_to, reaches_ahead_to, .. } = self;
        pairs.clear();
        far.clear();
        reaches_ahead_to.clear();
        first_pair.clear();
        first_pair.push(0);
        reaches_back_to.clear();
        reaches_back_to.resize(blocks, u32::MAX);
        let each = blocks.div_ceil(workers.threads()).clamp(1, BLOCKS_AT_A_TIME);
        let mut found: Vec<Found> = Vec::new();
        found.resize_with(workers.threads(), Found::default);
        for first in (0..blocks).step_by(found.len() * each) {
            workers.pieces(&mut found, |k, found| {
                let found = &mut found[0];
                let start = (first + k * each).min(blocks);
                found.clear();
                let mut at_hand = Vec::new();
                for block in start..(start + each).min(blocks) {
                    find(block, &mut at_hand);
                    found.take_in(block, &at_hand, &is_far);
                }
            });
            for found in &found {
                let start = pairs.len() as u32;
                pairs.extend_from_slice(&found.pairs);
                far.extend_from_slice(&found.far);
                first_pair.extend(found.blocks.iter().map(|[end, _]| start + end));
                reaches_ahead_to.extend(found.blocks.iter().map(|[_, end]| *end));
                for &[block, pair] in &found.reached {
                    let lowest = &mut reaches_back_to[block as usize];
                    *lowest = (*lowest).min(start + pair);
                }
            }
        }
        self.join_reaches();
    }

    /// Whoever begins at a block has all later ones to do, too, and whoever ends with one has done all before.
    fn join_reaches(&mut self) {
        let mut lowest = u32::MAX;
        for (back, first) in self.reaches_back_to.iter_mut().zip(&self.first_pair).rev() {
            lowest = lowest.min(*back);
            *back = lowest.min(*first);
        }
        let mut farthest = 0;
        for end in &mut self.reaches_ahead_to {
            farthest = farthest.max(*end);
            *end = farthest;
        }
    }
}

/// Those of ascending pairs whose lower place is among `places`.
fn of_places<'a>(pairs: &'a [[u32; 2]], places: &Range<usize>) -> &'a [[u32; 2]] {
    let from = |place: usize| pairs.partition_point(|pair| (pair[0] as usize) < place);
    &pairs[from(places.start)..from(places.end)]
}
