//! Who takes part in which near pairs, in the order in which a disc adds its forces up.

use std::mem::take;
use std::ops::Range;

use crate::crowd::BLOCK;
use crate::crowd::near::Near;
use crate::crowd::team::Team;

/// What one thread has of all discs' parts: those of the discs of some blocks.
struct Parts<'a> {
    blocks: Range<usize>,
    /// Where each disc's parts begin in all triples, and where they end.
    firsts: &'a [u32],
    triples: &'a mut [[u32; 3]],
    reaches_back_to: &'a mut [u32],
}

impl Near {
    /// Fills in who takes part in which pairs, in ascending id of the partner; `ids` are those of the
    /// discs as they are stored.
    pub(super) fn list_parts(&mut self, ids: &[u32], team: &Team) {
        self.count_parts(ids.len(), team);
        self.triples.resize(self.first_triple[ids.len()] as usize, [u32::MAX; 3]);
        self.reaches_back_to.clear();
        self.reaches_back_to.resize(ids.len().div_ceil(BLOCK), u32::MAX);
        self.for_parts(team, |near, parts| {
            near.fill_in(parts);
            near.order(parts, ids);
        });
        // Whoever begins at a block has all later ones to do, too.
        let mut lowest = u32::MAX;
        for reach in self.reaches_back_to.iter_mut().rev() {
            lowest = lowest.min(*reach);
            *reach = lowest;
        }
        self.pairs_at_a_time = self.most_pairs_at_a_time();
        self.for_parts(team, Self::place_in_ring);
    }

    /// Counts the parts of each of `n` discs, and so finds where in the triples they begin.
    fn count_parts(&mut self, n: usize, team: &Team) {
        let mut first = take(&mut self.first_triple);
        first.clear();
        first.resize(n + 1, 0);
        team.pieces(&mut first[..n], |start, counts| {
            self.for_parts_among(start..start + counts.len(), |disc, _| counts[disc] += 1);
        });
        let mut end = 0;
        for first in &mut first {
            (*first, end) = (end, end + first.div_ceil(3).max(1));
        }
        self.first_triple = first;
    }

    /// Tells `of` each part of each disc among `places`, in the order of the pairs: the disc, counted
    /// from the first of them, and the part.
    fn for_parts_among(&self, places: Range<usize>, mut of: impl FnMut(usize, u32)) {
        let before = &self.reaches_ahead_to[..places.start / BLOCK];
        let first = before.partition_point(|&end| end as usize <= places.start);
        for block in first..places.end.div_ceil(BLOCK) {
            // Of a place before the first, this is huge.
            let disc = |at: u32| (block * BLOCK + at as usize).wrapping_sub(places.start);
            for pair in self.pairs_of(block) {
                let part = 2 * pair as u32;
                for (part, at) in (part..).zip(self.pairs[pair]) {
                    if disc(at) < places.len() {
                        of(disc(at), part);
                    }
                }
            }
        }
    }

    /// Shares the discs' parts out to the team.
    fn for_parts(&mut self, team: &Team, work: impl Fn(&Self, &mut Parts) + Sync) {
        let mut all = take(&mut self.triples);
        let mut reaches_back_to = take(&mut self.reaches_back_to);
        let n = self.first_triple.len() - 1;
        let each = reaches_back_to.len().div_ceil(team.threads()).max(1);
        let mut rest = &mut all[..];
        let shares = reaches_back_to.chunks_mut(each).enumerate().map(|(k, reaches_back_to)| {
            let blocks = k * each..k * each + reaches_back_to.len();
            let places = blocks.start * BLOCK..(blocks.end * BLOCK).min(n);
            let firsts = &self.first_triple[places.start..=places.end];
            let length = firsts[places.len()] - firsts[0];
            let (triples, others) = take(&mut rest).split_at_mut(length as usize);
            rest = others;
            Parts { blocks, firsts, triples, reaches_back_to }
        });
        team.each(shares.collect(), |mut parts| work(self, &mut parts));
        self.triples = all;
        self.reaches_back_to = reaches_back_to;
    }

    /// Fills in which parts the discs take, in the order of the pairs.
    fn fill_in(&self, parts: &mut Parts) {
        let start = parts.blocks.start * BLOCK;
        let places = start..start + parts.firsts.len() - 1;
        let mut next: Vec<u32> = parts.firsts.iter().map(|k| 3 * (k - parts.firsts[0])).collect();
        let flat = parts.triples.as_flattened_mut();
        flat.fill(u32::MAX);
        self.for_parts_among(places, |disc, part| {
            flat[next[disc] as usize] = part;
            next[disc] += 1;
        });
    }

    /// Puts every disc's parts into ascending id of the partner, and finds the first pair of each block.
    fn order(&self, parts: &mut Parts, ids: &[u32]) {
        let start = parts.blocks.start * BLOCK;
        let mut by_partner = Vec::new();
        for (k, of_one) in parts.firsts.windows(2).enumerate() {
            let of_one = [0, 1].map(|end| (of_one[end] - parts.firsts[0]) as usize);
            let of_one = parts.triples[of_one[0]..of_one[1]].as_flattened_mut();
            let there = of_one.iter().position(|&part| part == u32::MAX).unwrap_or(of_one.len());
            let of_one = &mut of_one[..there]; // none at the end
            if let Some(first) = of_one.first() {
                let lowest = &mut parts.reaches_back_to[k / BLOCK];
                *lowest = (*lowest).min(first / 2);
            }
            by_partner.clear();
            let partner = |part: u32| {
                let (pair, side) = (self.pairs[part as usize / 2], part as usize % 2);
                // Both are counted from the same disc.
                ids[start + k + pair[1 - side] as usize - pair[side] as usize]
            };
            let keys = of_one.iter().map(|&part| u64::from(partner(part)) << 32 | u64::from(part));
            by_partner.extend(keys);
            by_partner.sort_unstable();
            of_one.iter_mut().zip(&by_partner).for_each(|(part, &key)| *part = key as u32);
        }
    }

    /// Names parts by where in the ring they will lie.
    fn place_in_ring(&self, parts: &mut Parts) {
        let ring = 2 * self.pairs_at_a_time as u32;
        let first = parts.firsts[0];
        let ends = parts.firsts[1..].chunks(BLOCK).map(|ends| ends[ends.len() - 1] - first);
        let mut start = 0;
        for (end, &from) in ends.zip(&*parts.reaches_back_to) {
            // The block's parts are at most once around the ring after this.
            let round = if from == u32::MAX { 0 } else { 2 * from / ring * ring };
            for part in parts.triples[start..end as usize].as_flattened_mut() {
                *part = match *part {
                    u32::MAX => ring,
                    part if part - round < ring => part - round,
                    part => part - round - ring,
                };
            }
            start = end as usize;
        }
    }

    fn most_pairs_at_a_time(&self) -> usize {
        let ends = self.first_pair.iter().skip(1);
        let needed = ends.zip(&self.reaches_back_to).map(|(&end, &from)| end.saturating_sub(from));
        needed.max().unwrap_or(0).max(4) as usize // four are put there at a time
    }
}
