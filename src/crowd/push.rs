//! One pass over all near pairs: every contact is computed once, and every disc adds its contacts up
//! in ascending id of the partner.
//!
//! Pairs of a block of discs are walked first, then the discs of the block gather. A disc's other
//! pairs were walked shortly before, with discs stored before it, so that only the last of the
//! pairs' pushes are kept, in a ring that stays in the processor's nearest memory. Who begins in
//! the middle walks some of the pairs before it too: the same numbers, computed twice.

use std::ops::Range;

use glam::DVec2;
use wide::f64x2;

use super::lane_law::LaneLaw;
use super::near::Near;
use super::{BLOCK, contact_lanes};
use crate::force::{HalfPlane, Tally};
use crate::particle::{Contact, Particle};

/// What is kept of a contact: on its first disc, and on its second.
pub(super) trait Kept: Copy {
    /// Whether the springs' share is told apart.
    const HAS_SPRING: bool;
    /// A force and the springs' share of it, N.
    fn of(force: f64x2, spring: f64x2) -> Self;
    /// The force, N.
    fn force(self) -> f64x2;
    /// The springs' share, N.
    fn spring(self) -> f64x2;
    /// The sum of both.
    fn plus(self, other: Self) -> Self;

    /// The sum of this and of all that `triples` name in the `ring`, one after the other.
    #[inline(always)]
    fn plus_all(self, triples: &[[u32; 3]], ring: &[Self]) -> Self {
        triples.iter().fold(self, |sum, &[first, second, third]| {
            let sum = sum.plus(ring[first as usize]).plus(ring[second as usize]);
            sum.plus(ring[third as usize])
        })
    }
}

/// The whole force alone.
impl Kept for f64x2 {
    const HAS_SPRING: bool = false;
    #[inline(always)]
    fn of(force: f64x2, _spring: f64x2) -> Self {
        force
    }
    #[inline(always)]
    fn force(self) -> f64x2 {
        self
    }
    #[inline(always)]
    fn spring(self) -> f64x2 {
        f64x2::ZERO
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        self + other
    }
}

/// The whole force and the springs' share, for the ledger.
impl Kept for [f64x2; 2] {
    const HAS_SPRING: bool = true;
    #[inline(always)]
    fn of(force: f64x2, spring: f64x2) -> Self {
        [force, spring]
    }
    #[inline(always)]
    fn force(self) -> f64x2 {
        self[0]
    }
    #[inline(always)]
    fn spring(self) -> f64x2 {
        self[1]
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        [self[0] + other[0], self[1] + other[1]]
    }
}

/// The last of the pairs' forces: for each pair that on its first disc, then that on its second.
#[derive(Default)]
pub(super) struct Ring {
    whole: Vec<[f64x2; 2]>,      // N
    split: Vec<[[f64x2; 2]; 2]>, // N, with a ledger
}

/// What a pass over the pairs needs to know.
pub(super) struct Pass<'a, L> {
    pub law: &'a L,
    pub planes: &'a [HalfPlane],
    pub gravity: DVec2, // m/s2
    pub particles: &'a [Particle],
    pub near: &'a Near,
}

/// What one thread does in a pass: the blocks of discs it serves, and where it puts what it finds.
pub(super) struct Share<'a> {
    pub blocks: Range<usize>,
    pub forces: &'a mut [DVec2],
    pub springs: &'a mut [DVec2],
    pub ring: &'a mut Ring,
    pub largest: &'a mut Largest,
}

