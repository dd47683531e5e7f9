//! What two threads whose discs lie next to each other both look at.

use super::BLOCK;
use super::near::Near;
use crate::particle::Particle;

/// Copies of the discs about a place where the discs of one thread end and those of the next begin, as
/// they were before anybody moved them.
pub(super) struct Seam {
    /// The block of the first of them.
    pub first_block: usize,
    discs: Vec<Particle>,
}

impl Seam {
    /// None: before the first thread's discs and after the last one's.
    pub fn none() -> Self {
        Self { first_block: usize::MAX, discs: Vec::new() }
    }

    /// Copies what those look at who end before `block` and who begin there.
    pub fn copy(&mut self, particles: &[Particle], near: &Near, block: usize) {
        let places;
        (self.first_block, places) = near.seam_at(block);
        self.discs.clear();
        self.discs.extend_from_slice(&particles[places]);
    }

    /// The discs of `block` and after it.
    #[inline(always)]
    pub fn discs_after(&self, block: usize) -> &[Particle] {
        &self.discs[(block - self.first_block) * BLOCK..]
    }
}
