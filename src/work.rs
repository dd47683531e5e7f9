//! The energy ledger's sums: what each kind of force did, gathered kick by kick, and what came from outside.
//!
//! A kick changes a disc's kinetic energy by exactly F . (v + v')/2 dt, with the velocities
//! before and after it. Booked so, force by force, the works add up to the change of kinetic
//! energy to round-off, whatever the time step: this ledger says that the *bookkeeping* is
//! right, and nothing about the accuracy of the motion (that is `analysis/energy.rs`).

use std::ops::{AddAssign, Index, IndexMut, SubAssign};

use glam::DVec2;

use crate::particle::{Contact, Particle};

/// Discs summed in one run; block sums are then added in order. A fixed tree, so that the
/// result does not depend on how the blocks are shared out.
const BLOCK: usize = 1024;

/// What becomes of the energy that a channel takes from the discs or gives them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Nature {
    /// It is there to be had back, and is read off the present state.
    Stored,
    /// It is gone as heat.
    Dissipated,
    /// It comes from outside, or goes there.
    Supplied,
}

/// One entry makes a channel: its name, and what becomes of its energy.
macro_rules! channels {
    ($($(#[$about:meta])* $name:ident: $nature:ident,)*) => {
        /// A way for energy to come and go.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Channel {
            $($(#[$about])* $name,)*
        }

        impl Channel {
            /// All of them, in the order in which they are added up.
            pub const ALL: [Self; [$(stringify!($name)),*].len()] = [$(Self::$name),*];

            /// What becomes of its energy.
            pub fn nature(self) -> Nature {
                match self {
                    $(Self::$name => Nature::$nature,)*
                }
            }
        }
    };
}

channels! {
    /// The weight, m g.
    Gravity: Stored,
    /// Normal springs of contacts, k_n delta_n, and added forces that say what they store.
    NormalSpring: Stored,
    /// Normal dashpots: all of a contact's normal force but its spring.
    NormalDashpot: Dissipated,
    /// Tangential springs.
    ShearSpring: Stored,
    /// Sliding, and tangential dashpots.
    Friction: Dissipated,
    /// Resistance to rolling.
    Rolling: Dissipated,
    /// Bonds and other forces between discs that need not touch.
    Bond: Stored,
    /// Walls that move.
    Wall: Supplied,
    /// Fields, and added forces that store nothing: drag takes.
    Field: Supplied,
    /// Thermostats.
    Thermostat: Supplied,
    /// Discs that are added, less those that are removed.
    Inflow: Supplied,
    /// What is changed by hand between two steps.
    Hand: Supplied,
}

/// The two sums of a channel, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Account {
    /// Kinetic energy given: work done at kicks, speeds changed by hand, discs that came with a speed.
    pub work: Sum,
    /// Other energy that came (or went, less than nothing), which is no work on a disc: discs lifted or pressed
    /// together by hand, a wall that moves against springs, the spring of a bond that breaks.
    pub beside: Sum,
}

/// Energies booked since the ledger was opened, J: an [`Account`] for each [`Channel`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Works([Account; Channel::ALL.len()]);

impl Index<Channel> for Works {
    type Output = Account;

    fn index(&self, channel: Channel) -> &Account {
        &self.0[channel as usize]
    }
}

impl IndexMut<Channel> for Works {
    fn index_mut(&mut self, channel: Channel) -> &mut Account {
        &mut self.0[channel as usize]
    }
}

impl Works {
    /// The work of this channel so far, J.
    pub fn work(&self, channel: Channel) -> f64 {
        self[channel].work.value()
    }

    /// The sum of all works, J: how much the kinetic energy has changed.
    pub fn total(&self) -> f64 {
        Channel::ALL.into_iter().fold(0.0, |sum, channel| sum + self.work(channel))
    }

    /// Energy supplied from outside, J; less than nothing where it was taken, as drag does.
    pub fn supplied(&self) -> f64 {
        self.sum_of(Nature::Supplied, |account| account.work.value() + account.beside.value())
    }

    /// Energy gone as heat, J: what dashpots and friction took, and what was stored in what is no more.
    pub fn dissipated(&self) -> f64 {
        let taken = |account: &Account| account.work.value() + account.beside.value();
        let taken = self.sum_of(Nature::Dissipated, taken);
        let lost = self.sum_of(Nature::Stored, |account| account.beside.value());
        0.0 - taken - lost // not -0.0 where nothing was taken
    }

    fn sum_of(&self, nature: Nature, of_account: impl Fn(&Account) -> f64) -> f64 {
        let channels = Channel::ALL.into_iter().filter(|channel| channel.nature() == nature);
        channels.fold(0.0, |sum, channel| sum + of_account(&self[channel]))
    }

    /// Kicks every disc by `dt` (s) and books what weight, springs and dashpots did. `has_fields` says whether other
    /// forces act, whose work is then the rest.
    pub fn kick(
        &mut self,
        particles: &mut [Particle],
        shares: &[Share],
        gravity: DVec2,
        has_fields: bool,
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
                if has_fields {
                    let rest = particle.force - weight - share.spring - share.dashpot;
                    block[3] += rest.dot(path);
                }
            }
            let kinds =
                [Channel::Gravity, Channel::NormalSpring, Channel::NormalDashpot, Channel::Field];
            kinds.into_iter().zip(block).for_each(|(channel, sum)| self[channel].work.add(sum));
        }
    }
}

/// The part of a disc's force that stores energy or damps, split in two.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Share {
    /// From springs, k_n delta_n, and from other forces that store energy.
    pub spring: DVec2, // N
    /// The rest of the contact force: the dashpot, and what clipping took away.
    pub dashpot: DVec2, // N
}

impl Share {
    /// Of a contact that pushes by `push`, of which `spring` stores energy (N), along its normal.
    pub fn of(contact: &Contact, spring: f64, push: f64) -> Self {
        Self { spring: spring * contact.normal, dashpot: (push - spring) * contact.normal }
    }
}

impl AddAssign for Share {
    fn add_assign(&mut self, other: Self) {
        self.spring += other.spring;
        self.dashpot += other.dashpot;
    }
}

impl SubAssign for Share {
    fn sub_assign(&mut self, other: Self) {
        self.spring -= other.spring;
        self.dashpot -= other.dashpot;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_channel_goes_into_the_sum_that_its_nature_says() {
        let mut works = Works::default();
        for (k, channel) in Channel::ALL.into_iter().enumerate() {
            works[channel].work.add(2f64.powi(k as i32)); // sums of powers of 2 are exact, and tell who is in them
        }
        let among = |channels: &[Channel]| -> f64 {
            channels.iter().map(|channel| works.work(*channel)).sum()
        };
        assert_eq!(works.total(), 2f64.powi(Channel::ALL.len() as i32) - 1.0);
        assert_eq!(
            works.supplied(),
            among(&[
                Channel::Wall,
                Channel::Field,
                Channel::Thermostat,
                Channel::Inflow,
                Channel::Hand
            ])
        );
        assert_eq!(
            works.dissipated(),
            -among(&[Channel::NormalDashpot, Channel::Friction, Channel::Rolling])
        );
    }

    #[test]
    fn what_is_no_work_is_supplied_or_lost_but_in_no_total() {
        let mut works = Works::default();
        works[Channel::Wall].beside.add(3.0); // a wall pushed discs together
        works[Channel::Bond].beside.add(-2.0); // a bond broke that held 2 J
        assert_eq!((works.total(), works.supplied(), works.dissipated()), (0.0, 3.0, 2.0));
    }
}
