//! A fingerprint of the state of a simulation.

use super::Simulation;

impl Simulation {
    /// A 64-bit fingerprint of the state: FNV-1a (Fowler, Noll, Vo) over the step and then, in
    /// id order, x, y, vx, vy, r, m of each disc, all as little-endian bytes.
    pub fn state_hash(&self) -> u64 {
        let words = self.each_particle().flat_map(|p| {
            let (x, v) = (p.position, p.velocity);
            [x.x, x.y, v.x, v.y, p.radius, p.mass].map(f64::to_bits)
        });
        let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
        for byte in std::iter::once(self.steps()).chain(words).flat_map(u64::to_le_bytes) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
        hash
    }
}
