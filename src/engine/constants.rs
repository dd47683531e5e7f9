//! What of two discs' sizes enters their contact: worked out for each near pair when the list is made, for discs of
//! several sizes.

use super::block::BLOCK;
use super::neighbour_list::NeighbourList;
use super::phase::Size;
use super::workers::Workers;

/// Pairs in a chunk; of them, as many are worked on at a time as a processor has lanes.
pub(super) const CHUNK: usize = 128;

/// Constants of each near pair, in the order of the pairs, and of a chunk more than there are; empty for discs of one size.
#[derive(Default)]
pub(super) struct PairConstants {
    /// Sums of the radii, m.
    pub reaches: Vec<f64>,
    /// Reduced masses, kg.
    pub reduced_masses: Vec<f64>,
    /// Smaller radii, m, rounded down.
    pub smaller_radii: Vec<f32>,
}

impl PairConstants {
    /// Works them out for the pairs of `near`, of discs of these sizes.
    pub fn work_out(&mut self, list: &NeighbourList, sizes: &[Size], workers: &Workers) {
        let length = list.pairs.len() + CHUNK;
        self.reaches.resize(length, 0.0);
        self.reduced_masses.resize(length, 0.0);
        self.smaller_radii.resize(length, 0.0);
        let blocks = sizes.len().div_ceil(BLOCK);
        let (mut reaches, mut masses, mut radii) =
            (&mut self.reaches[..], &mut self.reduced_masses[..], &mut self.smaller_radii[..]);
        let mut all = Vec::with_capacity(blocks);
        for block in 0..blocks {
            let many = list.pairs_of(block).len();
            let (reach, mass, radius);
            (reach, reaches) = reaches.split_at_mut(many);
            (mass, masses) = masses.split_at_mut(many);
            (radius, radii) = radii.split_at_mut(many);
            all.push((reach, mass, radius));
        }
        workers.pieces(&mut all, |first, all| {
            for (block, (reaches, masses, radii)) in (first..).zip(all) {
                let pairs = &list.pairs[list.pairs_of(block)];
                for (k, pair) in pairs.iter().enumerate() {
                    let [a, b] = pair.map(|at| sizes[block * BLOCK + usize::from(at)]);
                    reaches[k] = a.radius + b.radius;
                    masses[k] = a.mass * b.mass / (a.mass + b.mass);
                    let smaller = a.radius.min(b.radius) as f32;
                    radii[k] = f32::from_bits(smaller.to_bits() - 1); // the next one down: radii are above 0
                }
            }
        });
    }
}
