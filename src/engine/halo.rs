//! What two threads whose discs lie next to each other both look at.

use std::ops::Range;

use super::block::BLOCK;
use super::neighbour_list::NeighbourList;
use super::phase::Phase;

/// Copies of the discs about a place where the discs of one thread end and those of the next begin, as
/// they were before anybody moved them, and of what the pairs before it remembered.
pub(super) struct Halo {
    /// The block of the first of them.
    pub first_block: usize,
    /// The number of the first pair of which there is memory.
    pub first_pair: usize,
    pub memory: Vec<f64>,
    discs: Vec<Phase>,
    places: Range<usize>,
    pairs: Range<usize>,
}

impl Halo {
    /// None: before the first thread's discs and after the last one's.
    pub fn none() -> Self {
        Self {
            first_block: usize::MAX,
            first_pair: 0,
            memory: Vec::new(),
            discs: Vec::new(),
            places: 0..0,
            pairs: 0..0,
        }
    }

    /// Finds out what those look at who end before `block` and who begin there.
    pub fn lay_out(&mut self, list: &NeighbourList, block: usize) {
        (self.first_block, self.places) = list.halo_at(block);
        self.pairs = list.pairs_of_run(&(self.first_block..block));
        self.first_pair = self.pairs.start;
    }

    /// Copies it.
    pub fn copy(&mut self, phases: &[Phase], memory: &[f64]) {
        self.discs.clear();
        self.discs.extend_from_slice(&phases[self.places.clone()]);
        self.memory.clear();
        self.memory.extend_from_slice(memory.get(self.pairs.clone()).unwrap_or_default());
    }

    /// The discs of `block` and after it.
    #[inline(always)]
    pub fn discs_after(&self, block: usize) -> &[Phase] {
        &self.discs[(block - self.first_block) * BLOCK..]
    }
}
