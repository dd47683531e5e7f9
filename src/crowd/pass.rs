//! One pass over the discs: every contact is computed once, every disc adds its contacts up in ascending
//! id of the partner, and then it moves.
//!
//! Pairs of a block of discs are walked first, then the discs of the block gather, then they move:
//! nobody looks at them any more in this pass. A disc's other pairs were walked shortly before, with discs
//! stored before it, so that only the last of the pairs' pushes are kept, in a ring that stays in the
//! processor's nearest memory. Who begins in the middle walks some of the pairs before it too: the
//! same numbers, computed twice, from copies of discs that another thread may have moved already.

use std::ops::Range;

use glam::DVec2;
use wide::f64x4;

#[cfg(target_arch = "x86_64")]
use super::avx2::Four;
use super::lane_law::LaneLaw;
use super::lanes::Lanes;
use super::largest::Largest;
use super::motion::{Block, Booked, Move};
use super::near::Near;
use super::ring::{Kept, Ring, Split, Whole};
use super::seam::Seam;
use super::{BLOCK, contact_lanes};
use crate::force::HalfPlane;
use crate::particle::{Contact, Particle};

/// What a pass needs to know.
pub(super) struct Pass<'a, L> {
    pub law: &'a L,
    pub planes: &'a [HalfPlane],
    pub gravity: DVec2, // m/s2
    pub near: &'a Near,
    /// Whether forces are to be added up.
    pub adds_up: bool,
    /// Whether the springs' share of them is, too.
    pub has_ledger: bool,
    /// Whether somebody may ask for that share later.
    pub keeps_springs: bool,
    /// What the discs do then, and how many kicks are to be booked.
    pub moves: &'a [Move],
    pub kicks: usize,
}

/// What one thread does in a pass: the blocks of discs it serves, and where it puts what it finds.
pub(super) struct Share<'a> {
    pub blocks: Range<usize>,
    pub particles: &'a mut [Particle],
    pub springs: &'a mut [DVec2],
    pub listed_at: &'a [[f64; 2]],
    pub books: &'a mut [Booked],
    /// Where it meets the thread before, and the one after.
    pub seams: [&'a Seam; 2],
    pub ring: &'a mut Ring,
    /// The forces of far pairs, of which no thread knows when their discs are moved.
    pub far: &'a Ring,
    pub found: &'a mut Found,
}

/// What is found on the way.
#[derive(Clone, Default)]
pub(super) struct Found {
    pub largest: Largest,
    /// The square of how far the farthest disc is from where it was listed, m2.
    pub farthest: f64,
}

impl Found {
    /// What both have found.
    pub fn and(mut self, other: &Self) -> Self {
        self.largest.join(&other.largest);
        self.farthest = self.farthest.max(other.farthest);
        self
    }
}

