//! One pass over all near pairs: every contact is computed once, and every disc adds its contacts up
//! in ascending id of the partner.
//!
//! Pairs of a block of discs are walked first, then the discs of the block gather. A disc's other
//! pairs were walked shortly before, with discs stored before it, so that only the last of the
//! pairs' pushes are kept, in a ring that stays in the processor's nearest memory. Who begins in
//! the middle walks some of the pairs before it too: the same numbers, computed twice.

use std::ops::Range;

use glam::DVec2;
use wide::{f64x2, f64x4};

#[cfg(target_arch = "x86_64")]
use super::avx2::Four;
use super::contact_lanes::Forces;
use super::lane_law::LaneLaw;
use super::lanes::Lanes;
use super::near::Near;
use super::{BLOCK, contact_lanes};
use crate::force::{HalfPlane, Tally};
use crate::particle::{Contact, Particle};

/// What is kept of a contact: on its first disc, and on its second.
pub(super) trait Kept<V: Lanes> {
    /// Whether the springs' share is told apart.
    const HAS_SPRING: bool;
    /// As it lies in the ring.
    type Stored: Copy + Default;
    /// As it is added up.
    type Sum: Copy;
    /// What is to be stored of four contacts with these forces on the second discs, N.
    fn stored(forces: [Forces<V>; 2]) -> [[Self::Stored; 2]; 4];
    /// A force without springs, to begin a sum with.
    fn start(zero: V, force: DVec2, spring: DVec2) -> Self::Sum;
    /// The sum with one more.
    fn plus(sum: Self::Sum, other: Self::Stored) -> Self::Sum;
    /// The whole force and the springs' share, N.
    fn of(sum: Self::Sum) -> [DVec2; 2];

    /// The sum of this and of all that `triples` name in the `ring`, one after the other.
    #[inline(always)]
    fn plus_all(sum: Self::Sum, triples: &[[u32; 3]], ring: &[Self::Stored]) -> Self::Sum {
        let mut sum = sum;
        for &[first, second, third] in triples {
            sum = Self::plus(Self::plus(sum, ring[first as usize]), ring[second as usize]);
            sum = Self::plus(sum, ring[third as usize]);
        }
        sum
    }
}

/// The whole force alone.
struct Whole;

impl<V: Lanes> Kept<V> for Whole {
    const HAS_SPRING: bool = false;
    type Stored = [f64; 2];
    type Sum = f64x2;
    #[inline(always)]
    fn stored([[x, y], _]: [Forces<V>; 2]) -> [[[f64; 2]; 2]; 4] {
        let [a, b, c, d] = V::transposed([x.negated(), y.negated(), x, y]);
        [halves(a), halves(b), halves(c), halves(d)]
    }
    #[inline(always)]
    fn start(_zero: V, force: DVec2, _spring: DVec2) -> f64x2 {
        f64x2::new(force.to_array())
    }
    #[inline(always)]
    fn plus(sum: f64x2, other: [f64; 2]) -> f64x2 {
        sum + f64x2::new(other)
    }
    #[inline(always)]
    fn of(sum: f64x2) -> [DVec2; 2] {
        [DVec2::from_array(sum.to_array()), DVec2::ZERO]
    }
}

/// The whole force and the springs' share, for the ledger.
struct Split;

impl<V: Lanes> Kept<V> for Split {
    const HAS_SPRING: bool = true;
    type Stored = [f64; 4];
    type Sum = V;
    #[inline(always)]
    fn stored([[x, y], [sx, sy]]: [Forces<V>; 2]) -> [[[f64; 4]; 2]; 4] {
        let [a, b, c, d] = V::transposed([x, y, sx, sy]);
        [both_signs(a), both_signs(b), both_signs(c), both_signs(d)]
    }
    #[inline(always)]
    fn start(zero: V, force: DVec2, spring: DVec2) -> V {
        zero.of([force.x, force.y, spring.x, spring.y])
    }
    #[inline(always)]
    fn plus(sum: V, other: [f64; 4]) -> V {
        sum + sum.of(other)
    }
    #[inline(always)]
    fn of(sum: V) -> [DVec2; 2] {
        let [x, y, sx, sy] = sum.to_array();
        [DVec2::new(x, y), DVec2::new(sx, sy)]
    }
}

#[inline(always)]
fn halves<V: Lanes>(row: V) -> [[f64; 2]; 2] {
    let [a, b, c, d] = row.to_array();
    [[a, b], [c, d]]
}

#[inline(always)]
fn both_signs<V: Lanes>(row: V) -> [[f64; 4]; 2] {
    [row.negated().to_array(), row.to_array()]
}

