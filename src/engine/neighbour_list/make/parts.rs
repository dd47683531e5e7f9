//! Who takes part in which near pairs, in the order in which a disc adds its forces up.

use std::ops::Range;

use crate::engine::block::BLOCK;
use crate::engine::neighbour_list::{More, NeighbourList, PARTS};
use crate::engine::workers::Workers;

/// No part: sorted behind all others.
const NONE: u64 = u64::MAX;

/// In a part, that its pair is a far one.
const IS_FAR: u32 = 1 << 31;

/// What one thread has of all discs' parts: those of the discs of some blocks.
struct Share<'a> {
    blocks: Range<usize>,
    /// Where the first of them is stored.
    first: usize,
    parts: &'a mut [[u16; PARTS]],
    more: Vec<More>,
    more_parts: Vec<u32>,
}

/// The parts of discs that are still to be found, while pairs are gone through: the id of the partner, and below
/// it twice the number of the pair, and one more for the second disc.
struct Sorting {
    /// Of the discs from some place on: that of place p is at p modulo their number, a power of two.
    parts: Vec<[u64; PARTS]>,
    counts: Vec<u8>,
    /// Those for which there is no room, with the place of the disc.
    rest: Vec<(u32, u64)>,
}

impl Sorting {
    /// For pairs of discs of which no two are further apart than this.
    fn among(discs: usize) -> Self {
        let discs = discs.next_power_of_two();
        Self { parts: vec![[NONE; PARTS]; discs], counts: vec![0; discs], rest: Vec::new() }
    }

    #[inline(always)]
    fn add(&mut self, place: usize, partner: u32, part: u32) {
        let here = place & (self.parts.len() - 1);
        let part = u64::from(partner) << 32 | u64::from(part);
        let count = usize::from(self.counts[here]);
        match self.parts[here].get_mut(count) {
            Some(to) => *to = part,
            None => return self.rest.push((place as u32, part)),
        }
        self.counts[here] += 1;
    }

    /// Takes out what there is of a disc, sorted.
    #[inline(always)]
    fn take(&mut self, place: usize) -> [u64; PARTS] {
        let here = place & (self.parts.len() - 1);
        match std::mem::take(&mut self.counts[here]) {
            0 => [NONE; PARTS], // most discs of a gas
            _ => sorted(std::mem::replace(&mut self.parts[here], [NONE; PARTS])),
        }
    }

    /// Takes out the rest of discs before the place `end`.
    fn take_rest(&mut self, end: usize) -> Vec<(u32, u64)> {
        let rest = std::mem::take(&mut self.rest).into_iter();
        let (rest, later) = rest.partition(|of| (of.0 as usize) < end);
        self.rest = later;
        rest
    }
}

/// Sorts without a branch: a network of 12 comparisons (Knuth, TAOCP 3, 5.3.4).
#[inline(always)]
fn sorted(mut parts: [u64; PARTS]) -> [u64; PARTS] {
    const NETWORK: [[usize; 2]; 12] = [
        [0, 5],
        [1, 3],
        [2, 4],
        [1, 2],
        [3, 4],
        [0, 3],
        [2, 5],
        [0, 1],
        [2, 3],
        [4, 5],
        [1, 2],
        [3, 4],
    ];
    for [a, b] in NETWORK {
        (parts[a], parts[b]) = (parts[a].min(parts[b]), parts[a].max(parts[b]));
    }
    parts
}

impl NeighbourList {
    /// Fills in who takes part in which pairs, in ascending id of the partner; `ids` are those of the
    /// discs as they are stored.
    pub(super) fn list_parts(&mut self, ids: &[u32], workers: &Workers) {
        let far = self.far_parts(ids);
        let mut parts = std::mem::take(&mut self.parts);
        parts.resize(ids.len(), [0; PARTS]);
        let each = self.reaches_back_to.len().div_ceil(workers.threads()).max(1);
        let share = |(k, parts): (usize, _)| {
            let blocks = k * each..((k + 1) * each).min(self.reaches_back_to.len());
            let first = blocks.start * BLOCK;
            Share { blocks, first, parts, more: Vec::new(), more_parts: Vec::new() }
        };
        let mut shares: Vec<Share> =
            parts.chunks_mut(each * BLOCK).enumerate().map(share).collect();
        workers.pieces(&mut shares, |_, shares| {
            shares.iter_mut().for_each(|share| self.list_parts_of(share, ids, &far));
        });
        let (mut more, mut more_parts) = (Vec::new(), Vec::new());
        for share in shares {
            let start = more_parts.len() as u32;
            let moved = |of: More| More { parts: of.parts.map(|end| start + end), ..of };
            more.extend(share.more.into_iter().map(moved));
            more_parts.extend(share.more_parts);
        }
        (self.parts, self.more, self.more_parts) = (parts, more, more_parts);
    }

