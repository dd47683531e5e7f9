//! The time step and the integrator: what is wrong with them, and what would work.

use super::{FEWEST_STEPS, LONG_STRIDE};
use crate::analysis::collision::angular_frequency;
use crate::analysis::stability::{COARSE, explicit_euler_gain};
use crate::number::{at_most, safely_above, shortest, time_step};
use crate::scenario::expected::ExpectedContact;
use crate::scenario::finding::{Finding, Matter, Verdict};
use crate::scenario::settings::IntegratorName;
use crate::scenario::{DiscSource, Scenario, StepChoice};

/// A step below this fraction of the limit is finer than any answer needs.
const NEEDLESS: f64 = 1e-4;

impl Scenario {
    pub(super) fn step_finding(&self) -> Option<Finding> {
        if !self.is_stable() {
            return Some(self.unstable_step());
        }
        let what = self.what_is_coarse()?;
        let is_well = |mended: &Self| mended.what_is_coarse().is_none();
        let nt = self.nt_for(COARSE).max(1.5 * FEWEST_STEPS).max(self.nt_for_stride());
        let about = (Matter::Step, Verdict::Coarse);
        let mut finding = self.finding(about, what, is_well, Self::share_of_limit, nt);
        if self.limit().is_overdamped && self.share_of_limit() > COARSE {
            finding.ways_out.clear(); // nothing has to be done
        }
        Some(finding)
    }

    fn share_of_limit(&self) -> f64 {
        self.dt() / self.limit().dt
    }

    /// What makes a stable time step coarse, or needlessly fine.
    fn what_is_coarse(&self) -> Option<String> {
        let limit = self.limit();
        let (dt, fraction) = (self.dt(), self.dt() / limit.dt);
        let shortest = self.shortest_contact();
        Some(if fraction > COARSE {
            let (smallest, largest) = self.radius_range();
            let harm = match limit.is_overdamped && smallest == largest {
                true => "overdamped contacts bear that",
                false => "a crowded box heats up at such steps",
            };
            let by = limit.by;
            format!(
                "large step: dt = {} is {fraction:.2} of the largest stable step for {by}; {harm}",
                time_step(dt)
            )
        } else if shortest.steps < FEWEST_STEPS {
            let steps = shortest.steps;
            format!(
                "few steps in a contact: the shortest has {steps:.1} steps (Eq. (2) counts those at a wall); \
                 a crowded elastic box gains some per cent of its energy a second"
            )
        } else if fraction < NEEDLESS {
            format!(
                "needlessly small step: dt = {} is {fraction:.1e} of the largest stable step \
                 for {}; the run takes {:.1e} steps",
                time_step(dt),
                limit.by,
                self.time / dt
            )
        } else {
            return None;
        })
    }

    fn unstable_step(&self) -> Finding {
        let (dt, limit) = (self.dt(), self.limit());
        let what = format!(
            "dt = {} is {} times the largest stable step for {}, {}{}",
            time_step(dt),
            at_most(dt / limit.dt, 3),
            limit.by,
            time_step(limit.dt),
            self.lightest_disc()
        );
        // Just below the limit an elastic heap heats up; an overdamped one, which never lets go
        // of a contact, does not.
        let nt = match limit.is_overdamped {
            true => self.nt_for(1.0),
            false => self.nt_for(COARSE).max(1.5 * FEWEST_STEPS),
        };
        let (about, nt) = ((Matter::Step, Verdict::Unstable), nt.max(self.nt_for_stride()));
        self.finding(about, what, Self::is_stable, Self::share_of_limit, nt)
    }

    /// The N_t of a time step that is this fraction of the limit, as a number to type.
    fn nt_for(&self, fraction: f64) -> f64 {
        safely_above(self.with_step(StepChoice::Nt(1.0)).dt() / (fraction * self.limit().dt))
    }

    /// Who sets the limit where discs differ.
    fn lightest_disc(&self) -> String {
        let (lightest, heaviest) = self.mass_range();
        if lightest == heaviest {
            return String::new();
        }
        let species = self.species();
        let k = species.iter().position(|s| s.mass == lightest).unwrap_or(0);
        let listed = match &self.discs {
            DiscSource::Listed(listed, _) => listed.len(),
            _ => 0,
        };
        let who = match k.checked_sub(listed) {
            None => format!("disc {k}"),
            Some(group) => format!("population {group}"),
        };
        format!(" (the lightest discs rule: {who}, {} kg)", shortest(lightest))
    }

    fn shortest_contact(&self) -> ExpectedContact {
        if self.n() > 1 { self.expected_pair() } else { self.expected_wall() }
    }

    pub(super) fn travel_finding(&self) -> Option<Finding> {
        let travel = self.expected_travel();
        if self.n() < 2 || travel <= LONG_STRIDE {
            return None; // a wall is a half-plane: nothing passes it
        }
        let speed = at_most(self.expected_speed(), 3);
        let travelled = at_most(travel, 3);
        let (verdict, harm) = match travel > 1.0 {
            true => (Verdict::Unstable, "discs can cross each other between two steps"),
            false => (Verdict::Coarse, "contacts begin late"),
        };
        let what = format!(
            "long strides: a disc at {speed} m/s moves {travelled} r in a step (at most {LONG_STRIDE} is \
             good, 1 possible), and {harm}"
        );
        let is_well = |mended: &Self| mended.n() < 2 || mended.expected_travel() <= LONG_STRIDE;
        let stable = if self.is_stable() { 0.0 } else { self.nt_for(COARSE) };
        let nt = self.nt_for_stride().max(stable);
        Some(self.finding((Matter::Travel, verdict), what, is_well, Self::expected_travel, nt))
    }

    /// The N_t at which a disc moves no farther than [`LONG_STRIDE`] in a step, as a number to type.
    fn nt_for_stride(&self) -> f64 {
        let travel = self.with_step(StepChoice::Nt(1.0)).expected_travel();
        if self.n() < 2 || travel <= 0.0 { 0.0 } else { safely_above(travel / LONG_STRIDE) }
    }

    /// Whether discs can cross each other between two steps.
    pub(super) fn jumps(&self) -> bool {
        self.n() > 1 && self.expected_travel() > 1.0
    }

    pub(super) fn explicit_euler(&self) -> Option<Finding> {
        (self.integrator == IntegratorName::ExplicitEuler).then(|| {
            let (lightest, _) = self.mass_range();
            let gain = |reduced_mass| {
                let omega = angular_frequency(self.linear(reduced_mass).stiffness, reduced_mass);
                let percent = 100.0 * (explicit_euler_gain(omega, self.dt()) - 1.0);
                format!("{percent:.*}", if percent < 10.0 { 1 } else { 0 })
            };
            Finding {
                matter: Matter::Integrator,
                verdict: Verdict::Coarse,
                what: format!(
                    "explicit-euler gains energy: about {} % at an elastic wall bounce, {} % when \
                     two discs collide",
                    gain(lightest),
                    gain(0.5 * lightest)
                ),
                fault: "--integrator".to_owned(),
                value: self.integrator.name().to_owned(),
                ways_out: vec!["--integrator symplectic-euler".to_owned()],
            }
        })
    }
}