/// The last of the pairs' forces: for each pair that on its first disc, then that on its second.
#[derive(Default)]
pub(super) struct Ring {
    whole: Vec<[[f64; 2]; 2]>, // N
    split: Vec<[[f64; 4]; 2]>, // N, with a ledger
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
        let kept = match share.springs.is_empty() {
            true => self.serve_with::<V, Whole>(zero, &mut ring.whole, share),
            false => self.serve_with::<V, Split>(zero, &mut ring.split, share),
        };
        *kept = ring;
    }

    #[inline(always)]
    fn serve_with<'a, V: Lanes, K: Kept<V>>(
        &self,
        zero: V,
        ring: &mut Vec<[K::Stored; 2]>,
        share: Share<'a>,
    ) -> &'a mut Ring {
        let Share { blocks, forces, springs, ring: kept, largest } = share;
        // Room for the pairs, and at the end for no force at all.
        let nothing = [K::Stored::default(); 2];
        ring.resize(self.near.pairs_at_a_time + 1, nothing);
        ring[self.near.pairs_at_a_time] = nothing;
        let first = blocks.start * BLOCK;
        let before =
            self.near.reaches_back_to[blocks.start] as usize..self.pairs_of(blocks.start).start;
        if !before.is_empty() {
            self.walk::<V, K>(zero, before, ring, &mut Largest::default());
        }
        for block in blocks {
            self.walk::<V, K>(zero, self.pairs_of(block), ring, largest);
            let places = block * BLOCK..((block + 1) * BLOCK).min(self.particles.len());
            let here = places.start - first..places.end - first;
            let springs = springs.get_mut(here.clone()).unwrap_or_default();
            self.gather::<V, K>(zero, places, &mut forces[here], springs, ring, largest);
        }
        kept
    }

    fn pairs_of(&self, block: usize) -> Range<usize> {
        self.near.first_pair[block] as usize..self.near.first_pair[block + 1] as usize
    }

    /// Puts the forces of these pairs into the ring.
    #[inline(always)]
    fn walk<V: Lanes, K: Kept<V>>(
        &self,
        zero: V,
        pairs: Range<usize>,
        ring: &mut [[K::Stored; 2]],
        largest: &mut Largest,
    ) {
        let (law, discs) = (self.law.clone(), self.particles);
        let ring = &mut ring[..self.near.pairs_at_a_time]; // a power of two
        let last = ring.len() - 1;
        let mut pair = pairs.start;
        let mut fours = self.near.pairs[pairs].chunks_exact(4);
        for four in &mut fours {
            let stored = stored::<L, V, K>(
                &law,
                zero,
                &[four[0], four[1], four[2], four[3]],
                discs,
                largest,
            );
            (0..4).for_each(|k| ring[(pair + k) & last] = stored[k]);
            pair += 4;
        }
        if let [first, ..] = fours.remainder() {
            let mut four = [*first; 4];
            four.iter_mut().zip(fours.remainder()).for_each(|(to, from)| *to = *from);
            for (stored, _) in stored::<L, V, K>(&law, zero, &four, discs, largest)
                .into_iter()
                .zip(fours.remainder())
            {
                ring[pair & last] = stored;
                pair += 1;
            }
        }
    }

    /// Adds up the forces on the discs at `places`.
    #[inline(always)]
    fn gather<V: Lanes, K: Kept<V>>(
        &self,
        zero: V,
        places: Range<usize>,
        forces: &mut [DVec2],
        springs: &mut [DVec2],
        ring: &[[K::Stored; 2]],
        largest: &mut Largest,
    ) {
        let discs = &self.particles[places.clone()];
        let at_wall = self.near.at_wall_among(&places);
        let weight = |disc: &Particle| K::start(zero, disc.mass * self.gravity, DVec2::ZERO);
        let mut put = |here: usize, sum: K::Sum| {
            let [force, spring] = K::of(sum);
            forces[here] = force;
            if K::HAS_SPRING {
                springs[here] = spring;
            }
        };
        let (triples, ring) = (self.near.triples_of(places.clone()), ring.as_flattened());
        let all = discs.iter().zip(triples).enumerate();
        if at_wall.is_empty() {
            all.for_each(|(here, (disc, triples))| {
                put(here, K::plus_all(weight(disc), triples, ring))
            });
            return;
        }
        let mut at_wall = at_wall.iter().map(|&place| place as usize - places.start).peekable();
        for (here, (disc, triples)) in all {
            let start = match at_wall.next_if_eq(&here) {
                None => weight(disc),
                Some(_) => {
                    let [force, spring] = self.touch_walls(disc, largest);
                    K::start(zero, force, spring)
                }
            };
            put(here, K::plus_all(start, triples, ring));
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

/// What is to be stored of the contacts of four pairs of `discs`.
#[inline(always)]
fn stored<L: LaneLaw, V: Lanes, K: Kept<V>>(
    law: &L,
    zero: V,
    pairs: &[[u32; 2]; 4],
    discs: &[Particle],
    largest: &mut Largest,
) -> [[K::Stored; 2]; 4] {
    let [a, b, c, d] = pairs;
    let at = |place: u32| &discs[place as usize];
    let side = |k: usize| [at(a[k]), at(b[k]), at(c[k]), at(d[k])];
    match contact_lanes::forces(law, zero, [side(0), side(1)], largest) {
        Some(forces) => K::stored(forces),
        None => [[K::Stored::default(); 2]; 4],
    }
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
