//! Many discs, fast: the same physics as [`PlainDiscs`](crate::discs::PlainDiscs) with the contacts of [`crate::force`], to the
//! same bits, on any number of threads.
//!
//! What it does otherwise:
//! - Discs are stored cell by cell, so that those that touch lie close in memory too. Outside,
//!   everything is in id order.
//! - Each contact is computed once, four at a time; each disc then adds up its own in ascending id of
//!   the partner, whoever computed them.
//! - Forces, kicks and drifts are put off until forces are asked for again, and then done in one pass over the
//!   discs, block by block.
//! - The pass is shared out to threads by blocks of discs.
//!
//! Why the bits are the same is told in `docs/same-bits.md`.

mod as_discs;
#[cfg(target_arch = "x86_64")]
mod avx2;
mod cells;
mod contact_lanes;
mod kept;
mod lane_law;
mod lanes;
mod largest;
mod levels;
mod motion;
mod motion_lanes;
mod near;
mod pass;
mod ring;
mod seam;
mod sizes;
mod sums;
mod team;

use std::ops::Range;
use std::sync::OnceLock;

use glam::DVec2;

use self::cells::{Grid, put_in_order};
use self::kept::{Resized, Since};
pub use self::lane_law::{ContactLanes, LaneLaw};
pub use self::lanes::Lanes;
use self::largest::Largest;
use self::levels::usual_radius;
use self::motion::{Booked, Move};
use self::near::{Listed, Near, widest_skin};
use self::pass::{Found, Pass, Share};
use self::ring::Ring;
use self::seam::Seam;
use self::sizes::Sizes;
use self::team::Team;
use crate::discs::Discs;
use crate::force::{HalfPlane, Tally};
use crate::integrator::Motion;
use crate::particle::Particle;
use crate::work::Works;

/// Discs in a block: what is moved, walked or summed in one go. Sums are kept block by block and then
/// added in order, so that they do not depend on who did which.
const BLOCK: usize = 128;

/// Fewer discs than this are stepped by one thread unless more are asked for: sharing a step out costs
/// some microseconds.
pub const WORTH_SHARING: usize = 4000;

/// A thread's blocks from which on it pays to keep some of them for who is done first: each run of blocks
/// costs about one of them more, for the discs where two runs meet.
const WORTH_CUTTING: usize = 128;

/// Many discs with contacts between each other and with walls.
pub struct Crowd<L> {
    law: L,
    planes: Vec<HalfPlane>,
    gravity: DVec2, // m/s2
    dt: f64,        // s
    /// The discs as they are stored, and the id of each.
    particles: Vec<Particle>,
    ids: Vec<u32>,
    /// The springs' part of the forces on the discs as they are stored, N; empty without ledger.
    springs: Vec<DVec2>,
    near: Near,
    /// Asked for, and not done yet: first to add up the forces, then to move.
    forces_are_wanted: bool,
    moves: Vec<Move>,
    tally: Tally,
    works: Option<Works>,
    team: Team,
    rings: Vec<Ring>,
    seams: Vec<Seam>,
    /// What the discs have done since the forces in them were added up.
    since_forces: Since,
    /// Size changes by hand: the disc, and what it was.
    resized: Vec<Resized>,
    /// Made when asked for: the discs in id order, and where each id is stored.
    in_id_order: OnceLock<Vec<Particle>>,
    places: OnceLock<Vec<u32>>,
}

