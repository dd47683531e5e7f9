//! How a pass is shared out to threads: runs of blocks, laid out once for each list.

use std::mem::take;
use std::ops::Range;

use glam::DVec2;

use super::block::BLOCK;
use super::halo::Halo;
use super::largest::Largest;
use super::moves::Booked;
use super::neighbour_list::NeighbourList;
use super::pair_buffer::PairBuffer;
use super::pairs::Interaction;
use super::phase::Phase;
use super::sweep::{Desk, Found, Share, Sweep};
use super::workers::Workers;

/// A thread's blocks from which on it pays to keep some of them for who is done first: each run of blocks
/// costs about one of them more, for the discs where two runs meet.
const WORTH_CUTTING: usize = 128;

/// Runs of blocks, with what the thread that serves each needs for itself.
#[derive(Default)]
pub(super) struct Runs {
    runs: Vec<Range<usize>>,
    desks: Vec<Desk>,
    /// One before each run, and one after the last.
    halos: Vec<Halo>,
    found: Vec<Found>,
    powers: Vec<[f64; 2]>,
}

/// What lies beside the discs as they are stored, or their pairs, and changes in a sweep.
pub(super) struct Beside<'a> {
    pub phases: &'a mut [Phase],
    pub reference_positions: &'a mut [DVec2],
    pub forces: &'a mut [DVec2],
    pub springs: &'a mut [DVec2],
    pub memory: &'a mut [f64],
    pub books: &'a mut [Booked],
    pub far: &'a PairBuffer,
}

impl Runs {
    /// Lays out runs of so many blocks for `threads`.
    pub fn share_out(&mut self, list: &NeighbourList, blocks: usize, threads: usize) {
        self.runs = runs_of_blocks(blocks, threads);
        self.desks.resize_with(self.runs.len(), Desk::default);
        self.halos.resize_with(self.runs.len() + 1, Halo::none);
        for (k, halo) in self.halos.iter_mut().enumerate() {
            match self.runs.get(k) {
                Some(run) if k > 0 => halo.lay_out(list, run.start),
                _ => *halo = Halo::none(),
            }
        }
    }

    /// Has the workers serve all runs, and says what it found.
    pub fn serve<I: Interaction>(
        &mut self,
        sweep: &Sweep<I>,
        beside: Beside,
        largest: &Largest,
        workers: &Workers,
    ) -> Found {
        let Beside {
            mut phases,
            mut reference_positions,
            mut forces,
            mut springs,
            mut memory,
            mut books,
            far,
        } = beside;
        if sweep.adds_up {
            self.halos.iter_mut().for_each(|halo| halo.copy(phases, memory));
        }
        self.find_nothing_yet(largest);
        let mut powers = &mut self.powers[..];
        let halos = self.halos.windows(2).map(|halos| [&halos[0], &halos[1]]);
        let shares = self.runs.iter().zip(halos).zip(&mut self.desks).zip(&mut self.found);
        let mut shares: Vec<_> = shares
            .map(|(((blocks, halos), desk), found)| {
                let discs = blocks.len() * BLOCK;
                let pairs = sweep.list.pairs_of_run(blocks).len();
                let share = Share {
                    phases: first_of(&mut phases, discs),
                    forces: first_of(&mut forces, discs),
                    springs: first_of(&mut springs, discs),
                    memory: first_of(&mut memory, pairs),
                    reference_positions: first_of(&mut reference_positions, discs),
                    books: first_of(&mut books, blocks.len() * sweep.kicks),
                    powers: first_of(&mut powers, blocks.len()),
                    blocks: blocks.clone(),
                    halos,
                    far,
                    found,
                };
                (share, desk)
            })
            .collect();
        workers.each(&mut shares, |(share, desk)| sweep.serve(share, desk));
        self.all_found()
    }

    fn find_nothing_yet(&mut self, largest: &Largest) {
        let nothing = Found { largest: largest.clone(), farthest: 0.0, power: [0.0; 2] };
        self.found.clear();
        self.found.resize(self.runs.len(), nothing);
        self.powers.clear();
        self.powers.resize(self.runs.last().map_or(0, |run| run.end), [0.0; 2]);
    }

    fn all_found(&self) -> Found {
        let mut found = self.found.iter();
        let first = found.next().cloned().unwrap_or_default();
        let mut all = found.fold(first, |all, found| all.and(found));
        for power in &self.powers {
            (0..2).for_each(|k| all.power[k] += power[k]); // in the order of the blocks
        }
        all
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

/// The first `length` of what is there, which is there no more.
fn first_of<'a, T>(there: &mut &'a mut [T], length: usize) -> &'a mut [T] {
    let length = length.min(there.len());
    let (first, rest) = take(there).split_at_mut(length);
    *there = rest;
    first
}
