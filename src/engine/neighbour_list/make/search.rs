//! The search for discs near each other.

use std::ops::Range;

use glam::DVec2;
use wide::{CmpLt, f64x4};

use crate::engine::block::BLOCK;
use crate::engine::cells::sort_by_key;
use crate::engine::levels::{Around, Level};
use crate::engine::phase::Phase;
use crate::engine::sizes::Extents;
use crate::engine::workers::Workers;

/// Discs of a level that one thread looks at in one go.
const DISCS_AT_A_TIME: usize = 4096;

/// Discs of a run that are looked at in one go.
const LANES: usize = 4;

/// Which of four bits are set, lowest first, and some more; and how many.
const NEAR_ONES: [([u32; LANES], usize); 1 << LANES] = {
    let mut ones = [([0; LANES], 0); 1 << LANES];
    let mut bits = 0;
    while bits < ones.len() {
        let (ones, many) = &mut ones[bits];
        let mut bit = 0;
        while bit < LANES {
            ones[*many] = bit as u32;
            *many += bits >> bit & 1;
            bit += 1;
        }
        bits += 1;
    }
    ones
};

/// A search among discs as they are stored.
#[derive(Clone, Copy)]
pub(in crate::engine::neighbour_list) struct Search<'a> {
    pub discs: Extents<'a>,
    /// Pairs closer than touching and this are near, m.
    pub skin: f64,
}

impl Search<'_> {
    /// Tells `of` which discs may be near each of `discs`, of the level `own`: those ahead of it there, and those
    /// around it in `coarser` ones. It is told where the disc is stored, where it is and its radius, too.
    #[inline(always)]
    pub fn each_run<'a>(
        &self,
        own: &Level,
        coarser: impl Iterator<Item = &'a Level>,
        discs: Range<usize>,
        mut of: impl FnMut(usize, (DVec2, f64), (&Level, Extents), Range<usize>),
    ) {
        let here = own.discs(self.discs);
        let mut coarser: Vec<_> = coarser.map(|level| (level, Around::default())).collect();
        own.each_ahead(
            discs,
            #[inline(always)]
            |disc, [beside, above]| {
                let (place, p) = (own.place(disc), here.at(disc));
                of(place, p, (own, here), beside);
                of(place, p, (own, here), above);
                for (level, around) in &mut coarser {
                    for run in level.around(p.0, around).into_iter().filter(|run| !run.is_empty()) {
                        of(place, p, (level, level.discs(self.discs)), run);
                    }
                }
            },
        );
    }

    /// Puts the near pairs of `discs`, of one of the `levels`, with others into `pairs`, in place of what was there: the
    /// places, the lower first. Pairs of two levels are found from one of them.
    #[inline(always)]
    pub fn find(
        &self,
        levels: &[Level],
        level: usize,
        discs: Range<usize>,
        pairs: &mut Vec<[u32; 2]>,
    ) {
        let (own, mut found) = (&levels[level], 0);
        let (finer, coarser) = (&levels[..level], &levels[level + 1..]);
        for finer in finer.iter().filter(|finer| finer.is_found_from(own, self.skin)) {
            let there = finer.discs(self.discs);
            for disc in discs.clone() {
                let p = own.discs(self.discs).at(disc);
                for run in finer.within(p.1 + self.skin + finer.largest_radius, p.0) {
                    found += self.look(own.place(disc), p, (finer, there), run, pairs, found);
                }
            }
        }
        let coarser = coarser.iter().filter(|coarser| !own.is_found_from(coarser, self.skin));
        self.each_run(
            own,
            coarser,
            discs,
            #[inline(always)]
            |place, p, level, run| found += self.look(place, p, level, run, pairs, found),
        );
        pairs.truncate(found);
    }

    /// Which of a run of a level's discs are near the one at `place`: puts the pairs after the `found` ones, and says how
    /// many.
    ///
    /// Whether a pair is near cannot be guessed, and a wrong guess costs more than a pair: so four are looked at in one go,
    /// whatever comes after the run, and four are written down, the near ones first.
    #[inline(always)]
    fn look(
        &self,
        place: usize,
        (position, radius): (DVec2, f64),
        (level, discs): (&Level, Extents),
        run: Range<usize>,
        pairs: &mut Vec<[u32; 2]>,
        found: usize,
    ) -> usize {
        let room = found + run.len() + LANES;
        if pairs.len() < room {
            pairs.resize(2 * room.max(BLOCK), [0; 2]);
        }
        let pairs = &mut pairs[found..room];
        let (reach, mut first, mut found) = (radius + self.skin, run.start, 0);
        while first < run.end {
            let four = first..first + LANES;
            let is_near = match (discs.phases.get(four.clone()), discs.radii.get(four)) {
                (Some([a, b, c, d]), Some([e, f, g, h])) => {
                    are_near(position, reach, [a, b, c, d], [*e, *f, *g, *h])
                }
                _ => last_are_near(position, reach, discs, first),
            };
            let (near_ones, many) = NEAR_ONES[is_near & ((1 << (run.end - first).min(LANES)) - 1)];
            let near = near_ones.map(|k| [place as u32, first as u32 + k]);
            pairs[found..found + LANES].copy_from_slice(&near);
            found += many;
            first += LANES;
        }
        if !level.is_as_stored() {
            for pair in &mut pairs[..found] {
                let other = level.place(pair[1] as usize) as u32;
                *pair = [pair[0].min(other), pair[0].max(other)];
            }
        }
        found
    }

    /// All near pairs, ascending, of discs that are of several levels or not stored by cells.
    pub fn find_all(&self, levels: &[Level], workers: &Workers) -> Vec<[u32; 2]> {
        let mut found = Vec::new();
        for (k, level) in levels.iter().enumerate() {
            let starts = (0..level.count()).step_by(DISCS_AT_A_TIME);
            let piece = |start: usize| {
                let discs = start..(start + DISCS_AT_A_TIME).min(level.count());
                (k, discs, Vec::new())
            };
            found.extend(starts.map(piece));
        }
        workers.pieces(&mut found, |_, found| {
            found
                .iter_mut()
                .for_each(|(k, discs, pairs)| self.find(levels, *k, discs.clone(), pairs));
        });
        let mut pairs: Vec<[u32; 2]> = Vec::new();
        found.into_iter().for_each(|(.., found)| pairs.extend_from_slice(&found));
        sort_by_key(&mut pairs, |pair| u64::from(pair[0]));
        pairs.chunk_by_mut(|a, b| a[0] == b[0]).for_each(|of_one| of_one.sort_unstable());
        pairs
    }
}

/// Which of four discs of these radii (m) are so near, a bit each: centres closer than `reach` (m) and the radius.
#[inline(always)]
fn are_near(position: DVec2, reach: f64, phases: [&Phase; LANES], radii: [f64; LANES]) -> usize {
    let of = |coordinate: usize| f64x4::new(phases.map(|p| p.0[coordinate]));
    let (dx, dy) = (f64x4::splat(position.x) - of(0), f64x4::splat(position.y) - of(1));
    let reach = f64x4::splat(reach) + f64x4::new(radii);
    (dx * dx + dy * dy).cmp_lt(reach * reach).move_mask() as usize
}

/// The same of the last ones, fewer than four.
#[cold]
#[inline(never)]
fn last_are_near(position: DVec2, reach: f64, discs: Extents, first: usize) -> usize {
    let last = first..discs.count();
    let is_near =
        |(disc, radius)| position.distance_squared(disc) < (reach + radius) * (reach + radius);
    last.map(|k| usize::from(is_near(discs.at(k))) << (k - first)).sum()
}
