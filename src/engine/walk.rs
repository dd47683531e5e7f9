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
use super::lanes::Lanes;
use super::largest::Largest;
use super::pair_buffer::Entry;
use super::phase::Size;
use crate::particle::{Contact, ContactLaw};

/// Pairs worked on at a time.
const GROUP: usize = 4;

/// Numbers about the contacts of a chunk, group by group.
#[repr(C, align(64))]
#[derive(Clone, Copy)]
struct Column([[f64; GROUP]; CHUNK / GROUP]);

impl Column {
    #[inline(always)]
    fn group<V: Lanes>(&self, zero: V, group: usize) -> V {
        zero.of(self.0[group % (CHUNK / GROUP)])
    }

    #[inline(always)]
    fn set<V: Lanes>(&mut self, group: usize, lanes: V) {
        lanes.put(&mut self.0[group % (CHUNK / GROUP)]);
    }
}

/// The contacts of a chunk of pairs, between two strides.
#[derive(Clone, Copy)]
struct Contacts {
    /// All bits where the two touch, else none.
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
        let zero = Column([[0.0; GROUP]; CHUNK / GROUP]);
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
    /// The sums of the radii of four pairs of the chunk, from this one on, m.
    fn reach<V: Lanes>(zero: V, chunk: &Self::Chunk, first: usize) -> V;
    /// Their smaller radii, or a little less, m.
    fn smaller_radius<V: Lanes>(zero: V, chunk: &Self::Chunk, first: usize) -> V;
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
    fn reach<V: Lanes>(zero: V, chunk: &Self, _first: usize) -> V {
        zero.all(chunk.reach)
    }
    #[inline(always)]
    fn smaller_radius<V: Lanes>(zero: V, chunk: &Self, _first: usize) -> V {
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
    fn reach<V: Lanes>(zero: V, chunk: &Self::Chunk, k: usize) -> V {
        zero.of([chunk.0[k], chunk.0[k + 1], chunk.0[k + 2], chunk.0[k + 3]])
    }
    #[inline(always)]
    fn smaller_radius<V: Lanes>(zero: V, chunk: &Self::Chunk, k: usize) -> V {
        let of = |pair: usize| f64::from(chunk.2[pair]);
        zero.of([of(k), of(k + 1), of(k + 2), of(k + 3)])
    }
    #[inline(always)]
    fn reduced_mass(chunk: &Self::Chunk, pair: usize) -> f64 {
        chunk.1[pair]
    }
}

/// Two chunks of contacts: of one the geometry is being worked out, of the other the forces are written.
pub(super) struct Scratch([Contacts; 2]);

impl Default for Scratch {
    fn default() -> Self {
        Self([Contacts::NONE; 2])
    }
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
        Scratch([now, last]): &mut Scratch,
        largest: &mut Largest,
    ) {
        let all = self.block.pairs;
        let (mut now, mut last) = (now, last);
        let (mut slot, mut first, mut before) = (slot, 0, 0..0);
        while first < all.len() {
            let here = CHUNK.min(all.len() - first).min(ring.len() - slot);
            let pairs = &all[first..first + here];
            let sizing = self.sizing.chunk(self.block.first + first);
            let mut notable = zero;
            let seen_as = (&sizing, largest.notable);
            let mut written = ring[before.clone()].chunks_exact_mut(GROUP).enumerate();
            for (group, pairs) in pairs.chunks_exact(GROUP).enumerate() {
                if let Some((group, out)) = written.next() {
                    last.write::<V, E>(zero, group, out);
                }
                notable = notable.or_where(self.see::<V>(zero, pairs, seen_as, group, now));
            }
            for (group, out) in written {
                last.write::<V, E>(zero, group, out);
            }
            if notable.is_any() {
                self.look_closer(pairs, now, largest);
            }
            self.apply_law::<V, E>(zero, &sizing, now);
            (before, first) = (slot..slot + here, first + here);
            slot = if slot + here == ring.len() { 0 } else { slot + here };
            std::mem::swap(&mut now, &mut last);
        }
        last.write_from::<V, E>(zero, 0, &mut ring[before]);
    }

