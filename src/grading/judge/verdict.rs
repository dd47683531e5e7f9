//! What came out of the checks, and how points are counted.
//!
//! A passed check earns its points, a failed one loses them. One that is *not seen* (no two
//! discs ever met, say) does neither: it is out of the count, and the report says so. What hangs on
//! a failed check is *skipped*: out of the count as well, for one mistake should cost one check, or lost
//! if there are no frames to judge (the rubric can say otherwise, and can leave part of a check's points to a
//! mistake).

use serde_json::{Value, json};

use super::check::Check;
use super::mistake::Mistake;
use super::rubric::Rubric;
use super::wall::Wall;
use super::words::{Finding, Note, Quantity, Words};

/// A failure: where it is seen, by which numbers, what it looks like.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// What was found, and what was expected instead.
    pub finding: Finding,
    /// Frame, from 0.
    pub frame: Option<usize>,
    /// Discs, from 0, in the order of the rows.
    pub discs: Vec<usize>,
    /// Wall.
    pub wall: Option<Wall>,
    /// Numbers.
    pub numbers: Vec<(Quantity, f64)>,
    /// Which mistake it looks like.
    pub cause: Option<Mistake>,
    /// What a tool printed, or names of files. It comes from a submission: escape it before showing it.
    pub said: Option<String>,
}

impl Failure {
    /// A failure without a place and numbers.
    pub fn of(finding: Finding, cause: impl Into<Option<Mistake>>) -> Self {
        let cause = cause.into();
        let (frame, discs, wall) = (None, Vec::new(), None);
        Self { finding, frame, discs, wall, numbers: Vec::new(), cause, said: None }
    }

    /// With the frame and the discs where it is seen.
    pub fn at(mut self, frame: usize, discs: &[usize]) -> Self {
        self.frame = Some(frame);
        self.discs = discs.to_vec();
        self
    }

    /// With the wall where it is seen.
    pub fn on(mut self, wall: Wall) -> Self {
        self.wall = Some(wall);
        self
    }

    /// With one more number.
    pub fn with(mut self, quantity: Quantity, value: f64) -> Self {
        self.numbers.push((quantity, value));
        self
    }

    /// With what a tool printed, or names of files; nothing is added if it is empty.
    pub fn saying(mut self, text: &str) -> Self {
        self.said = (!text.trim().is_empty()).then(|| text.trim_end().to_owned());
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
    /// What the assignment's own trap did to the discs hides it: see [`overdamped`](super::overdamped).
    Masked,
}

/// What a check found: a status other than skipped.
pub type Verdict = Status;

/// All checks of one submission.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Each check that was come to, in order.
    pub checks: Vec<(Check, Status)>,
    /// What is to be asked.
    asked: Vec<Check>,
    rubric: Rubric,
    /// Whole frames.
    pub frames: usize,
    /// Discs.
    pub discs: usize,
    /// Frames that were cut and left out.
    pub torn: usize,
    /// Frames between which more or less time went by than between others, left out.
    pub uneven: usize,
    /// What the reader should know, though it costs nothing.
    pub notes: Vec<Note>,
}

impl Report {
    /// A report of frames, before the first check: what needs a program that runs is neither asked nor counted.
    pub fn of_frames(rubric: &Rubric) -> Self {
        let asked = Check::ALL.into_iter().filter(|check| check.is_of_frames()).collect();
        Self::asking(asked, rubric)
    }

    /// A report of a whole submission, before the first check. Checks worth 0 points are asked as well.
    pub fn of_submission(rubric: &Rubric) -> Self {
        Self::asking(Check::ALL.to_vec(), rubric)
    }

    fn asking(asked: Vec<Check>, rubric: &Rubric) -> Self {
        Self { asked, rubric: rubric.clone(), ..Self::default() }
    }

    /// Writes down a check.
    pub fn push(&mut self, check: Check, status: Status) {
        self.checks.push((check, status));
    }

