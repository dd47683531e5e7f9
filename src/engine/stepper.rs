//! The discs, what acts on them, and what was asked of them and is not done yet.

use std::mem::take;
use std::sync::{Arc, OnceLock};

use glam::DVec2;

use super::added::Added;
use super::block::BLOCK;
use super::block_pairs::Fixed;
use super::constants::PairConstants;
use super::largest::Largest;
use super::moment::Moment;
use super::moves::{Booked, Move};
use super::neighbour_list::NeighbourList;
use super::pair_buffer::PairBuffer;
use super::pair_memory::PairMemory;
use super::pairs::Interaction;
use super::phase::{Phase, Size};
use super::runs::{Beside, Runs};
use super::since::{Resized, Since};
use super::sweep::{Found, Sweep};
use super::workers::Workers;
use crate::boundary::Boundary;
use crate::discs::Discs;
use crate::discs::columns::Columns;
use crate::force::HalfPlane;
use crate::integrator::Motion;
use crate::particle::Particle;
use crate::wall::Wall;
use crate::work::Channel;

/// Many discs that act on each other, and walls.
pub struct Engine<I> {
    pub(super) interaction: I,
    pub(super) planes: Vec<HalfPlane>,
    /// Other walls, which may move; how fast the fastest of them is, m/s; and what they do: power on discs, and the dashpots'
    /// part of it, W.
    pub(super) walls: Vec<Arc<dyn Wall>>,
    pub(super) top_speed: f64,
    pub(super) power: [f64; 2],
    pub(super) boundary: Boundary,
    pub(super) gravity: DVec2, // m/s2
    pub(super) dt: f64,        // s
    /// The discs as they are stored: where they are and how they move, how large they are, and what pushed them when
    /// somebody last wanted to keep that (N).
    pub(super) phases: Vec<Phase>,
    pub(super) sizes: Vec<Size>,
    pub(super) forces: Vec<DVec2>,
    /// The size of all discs, if it is one.
    pub(super) equal: Option<Size>,
    /// What is remembered beside them (but for the list's own columns).
    pub(super) columns: Columns,
    pub(super) list: NeighbourList,
    pub(super) constants: PairConstants,
    pub(super) memory: PairMemory,
    /// Made when asked for: what pairs remember, by ids.
    pub(super) live: OnceLock<(Vec<[u32; 2]>, Vec<f64>)>,
    /// Forces that are no contacts.
    pub(super) added: Added,
    /// Asked for, and not done yet: first to add up the forces, then to move.
    pub(super) forces_are_wanted: bool,
    pub(super) moves: Vec<Move>,
    /// Time of drift since forces were last added up, s.
    pub(super) elapsed: f64,
    pub(super) moment: Moment,
    pub(super) workers: Workers,
    pub(super) runs: Runs,
    pub(super) far: PairBuffer,
    pub(super) books: Vec<Booked>,
    /// What the discs have done since the forces in them were added up.
    pub(super) since_forces: Since,
    /// Size changes by hand: the disc, and what it was.
    pub(super) resized: Vec<Resized>,
    /// Made when asked for: the discs in id order, as they are stored, and where each id is stored.
    pub(super) in_id_order: OnceLock<Vec<Particle>>,
    pub(super) as_stored: OnceLock<Vec<Particle>>,
    pub(super) places: OnceLock<Vec<u32>>,
}

impl<I: Interaction> Engine<I> {
    /// Does what was asked for. `keeps_forces` says whether somebody may ask for forces before they are added up anew.
    pub(super) fn carry_out(&mut self, keeps_forces: bool) {
        if self.moves.is_empty() && !self.forces_are_wanted {
            return;
        }
        self.forget_copies();
        if self.forces_are_wanted {
            self.add_up_added();
        }
        let found = self.go_through(keeps_forces);
        self.columns.overlaps = found.largest.overlaps;
        if self.forces_are_wanted {
            self.since_forces = Since::Still;
            self.elapsed = 0.0;
        }
        self.since_forces = self.since_forces.and_then(&self.moves);
        for to_do in self.moves.drain(..) {
            self.elapsed += if let Move::Drift(dt) = to_do { dt } else { 0.0 };
        }
        self.forces_are_wanted = false;
        if found.farthest > self.list.limit_squared {
            self.forget_list();
        }
    }