    /// The geometry of a group of pairs. Says where an overlap is worth a closer look.
    #[inline(always)]
    fn see<V: Lanes>(
        &self,
        zero: V,
        pairs: &[[u16; 2]],
        (sizing, notable): (&S::Chunk, f64),
        group: usize,
        contacts: &mut Contacts,
    ) -> V {
        // Seen from the first disc: velocities with the other sign than in `Contact::between`.
        let seen = |[i, j]: [u16; 2]| {
            let discs = &self.block.discs;
            zero.of(discs.at(j).0) - zero.of(discs.at(i).0)
        };
        let [a, b, c, d] = [seen(pairs[0]), seen(pairs[1]), seen(pairs[2]), seen(pairs[3])];
        let [x, y, vx, vy] = V::transposed([a, b, c, d]);
        let reach = S::reach(zero, sizing, GROUP * group);
        let distance_squared = x * x + y * y;
        let touch = distance_squared.is_less(reach * reach);
        contacts.touch.set(group, touch);
        if !touch.is_any() {
            contacts.overlap.set(group, zero); // most groups of a gas, few of a bed
            return zero;
        }
        let distance = distance_squared.sqrt();
        let (normal_x, normal_y) = (x / distance, y / distance);
        let overlap = (reach - distance).where_all(touch);
        contacts.normal_x.set(group, normal_x);
        contacts.normal_y.set(group, normal_y);
        contacts.overlap.set(group, overlap);
        contacts.approach_speed.set(group, (vx * normal_x + vy * normal_y).negated());
        (zero.all(notable) * S::smaller_radius(zero, sizing, GROUP * group)).is_less(overlap)
    }

    /// Notes overlaps, and gives those at exactly one place a direction, as [`Contact::between`] does.
    #[cold]
    #[inline(never)]
    fn look_closer(&self, pairs: &[[u16; 2]], contacts: &mut Contacts, largest: &mut Largest) {
        for (k, &[i, j]) in pairs.iter().enumerate() {
            let overlap = contacts.overlap.0.as_flattened()[k];
            if overlap > 0.0 {
                let [a, b] = [i, j].map(|place| self.block.discs.at(place));
                if a.position() == b.position() {
                    contacts.normal_x.0.as_flattened_mut()[k] = 1.0;
                    contacts.normal_y.0.as_flattened_mut()[k] = 0.0;
                    contacts.approach_speed.0.as_flattened_mut()[k] =
                        (a.velocity() - b.velocity()).dot(DVec2::X);
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
                let (normal_x, normal_y) = (normal_x.0.as_flattened(), normal_y.0.as_flattened());
                let (overlap, speed) = (overlap.0.as_flattened(), approach_speed.0.as_flattened());
                let (push, spring) = (push.0.as_flattened_mut(), spring.0.as_flattened_mut());
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
    fn write<V: Lanes, E: Entry<V>>(&self, zero: V, group: usize, out: &mut [E::Both]) {
        let [touch, x, y] = [
            self.touch.group(zero, group),
            self.normal_x.group(zero, group),
            self.normal_y.group(zero, group),
        ];
        let push = self.push.group(zero, group);
        let push = [(push * x).where_all(touch), (push * y).where_all(touch)];
        let spring = if E::HAS_SPRING {
            let spring = self.spring.group(zero, group);
            [(spring * x).where_all(touch), (spring * y).where_all(touch)]
        } else {
            push
        };
        E::put(push, spring, out);
    }

    /// The forces of the groups from this one on.
    #[inline(always)]
    fn write_from<V: Lanes, E: Entry<V>>(&self, zero: V, first: usize, out: &mut [E::Both]) {
        for (group, out) in (first..).zip(out.chunks_exact_mut(GROUP)) {
            self.write::<V, E>(zero, group, out);
        }
    }
}

#[cfg(test)]
mod tests;
