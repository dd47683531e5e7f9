//! The work done by each kind of force, gathered kick by kick.
//!
//! A kick changes a disc's kinetic energy by exactly F . (v + v')/2 dt, with the velocities
//! before and after it. Booked so, force by force, the works add up to the change of kinetic
//! energy to round-off, whatever the time step: this ledger says that the *bookkeeping* is
//! right, and nothing about the accuracy of the motion (that is `analysis/energy.rs`).

use glam::DVec2;

use crate::force::Share;
use crate::particle::Particle;

/// Discs summed in one run; block sums are then added in order. A fixed tree, so that the
/// result does not depend on how the blocks are shared out.
const BLOCK: usize = 1024;

/// Works since the start of the run, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Works {
    /// Done by the weight, m g.
    pub gravity: Sum,
    /// Done by the contacts' springs, k_n delta_n, and by all other forces that store energy.
    pub spring: Sum,
    /// Done by the contacts' dashpots; its negative is the dissipated energy.
    pub dashpot: Sum,
    /// Done by added forces that store nothing, and kinetic energy given by hand.
    pub external: Sum,
    /// Gravitational and stored energy given by hand: discs lifted, forces added. No work: not in the total.
    pub by_hand: Sum,
}

impl Works {
    /// The sum of all works, J.
    pub fn total(&self) -> f64 {
        self.gravity.value() + self.spring.value() + self.dashpot.value() + self.external.value()
    }

    /// Energy supplied from outside, J; less than nothing where it was taken, as drag does.
    pub fn supplied(&self) -> f64 {
        self.external.value() + self.by_hand.value()
    }

    /// Kicks every disc by `dt` (s) and books what weight, springs and dashpots did.
    /// `external` says whether other forces act, whose work is then the rest.
    pub fn kick(
        &mut self,
        particles: &mut [Particle],
        shares: &[Share],
        gravity: DVec2,
        external: bool,
        dt: f64,
    ) {
        for (particles, shares) in particles.chunks_mut(BLOCK).zip(shares.chunks(BLOCK)) {
            let mut block = [0.0; 4];
            for (particle, share) in particles.iter_mut().zip(shares) {
                let before = particle.velocity;
                particle.kick(dt);
                let path = 0.5 * (before + particle.velocity) * dt;
                let weight = particle.mass * gravity;
                block[0] += weight.dot(path);
                block[1] += share.spring.dot(path);
                block[2] += share.dashpot.dot(path);
                if external {
                    let rest = particle.force - weight - share.spring - share.dashpot;
                    block[3] += rest.dot(path);
                }
            }
            self.gravity.add(block[0]);
            self.spring.add(block[1]);
            self.dashpot.add(block[2]);
            self.external.add(block[3]);
        }
    }
}

/// Kinetic energy of all discs, J, added block by block.
pub fn kinetic_energy(particles: &[Particle]) -> f64 {
    sum_over(particles, Particle::kinetic_energy)
}

/// The sum of `quantity` over all discs, added block by block in a fixed order.
pub fn sum_over(particles: &[Particle], quantity: impl Fn(&Particle) -> f64) -> f64 {
    let mut total = Sum::default();
    for block in particles.chunks(BLOCK) {
        total.add(block.iter().map(&quantity).sum());
    }
    total.value()
}

/// A running sum that carries its own rounding error (Neumaier 1974), so that a million small
/// works do not drown in one large one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sum {
    pub(crate) value: f64,
    pub(crate) carry: f64,
}

impl Sum {
    /// Adds `term`.
    ///
    /// ```
    /// let mut sum = parsim2d::work::Sum::default();
    /// [1.0, 1e100, 1.0, -1e100].map(|term| sum.add(term));
    /// assert_eq!(sum.value(), 2.0); // a plain sum gives 0
    /// ```
    #[inline]
    pub fn add(&mut self, term: f64) {
        let value = self.value + term;
        self.carry += if self.value.abs() >= term.abs() {
            (self.value - value) + term
        } else {
            (term - value) + self.value
        };
        self.value = value;
    }

    /// The sum.
    #[inline]
    pub fn value(&self) -> f64 {
        self.value + self.carry
    }
}
