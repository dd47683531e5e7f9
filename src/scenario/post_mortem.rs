//! The post-mortem of a run that went wrong: what happened, and the parameter that explains it.

use super::Scenario;
use super::finding::{Finding, Matter, Verdict};
use super::suspects::IN_PLACE_OF_DT;
use crate::analysis::guard::{Trouble, Wrong};
use crate::number::{at_most, safely_above, shortest};
use crate::output::failure::FailureReport;

/// What is said behind a finer step that may help.
const TO_SEE: &str = " to see whether a finer step helps";

/// The flags of a way out, without the words behind them.
pub fn flags(way_out: &str) -> &str {
    let bare = way_out.strip_suffix(TO_SEE).unwrap_or(way_out);
    bare.strip_suffix(IN_PLACE_OF_DT).unwrap_or(bare)
}

impl Scenario {
    /// What the guard of a run looks for: of walls only where there are some, of discs that cross only where they are
    /// not known to be soft.
    pub fn watched(&self) -> Vec<Wrong> {
        let mut watched = Wrong::ALL.to_vec();
        let (is_soft, walls) = (self.is_soft(), self.walls);
        watched.retain(|wrong| match wrong {
            Wrong::Crossed => !is_soft,
            Wrong::BeyondWall => walls,
            Wrong::NotFinite | Wrong::EnergyGrown => true,
        });
        watched
    }

    /// What is to be said of `trouble` in a run of this scenario, `stopped` by it or not.
    pub fn post_mortem(&self, trouble: &Trouble, stopped: bool) -> FailureReport {
        let cause = self.cause_of(trouble);
        let (diagnosis, ways_out) = match &cause {
            Some(finding) => (finding.what.clone(), finding.ways_out.clone()),
            None => self.without_cause(trouble),
        };
        FailureReport {
            version: env!("CARGO_PKG_VERSION"),
            seed: self.seed,
            kind: trouble.wrong.name(),
            what: what(trouble),
            step: trouble.step,
            time_s: trouble.time,
            discs: trouble.discs.clone(),
            wall: trouble.wall,
            overlap_over_r: trouble.overlap,
            speed_m_per_s: trouble.speed,
            energy_start_J: trouble.energy_at_start,
            energy_before_J: trouble.energy_before,
            energy_after_J: trouble.energy_after,
            dissipated_J: trouble.dissipated,
            total_J: trouble.dissipated.map(|took| trouble.energy_after + took),
            fault: cause.as_ref().map(|finding| finding.fault.clone()),
            value: cause.as_ref().map(|finding| finding.value.clone()),
            diagnosis,
            ways_out,
            stopped,
        }
    }

    /// The finding that explains the trouble: what makes a run unstable explains everything; soft
    /// discs explain deep overlaps, and energy that grows comes from the integrator or the step.
    fn cause_of(&self, trouble: &Trouble) -> Option<Finding> {
        let findings = self.findings();
        let of = |matter| findings.iter().find(|finding| finding.matter == matter);
        let order = match trouble.wrong {
            Wrong::Crossed | Wrong::BeyondWall => {
                [Matter::Integrator, Matter::Start, Matter::Softness, Matter::Travel, Matter::Step]
            }
            Wrong::NotFinite | Wrong::EnergyGrown => {
                [Matter::Integrator, Matter::Step, Matter::Travel, Matter::Start, Matter::Softness]
            }
        };
        let unstable = findings.iter().find(|finding| finding.verdict == Verdict::Unstable);
        unstable.or_else(|| order.into_iter().find_map(of)).cloned()
    }

    /// What to say where the diagnosis had nothing against the run: a finer step may help.
    fn without_cause(&self, trouble: &Trouble) -> (String, Vec<String>) {
        let nt = self.steps_per_contact();
        let travel = trouble.speed * self.dt() / self.radius_range().0;
        let sentence = format!(
            "the diagnosis found nothing against this run beforehand (`parsim2d check`); the disc \
             moved {} r in a step",
            at_most(travel, 3)
        );
        let finer = self.in_place_of_dt(format!("--nt {}", shortest(safely_above(4.0 * nt))));
        (sentence, vec![format!("{finer}{TO_SEE}")])
    }
}

fn what(trouble: &Trouble) -> String {
    let id = |k: usize| trouble.discs.get(k).map_or("?".to_owned(), usize::to_string);
    let overlap = at_most(trouble.overlap, 3);
    let at_wall = trouble.wall.map(|wall| format!(", {overlap} r deep in the {wall} wall"));
    match trouble.wrong {
        Wrong::NotFinite => format!("the state of disc {} is not finite any more", id(0)),
        Wrong::Crossed => {
            format!("the centres of discs {} and {} met: overlap {overlap} r", id(0), id(1))
        }
        Wrong::BeyondWall => format!(
            "disc {} sank {overlap} r into the {} wall, its centre {} r beyond",
            id(0),
            trouble.wall.unwrap_or("?"),
            at_most(trouble.overlap - 1.0, 3)
        ),
        Wrong::EnergyGrown => format!(
            "the energy{} has grown by more than all that could move the discs at the start; the \
             fastest, disc {}, has {} m/s{}",
            if trouble.energy_after > trouble.energy_before.max(trouble.energy_at_start) {
                ""
            } else {
                ", with what damping took,"
            },
            id(0),
            at_most(trouble.speed, 3),
            at_wall.unwrap_or_default()
        ),
    }
}