    /// Asks a check, unless the one it hangs on failed or was skipped itself.
    pub fn decide(&mut self, check: Check, ask: impl FnOnce() -> Verdict) {
        if check == Check::Interface && self.rubric.interface.is_none() {
            return self.push(check, Status::NotSeen);
        }
        let status = match check.needs().map(|needed| (needed, self.status(needed))) {
            Some((needed, Some(Status::Failed(_)))) => Status::Skipped(needed),
            Some((_, Some(Status::Skipped(root)))) => Status::Skipped(*root),
            _ => ask(),
        };
        self.push(check, status);
    }

    /// Goes through every check of frames not yet come to: what hangs on a failed one is skipped.
    pub fn skip_frames(&mut self) {
        for check in Check::ALL.into_iter().filter(|check| check.is_of_frames()) {
            if self.status(check).is_none() {
                self.decide(check, || Status::NotSeen);
            }
        }
    }

    /// Goes through every check asked for and not yet come to, of frames or not.
    pub fn skip_the_rest(&mut self) {
        for check in self.asked.clone() {
            if self.status(check).is_none() {
                self.decide(check, || Status::NotSeen);
            }
        }
    }

    /// Whether nothing is known to be wrong, and less than half of the points of motion were decided.
    pub fn is_little_judged(&self) -> bool {
        let motion = Check::ALL.into_iter().filter(|c| c.is_of_motion() && *c != Check::LongRun);
        let all: f64 = motion.clone().map(|check| self.points_of(check)).sum();
        let seen = motion.filter(|&check| self.passed(check));
        let seen: f64 = seen.map(|check| self.points_of(check)).sum();
        self.failures().next().is_none() && 2.0 * seen < all
    }

    /// Discs that leave the box before anything is seen of how they move have shown nothing of it: its points are
    /// lost with the box.
    pub fn lose_what_is_not_seen_out_of_the_box(&mut self) {
        let is_unseen = self.status(Check::FreeFlight) == Some(&Status::NotSeen);
        if !is_unseen || !self.failed(Check::Box) {
            return;
        }
        for (_, status) in self.checks.iter_mut().filter(|(check, _)| check.is_of_motion()) {
            if *status == Status::NotSeen {
                *status = Status::Skipped(Check::Box);
            }
        }
    }