impl<L: LaneLaw + Clone + Sync + 'static> Crowd<L> {
    /// Discs under `gravity` (m/s2) that touch each other and the walls `planes` by `law`. They will be
    /// moved on by `dt` (s) a step, by `threads` threads.
    pub fn new(
        particles: Vec<Particle>,
        gravity: DVec2,
        law: L,
        planes: Vec<HalfPlane>,
        dt: f64,
        threads: usize,
    ) -> Self {
        let team = Team::of(threads);
        let mut crowd = Self {
            law,
            planes,
            gravity: gravity + DVec2::ZERO, // -0.0 would be told from the 0.0 of no contact
            dt,
            ids: (0..particles.len() as u32).collect(),
            particles,
            springs: Vec::new(),
            near: Near::default(),
            forces_are_wanted: false,
            moves: Vec::new(),
            tally: Tally::default(),
            works: None,
            rings: Vec::new(),
            seams: Vec::new(),
            team,
            since_forces: Since::Still,
            resized: Vec::new(),
            in_id_order: OnceLock::new(),
            places: OnceLock::new(),
        };
        crowd.near.forget();
        crowd.update_forces();
        crowd.settle();
        crowd
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.team.threads()
    }

    /// Does what was asked for. `keeps_springs` says whether somebody may ask for the springs' forces
    /// before they are added up anew.
    fn carry_out(&mut self, keeps_springs: bool) {
        if self.moves.is_empty() && !self.forces_are_wanted {
            return;
        }
        self.in_id_order.take();
        let moves = std::mem::take(&mut self.moves);
        let kicks = match self.works {
            Some(_) => moves.iter().filter(|to_do| matches!(to_do, Move::Kick(_))).count(),
            None => 0,
        };
        let mut books = vec![[0.0; 3]; self.particles.len().div_ceil(BLOCK) * kicks];
        let found = self.go_through(&moves, kicks, &mut books, keeps_springs);
        self.book(kicks, &books);
        self.tally = found.largest.tally;
        if self.forces_are_wanted {
            self.since_forces = Since::Still;
        }
        self.since_forces = self.since_forces.and_then(&moves);
        self.forces_are_wanted = false;
        self.moves = moves;
        self.moves.clear();
        if found.farthest > self.near.limit_squared {
            self.near.forget();
        }
    }

    /// One pass over all discs, shared out to the team.
    fn go_through(
        &mut self,
        moves: &[Move],
        kicks: usize,
        mut books: &mut [Booked],
        keeps_springs: bool,
    ) -> Found {
        let pass = Pass {
            law: &self.law,
            planes: &self.planes,
            gravity: self.gravity,
            near: &self.near,
            adds_up: self.forces_are_wanted,
            has_ledger: self.works.is_some(),
            keeps_springs,
            moves,
            kicks,
        };
        let runs = runs_of_blocks(self.particles.len().div_ceil(BLOCK), self.team.threads());
        self.rings.resize_with(runs.len(), Ring::default);
        self.seams.resize_with(runs.len() + 1, Seam::none);
        for (seam, run) in self.seams.iter_mut().zip(&runs).skip(1) {
            match pass.adds_up {
                true => seam.copy(&self.particles, &self.near, run.start),
                false => *seam = Seam::none(),
            }
        }
        *self.seams.last_mut().expect("one more than runs") = Seam::none();
        let mut nothing = Found { largest: Largest::of(&self.tally), farthest: 0.0 };
        let far = pass.far(&self.particles, &mut nothing.largest);
        let mut found = vec![nothing.clone(); runs.len()];
        let (mut particles, mut springs) = (&mut self.particles[..], &mut self.springs[..]);
        let seams = self.seams.windows(2).map(|seams| [&seams[0], &seams[1]]);
        let shares = runs.into_iter().zip(seams).zip(&mut self.rings).zip(&mut found);
        let shares = shares.map(|(((blocks, seams), ring), found)| Share {
            particles: first_of(&mut particles, blocks.len() * BLOCK),
            springs: first_of(&mut springs, blocks.len() * BLOCK),
            listed_at: places_of(&blocks, &self.near.listed_at),
            books: first_of(&mut books, blocks.len() * kicks),
            blocks,
            seams,
            ring,
            far: &far,
            found,
        });
        self.team.each(shares.collect(), |share| pass.serve(share));
        found.iter().fold(nothing, |all, found| all.and(found))
    }

    /// Adds up what the blocks have booked, kick by kick and block by block.
    fn book(&mut self, kicks: usize, books: &[Booked]) {
        let Some(works) = &mut self.works else { return };
        for kick in 0..kicks {
            for [gravity, spring, dashpot] in books.iter().skip(kick).step_by(kicks) {
                works.gravity.add(*gravity);
                works.spring.add(*spring);
                works.dashpot.add(*dashpot);
            }
        }
    }

    /// Stores the discs in this order: for each place, where its disc is now. What lies beside the discs
    /// goes with them. `order` is used up.
    fn store(&mut self, order: &mut [u32]) {
        let mut is_moved = false;
        put_in_order(order, |a, b| {
            is_moved = true;
            self.particles.swap(a, b);
            self.ids.swap(a, b);
            if !self.springs.is_empty() {
                self.springs.swap(a, b);
            }
        });
        if is_moved {
            self.in_id_order.take();
            self.places.take();
        }
    }

    /// Stores the discs cell by cell and lists who is near whom, with a skin for the present speeds.
    fn list(&mut self) {
        let sizes = Sizes::of(&self.particles, &self.ids, &self.team);
        let travel = (sizes.fastest * self.dt).min(sizes.largest_radius);
        // The cells of the median disc, however large the largest.
        let skin = widest_skin(&sizes, travel);
        let usual = usual_radius(&self.particles, &sizes, skin);
        let grid = Grid::new(&sizes, 2.0 * usual + skin);
        self.store(&mut grid.order(&self.particles, &self.ids, &self.team));
        let Self { particles, ids, planes, .. } = self;
        self.near.make(Listed { particles, ids, planes }, &sizes, travel, &self.team);
    }

    /// Stores the discs in id order again.
    fn restore_id_order(&mut self) {
        self.settle();
        let mut order: Vec<u32> = vec![0; self.ids.len()];
        for (place, &id) in (0..).zip(&self.ids) {
            order[id as usize] = place;
        }
        self.store(&mut order);
        self.in_id_order.take(); // the discs themselves may be about to change
        // Good for the energy of the present state; the next step stores the discs by cells again.
        let Self { particles, ids, planes, .. } = self;
        self.near.list_anywhere(Listed { particles, ids, planes }, &self.team);
        self.near.forget();
    }
}

