//! Where the sums of forces on the discs of a block go.

use glam::DVec2;

use crate::engine::lanes::Lanes;
use crate::engine::largest::Largest;
use crate::engine::pair_buffer::Entry;

/// Where the forces on the discs of a block are put, N: the whole, and the springs' share if there is a ledger.
pub(super) struct Sums<'a> {
    pub forces: &'a mut [DVec2],
    pub springs: &'a mut [DVec2],
}

impl Sums<'_> {
    #[inline(always)]
    pub fn put<V: Lanes, E: Entry<V>>(&mut self, here: usize, sum: E::Sum) {
        let spring;
        [self.forces[here], spring] = E::of(sum);
        if E::HAS_SPRING {
            self.springs[here] = spring;
        }
    }
}

/// What is noted on the way: overlaps, and the power of walls that move, with the dashpots' part of it (W).
pub(super) struct Noted<'a> {
    pub largest: &'a mut Largest,
    pub power: &'a mut [f64; 2],
}