    /// The parts in far pairs, with the places of the discs that take them, ascending.
    fn far_parts(&self, ids: &[u32]) -> Vec<(u32, u64)> {
        let part = |(k, &[a, b]): (usize, &[u32; 2])| {
            let part = u64::from((2 * k as u32) | IS_FAR);
            let partner = |place: u32| u64::from(ids[place as usize]) << 32;
            [(a, partner(b) | part), (b, partner(a) | part | 1)]
        };
        let mut parts: Vec<_> = self.far.iter().enumerate().flat_map(part).collect();
        parts.sort_unstable();
        parts
    }

    fn list_parts_of(&self, share: &mut Share, ids: &[u32], far: &[(u32, u64)]) {
        let Range { start, end } = share.blocks;
        let before = &self.reaches_ahead_to[..start];
        let first = before.partition_point(|&end| end as usize <= start * BLOCK);
        let reach = |block: usize| {
            (self.reaches_ahead_to[block] as usize).saturating_sub(block * BLOCK).max(BLOCK)
        };
        let mut sorting = Sorting::among((first..end).map(reach).max().unwrap_or(BLOCK));
        for block in first..end {
            let places = block * BLOCK..((block + 1) * BLOCK).min(ids.len());
            self.add_parts_of(block, ids, &mut sorting);
            let mut rest = sorting.take_rest(places.end);
            if block < start {
                places.for_each(|place| _ = sorting.take(place));
                continue;
            }
            let from = |place: usize| far.partition_point(|of| (of.0 as usize) < place);
            rest.extend_from_slice(&far[from(places.start)..from(places.end)]);
            rest.sort_unstable();
            self.name_parts(block, places, &mut sorting, &rest, share);
        }
    }

    /// Names the parts of discs of a block by where their forces lie; `rest` are those for which there was no
    /// room.
    fn name_parts(
        &self,
        block: usize,
        places: Range<usize>,
        sorting: &mut Sorting,
        rest: &[(u32, u64)],
        share: &mut Share,
    ) {
        let ring = 2 * self.ring_length as u32;
        // The block's parts are at most once around the ring after this.
        let from = self.reaches_back_to[block];
        let round = 2 * (from - from % self.ring_length as u32);
        let of_near = |part: u64| {
            let entry = (part as u32).wrapping_sub(round);
            let entry = if entry < ring { entry } else { entry.wrapping_sub(ring) };
            if part == NONE { ring } else { entry }
        };
        let entry = |part: u64| match part as u32 {
            far if far & IS_FAR != 0 => ring + 2 + (far ^ IS_FAR),
            _ => of_near(part),
        };
        let mut rest = rest;
        for (place, here) in places.clone().zip(&mut share.parts[places.start - share.first..]) {
            let parts = sorting.take(place);
            let more = rest.iter().take_while(|of| of.0 as usize == place).count();
            if more == 0 {
                *here = parts.map(|part| of_near(part) as u16);
                continue;
            }
            let (more, later) = rest.split_at(more);
            rest = later;
            *here = [ring as u16; PARTS];
            let few = parts.into_iter().filter(|part| *part != NONE);
            let mut parts: Vec<u64> = few.chain(more.iter().map(|of| of.1)).collect();
            parts.sort_unstable();
            let start = share.more_parts.len() as u32;
            share.more_parts.extend(parts.into_iter().map(entry));
            let parts = [start, share.more_parts.len() as u32];
            share.more.push(More { place: place as u32, parts });
        }
    }

    /// Adds the parts in the pairs of a block.
    fn add_parts_of(&self, block: usize, ids: &[u32], sorting: &mut Sorting) {
        let first = block * BLOCK;
        for (k, pair) in self.pairs_of(block).zip(self.distinct_pairs_of(block)) {
            let [a, b] = pair.map(|at| first + usize::from(at));
            sorting.add(a, ids[b], 2 * k as u32);
            sorting.add(b, ids[a], 2 * k as u32 + 1);
        }
    }
}