/// The blocks as they are shared out to `threads`: one long run for each, and some short ones for who is
/// done first.
fn runs_of_blocks(blocks: usize, threads: usize) -> Vec<Range<usize>> {
    let each = blocks.div_ceil(threads).max(1);
    let (long, short) = match threads > 1 && each >= WORTH_CUTTING {
        true => (each - each / 8, (each / 16).max(WORTH_CUTTING / 4)),
        false => (each, each),
    };
    let mut next = 0;
    let run = |k| {
        let start = next;
        next = (start + if k < threads { long } else { short }).min(blocks);
        start..next
    };
    (0..).map(run).take_while(|run| !run.is_empty()).collect()
}

/// What lies beside the discs of these blocks.
fn places_of<'a, T>(blocks: &Range<usize>, beside: &'a [T]) -> &'a [T] {
    let [start, end] = [blocks.start, blocks.end].map(|block| (block * BLOCK).min(beside.len()));
    &beside[start..end]
}

/// The first `length` of what is there, which is there no more.
fn first_of<'a, T>(there: &mut &'a mut [T], length: usize) -> &'a mut [T] {
    let length = length.min(there.len());
    let (first, rest) = std::mem::take(there).split_at_mut(length);
    *there = rest;
    first
}

impl<L: LaneLaw + Clone + Sync + 'static> Motion for Crowd<L> {
    fn kick(&mut self, dt: f64) {
        self.moves.push(Move::Kick(dt));
    }

    fn drift(&mut self, dt: f64) {
        self.moves.push(Move::Drift(dt));
    }

    fn update_forces(&mut self) {
        self.carry_out(false);
        if !self.near.is_there {
            self.list();
        }
        self.forces_are_wanted = true;
    }

    fn particles_mut(&mut self) -> &mut [Particle] {
        self.restore_id_order();
        self.since_forces = Since::Unknown;
        &mut self.particles
    }
}
