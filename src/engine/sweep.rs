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
use super::avx2::Four;
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
    pub desk: &'a mut Desk,
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
    pub fn serve(&self, share: &mut Share) {
        #[cfg(target_arch = "x86_64")]
        if let Some(zero) = Four::on_this_processor() {
            return zero.run(
                #[inline(always)]
                || self.serve_in(zero, share),
            );
        }
        self.serve_in(f64x4::ZERO, share);
    }

    #[inline(always)]
    fn serve_in<V: Lanes>(&self, zero: V, share: &mut Share) {
        let mut desk = std::mem::take(share.desk); // so that it is nobody's while `share` is
        let Desk { ring, by_hand } = &mut desk;
        let far = share.far;
        match self.has_ledger {
            false => self.serve_with::<V, Whole>(zero, &mut ring.whole, &far.whole, by_hand, share),
            true => self.serve_with::<V, Split>(zero, &mut ring.split, &far.split, by_hand, share),
        }
        *share.desk = desk;
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
        if self.adds_up {
            self.begin::<V, E>(zero, ring, share, &mut by_hand.scratch);
        }
        for block in share.blocks.clone() {
            if self.adds_up {
                self.walk_own::<V, E>(zero, block, ring, share, &mut by_hand.scratch);
                let (at, discs) = (block - share.blocks.start, share.discs_of(block));
                let sums = self.sums(&discs, share.forces, share.springs, by_hand);
                let (largest, power) = (&mut share.found.largest, &mut share.powers[at]);
                let first = share.blocks.start * BLOCK + discs.start;
                let discs = (&share.phases[discs], first);
                self.gather::<V, E>(zero, discs, ring, far, sums, Noted { largest, power });
            }
            self.go_on(zero, block, share, by_hand);
        }
    }

    /// Where forces on `discs` are put, or where they were put earlier.
    #[inline(always)]
    fn sums<'b>(
        &self,
        discs: &Range<usize>,
        forces: &'b mut [DVec2],
        springs: &'b mut [DVec2],
        by_hand: &'b mut ByHand,
    ) -> Sums<'b> {
        let ByHand { forces: forces_here, springs: springs_here, .. } = by_hand;
        let keeps = self.keeps_forces || !self.adds_up;
        let split = if self.has_ledger { discs.len() } else { 0 };
        Sums {
            forces: match keeps {
                true => &mut forces[discs.clone()],
                false => &mut forces_here.0[..discs.len()],
            },
            springs: match springs.get_mut(discs.clone()) {
                Some(springs) if keeps => springs,
                _ => &mut springs_here.0[..split],
            },
        }
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

    /// Moves the discs of a block.
    #[inline(always)]
    fn go_on<V: Lanes>(&self, zero: V, block: usize, share: &mut Share, by_hand: &mut ByHand) {
        let discs = share.discs_of(block);
        let first = share.blocks.start * BLOCK + discs.start;
        let places = first..first + discs.len();
        let Sums { forces, springs } = self.sums(&discs, share.forces, share.springs, by_hand);
        let books = (block - share.blocks.start) * self.kicks;
        let reference_positions =
            share.reference_positions.get_mut(discs.clone()).unwrap_or_default();
        let block = Block {
            sizes: &self.fixed.sizes[places.clone()],
            mass: self.fixed.equal.map(|size| size.mass),
            phases: &mut share.phases[discs.clone()],
            forces,
            springs,
            starts: self.starts.get(places).unwrap_or_default(),
            reference_positions,
            books: &mut share.books[books..books + self.kicks],
            gravity: self.gravity,
        };
        let farthest = block.go(zero, self.moves);
        share.found.farthest = share.found.farthest.max(farthest);
        self.wrap(&mut share.phases[discs], first, reference_positions);
    }

    /// Brings discs that have left a periodic space back into it, and where they were listed along with them.
    fn wrap(&self, discs: &mut [Phase], first: usize, reference_positions: &mut [DVec2]) {
        for &place in self.list.at_edge_among(&(first..first + discs.len())) {
            let here = place as usize - first;
            let shift = self.boundary.wrap(discs[here].position());
            if shift != DVec2::ZERO {
                discs[here] = Phase::new(discs[here].position() + shift, discs[here].velocity());
                reference_positions[here] += shift;
            }
        }
    }

    /// Makes the ring ready for those who begin at `block`.
    #[inline(always)]
    fn begin<V: Lanes, E: Entry<V>>(
        &self,
        zero: V,
        ring: &mut Vec<E::Both>,
        share: &Share,
        scratch: &mut Scratch,
    ) {
        let (halo, block) = (share.halos[0], share.blocks.start);
        // Room for the pairs, and at the end for no force at all.
        let nothing = E::Both::default();
        ring.resize(self.list.ring_length + 1, nothing);
        ring[self.list.ring_length] = nothing;
        let reaches_back_to = self.list.reaches_back_to[block] as usize / GROUP * GROUP;
        let mut memory = halo.memory.clone(); // thrown away: the thread before has them
        for before in halo.first_block..block {
            let Range { start, end } = self.list.pairs_of(before);
            let pairs = start.max(reaches_back_to)..end;
            if pairs.is_empty() {
                continue;
            }
            let remembered = pairs.start - halo.first_pair..pairs.end - halo.first_pair;
            let (discs, largest) = (halo.discs_after(before), &mut Largest::default());
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
