//! What can be expected of a run before it: speeds, overlaps, how long a contact lasts.

use super::{DiscSource, Population, Scenario};
use crate::analysis::collision::{
    angular_frequency, damping_ratio, largest_overlap, restitution, scaled_duration,
};
use crate::particle::Particle;

/// What one kind of contact, a pair's or a wall's, will be like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExpectedContact {
    /// Undamped angular frequency omega0.
    pub angular_frequency: f64, // 1/s
    /// Damping ratio zeta.
    pub damping_ratio: f64,
    /// How long a contact lasts; infinite if the discs never part.
    pub duration: f64, // s
    /// Restitution e.
    pub restitution: f64,
    /// Time steps in a contact.
    pub steps: f64,
    /// Overlap m g / k_n that carries one disc, over the smallest radius.
    pub static_overlap: f64,
    /// Overlap at the foot of a heap of all discs as wide as the box, over the smallest radius.
    pub foot_overlap: f64,
    /// Largest overlap of a contact met at the [`expected_speed`](Scenario::expected_speed), over
    /// the smallest radius.
    pub largest_overlap: f64,
}

impl Scenario {
    /// A contact of the two heaviest discs.
    pub fn expected_pair(&self) -> ExpectedContact {
        let (lightest, heaviest) = self.mass_range();
        // The lightest pair is the shortest contact, the heaviest the deepest.
        self.expected_contact(0.5 * lightest, 0.5 * heaviest)
    }

    /// A contact with a wall.
    pub fn expected_wall(&self) -> ExpectedContact {
        let (lightest, heaviest) = self.mass_range();
        self.expected_contact(lightest, heaviest)
    }

    /// A contact whose reduced mass is `lightest` (kg) for what must be fast enough and `heaviest`
    /// (kg) for what must be stiff enough.
    fn expected_contact(&self, lightest: f64, heaviest: f64) -> ExpectedContact {
        let omega = angular_frequency(self.stiffness, lightest);
        let zeta = self.damping_ratio(lightest);
        let duration = scaled_duration(zeta, self.contact_end()) / omega;
        let (smallest, largest) = self.radius_range();
        let static_overlap = self.mass_range().1 * self.gravity.abs() / self.stiffness / smallest;
        let (fall, deep_zeta) = (self.expected_speed(), self.damping_ratio(heaviest));
        let layers = self.n() as f64 * 2.0 * largest / self.side;
        ExpectedContact {
            angular_frequency: omega,
            damping_ratio: zeta,
            duration,
            restitution: restitution(zeta, self.contact_end()),
            steps: duration / self.dt(),
            static_overlap,
            foot_overlap: static_overlap * layers.max(1.0),
            largest_overlap: largest_overlap(fall, deep_zeta, self.stiffness, heaviest) / smallest,
        }
    }

    /// The speed to expect, m/s: that of a fall through the box, sqrt(2 g l), and of the discs' own
    /// motion at the start.
    pub fn expected_speed(&self) -> f64 {
        self.fall_speed().hypot(self.fastest_start())
    }

    /// The speed of a fall through the box, m/s; 0 without walls to end it.
    pub(super) fn fall_speed(&self) -> f64 {
        if self.walls { (2.0 * self.gravity.abs() * self.side).sqrt() } else { 0.0 }
    }

    /// The path in one time step at the expected speed, over the smallest radius.
    pub fn expected_travel(&self) -> f64 {
        self.expected_speed() * self.dt() / self.radius_range().0
    }

    /// The largest speed to expect of the discs' own motion, m/s: discs that are many exchange
    /// theirs, and twice the rms speed is then common (2 % of Maxwell's distribution in 2D).
    fn fastest_start(&self) -> f64 {
        let (listed, groups): (&[Particle], &[Population]) = match &self.discs {
            DiscSource::Equal(_) => (&[], &[]),
            DiscSource::Listed(listed, groups) => (listed, groups),
            DiscSource::Frame { discs, .. } => (discs, &[]),
        };
        let tail = if self.n() > 2 { 2.0 } else { 1.0 };
        let listed = listed.iter().map(|disc| disc.velocity.length());
        let placed = groups.iter().map(|group| tail * group.speed);
        listed.chain(placed).fold(tail * self.speed, f64::max)
    }

    /// The damping ratio zeta of a contact of this reduced mass, kg.
    pub(super) fn damping_ratio(&self, reduced_mass: f64) -> f64 {
        let eta = self.law().damping.coefficient(self.stiffness, reduced_mass);
        damping_ratio(eta, self.stiffness, reduced_mass)
    }
}