    /// Discs whose energy grew without bound pass any wall in the end: that is one mistake, not two.
    pub fn forgive_walls_that_were_shot_through(&mut self) {
        let makers = [
            Mistake::ExplicitEuler,
            Mistake::DampingSign,
            Mistake::EnergyPump,
            Mistake::ForcesNotReset,
            Mistake::ReactionSign,
        ];
        let is_made =
            self.failures().any(|(_, why)| why.cause.is_some_and(|m| makers.contains(&m)));
        // Who pairs run off with, or adds up forces, does not bounce as it should either.
        let is_wild = [Mistake::ForcesNotReset, Mistake::ReactionSign];
        let is_wild =
            self.failures().any(|(_, why)| why.cause.is_some_and(|m| is_wild.contains(&m)));
        for (check, status) in &mut self.checks {
            let is_forgiven = match check {
                Check::Box => is_made,
                Check::WallBounce | Check::RestitutionWall => is_wild,
                _ => false,
            };
            if is_forgiven && matches!(status, Status::Failed(_)) {
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

    /// Whether a check failed.
    pub fn failed(&self, check: Check) -> bool {
        matches!(self.status(check), Some(Status::Failed(_)))
    }

    /// Whether a check failed by this mistake.
    pub fn failed_by(&self, check: Check, mistake: Mistake) -> bool {
        matches!(self.status(check), Some(Status::Failed(why)) if why.cause == Some(mistake))
    }

    /// Whether a check failed with this finding.
    pub fn found(&self, check: Check, finding: Finding) -> bool {
        matches!(self.status(check), Some(Status::Failed(why)) if why.finding == finding)
    }

    /// Whether what a check hangs on was passed or not seen.
    pub fn is_asked_for(&self, check: Check) -> bool {
        let needed = check.needs().and_then(|needed| self.status(needed));
        !matches!(needed, Some(Status::Failed(_) | Status::Skipped(_)))
    }

    /// Puts the checks into the order of [`Check::ALL`].
    pub fn in_order(&mut self) {
        self.checks.sort_by_key(|(check, _)| *check);
    }

    /// Points of a check.
    pub fn points_of(&self, check: Check) -> f64 {
        self.rubric.points_of(check)
    }

    /// The rubric it was judged by.
    pub fn rubric(&self) -> &Rubric {
        &self.rubric
    }

    /// Points earned and lost by a check.
    pub fn score(&self, check: Check, status: &Status) -> (f64, f64) {
        let points = self.points_of(check);
        match status {
            Status::Passed => (points, 0.0),
            Status::Failed(failure) => {
                let left = self.rubric.part_left(failure.cause);
                (left * points, (1.0 - left) * points)
            }
            Status::Skipped(root) if self.rubric.skipped.is_lost(check, *root) => (0.0, points),
            Status::Skipped(_) | Status::NotSeen | Status::Masked => (0.0, 0.0),
        }
    }

    /// Points earned.
    pub fn earned(&self) -> f64 {
        self.checks.iter().map(|(check, status)| self.score(*check, status).0).sum()
    }

    /// Points lost.
    pub fn lost(&self) -> f64 {
        self.checks.iter().map(|(check, status)| self.score(*check, status).1).sum()
    }

    /// Points neither earned nor lost.
    pub fn open(&self) -> f64 {
        let all: f64 = self.asked.iter().map(|&check| self.points_of(check)).sum();
        all - self.earned() - self.lost()
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

    /// The hint for a mistake: the rubric's own, or the usual one.
    pub fn hint<'a>(&'a self, mistake: Mistake, words: &Words) -> &'a str {
        self.rubric.hints.get(&mistake).map_or((words.mistake)(mistake).hint, String::as_str)
    }

    /// As JSON, with stable names and texts of a language.
    pub fn json(&self, words: &Words) -> Value {
        let checks: Vec<Value> =
            self.checks.iter().map(|(check, status)| self.json_of(*check, status, words)).collect();
        let notes: Vec<Value> = self
            .notes
            .iter()
            .map(|note| json!({"id": note, "text": (words.note)(*note)}))
            .collect();
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
            "notes": notes,
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
            Status::Masked => ("masked", None),
        };
        let needs = check.needs().filter(|needed| self.asked.contains(needed)).map(Check::id);
        let (earned, lost) = self.score(check, status);
        let mut value = json!({"id": check.id(), "name": name, "status": id, "passed": passed,
            "points": self.points_of(check), "earned": earned, "lost": lost, "needs": needs,
            "visibility": self.rubric.visibility_of(check)});
        if let Status::Skipped(root) = status {
            value["because_of"] = root.id().into();
        }
        if let Status::Failed(failure) = status {
            value["failure"] = self.json_of_failure(failure, words);
        }
        value
    }

    fn json_of_failure(&self, failure: &Failure, words: &Words) -> Value {
        let finding = (words.finding)(failure.finding);
        let number = |(quantity, value): &(Quantity, f64)| json!({"id": quantity, "name": (words.quantity)(*quantity), "value": value});
        let numbers: Vec<Value> = failure.numbers.iter().map(number).collect();
        let cause = failure.cause.map(|mistake| {
            let looks_like = (words.mistake)(mistake).looks_like;
            json!({"id": mistake, "looks_like": looks_like, "hint": self.hint(mistake, words)})
        });
        json!({"finding": failure.finding, "what": finding.what, "expected": finding.expected,
            "frame": failure.frame, "discs": failure.discs, "wall": failure.wall, "numbers": numbers, "cause": cause,
            "said": failure.said})
    }
}
