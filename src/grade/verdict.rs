//! What came out of the checks, and how points are counted.
//!
//! A passed check earns its points, a failed one loses them. One that is *not seen* (no two
//! discs ever met, say) does neither: it is out of the count, and the report says so. What hangs on
//! a failed check is *skipped*: out of the count as well, for one mistake should cost one check
//! (the rubric can say otherwise).

use serde_json::{Value, json};

use super::check::Check;
use super::mistake::Mistake;
use super::rubric::{Rubric, Skipped};
use super::words::{Finding, Quantity, Words};

/// A failure: where it is seen, by which numbers, what it looks like.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// What was found, and what was expected instead.
    pub finding: Finding,
    /// Frame, from 0.
    pub frame: Option<usize>,
    /// Discs, from 0, in the order of the rows.
    pub discs: Vec<usize>,
    /// Numbers.
    pub numbers: Vec<(Quantity, f64)>,
    /// Which mistake it looks like.
    pub cause: Option<Mistake>,
}

impl Failure {
    /// A failure without a place and numbers.
    pub fn of(finding: Finding, cause: impl Into<Option<Mistake>>) -> Self {
        let cause = cause.into();
        Self { finding, frame: None, discs: Vec::new(), numbers: Vec::new(), cause }
    }

    /// With the frame and the discs where it is seen.
    pub fn at(mut self, frame: usize, discs: &[usize]) -> Self {
        self.frame = Some(frame);
        self.discs = discs.to_vec();
        self
    }

    /// With one more number.
    pub fn with(mut self, quantity: Quantity, value: f64) -> Self {
        self.numbers.push((quantity, value));
        self
    }
}

/// What a check says of a submission.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// As it should be.
    Passed,
    /// Not as it should be.
    Failed(Failure),
    /// The frames hold nothing to decide it by.
    NotSeen,
    /// It hangs on a check that failed.
    Skipped(Check),
}

/// What a check found: a status other than skipped.
pub type Verdict = Status;

/// All checks of one submission.
#[derive(Clone, Debug)]
pub struct Report {
    /// Each check that was come to, in order.
    pub checks: Vec<(Check, Status)>,
    /// Points of each check, in the order of [`Check::ALL`].
    points: Vec<f64>,
    skipped: Skipped,
    /// Whole frames.
    pub frames: usize,
    /// Discs.
    pub discs: usize,
    /// Frames that were cut and left out.
    pub torn: usize,
    /// Frames between which more or less time went by than between others, left out.
    pub uneven: usize,
}

impl Report {
    /// A report before the first check.
    pub fn new(rubric: &Rubric) -> Self {
        let points = Check::ALL.map(|check| rubric.points_of(check)).to_vec();
        let skipped = rubric.skipped;
        Self { checks: Vec::new(), points, skipped, frames: 0, discs: 0, torn: 0, uneven: 0 }
    }

    /// Writes down a check.
    pub fn push(&mut self, check: Check, status: Status) {
        self.checks.push((check, status));
    }

    /// Asks a check, unless the one it hangs on failed or was skipped itself.
    pub fn decide(&mut self, check: Check, ask: impl FnOnce() -> Verdict) {
        let status = match check.needs().map(|needed| (needed, self.status(needed))) {
            Some((needed, Some(Status::Failed(_)))) => Status::Skipped(needed),
            Some((_, Some(Status::Skipped(root)))) => Status::Skipped(*root),
            _ => ask(),
        };
        self.push(check, status);
    }

    /// Skips every check not yet come to: only right after one that they all hang on failed.
    pub fn skip_the_rest(&mut self) {
        for check in Check::ALL {
            if self.status(check).is_none() {
                self.decide(check, || Status::NotSeen);
            }
        }
    }

    /// Discs whose energy grew without bound pass any wall in the end: that is one mistake, not two.
    pub fn forgive_walls_that_were_shot_through(&mut self) {
        let grows = |status: Option<&Status>| matches!(status, Some(Status::Failed(why)) if why.finding == Finding::EnergyGrows);
        if grows(self.status(Check::Energy)) {
            let walls = self.checks.iter_mut().find(|(check, _)| *check == Check::Box);
            if let Some((_, status @ Status::Failed(_))) = walls {
                *status = Status::NotSeen;
            }
        }
    }

