//! The making of a list: near pairs are found by a [`search`], laid out by [`blocks`], and named disc by disc as
//! [`parts`]; discs near walls are listed here.

mod across;
mod blocks;
mod parts;
mod search;

pub(super) use self::search::Search;
use std::ops::Range;
use std::sync::Arc;

use glam::DVec2;

use super::NeighbourList;
use super::skin::{best_skin, widest_skin};
use crate::boundary::Boundary;
use crate::discs::columns::Columns;
use crate::engine::block::BLOCK;
use crate::engine::cells::InCells;
use crate::engine::levels::{Level, levels};
use crate::engine::phase::Phase;
use crate::engine::sizes::{Extents, Sizes};
use crate::engine::workers::Workers;
use crate::force::HalfPlane;
use crate::wall::Wall;

/// What a list is made of.
#[derive(Clone, Copy)]
pub(in crate::engine) struct Listed<'a> {
    /// The discs as they are stored, and their ids.
    pub discs: Extents<'a>,
    pub ids: &'a [u32],
    pub boundary: Boundary,
    /// Walls, and when they are looked at, s.
    pub planes: &'a [HalfPlane],
    pub walls: &'a [Arc<dyn Wall>],
    pub time: f64,
}

impl Listed<'_> {
    /// Whether the disc stored at `place` may touch a wall once it has come closer by `skin` (m).
    fn is_at_wall(&self, place: usize, skin: f64) -> bool {
        let (position, radius) = self.discs.at(place);
        let is_near = |distance: f64| distance < radius + skin;
        self.planes.iter().any(|plane| is_near(plane.distance(position)))
            || self.walls.iter().any(|wall| is_near(wall.nearest(position, self.time).distance))
    }

    /// Whether one of those stored at `places` might: false only if no plane is near the box around them. Rounding keeps
    /// the order of distances, so that none of them is nearer than the corner.
    fn has_wall_near(&self, places: Range<usize>, skin: f64) -> bool {
        let (mut low, mut high, mut largest) = (DVec2::INFINITY, DVec2::NEG_INFINITY, 0.0_f64);
        for (position, radius) in places.map(|place| self.discs.at(place)) {
            (low, high) = (position.min(low), position.max(high)); // in this order: NaN goes by
            largest = largest.max(radius);
        }
        let is_clear = |plane: &HalfPlane| {
            let corner = DVec2::select(plane.normal.cmpgt(DVec2::ZERO), high, low);
            plane.distance(corner) >= largest + skin // false if one is no number
        };
        !self.walls.is_empty() || !self.planes.iter().all(is_clear)
    }
}

impl NeighbourList {
    /// A new list, for discs of these `sizes`, `stored` cell by cell, of which the fastest goes `travel` m a step.
    pub fn make(
        &mut self,
        listed: Listed,
        sizes: &Sizes,
        stored: InCells,
        travel: f64,
        workers: &Workers,
    ) {
        let discs = listed.discs;
        let widest = widest_skin(sizes, travel);
        let levels = levels(discs, sizes, widest, Some(stored));
        let search = Search { discs, skin: widest };
        self.skin = best_skin(search, &levels, sizes, travel, workers);
        self.list(listed, &levels, self.skin, workers);
        self.refer_to(discs.phases, workers);
        self.made += 1;
    }

    /// A list for discs to which `remembered` goes back. They lie about where they were listed, so the skin
    /// is twice as wide; the next list is made at the same step as the first time.
    pub fn restore(&mut self, remembered: &Columns, listed: Listed, workers: &Workers) {
        let Columns { reference_positions, list: [skin, limit_squared], .. } = remembered;
        self.skin = *skin;
        self.limit_squared = *limit_squared;
        self.reference_positions.clone_from(reference_positions);
        self.list_anywhere(listed, workers);
    }

    /// Lists discs that are not stored cell by cell, with a skin twice as wide, and refers to no new
    /// positions.
    pub fn list_anywhere(&mut self, listed: Listed, workers: &Workers) {
        let skin = 2.0 * self.skin;
        let sizes = Sizes::of(listed.discs, listed.ids, workers);
        let levels = levels(listed.discs, &sizes, skin, None);
        self.list(listed, &levels, skin, workers);
    }

    fn list(&mut self, listed: Listed, levels: &[Level], skin: f64, workers: &Workers) {
        let search = Search { discs: listed.discs, skin };
        self.list_pairs(search, listed.boundary, levels, workers);
        self.list_across(listed, skin);
        self.list_parts(listed.ids, workers);
        self.list_at_wall(listed, skin, workers);
        self.note_begins(listed.discs.count());
        self.is_there = true;
    }

    fn list_at_wall(&mut self, listed: Listed, skin: f64, workers: &Workers) {
        let discs = listed.discs;
        let mut blocks = vec![Vec::new(); discs.count().div_ceil(BLOCK)];
        workers.pieces(&mut blocks, |first, blocks| {
            let places = (first * BLOCK..discs.count()).step_by(BLOCK);
            for (block, first) in blocks.iter_mut().zip(places) {
                let places = first..(first + BLOCK).min(discs.count());
                if listed.has_wall_near(places.clone(), skin) {
                    let near = places.filter(|&place| listed.is_at_wall(place, skin));
                    block.extend(near.map(|place| place as u32));
                }
            }
        });
        self.at_wall.clear();
        blocks.iter().for_each(|block| self.at_wall.extend_from_slice(block));
    }

    /// From now on discs are held against their present positions.
    fn refer_to(&mut self, phases: &[Phase], workers: &Workers) {
        self.reference_positions.resize(phases.len(), DVec2::ZERO);
        workers.pieces(&mut self.reference_positions, |first, reference_positions| {
            let discs = &phases[first..];
            reference_positions.iter_mut().zip(discs).for_each(|(here, p)| *here = p.position());
        });
        let limit = 0.499 * self.skin; // a little less than half the skin, for rounding
        self.limit_squared = limit * limit;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::phase::Phase;

    #[test]
    fn every_disc_near_a_wall_is_listed_also_beside_one_that_is_nowhere() {
        let golden = |k: usize| (0.618_033_988_749_895 * k as f64).fract();
        let place = |k: usize| match k {
            50 => DVec2::NAN,
            60 => DVec2::new(f64::INFINITY, 0.5),
            _ => DVec2::new(golden(k), 1.02 * k as f64 / 1000.0 - 0.01),
        };
        let phases: Vec<_> = (0..1000).map(|k| Phase::new(place(k), DVec2::ZERO)).collect();
        let radii: Vec<_> = (0..1000).map(|k| 0.01 * (1.0 + golden(3 * k))).collect();
        let ids: Vec<u32> = (0..1000).collect();
        let leaning = HalfPlane { point: DVec2::splat(0.5), normal: DVec2::new(0.6, -0.8) };
        for plane in HalfPlane::square(1.0).into_iter().chain([leaning]) {
            let discs = Extents { phases: &phases, radii: &radii };
            let boundary = Boundary::default();
            let planes = &[plane];
            let listed = Listed { discs, ids: &ids, boundary, planes, walls: &[], time: 0.0 };
            let mut list = NeighbourList::default();
            list.list_at_wall(listed, 0.005, &Workers::of(1));
            let near = (0..1000).filter(|&k| plane.distance(place(k)) < radii[k] + 0.005);
            assert_eq!(list.at_wall, near.map(|k| k as u32).collect::<Vec<_>>());
            assert!((10..600).contains(&list.at_wall.len()), "{}", list.at_wall.len());
        }
    }
}
