//! Plain lines said before a run: what the guide's numbers do, and what would be better.

use super::finding::{Finding, Matter, Verdict};
use super::preset::Preset;
use super::settings::{PlacementName, Settings};
use super::{DampingChoice, DiscSource, Scenario};
use crate::analysis::collision::{damping_ratio, restitution};
use crate::number::{at_most, counted, safely_above, shortest};
use crate::particle::Particle;

/// Particle-steps a second on one core of a laptop; for a rough guess only.
pub const USUAL_SPEED: f64 = 2e7;

impl Scenario {
    /// What a person should know before this run starts with `discs`, a sentence each.
    pub fn notes(&self, discs: &[Particle]) -> Vec<String> {
        let before = [self.note_on_the_guide(), self.note_on_overdamping()];
        let untold = |finding: &Finding| !self.is_of_the_guide(finding);
        let findings =
            self.findings().into_iter().filter(untold).map(|finding| match finding.verdict {
                Verdict::Unstable => Some(format!("unstable on purpose: {}", finding.what)),
                _ => Some(finding.note()),
            });
        let after = [
            self.note_on_gravity(),
            self.note_on_stillness(discs),
            self.note_on_length(),
            self.note_on_threads(),
            self.note_on_start(discs),
            self.note_on_lattice(),
        ];
        let of_file = self.notes_on_file().iter().cloned().map(Some);
        of_file.chain(before).chain(findings).chain(after).flatten().collect()
    }

    /// One line of all that the guide's own numbers bring with them, and who says more; of other presets how
    /// they read the guide's damping.
    fn note_on_the_guide(&self) -> Option<String> {
        if !self.has_damping_of_the_guide() {
            return self.reading_of_the_guide();
        }
        let is_soft = self.findings().iter().any(|finding| self.is_of_the_guide(finding));
        let soft = if is_soft { ", and discs as soft as its numbers make them" } else { "" };
        Some(format!(
            "eta_n = 1.5e-3 kg/s for the guide's printed 1.5e3{soft}; `parsim2d check` says more"
        ))
    }

    fn has_damping_of_the_guide(&self) -> bool {
        matches!(self.preset, Preset::Guide | Preset::GuideListing)
            && self.damping == self.preset.values().damping
    }

    /// Whether `finding` is about the guide's own softness, which [`notes`](Self::notes) tell in one line with its
    /// damping: nothing that was changed makes its discs any softer.
    pub fn is_of_the_guide(&self, finding: &Finding) -> bool {
        let preset = Settings { preset: Some(self.preset), ..Settings::default() };
        finding.matter == Matter::Softness
            && self.has_damping_of_the_guide()
            && Self::resolve(&preset, || 0)
                .is_ok_and(|guide| self.expected_overlap() <= 1.001 * guide.expected_overlap())
    }

    /// How the preset reads the guide's damping, if that is the damping of this run.
    pub fn reading_of_the_guide(&self) -> Option<String> {
        let printed = "the guide prints eta_n = 1.5e3";
        let zeta_of = |eta: f64, reduced_mass: f64| {
            damping_ratio(eta, self.linear(reduced_mass).stiffness, reduced_mass)
        };
        let zeta = zeta_of(1.5e3, 0.5 * self.mass);
        let times = format!("{} times critical damping for a pair", at_most(zeta, 3));
        let unchanged = self.damping == self.preset.values().damping;
        match (self.preset, self.damping) {
            (Preset::Guide | Preset::GuideListing, _) if unchanged => Some(format!(
                "eta_n = 1.5e-3 kg/s ({printed}, {times}, which no step of Eq. (2) with N_t of 10 \
                 to 50 can follow: README, trap 1)"
            )),
            (Preset::GuidePrinted, _) if unchanged => {
                Some(format!("{printed}, taken as kg/s: {times}"))
            }
            (Preset::GuideMassScaled, DampingChoice::Gamma(gamma)) if unchanged => {
                let e = |reduced_mass: f64| {
                    restitution(zeta_of(gamma * reduced_mass, reduced_mass), self.contact_end())
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

    fn note_on_gravity(&self) -> Option<String> {
        let up = self.gravity.vector.y;
        (self.gravity.is_vertical() && up > 0.0).then(|| {
            let up = shortest(up);
            format!(
                "gravity is positive downward (y of a vector [gx, gy] is up): this one pulls up; \
                 --gravity {up} pulls down"
            )
        })
    }

    fn note_on_stillness(&self, discs: &[Particle]) -> Option<String> {
        let all_rest = discs.iter().all(|disc| disc.velocity.length_squared() == 0.0);
        let touches = || self.deepest_overlap(discs, |overlap| overlap.relative).1 > 0;
        (self.gravity.is_nothing() && !discs.is_empty() && all_rest && !touches())
            .then(|| "no disc moves: no gravity, no speed, no contact; try --speed 0.1".to_owned())
    }

    fn note_on_length(&self) -> Option<String> {
        let particle_steps = self.n() as f64 * self.steps() as f64;
        let minutes = particle_steps / USUAL_SPEED / 60.0;
        (minutes > 5.0).then(|| {
            let advice = match self.output.checkpoint_every {
                Some(_) => "",
                None => "; --checkpoint-every 10min keeps it from being lost",
            };
            format!(
                "a long run: {:.0e} particle-steps, some {} minutes at {:.0e} a second{advice}",
                particle_steps,
                safely_above(minutes),
                USUAL_SPEED
            )
        })
    }

    fn note_on_threads(&self) -> Option<String> {
        let asked = self.output.threads.filter(|&threads| threads > self.threads() as u64)?;
        let n = self.n();
        Some(format!(
            "--threads {asked}: {n} discs run on one, sharing pays from some thousands on"
        ))
    }

    fn note_on_start(&self, discs: &[Particle]) -> Option<String> {
        if matches!(self.discs, DiscSource::Equal(_)) || self.start_finding().is_some() {
            return None; // nothing overlaps, or it has been told
        }
        let (deepest, many) = self.deepest_overlap(discs, |overlap| overlap.relative);
        let deepest = deepest?;
        // Touching discs that rounding made overlap by a hair, 0.000 r in the sentence, are nothing to tell.
        (deepest.relative >= 5e-4).then(|| {
            let other = deepest.other.map_or("a wall".to_owned(), |other| format!("disc {other}"));
            format!(
                "{} at the start; the deepest, disc {} and {other}, is {:.3} r",
                counted(many, "overlap"),
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
