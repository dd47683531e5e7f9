//! One pass over the discs: every pair is computed once, every disc adds its pairs up in ascending
//! id of the partner, and then it moves.
//!
//! Pairs of a block of discs are walked first, then the discs of the block gather, then they move:
//! nobody looks at them any more in this sweep. A disc's other pairs were walked shortly before, with discs
//! stored before it, so that only the last of the pairs' pushes are kept, in a ring that stays in the
//! processor's nearest memory. Who begins in the middle walks some of the pairs before it too: the
//! same numbers, computed twice, from copies of discs that another thread may have moved already.

mod far;
mod gather;
mod sums;

use std::ops::Range;
use std::sync::Arc;

use glam::DVec2;
use wide::f64x4;

use self::sums::{Noted, Sums};
use super::added::Start;
#[cfg(target_arch = "x86_64")]
use super::avx2::{Avx2, Four};
#[cfg(all(target_arch = "x86_64", has_avx512))]
use super::avx512::Avx512;
use super::block::BLOCK;
use super::block_pairs::{BlockPairs, Fixed};
use super::constants::PairConstants;
use super::halo::Halo;
use super::lanes::Lanes;
use super::largest::Largest;
use super::lookup::Lookup;
use super::moves::{Block, Booked, Move};
use super::neighbour_list::{GROUP, NeighbourList};
use super::pair_buffer::{Entry, PairBuffer, Split, Whole};
use super::pairs::Interaction;
use super::phase::Phase;
use super::walk::Scratch;
use crate::boundary::Boundary;
use crate::force::HalfPlane;
use crate::wall::Wall;

/// What a pass needs to know.
pub(super) struct Sweep<'a, I> {
    pub interaction: &'a I,
    pub planes: &'a [HalfPlane],
    pub walls: &'a [Arc<dyn Wall>],
    /// When forces are added up, s.
    pub time: f64,
    pub gravity: DVec2, // m/s2
    pub boundary: Boundary,
    pub list: &'a NeighbourList,
    pub constants: &'a PairConstants,
    pub fixed: Fixed<'a>,
    /// What the sums begin with, as discs are stored; empty if that is the weight.
    pub starts: &'a [Start],
    /// Whether forces are to be added up.
    pub adds_up: bool,
    /// Whether the springs' share of them is, too.
    pub has_ledger: bool,
    /// Whether somebody may ask for forces later.
    pub keeps_forces: bool,
    /// Time of drift since forces were last added up, s.
    pub elapsed: f64,
    /// What the discs do then, and how many kicks are to be booked.
    pub moves: &'a [Move],
    pub kicks: usize,
}

/// What one thread does in a sweep: the blocks of discs it serves, and where it puts what it finds.
pub(super) struct Share<'a> {
    pub blocks: Range<usize>,
    pub phases: &'a mut [Phase],
    pub forces: &'a mut [DVec2],
    pub springs: &'a mut [DVec2],
    /// What the pairs of the blocks remember.
    pub memory: &'a mut [f64],
    pub reference_positions: &'a mut [DVec2],
    pub books: &'a mut [Booked],
    /// Of each block, the power of walls that move on its discs, and the dashpots' part of it, W.
    pub powers: &'a mut [[f64; 2]],
    /// Where it meets the thread before, and the one after.
    pub halos: [&'a Halo; 2],
    /// The forces of far pairs.
    pub far: &'a PairBuffer,
    pub found: &'a mut Found,
}

impl Share<'_> {
    /// Where among its discs those of a block are.
    fn discs_of(&self, block: usize) -> Range<usize> {
        let start = (block - self.blocks.start) * BLOCK;
        start..(start + BLOCK).min(self.phases.len())
    }
}

/// What a thread has for itself from pass to sweep.
#[derive(Default)]
pub(super) struct Desk {
    ring: PairBuffer,
    by_hand: Box<ByHand>,
}

/// What is needed for one block, and then for the next.
#[derive(Default)]
struct ByHand {
    scratch: Scratch,
    /// Forces on its discs that nobody wants to keep, and the springs' share, N.
    forces: OfBlock,
    springs: OfBlock,
}

/// A vector for each disc of a block, aligned to lines of the cache.
#[repr(align(64))]
struct OfBlock([DVec2; BLOCK]);

impl Default for OfBlock {
    fn default() -> Self {
        Self([DVec2::ZERO; BLOCK])
    }
}

/// What is found on the way.
#[derive(Clone, Default)]
pub(super) struct Found {
    pub largest: Largest,
    /// The square of how far the farthest disc is from where it was listed, m2.
    pub farthest: f64,
    /// Power of walls that move on discs, and the dashpots' part of it, W; added up once all blocks are served.
    pub power: [f64; 2],
}

impl Found {
    /// What both have found.
    pub fn and(mut self, other: &Self) -> Self {
        self.largest.join(&other.largest);
        self.farthest = self.farthest.max(other.farthest);
        self
    }
}

