//! The diagnosis of a scenario before it runs: what its contacts will be like, how far its time step
//! is from every limit, and what is wrong, by which parameter.

use serde::Serialize;

use super::Scenario;
use super::expected::ExpectedContact;
use super::finding::{Finding, Matter, Verdict};
use super::judgement::{FEWEST_STEPS, LONG_STRIDE, SOFT};
use crate::analysis::collision::ContactEnd;
use crate::analysis::stability::{self, COARSE, LimitedBy};
use crate::number::{significant, time_step};

/// Linear limits say only this much.
pub const CAVEAT: &str = "These limits are necessary, not sufficient: contacts open and close. With \
    many contacts N_t = 4 to 8 pass and heat up, and N_t = 10 gains a few per cent of the energy a \
    second.";

/// What can be told of a run before it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Diagnosis {
    /// The gravest verdict.
    pub verdict: Verdict,
    /// The parameter at fault, as its flag, if something is.
    pub fault: Option<String>,
    /// Its value.
    pub value: Option<String>,
    /// Changes that work.
    pub ways_out: Vec<String>,
    /// One sentence with all of that.
    pub sentence: String,
    /// Time step, s.
    pub dt_s: f64,
    /// Largest stable time step, s.
    pub limit_s: f64,
    /// Memory that the run takes, an estimate, bytes.
    pub memory_bytes: u64,
    /// The speed to expect, m/s.
    pub speed_m_s: f64,
    /// When a contact counts as over: at overlap zero, or at force zero.
    pub contact_end: &'static str,
    /// Figures of contacts and steps, with their verdicts.
    pub figures: Vec<Figure>,
    /// Limits on the time step, with their verdicts.
    pub limits: Vec<LimitFigure>,
    /// All that was found, the gravest first.
    pub findings: Vec<Finding>,
}

/// A number for a contact of two discs and for one with a wall.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Figure {
    /// What it is, with its unit.
    pub name: &'static str,
    /// Between two discs; absent if there is only one.
    pub pair: Option<f64>,
    /// At a wall; absent if there is none.
    pub wall: Option<f64>,
    /// The verdict on it; absent where there is nothing to judge.
    pub verdict: Option<Verdict>,
}

/// A limit on the time step.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LimitFigure {
    /// What sets it.
    pub by: String,
    /// The largest time step, s.
    pub dt_s: f64,
    /// The time step over it.
    pub fraction: f64,
    /// The verdict on it.
    pub verdict: Verdict,
}

impl Scenario {
    /// The diagnosis of this scenario.
    ///
    /// ```
    /// use parsim2d::scenario::{Scenario, finding::Verdict};
    /// let guide = Scenario::from_toml("").unwrap().diagnosis();
    /// assert_eq!(guide.verdict, Verdict::Coarse);
    /// assert_eq!(guide.fault.unwrap(), "--kn"); // a fall sinks discs of 1e-4 m 1.25 r deep
    /// assert!((guide.limit_s / 1.145e-4 - 1.0).abs() < 1e-3); // s, a heap of discs
    /// ```
    pub fn diagnosis(&self) -> Diagnosis {
        let findings = self.findings();
        let worst = findings.first();
        let (dt, limit) = (self.dt(), self.limit());
        let sentence = match worst {
            Some(finding) => finding.sentence(),
            None => format!(
                "dt = {} is {:.2} of the largest stable step for {}",
                time_step(dt),
                dt / limit.dt,
                limit.by
            ),
        };
        Diagnosis {
            verdict: worst.map_or(Verdict::Good, |finding| finding.verdict),
            fault: worst.map(|finding| finding.fault.clone()),
            value: worst.map(|finding| finding.value.clone()),
            ways_out: worst.map(|finding| finding.ways_out.clone()).unwrap_or_default(),
            sentence,
            dt_s: dt,
            limit_s: limit.dt,
            memory_bytes: self.memory(),
            speed_m_s: self.expected_speed(),
            contact_end: match self.contact_end() {
                ContactEnd::OverlapZero => "overlap zero: the dashpot may pull as discs part",
                ContactEnd::ForceZero => "force zero: --no-tension",
            },
            figures: self.figures(&findings),
            limits: self.limit_figures(),
            findings,
        }
    }

