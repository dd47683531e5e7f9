//! Sums of forces on the discs of a block.

use glam::DVec2;

use crate::engine::lanes::Lanes;
use crate::engine::largest::Largest;
use crate::engine::lookup::Lookup;
use crate::engine::moves::Forces;
use crate::engine::neighbour_list::PARTS;
use crate::engine::pair_buffer::Entry;

/// The sums of forces on the discs of a block, each added up when it is asked for.
pub(super) struct Sums<'a, V: Lanes, E: Entry<V>> {
    pub zero: V,
    /// What each sum begins with.
    pub starts: &'a [E::Stored],
    /// What in the ring is added to it.
    pub parts: &'a [[u16; PARTS]],
    pub ring: Lookup<'a, E::Stored>,
}

impl<V: Lanes, E: Entry<V>> Sums<'_, V, E> {
    /// The sum on the disc of this number.
    #[inline(always)]
    pub fn on(&self, disc: usize) -> E::Sum {
        E::plus_six(E::start(self.zero, &self.starts[disc]), &self.parts[disc], self.ring)
    }

    /// Puts them there, N: the whole forces, and the springs' shares where there is room for them.
    #[inline(always)]
    pub fn put(&self, forces: &mut [DVec2], springs: &mut [DVec2]) {
        let n = self.parts.len();
        if E::HAS_SPRING {
            let all = forces[..n].iter_mut().zip(&mut springs[..n]);
            for (disc, (force, spring)) in all.enumerate() {
                [*force, *spring] = E::of(self.on(disc));
            }
        } else {
            forces[..n].iter_mut().enumerate().for_each(
                #[inline(always)]
                |(disc, force)| [*force, _] = E::of(self.on(disc)),
            );
        }
    }
}

impl<V: Lanes, E: Entry<V>> Forces<V> for Sums<'_, V, E> {
    #[inline(always)]
    fn on_two(&self, first: usize) -> [V; 2] {
        E::of_two(self.zero, [self.on(first), self.on(first + 1)])
    }
}

/// What is noted on the way: overlaps, and the power of walls that move, with the dashpots' part of it (W).
pub(super) struct Noted<'a> {
    pub largest: &'a mut Largest,
    pub power: &'a mut [f64; 2],
}
