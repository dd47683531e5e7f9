//! The sum of the forces on each disc of a block: weight, added forces, walls, then its pairs in ascending id of the partner.

use std::ops::Range;

use glam::DVec2;

use super::Sweep;
use super::sums::{Noted, Sums};
use crate::engine::lanes::Lanes;
use crate::engine::largest::Largest;
use crate::engine::lookup::Lookup;
use crate::engine::pair_buffer::Entry;
use crate::engine::pairs::Interaction;
use crate::engine::phase::Phase;
use crate::particle::{Contact, ContactLaw, Particle};

impl<I: Interaction> Sweep<'_, I> {
    /// Adds up the forces on `discs`, the first of which is stored at `first`. `ring` and `far` hold those of their pairs.
    #[inline(always)]
    pub(super) fn gather<V: Lanes, E: Entry<V>>(
        &self,
        zero: V,
        (discs, first): (&[Phase], usize),
        ring: &[E::Both],
        far: &[E::Both],
        mut sums: Sums,
        noted: Noted,
    ) {
        let places = first..first + discs.len();
        // SAFETY: parts name no entry after those of no force: the list was made so.
        #[allow(unsafe_code)]
        let ring = unsafe { Lookup::sides::<E::Both>(ring, self.list.no_force() + 2) };
        let parts = &self.list.parts[places.clone()];
        match self.fixed.equal {
            Some(size) if self.starts.is_empty() => {
                let weight = E::start(zero, size.mass * self.gravity, DVec2::ZERO);
                add_up::<V, E>(
                    #[inline(always)]
                    |_| weight,
                    parts,
                    ring,
                    &mut sums,
                );
            }
            _ => {
                add_up::<V, E>(
                    #[inline(always)]
                    |here| self.start::<V, E>(zero, first + here),
                    parts,
                    ring,
                    &mut sums,
                );
            }
        }
        for &at in self.list.at_wall_among(&places) {
            let here = at as usize - first;
            let start = E::of(self.start::<V, E>(zero, at as usize));
            let disc = self.fixed.body(at as usize, &discs[here]).particle();
            let [force, spring] = self.touch_walls(start, &disc, noted.largest, noted.power);
            let start = E::start(zero, force, spring);
            sums.put::<V, E>(here, E::plus_six(start, &parts[here], ring));
        }
        self.add_more::<V, E>(zero, places, ring, far, &mut sums);
    }

    /// Adds up the parts of discs that have many, or far ones. Their six parts were no force at all, so what is there is
    /// what the sum begins with.
    #[inline(always)]
    fn add_more<V: Lanes, E: Entry<V>>(
        &self,
        zero: V,
        places: Range<usize>,
        ring: Lookup<E::Stored>,
        far: &[E::Both],
        sums: &mut Sums,
    ) {
        for of in self.list.more_among(&places) {
            let here = of.place as usize - places.start;
            let spring = sums.springs.get(here).copied().unwrap_or_default();
            let mut sum = E::start(zero, sums.forces[here], spring);
            let [begin, end] = of.parts.map(|part| part as usize);
            for &part in &self.list.more_parts[begin..end] {
                sum = match (part as usize).checked_sub(self.list.no_force() + 2) {
                    None => E::plus(sum, ring.at(part as u16)),
                    Some(part) => E::plus(sum, &E::apart(far[part / 2])[part % 2]),
                };
            }
            sums.put::<V, E>(here, sum);
        }
    }

    /// What the sum of the disc at this place begins with.
    #[inline(always)]
    fn start<V: Lanes, E: Entry<V>>(&self, zero: V, place: usize) -> E::Sum {
        match self.starts.get(place) {
            Some(start) => E::start(zero, start.force, start.spring),
            None => E::start(zero, self.fixed.sizes[place].mass * self.gravity, DVec2::ZERO),
        }
    }

    /// The whole force and the springs' share, N, with those of the walls.
    fn touch_walls(
        &self,
        [mut force, mut spring]: [DVec2; 2],
        disc: &Particle,
        largest: &mut Largest,
        power: &mut [f64; 2],
    ) -> [DVec2; 2] {
        let law = self.interaction.at_walls();
        for wall in self.walls {
            let nearest = wall.nearest(disc.position, self.time);
            let mut seen = *disc;
            seen.velocity -= nearest.velocity;
            if let Some(contact) = Contact::with_wall(&seen, nearest.distance, nearest.normal) {
                let (push, part) = (law.push(&contact), law.spring(&contact));
                force -= push * contact.normal;
                spring -= part * contact.normal;
                let along = -contact.normal.dot(nearest.velocity);
                power[0] += push * along;
                power[1] += (push - part) * along;
                largest.overlaps.note_wall(contact.overlap, disc.radius);
            }
        }
        for plane in self.planes {
            let distance = plane.distance(disc.position);
            if let Some(contact) = Contact::with_wall(disc, distance, plane.normal) {
                force -= law.push(&contact) * contact.normal;
                spring -= law.spring(&contact) * contact.normal;
                largest.overlaps.note_wall(contact.overlap, disc.radius);
            }
        }
        [force, spring]
    }
}

/// Adds up what each disc's `parts` name in the `ring`, from its start on.
#[inline(always)]
fn add_up<V: Lanes, E: Entry<V>>(
    start: impl Fn(usize) -> E::Sum,
    parts: &[[u16; 6]],
    ring: Lookup<E::Stored>,
    sums: &mut Sums,
) {
    let forces = &mut sums.forces[..parts.len()];
    if E::HAS_SPRING {
        let springs = &mut sums.springs[..parts.len()];
        for (here, parts) in parts.iter().enumerate() {
            [forces[here], springs[here]] = E::of(E::plus_six(start(here), parts, ring));
        }
    } else {
        for (here, (parts, force)) in parts.iter().zip(forces).enumerate() {
            [*force, _] = E::of(E::plus_six(start(here), parts, ring));
        }
    }
}
