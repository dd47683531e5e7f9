//! What can be expected of a run before it: speeds, overlaps, how long a contact lasts.

use super::{DiscSource, Scenario};
use crate::analysis::bounce::Touch;
use crate::analysis::collision::{
    angular_frequency, damping_ratio, largest_overlap, restitution, scaled_duration,
};
use crate::analysis::linear::Linear;
use crate::analysis::stability::Species;

/// What one kind of contact, a pair's or a wall's, will be like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExpectedContact {
    /// Reduced mass m_eff.
    pub reduced_mass: f64, // kg
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
    /// A contact of two discs: what must be fast enough is told of the lightest pair, what must be
    /// stiff enough of the pair that sinks deepest.
    pub fn expected_pair(&self) -> ExpectedContact {
        let (lightest, _) = self.mass_range();
        let (kinds, mut deepest) = (self.kinds(), 0.0_f64);
        for (k, a) in kinds.iter().enumerate() {
            // The other of the same kind, if there is one, and all of other kinds.
            let others = &kinds[if a.n > 1 { k } else { k + 1 }..];
            for b in others {
                let mass = a.mass * b.mass / (a.mass + b.mass);
                deepest = deepest.max(self.expected_depth(mass) / a.radius.min(b.radius));
            }
        }
        let shortest = if self.n() == 2 && kinds.len() == 2 {
            kinds[0].mass * kinds[1].mass / (kinds[0].mass + kinds[1].mass)
        } else {
            0.5 * lightest
        };
        self.expected_contact(shortest, deepest)
    }

    /// A contact with a wall, likewise.
    pub fn expected_wall(&self) -> ExpectedContact {
        let (lightest, _) = self.mass_range();
        let depths =
            self.kinds().into_iter().map(|kind| self.expected_depth(kind.mass) / kind.radius);
        self.expected_contact(lightest, depths.fold(0.0, f64::max))
    }

    /// The deepest overlap, over the smaller radius, to expect of any contact in the run; at walls, if
    /// there are any: the wall's contact is the deeper one.
    pub fn expected_overlap(&self) -> f64 {
        match (self.walls, self.n()) {
            (true, _) => self.expected_wall().largest_overlap,
            (false, 1) => 0.0,
            (false, _) => self.expected_pair().largest_overlap,
        }
    }

    /// Whether discs are expected to sink so deep into each other that they may pass through.
    pub fn is_soft(&self) -> bool {
        self.expected_overlap() > super::judgement::SOFT
    }

    /// Discs that differ; of very many kinds the extreme ones.
    fn kinds(&self) -> Vec<Species> {
        const MANY: usize = 40;
        let mut kinds: Vec<Species> = Vec::new();
        let mut all = self.species();
        all.sort_by(|a, b| a.radius.total_cmp(&b.radius).then(a.mass.total_cmp(&b.mass)));
        for kind in all {
            match kinds.last_mut() {
                Some(last) if last.radius == kind.radius && last.mass == kind.mass => {
                    last.n += kind.n;
                }
                _ => kinds.push(kind),
            }
        }
        if kinds.len() > MANY {
            // The lightest, the heaviest and the smallest of all, taken for many each.
            let heaviest = kinds.iter().max_by(|a, b| a.mass.total_cmp(&b.mass)).copied();
            let lightest = kinds.iter().min_by(|a, b| a.mass.total_cmp(&b.mass)).copied();
            let extremes = [Some(kinds[0]), heaviest, lightest].into_iter().flatten();
            kinds = extremes.map(|kind| Species { n: 2, ..kind }).collect();
        }
        kinds
    }

    /// The largest overlap, m, of a contact of this reduced mass (kg) met at the expected speed.
    fn expected_depth(&self, reduced_mass: f64) -> f64 {
        let Linear { stiffness, damping } = self.linear(reduced_mass);
        let zeta = damping_ratio(damping, stiffness, reduced_mass);
        largest_overlap(self.expected_speed(), zeta, stiffness, reduced_mass)
    }

    /// A contact of `reduced_mass` (kg) in time, and of `largest_overlap` radii.
    fn expected_contact(&self, reduced_mass: f64, largest_overlap: f64) -> ExpectedContact {
        let Linear { stiffness, damping } = self.linear(reduced_mass);
        let omega = angular_frequency(stiffness, reduced_mass);
        let zeta = damping_ratio(damping, stiffness, reduced_mass);
        let duration = scaled_duration(zeta, self.contact_end()) / omega;
        let weights = self.species().into_iter().map(|disc| disc.mass / disc.radius);
        let static_overlap = weights.fold(0.0, f64::max) * self.gravity.size() / stiffness;
        let (_, largest) = self.radius_range();
        let area = self.n() as f64 * 4.0 * largest * largest;
        let layers = self.gravity.heap_depth(area, self.side) / (2.0 * largest);
        ExpectedContact {
            reduced_mass,
            angular_frequency: omega,
            damping_ratio: zeta,
            duration,
            restitution: restitution(zeta, self.contact_end()),
            steps: duration / self.dt(),
            static_overlap,
            foot_overlap: static_overlap * layers.max(1.0),
            largest_overlap,
        }
    }

    /// Restitution of the lightest disc on the floor, met at the speed to expect, with its weight on it;
    /// 0 if it stays, `None` without a weight.
    pub(super) fn bounce_with_weight(&self) -> Option<f64> {
        let (reduced_mass, push) = (self.mass_range().0, self.gravity.vector.abs().max_element());
        let Linear { stiffness, damping } = self.linear(reduced_mass);
        let touch = Touch {
            stiffness,
            eta: damping,
            reduced_mass,
            speed: self.expected_speed(),
            push,
            end: self.contact_end(),
        };
        let parting_speed = touch.bounce().parting.map_or(0.0, |parting| parting.speed);
        (push > 0.0 && touch.speed > 0.0).then_some(parting_speed / touch.speed)
    }

    /// The speed to expect, m/s: that of a fall through the box, sqrt(2 g l), and of the discs' own
    /// motion at the start.
    pub fn expected_speed(&self) -> f64 {
        self.fall_speed().hypot(self.fastest_start())
    }

    /// The speed of a fall through the box, along gravity from corner to corner, m/s; 0 without walls to end it.
    pub(super) fn fall_speed(&self) -> f64 {
        let height = self.gravity.fall_height(self.side);
        if self.walls { (2.0 * self.gravity.size() * height).sqrt() } else { 0.0 }
    }

    /// The path in one time step at the expected speed, over the smallest radius.
    pub fn expected_travel(&self) -> f64 {
        self.expected_speed() * self.dt() / self.radius_range().0
    }

    /// The largest speed to expect of the discs' own motion, m/s: discs that are many exchange
    /// theirs, and twice the rms speed is then common (2 % of Maxwell's distribution in 2D).
    pub(super) fn fastest_start(&self) -> f64 {
        let tail = if self.n() > 2 { 2.0 } else { 1.0 };
        let usual = tail * self.speed;
        match &self.discs {
            DiscSource::Equal(_) => usual,
            DiscSource::Listed(listed, groups) => {
                let listed = listed.iter().map(|disc| disc.velocity.length());
                let placed = groups.iter().map(|group| tail * group.speed);
                listed.chain(placed).fold(usual, f64::max)
            }
            DiscSource::Frame { discs, .. } => {
                discs.iter().map(|disc| disc.velocity.length()).fold(usual, f64::max)
            }
        }
    }

    /// The damping ratio zeta of a contact of this reduced mass, kg.
    pub(super) fn damping_ratio(&self, reduced_mass: f64) -> f64 {
        let Linear { stiffness, damping } = self.linear(reduced_mass);
        damping_ratio(damping, stiffness, reduced_mass)
    }
}
