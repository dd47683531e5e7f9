//! The judgement of a scenario: what is wrong with its time step, its softness, its speeds and its
//! integrator, by which parameter, and what would work.

use super::expected::ExpectedContact;
use super::finding::{Finding, Matter, Verdict};
use super::number::{Num, round_up};
use super::settings::IntegratorName;
use super::{DiscSource, Scenario, StepChoice};
use crate::analysis::collision::angular_frequency;
use crate::analysis::stability::{COARSE, explicit_euler_gain};

/// Overlaps above this many radii are called soft.
pub const SOFT: f64 = 0.5;

/// Overlap, in radii, that the cure for soft discs aims at.
const FIRM: f64 = 0.26;

/// A contact of fewer steps than this is coarse: with N_t = 10, a pair's contact has 7, a crowded
/// elastic box gains a few per cent of its energy a second.
pub const FEWEST_STEPS: f64 = 10.0;

/// A disc that moves more than this many radii in a step is coarse; more than one, and two discs
/// can pass each other between two steps.
pub const LONG_STRIDE: f64 = 0.25;

impl Scenario {
    /// All that is wrong with this scenario, the gravest first.
    pub fn findings(&self) -> Vec<Finding> {
        let mut findings: Vec<Finding> =
            [self.step_finding(), self.travel_finding(), self.explicit_euler(), self.softness()]
                .into_iter()
                .flatten()
                .collect();
        findings.sort_by_key(|finding| std::cmp::Reverse(finding.verdict)); // keeps ties in order
        findings
    }

    /// Why this scenario is refused; `None` if it may run.
    pub fn refusal(&self) -> Option<Finding> {
        self.findings().into_iter().find(|finding| finding.verdict == Verdict::Unstable)
    }

    pub(super) fn is_stable(&self) -> bool {
        self.dt() <= self.limit().dt
    }

    fn step_finding(&self) -> Option<Finding> {
        if !self.is_stable() {
            return Some(self.unstable_step());
        }
        let limit = self.limit();
        let (dt, fraction) = (self.dt(), self.dt() / limit.dt);
        let shortest = self.shortest_contact();
        let what = if fraction > COARSE {
            let (smallest, largest) = self.radius_range();
            let harm = match limit.is_overdamped && smallest == largest {
                true => "overdamped contacts bear that",
                false => "a crowded box heats up at such steps",
            };
            let by = limit.by;
            format!(
                "large step: dt = {dt:.3e} s is {fraction:.2} of the largest stable step for {by}; {harm}"
            )
        } else if shortest.steps < FEWEST_STEPS {
            let steps = shortest.steps;
            format!(
                "few steps in a contact: the shortest has {steps:.1} steps (Eq. (2) counts those at a wall); \
                 a crowded elastic box gains some per cent of its energy a second"
            )
        } else {
            return None;
        };
        let is_well = |mended: &Self| {
            mended.dt() <= COARSE * mended.limit().dt
                && mended.shortest_contact().steps >= FEWEST_STEPS
        };
        let bears_it = limit.is_overdamped && fraction > COARSE;
        let mut finding = self.finding((Matter::Step, Verdict::Coarse), what, is_well, |mended| {
            let nt = mended.nt_for(COARSE).max(1.5 * FEWEST_STEPS);
            vec![nt_choice(mended, nt), auto(mended)]
        });
        if bears_it {
            finding.ways_out.clear();
        }
        Some(finding)
    }

    fn unstable_step(&self) -> Finding {
        let (dt, limit) = (self.dt(), self.limit());
        let what = format!(
            "dt = {dt:.3e} s is {} times the largest stable step for {}, {:.3e} s{}",
            Num::rounded(dt / limit.dt),
            limit.by,
            limit.dt,
            self.lightest_disc()
        );
        // Just below the limit an elastic heap heats up; an overdamped one, which never lets go
        // of a contact, does not.
        let fraction = if limit.is_overdamped { 1.0 } else { COARSE };
        self.finding((Matter::Step, Verdict::Unstable), what, Self::is_stable, |mended| {
            vec![nt_choice(mended, mended.nt_for(fraction)), auto(mended)]
        })
    }

    /// The N_t of a time step that is this fraction of the limit, as a number to type.
    fn nt_for(&self, fraction: f64) -> f64 {
        round_up(self.with_step(StepChoice::Nt(1.0)).dt() / (fraction * self.limit().dt))
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
        format!(" (the lightest discs rule: {who}, {} kg)", Num(lightest))
    }

    fn shortest_contact(&self) -> ExpectedContact {
        if self.n() > 1 { self.expected_pair() } else { self.expected_wall() }
    }