    /// One pass over all discs, shared out to the workers.
    pub(super) fn go_through(&mut self, keeps_forces: bool) -> Found {
        let kicks = self.open_books();
        let has_ledger = self.has_ledger();
        let mut reference_positions = take(&mut self.list.reference_positions); // it moves with discs that are brought back
        let sweep = Sweep {
            interaction: &self.interaction,
            planes: &self.planes,
            walls: &self.walls,
            time: self.moment.of_forces(),
            gravity: self.gravity,
            boundary: self.boundary,
            list: &self.list,
            constants: &self.constants,
            fixed: Fixed::of(&self.sizes, self.equal, &self.columns.ids, &self.columns.kinds),
            starts: self.added.starts(),
            adds_up: self.forces_are_wanted,
            has_ledger,
            keeps_forces,
            elapsed: self.elapsed,
            moves: &self.moves,
            kicks,
        };
        let mut largest = Largest::of(self.columns.overlaps);
        if sweep.adds_up {
            let memory = &mut self.memory.far;
            sweep.far(&self.phases, memory, &self.workers, &mut self.far, &mut largest);
        }
        let beside = Beside {
            phases: &mut self.phases,
            reference_positions: &mut reference_positions,
            forces: &mut self.forces,
            springs: &mut self.columns.springs,
            memory: &mut self.memory.near,
            books: &mut self.books,
            far: &self.far,
        };
        let found = self.runs.serve(&sweep, beside, &largest, &self.workers);
        self.list.reference_positions = reference_positions;
        self.book(kicks, &found);
        found
    }

    /// Makes room for what the blocks will book, and says in how many kicks.
    fn open_books(&mut self) -> usize {
        let is_kick = |to_do: &&Move| matches!(to_do, Move::Kick(_));
        let kicks = match self.has_ledger() {
            true => self.moves.iter().filter(is_kick).count(),
            false => 0,
        };
        self.books.clear();
        self.books.resize(self.phases.len().div_ceil(BLOCK) * kicks, Booked::default());
        kicks
    }

    /// Adds up what the blocks have booked, kick by kick and block by block, and what was `found` of walls.
    fn book(&mut self, kicks: usize, found: &Found) {
        if self.forces_are_wanted {
            self.power = found.power;
        }
        let kinds =
            [Channel::Gravity, Channel::NormalSpring, Channel::NormalDashpot, Channel::Field];
        for kick in 0..kicks {
            for sums in self.books.iter().skip(kick).step_by(kicks) {
                let works = &mut self.columns.works;
                kinds.iter().zip(sums).for_each(|(kind, sum)| works[*kind].work.add(*sum));
            }
        }
        self.book_walls();
    }

    /// Books what walls that move supply in the kicks that are asked for.
    fn book_walls(&mut self) {
        let [power, by_dashpots] = self.power;
        if power == 0.0 || !self.has_ledger() {
            return;
        }
        for to_do in &self.moves {
            if let Move::Kick(dt) = *to_do {
                let works = &mut self.columns.works;
                works[Channel::Wall].beside.add(power * dt);
                works[Channel::NormalDashpot].beside.add(-by_dashpots * dt);
            }
        }
    }
}

impl<I: Interaction> Motion for Engine<I> {
    fn kick(&mut self, dt: f64) {
        self.moves.push(Move::Kick(dt));
    }

    fn drift(&mut self, dt: f64) {
        self.moment.drift(dt);
        self.moves.push(Move::Drift(dt));
    }

    fn update_forces(&mut self) {
        self.carry_out(false);
        self.moment.ask_for_forces();
        if self.top_speed * self.moment.since_list() > self.list.limit_squared.sqrt() {
            self.forget_list(); // walls have come too far
        }
        if !self.list.is_there {
            self.list();
        }
        self.forces_are_wanted = true;
    }

    fn each(&mut self, change: &(dyn Fn(u32, &mut Particle) + Sync)) {
        self.settle();
        self.change_each(change);
        self.since_forces = Since::Unknown;
        // Nothing is asked for: this only looks how far the discs have come.
        if self.go_through(true).farthest > self.list.limit_squared {
            self.forget_list();
        }
    }
}
