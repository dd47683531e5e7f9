//! The sum of the forces on each disc of a block: weight, added forces, walls, then its pairs in ascending id of the partner.

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
    /// What the sums of all discs begin with, if that is the same for all but those near walls.
    pub(super) fn usual_start<V: Lanes, E: Entry<V>>(&self) -> Option<E::Stored> {
        let size = self.fixed.equal.filter(|_| self.starts.is_empty())?;
        Some(E::side(size.mass * self.gravity, DVec2::ZERO))
    }

    /// The sums of forces on the `discs` of a block. What they begin with is put into `starts`, which hold the usual
    /// start if there is one. `ring` and `far` hold the forces of the discs' pairs.
    #[inline(always)]
    pub(super) fn sums<'b, V: Lanes, E: Entry<V>>(
        &'b self,
        zero: V,
        (block, discs, first): (usize, &[Phase], usize),
        ring: &'b [E::Both],
        far: &[E::Both],
        starts: &'b mut [E::Stored],
        noted: Noted,
    ) -> Sums<'b, V, E> {
        // SAFETY: parts name no entry after those of no force: the list was made so.
        #[allow(unsafe_code)]
        let ring = unsafe { Lookup::sides::<E::Both>(ring, self.list.no_force() + 2) };
        if self.fixed.equal.is_none() || !self.starts.is_empty() {
            for (place, start) in (first..).zip(&mut starts[..discs.len()]) {
                *start = self.start::<V, E>(place);
            }
        }
        for &at in self.list.at_wall_of(block) {
            let here = at as usize - first;
            let disc = self.fixed.body(at as usize, &discs[here]).particle();
            let start = E::of(E::start(zero, &starts[here]));
            let [force, spring] = self.touch_walls(start, &disc, noted.largest, noted.power);
            starts[here] = E::side(force, spring);
        }
        // Discs that have many parts, or far ones: their six parts are no force at all, so all that there is comes before.
        for of in self.list.more_of(block) {
            let here = of.place as usize - first;
            let mut sum = E::start(zero, &starts[here]);
            let [begin, end] = of.parts.map(|part| part as usize);
            for &part in &self.list.more_parts[begin..end] {
                sum = match (part as usize).checked_sub(self.list.no_force() + 2) {
                    None => E::plus(sum, ring.at(part as u16)),
                    Some(part) => E::plus(sum, &E::apart(far[part / 2])[part % 2]),
                };
            }
            let [force, spring] = E::of(sum);
            starts[here] = E::side(force, spring);
        }
        let parts = &self.list.parts[first..first + discs.len()];
        Sums { zero, starts: &starts[..discs.len()], parts, ring }
    }

    /// What the sum of the disc at this place begins with.
    #[inline(always)]
    fn start<V: Lanes, E: Entry<V>>(&self, place: usize) -> E::Stored {
        match self.starts.get(place) {
            Some(start) => E::side(start.force, start.spring),
            None => E::side(self.fixed.sizes[place].mass * self.gravity, DVec2::ZERO),
        }
    }

    /// Puts the `usual` start back for the discs of a block that began otherwise; `first` is the place of the first.
    #[inline(always)]
    pub(super) fn put_back<V: Lanes, E: Entry<V>>(
        &self,
        (block, first): (usize, usize),
        usual: Option<E::Stored>,
        starts: &mut [E::Stored],
    ) {
        if let Some(usual) = usual {
            let more = self.list.more_of(block).iter().map(|of| of.place);
            for at in self.list.at_wall_of(block).iter().copied().chain(more) {
                starts[at as usize - first] = usual;
            }
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