impl<L: LaneLaw + Clone> Pass<'_, L> {
    /// Adds up weight, walls and contacts of every disc of `share`, in this order.
    pub fn serve(&self, share: Share) {
        let mut ring = std::mem::take(share.ring);
        let kept = match share.springs.is_empty() {
            true => self.serve_with::<f64x2>(&mut ring.whole, share),
            false => self.serve_with::<[f64x2; 2]>(&mut ring.split, share),
        };
        *kept = ring;
    }

    fn serve_with<'a, K: Kept>(&self, ring: &mut Vec<[K; 2]>, share: Share<'a>) -> &'a mut Ring {
        let Share { blocks, forces, springs, ring: kept, largest } = share;
        // Room for the pairs, and at the end for no force at all.
        let nothing = K::of(f64x2::ZERO, f64x2::ZERO);
        ring.resize(self.near.pairs_at_a_time + 1, [nothing; 2]);
        ring[self.near.pairs_at_a_time] = [nothing; 2];
        let first = blocks.start * BLOCK;
        let before =
            self.near.reaches_back_to[blocks.start] as usize..self.pairs_of(blocks.start).start;
        if !before.is_empty() {
            self.walk(before, ring, &mut Largest::default());
        }
        for block in blocks {
            self.walk(self.pairs_of(block), ring, largest);
            let places = block * BLOCK..((block + 1) * BLOCK).min(self.particles.len());
            let here = places.start - first..places.end - first;
            let springs = springs.get_mut(here.clone()).unwrap_or_default();
            self.gather(places, &mut forces[here], springs, ring, largest);
        }
        kept
    }

    fn pairs_of(&self, block: usize) -> Range<usize> {
        self.near.first_pair[block] as usize..self.near.first_pair[block + 1] as usize
    }

    /// Puts the forces of these pairs into the ring.
    #[inline(always)]
    fn walk<K: Kept>(&self, pairs: Range<usize>, ring: &mut [[K; 2]], largest: &mut Largest) {
        let (law, discs) = (self.law.clone(), self.particles);
        let ring = &mut ring[..self.near.pairs_at_a_time]; // a power of two
        let mut put = |pair: usize, force: f64x2, spring: f64x2| {
            let last = ring.len() - 1;
            ring[pair & last] = [K::of(force ^ MINUS, spring ^ MINUS), K::of(force, spring)];
        };
        let mut pair = pairs.start;
        let mut twos = self.near.pairs[pairs].chunks_exact(2);
        for two in &mut twos {
            let a = [&discs[two[0][0] as usize], &discs[two[1][0] as usize]];
            let b = [&discs[two[0][1] as usize], &discs[two[1][1] as usize]];
            let (forces, springs) = contact_lanes::forces::<L, K>(&law, a, b, largest);
            put(pair, forces[0], springs[0]);
            put(pair + 1, forces[1], springs[1]);
            pair += 2;
        }
        if let [[a, b]] = twos.remainder() {
            let (a, b) = ([&discs[*a as usize]; 2], [&discs[*b as usize]; 2]);
            let (forces, springs) = contact_lanes::forces::<L, K>(&law, a, b, largest);
            put(pair, forces[0], springs[0]);
        }
    }

    /// Adds up the forces on the discs at `places`.
    #[inline(always)]
    fn gather<K: Kept>(
        &self,
        places: Range<usize>,
        forces: &mut [DVec2],
        springs: &mut [DVec2],
        ring: &[[K; 2]],
        largest: &mut Largest,
    ) {
        let discs = &self.particles[places.clone()];
        let at_wall = self.near.at_wall_among(&places);
        let weight = |disc: &Particle| K::of(vector(disc.mass * self.gravity), f64x2::ZERO);
        let mut put = |here: usize, sum: K| {
            forces[here] = DVec2::from_array(sum.force().to_array());
            if K::HAS_SPRING {
                springs[here] = DVec2::from_array(sum.spring().to_array());
            }
        };
        let (triples, ring) = (self.near.triples_of(places.clone()), ring.as_flattened());
        let all = discs.iter().zip(triples).enumerate();
        if at_wall.is_empty() {
            all.for_each(|(here, (disc, triples))| put(here, weight(disc).plus_all(triples, ring)));
            return;
        }
        let mut at_wall = at_wall.iter().map(|&place| place as usize - places.start).peekable();
        for (here, (disc, triples)) in all {
            let start = match at_wall.next_if_eq(&here) {
                None => weight(disc),
                Some(_) => self.touch_walls(disc, largest),
            };
            put(here, start.plus_all(triples, ring));
        }
    }

    /// Weight and walls.
    fn touch_walls<K: Kept>(&self, disc: &Particle, largest: &mut Largest) -> K {
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
        K::of(vector(force), vector(spring))
    }

    /// Energy stored in the contacts of the discs of a block with walls and with discs ahead, J.
    pub fn stored_energy(&self, block: usize) -> f64 {
        let places = block * BLOCK..((block + 1) * BLOCK).min(self.particles.len());
        let mut stored = 0.0;
        for &place in self.near.at_wall_among(&places) {
            let disc = &self.particles[place as usize];
            for plane in self.planes {
                let distance = plane.distance(disc.position);
                if let Some(contact) = Contact::with_wall(disc, distance, plane.normal) {
                    stored += self.law.stored_energy(&contact);
                }
            }
        }
        for &[a, b] in &self.near.pairs[self.pairs_of(block)] {
            let (a, b) = (&self.particles[a as usize], &self.particles[b as usize]);
            if let Some(contact) = Contact::between(a, b) {
                stored += self.law.stored_energy(&contact);
            }
        }
        stored
    }
}

/// Changes the sign of what it is joined to by `^`.
const MINUS: f64x2 = f64x2::new([-0.0, -0.0]);

#[inline(always)]
fn vector(v: DVec2) -> f64x2 {
    f64x2::new(v.to_array())
}

/// The largest overlaps met so far.
#[derive(Clone, Default)]
pub(super) struct Largest {
    pub tally: Tally,
    /// An overlap over the smaller radius up to which there is nothing to note: a little less than
    /// the largest so far, for rounding, and never above 1, where centres may have met.
    pub notable: f64,
}

impl Largest {
    pub fn of(tally: &Tally) -> Self {
        let tally = Tally { shares: None, ..tally.clone() };
        let notable = tally.largest_pair_overlap.min(1.0) * (1.0 - 4.0 * f64::EPSILON);
        Self { tally, notable }
    }

    /// Takes the larger of both.
    pub fn join(&mut self, other: &Self) {
        let (mine, other) = (&mut self.tally, &other.tally);
        mine.largest_pair_overlap = mine.largest_pair_overlap.max(other.largest_pair_overlap);
        mine.largest_sinking = mine.largest_sinking.max(other.largest_sinking);
        mine.largest_wall_overlap = mine.largest_wall_overlap.max(other.largest_wall_overlap);
    }

    /// Notes an overlap, m, of discs of these radii, m.
    #[cold]
    pub fn note(&mut self, overlap: f64, radius: f64, other: f64) {
        if overlap > 0.0 {
            let relative_overlap = overlap / radius.min(other);
            self.tally.largest_pair_overlap = self.tally.largest_pair_overlap.max(relative_overlap);
            if relative_overlap > 1.0 {
                let sinking = overlap / (radius + other);
                self.tally.largest_sinking = self.tally.largest_sinking.max(sinking);
            }
            self.notable = Self::of(&self.tally).notable;
        }
    }
}
