//! The near pairs of a block of discs, and what of the discs stays the same meanwhile.

use super::constants::PairConstants;
use super::lookup::Lookup;
use super::phase::{Phase, Size};
use crate::pair::Body;

/// What of the discs stays the same during a sweep, as they are stored.
#[derive(Clone, Copy)]
pub(super) struct Fixed<'a> {
    pub sizes: &'a [Size],
    /// The size of all discs, if it is one.
    pub equal: Option<Size>,
    pub ids: &'a [u32],
    /// Empty where kinds are not told apart.
    pub kinds: &'a [u32],
}

impl<'a> Fixed<'a> {
    /// That of discs of these sizes, which may all be `equal`, with these ids and kinds.
    pub fn of(sizes: &'a [Size], equal: Option<Size>, ids: &'a [u32], kinds: &'a [u32]) -> Self {
        Self { sizes, equal, ids, kinds }
    }

    /// The disc at this place, which is there now.
    #[inline(always)]
    pub fn body(&self, place: usize, phase: &Phase) -> Body {
        let Size { radius, mass } = self.sizes[place];
        let (position, velocity) = (phase.position(), phase.velocity());
        let kind = self.kinds.get(place).copied().unwrap_or(0);
        Body { id: self.ids[place], kind, position, velocity, radius, mass }
    }
}

/// NeighbourList pairs of one block of discs.
pub(super) struct BlockPairs<'a> {
    pub fixed: Fixed<'a>,
    pub constants: &'a PairConstants,
    /// The discs of the block and those after it, and the place of the first.
    pub discs: Lookup<'a, Phase>,
    pub place: usize,
    /// Places, counted from the first disc; whole groups. And the number of the first of them among all pairs.
    pub pairs: &'a [[u16; 2]],
    pub first: usize,
    /// What each of the pairs remembers; empty where they do not.
    pub memory: &'a mut [f64],
    /// Time of drift since then, s.
    pub elapsed: f64,
}
