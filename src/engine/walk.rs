//! The contacts of a block's pairs, in three strides: geometry, law, forces.
//!
//! *Geometry* and *forces* are written in lanes, with the arithmetic of [`Contact::between`], operation by
//! operation, so the bits are the same; a test holds one against the other. The *law* in between is the very text a
//! student writes, [`ContactLaw::push`], in a plain loop over contacts: the compiler makes the lanes, and a law that
//! it cannot put into lanes is right all the same. What lies between two strides stays in the processor's nearest
//! memory.
//!
//! Roots and quotients of a chunk are under way while the forces of the chunk before it are written: the divider is
//! what bounds a step.

use glam::DVec2;

use super::block_pairs::BlockPairs;
use super::constants::{CHUNK, PairConstants};
use super::group::Group;
use super::lanes::Lanes;
use super::largest::Largest;
use super::lookup::{Lookup, Offset};
use super::pair_buffer::Entry;
use super::phase::{Phase, Size};
use crate::particle::{Contact, ContactLaw};

/// Numbers about the contacts of a chunk.
#[repr(C, align(64))]
#[derive(Clone, Copy)]
struct Column([f64; CHUNK]);

impl Column {
    #[inline(always)]
    fn group<G: Group>(&self, group: usize) -> &[f64] {
        &self.0[G::PAIRS * group..][..G::PAIRS]
    }

    #[inline(always)]
    fn group_mut<G: Group>(&mut self, group: usize) -> &mut [f64] {
        &mut self.0[G::PAIRS * group..][..G::PAIRS]
    }
}

/// The contacts of a chunk of pairs, between two strides.
#[derive(Clone, Copy)]
struct Contacts {
    /// Where the two touch: masks.
    touch: Column,
    normal_x: Column,
    normal_y: Column,
    overlap: Column,        // m; 0 where they do not touch
    approach_speed: Column, // m/s
    push: Column,           // N
    spring: Column,         // N, with a ledger
}

impl Contacts {
    const NONE: Self = {
        let zero = Column([0.0; CHUNK]);
        Self {
            touch: zero,
            normal_x: zero,
            normal_y: zero,
            overlap: zero,
            approach_speed: zero,
            push: zero,
            spring: zero,
        }
    };
}

/// What of the sizes of two discs enters a contact: the same in every step.
pub(super) trait Sizing: Copy {
    /// What of it belongs to a chunk of pairs.
    type Chunk: Copy;
    /// The chunk that begins with this pair.
    fn chunk(&self, first: usize) -> Self::Chunk;
    /// The sums of the radii of a group of the chunk's pairs, m.
    fn reach<G: Group>(zero: G, chunk: &Self::Chunk, group: usize) -> G;
    /// Their smaller radii, or a little less, m.
    fn smaller_radius<G: Group>(zero: G, chunk: &Self::Chunk, group: usize) -> G;
    /// The reduced mass of a pair of the chunk, kg.
    fn reduced_mass(chunk: &Self::Chunk, pair: usize) -> f64;
}

/// Discs of one radius and one mass.
#[derive(Clone, Copy)]
pub(super) struct Equal {
    pub radius: f64,       // m
    pub reach: f64,        // m
    pub reduced_mass: f64, // kg
}

impl Equal {
    /// Discs of this size.
    pub fn of(Size { radius, mass }: Size) -> Self {
        Self { radius, reach: radius + radius, reduced_mass: mass * mass / (mass + mass) }
    }
}

impl Sizing for Equal {
    type Chunk = Self;
    #[inline(always)]
    fn chunk(&self, _first: usize) -> Self {
        *self
    }
    #[inline(always)]
    fn reach<G: Group>(zero: G, chunk: &Self, _group: usize) -> G {
        zero.all(chunk.reach)
    }
    #[inline(always)]
    fn smaller_radius<G: Group>(zero: G, chunk: &Self, _group: usize) -> G {
        zero.all(chunk.radius)
    }
    #[inline(always)]
    fn reduced_mass(chunk: &Self, _pair: usize) -> f64 {
        chunk.reduced_mass
    }
}

/// Discs of several sizes: constants of each pair, worked out when the list was made, and a chunk more.
#[derive(Clone, Copy)]
pub(super) struct Unequal<'a> {
    pub reaches: &'a [f64],        // m
    pub reduced_masses: &'a [f64], // kg
    /// Smaller radii, m, rounded down.
    pub smaller_radii: &'a [f32],
}

impl<'a> Unequal<'a> {
    /// Those of these pairs.
    pub fn of(constants: &'a PairConstants) -> Self {
        let PairConstants { reaches, reduced_masses, smaller_radii } = constants;
        Self { reaches, reduced_masses, smaller_radii }
    }
}