    fn travel_finding(&self) -> Option<Finding> {
        let travel = self.expected_travel();
        if self.n() < 2 || travel <= LONG_STRIDE {
            return None; // a wall is a half-plane: nothing passes it
        }
        let speed = Num::rounded(self.expected_speed());
        let travelled = Num::rounded(travel);
        let (verdict, harm) = match travel > 1.0 {
            true => (Verdict::Unstable, "discs can cross each other between two steps"),
            false => (Verdict::Coarse, "contacts begin late"),
        };
        let what = format!(
            "long strides: a disc at {speed} m/s moves {travelled} r in a step (at most {LONG_STRIDE} is \
             good, 1 possible), and {harm}"
        );
        let is_well = |mended: &Self| mended.expected_travel() <= LONG_STRIDE;
        Some(self.finding((Matter::Travel, verdict), what, is_well, |mended| {
            let nt =
                round_up(mended.with_step(StepChoice::Nt(1.0)).expected_travel() / LONG_STRIDE);
            vec![nt_choice(mended, nt), auto(mended)]
        }))
    }

    fn softness(&self) -> Option<Finding> {
        let overlap = self.expected_overlap();
        if overlap <= SOFT {
            return None;
        }
        let cause = match (self.walls, self.fall_speed() > 0.0) {
            (true, true) => "a fall through the box".to_owned(),
            (walls, _) => {
                let met = if walls { "a wall met" } else { "discs that meet" };
                format!("{met} at {} m/s", Num::rounded(self.expected_speed()))
            }
        };
        let verb = if self.walls { "sinks them" } else { "sink" };
        // The guide's own discs are soft: a parameter that makes them twice as soft is at fault too.
        let is_well = |mended: &Self| mended.expected_overlap() <= SOFT.max(0.5 * overlap);
        let suspect = self.at_fault(is_well);
        let (fault, value) = match suspect {
            Some(suspect) => (suspect.name, suspect.value),
            None => ("--kn".to_owned(), Num(self.stiffness).to_string()),
        };
        Some(Finding {
            matter: Matter::Softness,
            verdict: Verdict::Coarse,
            what: format!("soft discs: {cause} {verb} {overlap:.2} r deep"),
            fault,
            value,
            ways_out: self.cure_for_softness(overlap),
        })
    }

    /// The deepest overlap, in radii, to expect of a fall through the box or of the fastest disc.
    fn expected_overlap(&self) -> f64 {
        let contact = if self.walls { self.expected_wall() } else { self.expected_pair() };
        contact.largest_overlap
    }

    /// Flags that bring overlaps of `overlap` radii down: a radius that suits the fall, if that
    /// many discs of it fit, and a stiffness that suits what was measured.
    pub fn cure_for_softness(&self, overlap: f64) -> Vec<String> {
        let kn = round_up(self.stiffness * (overlap / FIRM).powi(2) / 1.03);
        let radius = one_digit_up(self.radius * self.expected_overlap() / FIRM);
        let area = std::f64::consts::PI * radius * radius * self.n() as f64;
        let fits = area < 0.5 * self.side * self.side;
        let stays_stable = Self { stiffness: kn, ..self.clone() }.is_stable();
        let is_equal = matches!(self.discs, DiscSource::Equal(_));
        let mut cures = Vec::new();
        if is_equal && fits && radius > self.radius {
            cures.push(format!("--radius {}", Num(radius)));
        }
        let with_step = if stays_stable { "" } else { " with --dt auto" };
        cures.push(format!("--kn {}{with_step}", Num(kn)));
        cures
    }

    fn explicit_euler(&self) -> Option<Finding> {
        (self.integrator == IntegratorName::ExplicitEuler).then(|| {
            let (lightest, _) = self.mass_range();
            let gain = |reduced_mass| {
                let omega = angular_frequency(self.stiffness, reduced_mass);
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

    /// A finding with its parameter at fault, and up to three changes that are well: the usual value
    /// of that parameter, and those of `others`.
    fn finding(
        &self,
        (matter, verdict): (Matter, Verdict),
        what: String,
        is_well: impl Fn(&Self) -> bool,
        others: impl Fn(&Self) -> Vec<(String, Self)>,
    ) -> Finding {
        let mut tries = Vec::new();
        let (fault, value) = match self.at_fault(&is_well) {
            Some(suspect) => {
                tries.push((suspect.usual, suspect.mended));
                (suspect.name, suspect.value)
            }
            None => {
                let usual = self.preset.values().step;
                let (flag, number) = usual.flag_and_value();
                tries.push((format!("{flag} {number}"), self.with_step(usual)));
                self.step_flag()
            }
        };
        tries.extend(others(self));
        tries.dedup_by(|a, b| a.0 == b.0);
        tries.retain(|(_, mended)| {
            is_well(mended) && mended.is_stable() && mended.check_clock().is_ok()
        });
        let ways_out = tries.into_iter().map(|(way_out, _)| way_out).collect();
        Finding { matter, verdict, what, fault, value, ways_out }
    }
}

fn nt_choice(scenario: &Scenario, nt: f64) -> (String, Scenario) {
    (format!("--nt {}", Num(nt)), scenario.with_step(StepChoice::Nt(nt)))
}

fn auto(scenario: &Scenario) -> (String, Scenario) {
    ("--dt auto".to_owned(), scenario.with_step(StepChoice::Auto))
}

/// `value` rounded up to one digit.
fn one_digit_up(value: f64) -> f64 {
    let digit = 10f64.powi(value.log10().floor() as i32);
    format!("{:.0e}", (value / digit).ceil() * digit).parse().unwrap_or(value)
}