impl<I: Interaction> Sweep<'_, I> {
    /// Adds up weight, walls and pairs of every disc of `share`, in this order, and moves it.
    pub fn serve(&self, share: &mut Share, desk: &mut Desk) {
        #[cfg(all(target_arch = "x86_64", has_avx512))]
        if let Some(zero) = Four::<Avx512>::on_this_processor() {
            return zero.run(
                #[inline(always)]
                || self.serve_in(zero, share, desk),
            );
        }
        #[cfg(target_arch = "x86_64")]
        if let Some(zero) = Four::<Avx2>::on_this_processor() {
            return zero.run(
                #[inline(always)]
                || self.serve_in(zero, share, desk),
            );
        }
        self.serve_in(f64x4::ZERO, share, desk);
    }

    #[inline(always)]
    fn serve_in<V: Lanes>(&self, zero: V, share: &mut Share, desk: &mut Desk) {
        let Desk { ring, by_hand } = desk;
        let far = share.far;
        match self.has_ledger {
            false => self.serve_with::<V, Whole>(zero, &mut ring.whole, &far.whole, by_hand, share),
            true => self.serve_with::<V, Split>(zero, &mut ring.split, &far.split, by_hand, share),
        }
    }

    #[inline(always)]
    fn serve_with<V: Lanes, E: Entry<V>>(
        &self,
        zero: V,
        ring: &mut Vec<E::Both>,
        far: &[E::Both],
        by_hand: &mut ByHand,
        share: &mut Share,
    ) {
        if !self.adds_up {
            for block in share.blocks.clone() {
                self.go_on(block, share, by_hand, |block| block.go(zero, self.moves));
            }
            return;
        }
        let ring = self.ring_in::<V, E>(ring);
        self.begin::<V, E>(zero, ring, share, &mut by_hand.scratch);
        let usual = self.usual_start::<V, E>();
        let mut starts = [usual.unwrap_or_default(); BLOCK];
        for block in share.blocks.clone() {
            self.walk_own::<V, E>(zero, block, ring, share, &mut by_hand.scratch);
            let (at, discs) = (block - share.blocks.start, share.discs_of(block));
            let (largest, power) = (&mut share.found.largest, &mut share.powers[at]);
            let first = block * BLOCK;
            let discs = (block, &share.phases[discs], first);
            let noted = Noted { largest, power };
            let sums = self.sums::<V, E>(zero, discs, ring, far, &mut starts, noted);
            self.move_by(zero, block, &sums, share, by_hand);
            self.put_back::<V, E>((block, first), usual, &mut starts);
        }
    }

    /// Moves the discs of a block by the `sums` of forces on them.
    #[inline(always)]
    fn move_by<V: Lanes, E: Entry<V>>(
        &self,
        zero: V,
        block: usize,
        sums: &Sums<V, E>,
        share: &mut Share,
        by_hand: &mut ByHand,
    ) {
        let discs = share.discs_of(block);
        let (forces, springs) = self.kept(&discs, share.forces, share.springs, by_hand);
        if let ([Move::Kick(kick), Move::Drift(drift)], false) = (self.moves, self.keeps_forces) {
            let last = discs.len() - 1; // it may be moved by itself
            let spring;
            [forces[last], spring] = E::of(sums.on(last));
            springs.iter_mut().skip(last).for_each(|last| *last = spring);
            self.go_on(
                block,
                share,
                by_hand,
                #[inline(always)]
                |block| block.kick_and_drift(zero, [*kick, *drift], sums),
            );
        } else {
            sums.put(forces, springs);
            self.go_on(
                block,
                share,
                by_hand,
                #[inline(always)]
                |block| block.go(zero, self.moves),
            );
        }
    }

    /// Where forces on `discs` are put, and the springs' shares, or where they were put earlier.
    #[inline(always)]
    fn kept<'b>(
        &self,
        discs: &Range<usize>,
        forces: &'b mut [DVec2],
        springs: &'b mut [DVec2],
        by_hand: &'b mut ByHand,
    ) -> (&'b mut [DVec2], &'b mut [DVec2]) {
        let keeps = self.keeps_forces || !self.adds_up;
        let split = if self.has_ledger { discs.len() } else { 0 };
        let forces = match keeps {
            true => &mut forces[discs.clone()],
            false => &mut by_hand.forces.0[..discs.len()],
        };
        let springs = match springs.get_mut(discs.clone()) {
            Some(springs) if keeps => springs,
            _ => &mut by_hand.springs.0[..split],
        };
        (forces, springs)
    }

    /// Has `go` move the discs of a block.
    #[inline(always)]
    fn go_on(
        &self,
        block: usize,
        share: &mut Share,
        by_hand: &mut ByHand,
        go: impl FnOnce(Block) -> f64,
    ) {
        let discs = share.discs_of(block);
        let first = block * BLOCK;
        let places = first..first + discs.len();
        let (forces, springs) = self.kept(&discs, share.forces, share.springs, by_hand);
        let books = (block - share.blocks.start) * self.kicks;
        let reference_positions =
            share.reference_positions.get_mut(discs.clone()).unwrap_or_default();
        let farthest = go(Block {
            sizes: &self.fixed.sizes[places.clone()],
            mass: self.fixed.equal.map(|size| size.mass),
            phases: &mut share.phases[discs.clone()],
            forces,
            springs,
            starts: self.starts.get(places).unwrap_or_default(),
            reference_positions,
            books: &mut share.books[books..books + self.kicks],
            gravity: self.gravity,
        });
        share.found.farthest = share.found.farthest.max(farthest);
        self.wrap(block, &mut share.phases[discs], reference_positions);
    }

    /// Puts the forces of a block's own pairs into the ring.
    #[inline(always)]
    fn walk_own<V: Lanes, E: Entry<V>>(
        &self,
        zero: V,
        block: usize,
        ring: &mut [E::Both],
        share: &mut Share,
        scratch: &mut Scratch,
    ) {
        let ahead = match block < share.halos[1].first_block {
            true => &share.phases[share.discs_of(block).start..],
            false => share.halos[1].discs_after(block),
        };
        let pairs = self.list.pairs_of(block);
        let before = self.list.pairs_of(share.blocks.start).start;
        let memory = share.memory.get_mut(pairs.start - before..pairs.end - before);
        let memory = memory.unwrap_or_default();
        let largest = &mut share.found.largest;
        self.walk::<V, E>(zero, (block, pairs), ahead, memory, ring, scratch, largest);
    }

    /// Brings discs that have left a periodic space back into it, and where they were listed along with them.
    fn wrap(&self, block: usize, discs: &mut [Phase], reference_positions: &mut [DVec2]) {
        for &place in self.list.at_edge_of(block) {
            let here = place as usize - block * BLOCK;
            let shift = self.boundary.wrap(discs[here].position());
            if shift != DVec2::ZERO {
                discs[here] = Phase::new(discs[here].position() + shift, discs[here].velocity());
                reference_positions[here] += shift;
            }
        }
    }

    /// The ring: room for the pairs, and at the end for no force at all. It begins with a line of the cache, so that no store
    /// into it crosses one.
    #[inline(always)]
    fn ring_in<'b, V: Lanes, E: Entry<V>>(&self, room: &'b mut Vec<E::Both>) -> &'b mut [E::Both] {
        let nothing = E::Both::default();
        room.resize(self.list.ring_length + 2, nothing);
        let first = room.as_ptr().align_offset(64).min(1);
        let ring = &mut room[first..][..self.list.ring_length + 1];
        ring[self.list.ring_length] = nothing;
        ring
    }

    /// Makes the ring ready for those who begin at `block`.
    #[inline(always)]
    fn begin<V: Lanes, E: Entry<V>>(
        &self,
        zero: V,
        ring: &mut [E::Both],
        share: &Share,
        scratch: &mut Scratch,
    ) {
        let (halo, block) = (share.halos[0], share.blocks.start);
        let reaches_back_to = self.list.reaches_back_to[block] as usize / GROUP * GROUP;
        let mut memory = halo.memory.clone(); // thrown away: the thread before has them
        let largest = &mut share.found.largest.clone(); // as well
        for before in halo.first_block..block {
            let Range { start, end } = self.list.pairs_of(before);
            let pairs = start.max(reaches_back_to)..end;
            if pairs.is_empty() {
                continue;
            }
            let remembered = pairs.start - halo.first_pair..pairs.end - halo.first_pair;
            let discs = halo.discs_after(before);
            let remembered = memory.get_mut(remembered).unwrap_or_default();
            self.walk::<V, E>(zero, (before, pairs), discs, remembered, ring, scratch, largest);
        }
    }

    /// Puts the forces of these pairs of one block into the ring; `discs` are the block's and those after.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)]
    fn walk<V: Lanes, E: Entry<V>>(
        &self,
        zero: V,
        (block, pairs): (usize, Range<usize>),
        discs: &[Phase],
        memory: &mut [f64],
        ring: &mut [E::Both],
        scratch: &mut Scratch,
        largest: &mut Largest,
    ) {
        if pairs.is_empty() {
            return;
        }
        let ring = &mut ring[..self.list.ring_length];
        let slot = pairs.start % ring.len();
        let mut block = BlockPairs {
            fixed: self.fixed,
            constants: self.constants,
            // SAFETY: pairs of a block name no place from `reach_of` on: the list was made so.
            #[allow(unsafe_code)]
            discs: unsafe { Lookup::new(discs, self.list.reach_of(block)) },
            place: block * BLOCK,
            first: pairs.start,
            pairs: &self.list.pairs[pairs],
            memory,
            elapsed: self.elapsed,
        };
        self.interaction.walk::<V, E>(zero, &mut block, ring, slot, scratch, largest);
    }
}