impl<'a> Sizing for Unequal<'a> {
    type Chunk = (&'a [f64; CHUNK], &'a [f64; CHUNK], &'a [f32; CHUNK]);
    #[inline(always)]
    fn chunk(&self, first: usize) -> Self::Chunk {
        let whole = "a chunk more than there are pairs";
        (
            self.reaches[first..].first_chunk().expect(whole),
            self.reduced_masses[first..].first_chunk().expect(whole),
            self.smaller_radii[first..].first_chunk().expect(whole),
        )
    }
    #[inline(always)]
    fn reach<G: Group>(zero: G, chunk: &Self::Chunk, group: usize) -> G {
        zero.load(&chunk.0[G::PAIRS * group..][..G::PAIRS])
    }
    #[inline(always)]
    fn smaller_radius<G: Group>(zero: G, chunk: &Self::Chunk, group: usize) -> G {
        let of_pairs = &chunk.2[G::PAIRS * group..][..G::PAIRS];
        let mut radii = [0.0; CHUNK];
        radii.iter_mut().zip(of_pairs).for_each(|(radius, of_pair)| *radius = f64::from(*of_pair));
        zero.load(&radii)
    }
    #[inline(always)]
    fn reduced_mass(chunk: &Self::Chunk, pair: usize) -> f64 {
        chunk.1[pair]
    }
}

/// Two chunks of contacts: of one the geometry is being worked out, of the other the forces are written. And where the discs of
/// a chunk are.
pub(super) struct Scratch {
    contacts: [Contacts; 2],
    offsets: [[Offset; 2]; CHUNK],
}

impl Default for Scratch {
    fn default() -> Self {
        Self { contacts: [Contacts::NONE; 2], offsets: [Default::default(); CHUNK] }
    }
}

/// A group of pairs, the second disc of each seen from the first.
struct Seen<G: Group> {
    away: [G; 2],     // m
    velocity: [G; 2], // m/s
    distance: G,      // m
    touch: G::Mask,
}

/// A walk over the near pairs of one block of discs.
pub(super) struct Walk<'a, 'b, L, S> {
    pub law: &'a L,
    pub sizing: S,
    pub block: &'a BlockPairs<'b>,
}

impl<L: ContactLaw + Clone, S: Sizing> Walk<'_, '_, L, S> {
    /// Puts both sides' forces of every pair into `ring`, from `slot` on and around, and notes the largest overlap.
    #[inline(always)]
    pub fn go<V: Lanes, E: Entry<V>>(
        &self,
        zero: V,
        ring: &mut [E::Both],
        slot: usize,
        Scratch { contacts: [now, last], offsets }: &mut Scratch,
        largest: &mut Largest,
    ) {
        let all = self.block.pairs;
        let (mut now, mut last) = (now, last);
        let (mut slot, mut first, mut before) = (slot, 0, 0..0);
        while first < all.len() {
            let here = CHUNK.min(all.len() - first).min(ring.len() - slot);
            let pairs = &all[first..first + here];
            let places = &mut offsets[..here];
            for (offsets, pair) in places.iter_mut().zip(pairs) {
                *offsets = [Lookup::<Phase>::offset(pair[0]), Lookup::<Phase>::offset(pair[1])];
            }
            let sizing = self.sizing.chunk(self.block.first + first);
            let out = &mut ring[before.clone()];
            let notable = self.see_and_write::<V, E>(
                zero.group(),
                places,
                (&sizing, largest.notable),
                now,
                last,
                out,
            );
            if notable {
                self.look_closer(pairs, now, largest);
            }
            self.apply_law::<V, E>(zero, &sizing, now);
            (before, first) = (slot..slot + here, first + here);
            slot = if slot + here == ring.len() { 0 } else { slot + here };
            std::mem::swap(&mut now, &mut last);
        }
        last.write_from::<V, E>(zero.group(), 0, &mut ring[before]);
    }

    /// Works out the geometry of a chunk, and writes the forces of the chunk before it meanwhile.
    #[inline(always)]
    fn see_and_write<V: Lanes, E: Entry<V>>(
        &self,
        zero: V::Group,
        pairs: &[[Offset; 2]],
        seen_as: (&S::Chunk, f64),
        now: &mut Contacts,
        last: &Contacts,
        out: &mut [E::Both],
    ) -> bool {
        let size = V::Group::PAIRS;
        let (groups, written) = (pairs.len().min(CHUNK) / size, out.len().min(CHUNK) / size);
        let mut notable = zero.none();
        let mut seen = self.look(zero, &pairs[..size], seen_as.0, 0);
        for group in 0..groups {
            if group < written {
                last.write::<V, E>(zero, group, &mut out[size * group..][..size]);
            }
            let ahead = (group + 1).min(groups - 1);
            let next = self.look(zero, &pairs[size * ahead..][..size], seen_as.0, ahead);
            notable = zero.either(notable, Self::measure(zero, seen, seen_as, group, now));
            seen = next;
        }
        last.write_from::<V, E>(zero, groups, out);
        zero.is_any(notable)
    }

