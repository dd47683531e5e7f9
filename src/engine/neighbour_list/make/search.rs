//! The search for discs near each other.

use std::ops::Range;

use glam::DVec2;

use crate::engine::block::BLOCK;
use crate::engine::cells::sort_by_key;
use crate::engine::levels::{Around, Level, Run};
use crate::engine::sizes::Extents;
use crate::engine::workers::Workers;

/// Discs of a level that one thread looks at in one go.
const DISCS_AT_A_TIME: usize = 4096;

/// A search among discs as they are stored.
#[derive(Clone, Copy)]
pub(in crate::engine::neighbour_list) struct Search<'a> {
    pub discs: Extents<'a>,
    /// Pairs closer than touching and this are near, m.
    pub skin: f64,
}

impl Search<'_> {
    /// Tells `of` which discs may be near each of `discs`, of the first of `levels`: those ahead of it in
    /// its own level, and those around it in coarser ones. It is told where the disc is stored, where it is
    /// and its radius, too.
    #[inline(always)]
    pub fn each_run(
        &self,
        levels: &[Level],
        discs: Range<usize>,
        mut of: impl FnMut(usize, (DVec2, f64), Run),
    ) {
        let Some((own, coarser)) = levels.split_first() else { return };
        let mut around = vec![Around::default(); coarser.len()];
        own.each_ahead(discs, |disc, ahead| {
            let place = own.place(disc);
            let p = self.discs.at(place);
            let [beside, above] = ahead;
            for run in [beside, above] {
                if run.count() > 0 {
                    of(place, p, run);
                }
            }
            for (level, around) in coarser.iter().zip(&mut around) {
                for run in level.around(p.0, around) {
                    if run.count() > 0 {
                        of(place, p, run);
                    }
                }
            }
        });
    }

    /// Puts the near pairs of `discs` with others into `pairs`, in place of what was there: the places, the lower
    /// first.
    ///
    /// Every pair looked at is written down, and the next one over it if it is not near: whether it is cannot be
    /// guessed, and a wrong guess costs more than a pair.
    #[inline(always)]
    pub fn find(&self, levels: &[Level], discs: Range<usize>, pairs: &mut Vec<[u32; 2]>) {
        let mut found = 0;
        self.each_run(levels, discs, |place, (position, radius), run| {
            let room = found + run.count();
            if pairs.len() < room {
                pairs.resize(2 * room.max(BLOCK), [0; 2]);
            }
            let pairs = &mut pairs[found..room];
            let mut near = 0;
            let reach = radius + self.skin;
            run.each(self.discs, |other, its_position, its_radius| {
                let reach = reach + its_radius;
                pairs[near] = [place.min(other) as u32, place.max(other) as u32];
                near += usize::from(position.distance_squared(its_position) < reach * reach);
            });
            found += near;
        });
        pairs.truncate(found);
    }

    /// All near pairs, ascending, of discs that are of several levels or not stored by cells.
    pub fn find_all(&self, levels: &[Level], workers: &Workers) -> Vec<[u32; 2]> {
        let mut found = Vec::new();
        for (k, level) in levels.iter().enumerate() {
            let starts = (0..level.count()).step_by(DISCS_AT_A_TIME);
            let piece = |start: usize| {
                let discs = start..(start + DISCS_AT_A_TIME).min(level.count());
                (&levels[k..], discs, Vec::new())
            };
            found.extend(starts.map(piece));
        }
        workers.pieces(&mut found, |_, found| {
            found.iter_mut().for_each(|(levels, discs, pairs)| {
                self.find(levels, discs.clone(), pairs);
            });
        });
        let mut pairs: Vec<[u32; 2]> = Vec::new();
        found.into_iter().for_each(|(.., found)| pairs.extend_from_slice(&found));
        sort_by_key(&mut pairs, |pair| u64::from(pair[0]));
        pairs.chunk_by_mut(|a, b| a[0] == b[0]).for_each(|of_one| of_one.sort_unstable());
        pairs
    }
}
