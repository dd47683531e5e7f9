//! The making of a list: near pairs are found by a [`search`], laid out by [`blocks`], and named disc by disc as
//! [`parts`]; discs near walls are listed here.

mod blocks;
mod parts;
mod search;

pub(super) use self::search::Search;
use super::Near;
use super::skin::{best_skin, widest_skin};
use crate::crowd::BLOCK;
use crate::crowd::levels::{Level, levels};
use crate::crowd::sizes::Sizes;
use crate::crowd::team::Team;
use crate::discs::Snapshot;
use crate::force::HalfPlane;
use crate::particle::Particle;

/// What a list is made of.
#[derive(Clone, Copy)]
pub(in crate::crowd) struct Listed<'a> {
    /// The discs as they are stored, and their ids.
    pub particles: &'a [Particle],
    pub ids: &'a [u32],
    pub planes: &'a [HalfPlane],
}

impl Near {
    /// A new list, for discs of these `sizes`, stored cell by cell, of which the fastest goes `travel` m a step.
    pub fn make(&mut self, listed: Listed, sizes: &Sizes, travel: f64, team: &Team) {
        let particles = listed.particles;
        let widest = widest_skin(sizes, travel);
        let levels = levels(particles, sizes, widest, team);
        let search = Search { particles, skin: widest };
        self.skin = best_skin(search, &levels, sizes, travel, team);
        self.list(listed, &levels, self.skin, team);
        self.refer_to(particles, team);
        self.made += 1;
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
        let levels =
            levels(listed.particles, &Sizes::of(listed.particles, listed.ids, team), skin, team);
        self.list(listed, &levels, skin, team);
    }

    fn list(&mut self, listed: Listed, levels: &[Level], skin: f64, team: &Team) {
        self.list_pairs(Search { particles: listed.particles, skin }, levels, team);
        self.list_parts(listed.ids, team);
        self.list_at_wall(listed, skin, team);
        self.is_there = true;
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

    /// From now on discs are held against their present positions.
    fn refer_to(&mut self, particles: &[Particle], team: &Team) {
        self.listed_at.resize(particles.len(), [0.0; 2]);
        team.pieces(&mut self.listed_at, |first, listed_at| {
            let discs = &particles[first..];
            listed_at.iter_mut().zip(discs).for_each(|(here, p)| *here = p.position.to_array());
        });
        let limit = 0.499 * self.skin; // a little less than half the skin, for rounding
        self.limit_squared = limit * limit;
    }
}