    /// Where the discs of a group of pairs are, seen from the first of each, and how far apart.
    #[inline(always)]
    fn look<G: Group>(
        &self,
        zero: G,
        pairs: &[[Offset; 2]],
        sizing: &S::Chunk,
        group: usize,
    ) -> Seen<G> {
        // Seen from the first disc: velocities with the other sign than in `Contact::between`.
        let [x, y, vx, vy] = zero.differences(self.block.discs, pairs);
        let reach = S::reach(zero, sizing, group);
        let distance_squared = x * x + y * y;
        let touch = distance_squared.is_less(reach * reach);
        let distance = distance_squared.sqrt();
        Seen { away: [x, y], velocity: [vx, vy], distance, touch }
    }

    /// The contacts of a group of pairs. Says where an overlap is worth a closer look.
    #[inline(always)]
    fn measure<G: Group>(
        zero: G,
        seen: Seen<G>,
        (sizing, notable): (&S::Chunk, f64),
        group: usize,
        contacts: &mut Contacts,
    ) -> G::Mask {
        let Seen { away: [x, y], velocity: [vx, vy], distance, touch } = seen;
        zero.store_mask(touch, contacts.touch.group_mut::<G>(group));
        let reach = S::reach(zero, sizing, group);
        let (normal_x, normal_y) = (x / distance, y / distance);
        let overlap = (reach - distance).where_all(touch);
        normal_x.store(contacts.normal_x.group_mut::<G>(group));
        normal_y.store(contacts.normal_y.group_mut::<G>(group));
        overlap.store(contacts.overlap.group_mut::<G>(group));
        let speed = (vx * normal_x + vy * normal_y).negated();
        speed.store(contacts.approach_speed.group_mut::<G>(group));
        (zero.all(notable) * S::smaller_radius(zero, sizing, group)).is_less(overlap)
    }

    /// Notes overlaps, and gives those at exactly one place a direction, as [`Contact::between`] does.
    #[cold]
    #[inline(never)]
    fn look_closer(&self, pairs: &[[u16; 2]], contacts: &mut Contacts, largest: &mut Largest) {
        for (k, &[i, j]) in pairs.iter().enumerate() {
            let overlap = contacts.overlap.0[k];
            if overlap > 0.0 {
                let [a, b] = [i, j].map(|place| self.block.discs.at(place));
                if a.position() == b.position() {
                    contacts.normal_x.0[k] = 1.0;
                    contacts.normal_y.0[k] = 0.0;
                    contacts.approach_speed.0[k] = (a.velocity() - b.velocity()).dot(DVec2::X);
                }
                let [radius, other] = [i, j].map(|place| {
                    self.block.fixed.sizes[self.block.place + usize::from(place)].radius
                });
                largest.note(overlap, radius, other);
            }
        }
    }

    /// The law, one contact after the other: the compiler makes the lanes.
    #[inline(always)]
    fn apply_law<V: Lanes, E: Entry<V>>(
        &self,
        zero: V,
        sizing: &S::Chunk,
        contacts: &mut Contacts,
    ) {
        let Contacts { normal_x, normal_y, overlap, approach_speed, push, spring, .. } = contacts;
        zero.apart(
            #[inline(always)]
            || {
                // A copy, so that the compiler sees that nothing in the loop changes it. Whole chunks, whatever is in
                // them: a loop of known length needs no rest.
                let law = self.law.clone();
                let (normal_x, normal_y) = (&normal_x.0, &normal_y.0);
                let (overlap, speed) = (&overlap.0, &approach_speed.0);
                let (push, spring) = (&mut push.0, &mut spring.0);
                for k in 0..CHUNK {
                    let contact = Contact {
                        overlap: overlap[k],
                        normal: DVec2::new(normal_x[k], normal_y[k]),
                        approach_speed: speed[k],
                        reduced_mass: S::reduced_mass(sizing, k),
                    };
                    push[k] = law.push(&contact);
                    if E::HAS_SPRING {
                        spring[k] = law.spring(&contact);
                    }
                }
            },
        );
    }
}

impl Contacts {
    /// The forces of a group of contacts, both sides.
    #[inline(always)]
    fn write<V: Lanes, E: Entry<V>>(&self, zero: V::Group, group: usize, out: &mut [E::Both]) {
        let at = |column: &Column| zero.load(column.group::<V::Group>(group));
        let touch = zero.load_mask(self.touch.group::<V::Group>(group));
        let (x, y, push) = (at(&self.normal_x), at(&self.normal_y), at(&self.push));
        let push = [(push * x).where_all(touch), (push * y).where_all(touch)];
        let spring = if E::HAS_SPRING {
            let spring = at(&self.spring);
            [(spring * x).where_all(touch), (spring * y).where_all(touch)]
        } else {
            push
        };
        E::put(push, spring, out);
    }

    /// The forces of the groups from this one on.
    #[inline(always)]
    fn write_from<V: Lanes, E: Entry<V>>(&self, zero: V::Group, first: usize, out: &mut [E::Both]) {
        let size = V::Group::PAIRS;
        for group in first..out.len().min(CHUNK) / size {
            self.write::<V, E>(zero, group, &mut out[size * group..][..size]);
        }
    }
}

#[cfg(test)]
mod tests;
