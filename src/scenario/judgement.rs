//! The judgement of a scenario: what is wrong with its time step, its softness, its speeds and its
//! integrator, by which parameter, and what would work.

mod softness;
mod step;
mod stepped;

use super::finding::{Finding, Matter, Verdict};
use super::suspects::Suspect;
use super::{Scenario, StepChoice};
use crate::number::shortest;

/// Overlaps above this many radii are called soft.
pub const SOFT: f64 = 0.5;

/// Overlaps above this many radii are hopeless: the centres of two discs meet.
const HOPELESS: f64 = 2.0;

/// A contact of fewer steps than this is coarse: with N_t = 10, a pair's contact has 7, a crowded
/// elastic box gains a few per cent of its energy a second.
pub const FEWEST_STEPS: f64 = 10.0;

/// A disc that moves more than this many radii in a step is coarse; more than one, and two discs
/// can pass each other between two steps.
pub const LONG_STRIDE: f64 = 0.25;

impl Scenario {
    /// All that is wrong with this scenario, the gravest first.
    pub fn findings(&self) -> Vec<Finding> {
        let found = [
            self.start_finding(),
            self.far_finding(),
            self.step_finding(),
            self.travel_finding(),
            self.explicit_euler(),
            self.missed_restitution(),
            self.softness(),
        ];
        let mut findings: Vec<Finding> = found.into_iter().flatten().collect();
        findings.sort_by_key(|finding| std::cmp::Reverse(finding.verdict)); // keeps ties in order
        findings
    }

    /// Why this scenario is refused; `None` if it may run.
    pub fn refusal(&self) -> Option<Finding> {
        self.findings().into_iter().find(|finding| finding.verdict == Verdict::Unstable)
    }

    /// Whether the step is below the stable limit.
    pub(super) fn is_stable(&self) -> bool {
        self.dt() <= self.limit().dt
    }

    /// Whether nothing refuses this scenario.
    pub(super) fn is_runnable(&self) -> bool {
        self.is_stable() && !self.jumps() && self.check_clock().is_ok()
    }

    /// Whether discs keep from sinking through each other: what is softer goes wrong on the way, whatever
    /// its time step.
    pub(super) fn is_firm_enough(&self) -> bool {
        self.expected_overlap() <= HOPELESS
    }

    /// The stiffness, with a time step that suits it, that makes hopelessly soft discs firm; nothing if that
    /// does not run either.
    fn firm(&self) -> Option<(String, Self)> {
        let stiffness = self.firm_stiffness(self.expected_overlap());
        let mended = Self { stiffness, step: StepChoice::Auto, ..self.clone() };
        let runs = mended.is_runnable() && mended.is_firm_enough();
        runs.then(|| (format!("--kn {} with --dt auto", shortest(stiffness)), mended))
    }

    /// A finding with its parameter at fault, and up to three changes that are well: the usual value
    /// of that parameter, an N_t, and `--dt auto`. `strain` is what the finding judges; the lower, the
    /// better.
    fn finding(
        &self,
        (matter, verdict): (Matter, Verdict),
        what: String,
        is_well: impl Fn(&Self) -> bool,
        strain: impl Fn(&Self) -> f64,
        nt: f64,
    ) -> Finding {
        let Suspect { name, value, usual, mended } = self.blamed(&is_well, strain);
        let finer = self.in_place_of_dt(format!("--nt {}", shortest(nt)));
        let finer = (finer, self.with_step(StepChoice::Nt(nt)));
        let auto = ("--dt auto".to_owned(), self.with_step(StepChoice::Auto));
        let mut tries = vec![(usual, mended), finer, auto];
        tries.dedup_by(|a, b| a.0 == b.0);
        tries.retain(|(_, mended)| is_well(mended) && mended.is_runnable());
        // What runs and sinks discs past each other would be refused by the guard later.
        if tries.iter().any(|(_, mended)| mended.is_firm_enough()) {
            tries.retain(|(_, mended)| mended.is_firm_enough());
        } else if let Some(firm) = self.firm().filter(|(_, mended)| is_well(mended)) {
            tries = vec![firm];
        }
        let ways_out = tries.into_iter().map(|(way_out, _)| way_out).collect();
        Finding { matter, verdict, what, fault: name, value, ways_out }
    }

    /// What the discs are, or the time step: whichever does more if put back to its usual value.
    fn blamed(&self, is_well: impl Fn(&Self) -> bool, strain: impl Fn(&Self) -> f64) -> Suspect {
        let step = self.step_suspect();
        let step_mends = step.mended != *self && is_well(&step.mended);
        match self.at_fault(is_well) {
            Some(suspect) if !step_mends => suspect,
            Some(suspect) if strain(&step.mended) > 0.5 * strain(&suspect.mended) => suspect,
            _ => step,
        }
    }
}