    /// What was said of a check.
    pub fn status(&self, check: Check) -> Option<&Status> {
        self.checks.iter().find(|(known, _)| *known == check).map(|(_, status)| status)
    }

    /// Whether a check was passed.
    pub fn passed(&self, check: Check) -> bool {
        self.status(check) == Some(&Status::Passed)
    }

    fn points_of(&self, check: Check) -> f64 {
        self.points[check as usize]
    }

    fn sum(&self, wanted: impl Fn(&Status) -> bool) -> f64 {
        let chosen = self.checks.iter().filter(|(_, status)| wanted(status));
        chosen.map(|(check, _)| self.points_of(*check)).sum()
    }

    /// Points earned.
    pub fn earned(&self) -> f64 {
        self.sum(|status| *status == Status::Passed)
    }

    /// Points lost.
    pub fn lost(&self) -> f64 {
        self.sum(|status| match status {
            Status::Failed(_) => true,
            Status::Skipped(_) => self.skipped == Skipped::Lost,
            _ => false,
        })
    }

    /// Points neither earned nor lost.
    pub fn open(&self) -> f64 {
        self.points.iter().sum::<f64>() - self.earned() - self.lost()
    }

    /// Earned of what was decided, per cent; nothing decided is nothing earned.
    pub fn percent(&self) -> f64 {
        let decided = self.earned() + self.lost();
        if decided > 0.0 { 100.0 * self.earned() / decided } else { 0.0 }
    }

    /// The failures, with their checks.
    pub fn failures(&self) -> impl Iterator<Item = (Check, &Failure)> {
        self.checks.iter().filter_map(|(check, status)| match status {
            Status::Failed(failure) => Some((*check, failure)),
            _ => None,
        })
    }

    /// As JSON, with stable names and texts of a language.
    pub fn json(&self, words: &Words) -> Value {
        let checks: Vec<Value> =
            self.checks.iter().map(|(check, status)| self.json_of(*check, status, words)).collect();
        json!({
            "schema": "parsim2d/grade/v1",
            "percent": self.percent(),
            "earned": self.earned(),
            "lost": self.lost(),
            "open": self.open(),
            "frames": self.frames,
            "discs": self.discs,
            "torn_frames": self.torn,
            "uneven_frames": self.uneven,
            "checks": checks,
        })
    }

    fn json_of(&self, check: Check, status: &Status, words: &Words) -> Value {
        let name = (words.check)(check).title;
        let (id, passed) = match status {
            Status::Passed => ("passed", Some(true)),
            Status::Failed(_) => ("failed", Some(false)),
            Status::NotSeen => ("not_seen", None),
            Status::Skipped(_) => ("skipped", None),
        };
        let needs = check.needs().map(Check::id);
        let mut value = json!({"id": check.id(), "name": name, "status": id, "passed": passed,
            "points": self.points_of(check), "needs": needs});
        if let Status::Skipped(root) = status {
            value["because_of"] = root.id().into();
        }
        if let Status::Failed(failure) = status {
            value["failure"] = failure.json(words);
        }
        value
    }
}

impl Failure {
    fn json(&self, words: &Words) -> Value {
        let finding = (words.finding)(self.finding);
        let numbers: Vec<Value> = self.numbers.iter().map(|(quantity, value)| {
            json!({"id": quantity, "name": (words.quantity)(*quantity), "value": value})
        }).collect();
        let cause = self.cause.map(|mistake| {
            let said = (words.mistake)(mistake);
            json!({"id": mistake, "looks_like": said.looks_like, "hint": said.hint})
        });
        json!({"finding": self.finding, "what": finding.what, "expected": finding.expected,
            "frame": self.frame, "discs": self.discs, "numbers": numbers, "cause": cause})
    }
}