    fn figures(&self, findings: &[Finding]) -> Vec<Figure> {
        let pair = (self.n() > 1).then(|| self.expected_pair());
        let wall = self.walls.then(|| self.expected_wall());
        let row = |name, of: fn(&ExpectedContact) -> f64| Figure {
            name,
            pair: pair.as_ref().map(of),
            wall: wall.as_ref().map(of),
            verdict: None,
        };
        let soft = |overlap: f64| grade(overlap, SOFT, f64::INFINITY);
        let travel = self.expected_travel();
        // Nothing passes a wall.
        let farthest = if self.n() > 1 { 1.0 } else { f64::INFINITY };
        let mut figures = vec![
            row("undamped frequency omega0, 1/s", |c| c.angular_frequency),
            row("damping ratio zeta", |c| c.damping_ratio),
            row("duration of a contact tau, s", |c| c.duration),
            row("restitution e, without a weight", |c| c.restitution),
        ];
        figures.extend(self.with_weight());
        figures.extend(self.stepped(pair.as_ref(), wall.as_ref(), findings));
        figures.extend([
            judged(row("time steps in a contact", |c| c.steps), &|steps| {
                if steps < FEWEST_STEPS { Verdict::Coarse } else { Verdict::Good }
            }),
            judged(row("static overlap m g/k_n, radii", |c| c.static_overlap), &soft),
            judged(row("overlap at the foot of the heap, radii", |c| c.foot_overlap), &soft),
            judged(row("largest overlap after a fall, radii", |c| c.largest_overlap), &soft),
            judged(
                Figure {
                    name: "path in a step at that speed, radii",
                    pair: pair.map(|_| travel),
                    wall: wall.map(|_| travel),
                    verdict: None,
                },
                &|travel| grade(travel, LONG_STRIDE, farthest),
            ),
        ]);
        figures
    }

    /// Restitution as the time step gives it, without a weight; `None` where nothing is to be told.
    fn stepped(
        &self,
        pair: Option<&ExpectedContact>,
        wall: Option<&ExpectedContact>,
        findings: &[Finding],
    ) -> Option<Figure> {
        let stepped = |contact: Option<&ExpectedContact>| {
            contact.and_then(|contact| self.stepped_restitution(contact))
        };
        let missed = findings.iter().find(|finding| finding.matter == Matter::Restitution);
        let [pair, wall] = [pair, wall].map(stepped);
        pair.or(wall)?;
        let verdict = Some(missed.map_or(Verdict::Good, |found| found.verdict));
        Some(Figure { name: "e as this time step gives it", pair, wall, verdict })
    }

    /// Restitution on the floor, where the weight pushes a disc in while it is in contact: what a run
    /// measures. The slower it comes, the less; this is at the speed to expect.
    fn with_weight(&self) -> Option<Figure> {
        let wall = Some(self.walls.then(|| self.bounce_with_weight())??);
        let name = "e with the weight on it, after a fall";
        Some(Figure { name, pair: None, wall, verdict: None })
    }

    fn limit_figures(&self) -> Vec<LimitFigure> {
        let dt = self.dt();
        let linear = stability::limits(&self.law(), &self.assembly());
        let mut limits: Vec<LimitFigure> = linear
            .into_iter()
            // Without walls no disc is alone at one; a single disc has no other limit.
            .filter(|limit| limit.by != LimitedBy::OneDisc || self.walls || self.n() == 1)
            .map(|limit| LimitFigure {
                by: limit.by.to_string(),
                dt_s: limit.dt,
                fraction: dt / limit.dt,
                verdict: grade(dt / limit.dt, COARSE, 1.0),
            })
            .collect();
        let travel = self.expected_travel();
        if self.n() > 1 && travel > 0.0 {
            limits.push(LimitFigure {
                by: "one radius in a step".to_owned(),
                dt_s: dt / travel,
                fraction: travel,
                verdict: grade(travel, LONG_STRIDE, 1.0),
            });
        }
        limits
    }
}

/// Good up to `coarse`, coarse up to `unstable`.
fn grade(value: f64, coarse: f64, unstable: f64) -> Verdict {
    match value {
        value if value <= coarse => Verdict::Good,
        value if value <= unstable => Verdict::Coarse,
        _ => Verdict::Unstable,
    }
}

/// A number in four digits, or a dash.
pub fn cell(value: Option<f64>) -> String {
    match value {
        None => "-".to_owned(),
        Some(value) if value.is_infinite() => "never ends".to_owned(),
        Some(value) => significant(value, 4),
    }
}

/// The figure with the worse of the verdicts that `judge` gives on its values.
fn judged(figure: Figure, judge: &dyn Fn(f64) -> Verdict) -> Figure {
    let values = [figure.pair, figure.wall].into_iter().flatten();
    Figure { verdict: values.map(judge).max(), ..figure }
}
