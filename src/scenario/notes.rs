//! Plain lines said before a run: what the guide's numbers do, and what would be better.

use super::number::Num;
use super::preset::Preset;
use super::refusal::round_up;
use super::settings::{IntegratorName, PlacementName};
use super::{DampingChoice, DiscSource, Population, Scenario};
use crate::analysis::collision::{angular_frequency, damping_ratio, largest_overlap, restitution};
use crate::analysis::stability::{COARSE, explicit_euler_gain};
use crate::particle::Particle;

/// Overlaps above this many radii are called soft.
pub const SOFT: f64 = 0.5;

/// Particle-steps a second on one core of a laptop; for a rough guess only.
const USUAL_SPEED: f64 = 2e7;

/// Overlap, in radii, that the cure for soft discs aims at.
const FIRM: f64 = 0.26;

/// `value` rounded up to one digit.
fn one_digit_up(value: f64) -> f64 {
    let digit = 10f64.powi(value.log10().floor() as i32);
    format!("{:.0e}", (value / digit).ceil() * digit).parse().unwrap_or(value)
}

impl Scenario {
    /// What a person should know before this run starts with `discs`, a sentence each.
    pub fn notes(&self, discs: &[Particle]) -> Vec<String> {
        [
            self.note_on_damping(),
            self.note_on_overdamping(),
            self.note_on_softness(),
            self.note_on_step(),
            self.note_on_length(),
            self.note_on_explicit_euler(),
            self.note_on_start(discs),
            self.note_on_lattice(),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    fn note_on_softness(&self) -> Option<String> {
        let overlap = self.expected_overlap();
        let cause = match self.fall_energy() > 0.0 {
            true => "a fall through the box".to_owned(),
            false => format!("a wall met at {} m/s", Num::rounded(self.expected_speed())),
        };
        (overlap > SOFT).then(|| {
            let cure = self.cure_for_softness(overlap);
            format!("soft discs: {cause} sinks them {overlap:.2} r deep; {cure}")
        })
    }

    /// Twice the energy that a fall through the box gives a disc, over its mass, m²/s².
    fn fall_energy(&self) -> f64 {
        if self.walls { 2.0 * self.gravity.abs() * self.side } else { 0.0 }
    }

    fn expected_speed(&self) -> f64 {
        (self.fall_energy() + self.fastest_start().powi(2)).sqrt()
    }

    /// The deepest overlap, in radii, that a fall through the box or the fastest disc makes at
    /// a wall.
    fn expected_overlap(&self) -> f64 {
        let speed = self.expected_speed();
        let (smallest, _) = self.radius_range();
        let (_, heaviest) = self.mass_range();
        largest_overlap(speed, self.damping_ratio(heaviest), self.stiffness, heaviest) / smallest
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

    /// Flags that bring overlaps of `overlap` radii down: a radius that suits the fall, if that
    /// many discs of it fit, and a stiffness that suits what was measured.
    pub fn cure_for_softness(&self, overlap: f64) -> String {
        let kn = round_up(self.stiffness * (overlap / FIRM).powi(2) / 1.03);
        let radius = one_digit_up(self.radius * self.expected_overlap() / FIRM);
        let area = std::f64::consts::PI * radius * radius * self.n() as f64;
        let fits = area < 0.5 * self.side * self.side;
        let stays_stable = Self { stiffness: kn, ..self.clone() }.refusal().is_none();
        let is_equal = matches!(self.discs, DiscSource::Equal(_));
        let mut cures = Vec::new();
        if is_equal && fits && radius > self.radius {
            cures.push(format!("--radius {}", Num(radius)));
        }
        if stays_stable {
            cures.push(format!("--kn {}", Num(kn)));
        } else {
            cures.push(format!("--kn {} with --dt auto", Num(kn)));
        }
        format!("try {}", cures.join(" or "))
    }

    fn note_on_damping(&self) -> Option<String> {
        let printed = "the guide prints eta_n = 1.5e3";
        let zeta = damping_ratio(1.5e3, self.stiffness, 0.5 * self.mass);
        let times = format!("{} times critical damping for a pair", Num::rounded(zeta));
        let unchanged = self.damping == self.preset.values().damping;
        match (self.preset, self.damping) {
            (Preset::Guide | Preset::GuideListing, _) if unchanged => Some(format!(
                "eta_n = 1.5e-3 kg/s ({printed}, {times}, which no step of Eq. (2) can follow: \
                 README, trap 1)"
            )),
            (Preset::GuidePrinted, _) if unchanged => {
                Some(format!("{printed}, taken as kg/s: {times}"))
            }
            (Preset::GuideMassScaled, DampingChoice::Gamma(gamma)) if unchanged => {
                let e = |reduced_mass: f64| {
                    let eta = gamma * reduced_mass;
                    let zeta = damping_ratio(eta, self.stiffness, reduced_mass);
                    restitution(zeta, self.contact_end())
                };
                Some(format!(
                    "{printed}, taken as a rate: eta_n = m_eff gamma, restitution {:.3} for a pair \
                     and {:.3} at a wall",
                    e(0.5 * self.mass),
                    e(self.mass)
                ))
            }
            _ => None,
        }
    }

    fn note_on_overdamping(&self) -> Option<String> {
        let (lightest, heaviest) = self.mass_range();
        let wall = if self.walls { heaviest } else { 0.5 * lightest };
        // By eta the lightest contact is damped most, by gamma the heaviest.
        let contacts =
            if self.n() > 1 { vec![0.5 * lightest, 0.5 * heaviest, wall] } else { vec![wall] };
        let zeta = contacts.into_iter().map(|mass| self.damping_ratio(mass)).fold(0.0, f64::max);
        (zeta >= 1.0 && self.tension).then(|| {
            format!(
                "zeta = {zeta:.3}: at zeta >= 1 discs that touch never separate on their own; \
                 --no-tension lets them"
            )
        })
    }

    /// The damping ratio zeta of a contact of this reduced mass, kg.
    fn damping_ratio(&self, reduced_mass: f64) -> f64 {
        let eta = self.law().damping.coefficient(self.stiffness, reduced_mass);
        damping_ratio(eta, self.stiffness, reduced_mass)
    }

    fn note_on_step(&self) -> Option<String> {
        let limit = self.limit();
        let (dt, fraction) = (self.dt(), self.dt() / limit.dt);
        let step = format!("dt = {dt:.3e} s is {fraction:.2} of the largest stable step");
        if fraction > 1.0 {
            return Some(format!("unstable on purpose: {step} for {}", limit.by));
        }
        if fraction <= COARSE || self.integrator == IntegratorName::ExplicitEuler {
            return None;
        }
        let (smallest, largest) = self.radius_range();
        Some(match limit.is_overdamped && smallest == largest {
            true => format!("coarse: {step} for {}; overdamped contacts bear that", limit.by),
            false => format!(
                "coarse: {step} for {}; a crowded box heats up at such steps. --dt auto is finer",
                limit.by
            ),
        })
    }

    fn note_on_length(&self) -> Option<String> {
        let particle_steps = self.n() as f64 * self.steps() as f64;
        let minutes = particle_steps / USUAL_SPEED / 60.0;
        (minutes > 5.0).then(|| {
            format!(
                "a long run: {:.0e} particle-steps, some {} minutes at {:.0e} a second",
                particle_steps,
                round_up(minutes),
                USUAL_SPEED
            )
        })
    }

    fn note_on_explicit_euler(&self) -> Option<String> {
        (self.integrator == IntegratorName::ExplicitEuler).then(|| {
            let (lightest, _) = self.mass_range();
            let gain = |reduced_mass| {
                let omega = angular_frequency(self.stiffness, reduced_mass);
                let percent = 100.0 * (explicit_euler_gain(omega, self.dt()) - 1.0);
                format!("{percent:.*}", if percent < 10.0 { 1 } else { 0 })
            };
            format!(
                "explicit-euler gains energy: about {} % at an elastic wall bounce, {} % when \
                 two discs collide. --integrator symplectic-euler does not",
                gain(lightest),
                gain(0.5 * lightest)
            )
        })
    }

    fn note_on_start(&self, discs: &[Particle]) -> Option<String> {
        if matches!(self.discs, DiscSource::Equal(_)) {
            return None;
        }
        let overlaps = self.overlaps(discs);
        let deepest = overlaps.iter().max_by(|a, b| a.relative.total_cmp(&b.relative))?;
        // Touching discs that rounding made overlap by a hair are nothing to tell.
        (deepest.relative > 1e-6).then(|| {
            let other = deepest.other.map_or("a wall".to_owned(), |other| format!("disc {other}"));
            format!(
                "{} overlaps at the start; the deepest, disc {} and {other}, is {:.3} r",
                overlaps.len(),
                deepest.disc,
                deepest.relative
            )
        })
    }

    fn note_on_lattice(&self) -> Option<String> {
        let listed = matches!(&self.discs, DiscSource::Listed(listed, groups)
            if !listed.is_empty() && !groups.is_empty());
        (listed && self.placement == PlacementName::Lattice).then(|| {
            "--placement lattice is for boxes without listed discs: placed at random".to_owned()
        })
    }
}