impl<L: LaneLaw + Clone> Pass<'_, L> {
    /// Adds up weight, walls and contacts of every disc of `share`, in this order, and moves it.
    pub fn serve(&self, share: Share) {
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
    fn serve_in<V: Lanes>(&self, zero: V, share: Share) {
        let mut ring = std::mem::take(share.ring);
        let kept = match self.has_ledger {
            false => self.serve_with::<V, Whole>(zero, &mut ring.whole, &share.far.whole, share),
            true => self.serve_with::<V, Split>(zero, &mut ring.split, &share.far.split, share),
        };
        *kept = ring;
    }

    #[inline(always)]
    fn serve_with<'a, V: Lanes, K: Kept<V>>(
        &self,
        zero: V,
        ring: &mut Vec<[K::Stored; 2]>,
        far: &[[K::Stored; 2]],
        share: Share<'a>,
    ) -> &'a mut Ring {
        let Share {
            blocks, particles, springs, listed_at, books, seams, ring: kept, found, ..
        } = share;
        let first = blocks.start * BLOCK;
        let mut books = books.chunks_mut(self.kicks.max(1));
        let mut springs_at_hand = [DVec2::ZERO; BLOCK];
        if self.adds_up {
            self.begin::<V, K>(zero, ring, far, seams[0], blocks.start);
        }
        for block in blocks {
            let start = block * BLOCK - first;
            let here = start..(start + BLOCK).min(particles.len());
            let springs = match springs.get_mut(here.clone()) {
                Some(springs) if self.keeps_springs || !self.adds_up => springs,
                _ => &mut springs_at_hand[..if self.has_ledger { here.len() } else { 0 }],
            };
            if self.adds_up {
                let ahead = match block < seams[1].first_block {
                    true => &particles[start..],
                    false => seams[1].discs_after(block),
                };
                let largest = &mut found.largest;
                self.walk::<V, K>(zero, self.near.pairs_of(block), ahead, ring, largest);
                let discs = &mut particles[here.clone()];
                self.gather::<V, K>(zero, discs, block * BLOCK, springs, ring, largest);
            }
            let listed_at = listed_at.get(here.clone()).unwrap_or_default();
            let books = books.next().unwrap_or_default();
            let block = Block { particles: &mut particles[here], springs, listed_at, books };
            found.farthest = found.farthest.max(block.go(zero, self.moves, self.gravity));
        }
        kept
    }

    /// Makes the ring ready for those who begin at `block`.
    #[inline(always)]
    fn begin<V: Lanes, K: Kept<V>>(
        &self,
        zero: V,
        ring: &mut Vec<[K::Stored; 2]>,
        far: &[[K::Stored; 2]],
        seam: &Seam,
        block: usize,
    ) {
        // Room for the pairs, then no force at all, then far pairs.
        let nothing = [K::Stored::default(); 2];
        ring.resize(self.near.ring_length, nothing);
        ring.push(nothing);
        ring.extend_from_slice(far);
        let reaches_back_to = self.near.reaches_back_to[block] as usize;
        for before in seam.first_block..block {
            let Range { start, end } = self.near.pairs_of(before);
            let pairs = start.max(reaches_back_to)..end;
            let discs = seam.discs_after(before);
            self.walk::<V, K>(zero, pairs, discs, ring, &mut Largest::default());
        }
    }

    /// Puts the forces of these pairs of one block into the ring; `discs` are the block's and those after.
    #[inline(always)]
    fn walk<V: Lanes, K: Kept<V>>(
        &self,
        zero: V,
        pairs: Range<usize>,
        discs: &[Particle],
        ring: &mut [[K::Stored; 2]],
        largest: &mut Largest,
    ) {
        if pairs.is_empty() {
            return;
        }
        let law = self.law.clone();
        let round = self.near.ring_length;
        let mut slot = pairs.start % round;
        for four in self.near.pairs[pairs].chunks_exact(4) {
            let four = [four[0], four[1], four[2], four[3]].map(|pair| pair.map(usize::from));
            let stored = stored::<L, V, K>(&law, zero, four, discs, largest);
            ring[slot..slot + 4].copy_from_slice(&stored);
            slot += 4;
            slot -= if slot < round { 0 } else { round };
        }
    }

    /// The forces of the far pairs of `particles`.
    pub fn far(&self, particles: &[Particle], largest: &mut Largest) -> Ring {
        let mut ring = Ring::default();
        if self.adds_up {
            match self.has_ledger {
                false => ring.whole = self.walk_far::<Whole>(particles, largest),
                true => ring.split = self.walk_far::<Split>(particles, largest),
            }
        }
        ring
    }

    fn walk_far<K: Kept<f64x4>>(
        &self,
        discs: &[Particle],
        largest: &mut Largest,
    ) -> Vec<[K::Stored; 2]> {
        let law = self.law.clone();
        let mut forces = Vec::new();
        for four in self.near.far.chunks(4) {
            let four_pairs =
                std::array::from_fn(|k| four[k.min(four.len() - 1)].map(|at| at as usize));
            let stored = stored::<L, f64x4, K>(&law, f64x4::ZERO, four_pairs, discs, largest);
            forces.extend_from_slice(&stored[..four.len()]);
        }
        forces
    }

    /// Adds up the forces on `discs`, the first of which is stored at `first`, and the springs' share.
    #[inline(always)]
    fn gather<V: Lanes, K: Kept<V>>(
        &self,
        zero: V,
        discs: &mut [Particle],
        first: usize,
        springs: &mut [DVec2],
        ring: &[[K::Stored; 2]],
        largest: &mut Largest,
    ) {
        let places = first..first + discs.len();
        let mut at_wall = self.near.at_wall_among(&places).iter();
        let mut next_at_wall = at_wall.next().map(|&place| place as usize - first);
        let mut more = self.near.more_among(&places);
        let (parts, ring) = (&self.near.parts[places], ring.as_flattened());
        for (here, (disc, parts)) in discs.iter_mut().zip(parts).enumerate() {
            let start = if next_at_wall == Some(here) {
                next_at_wall = at_wall.next().map(|&place| place as usize - first);
                let [force, spring] = self.touch_walls(disc, largest);
                K::start(zero, force, spring)
            } else {
                K::start(zero, disc.mass * self.gravity, DVec2::ZERO)
            };
            let sum = match more {
                [of, rest @ ..] if of.place as usize == first + here => {
                    more = rest;
                    let parts = of.parts[0] as usize..of.parts[1] as usize;
                    let parts = self.near.more_parts[parts].iter().map(|part| *part as usize);
                    parts.fold(start, |sum, part| K::plus(sum, ring[part]))
                }
                _ => parts.iter().fold(start, |sum, part| K::plus(sum, ring[usize::from(*part)])),
            };
            let [force, spring] = K::of(sum);
            disc.force = force;
            if K::HAS_SPRING {
                springs[here] = spring;
            }
        }
    }

    /// Weight and walls: the whole force and the springs' share, N.
    fn touch_walls(&self, disc: &Particle, largest: &mut Largest) -> [DVec2; 2] {
        let (mut force, mut spring) = (disc.mass * self.gravity, DVec2::ZERO);
        for plane in self.planes {
            let distance = plane.distance(disc.position);
            if let Some(contact) = Contact::with_wall(disc, distance, plane.normal) {
                force -= self.law.push(&contact) * contact.normal;
                spring -= self.law.spring(&contact) * contact.normal;
                let wall = &mut largest.tally.largest_wall_overlap;
                *wall = wall.max(contact.overlap / disc.radius);
            }
        }
        [force, spring]
    }
}

/// What is to be stored of the contacts of four pairs of `discs`.
#[inline(always)]
fn stored<L: LaneLaw, V: Lanes, K: Kept<V>>(
    law: &L,
    zero: V,
    [a, b, c, d]: [[usize; 2]; 4],
    discs: &[Particle],
    largest: &mut Largest,
) -> [[K::Stored; 2]; 4] {
    let at = |place: usize| &discs[place];
    let side = |k: usize| [at(a[k]), at(b[k]), at(c[k]), at(d[k])];
    match contact_lanes::forces(law, zero, [side(0), side(1)], largest) {
        Some(forces) => K::stored(forces),
        None => [[K::Stored::default(); 2]; 4],
    }
}
