//! The analytic answer beside a run of one or two discs: what theory says of the first contact and of
//! the heights after it, what this integrator measures, and the order at which it converges.
//!
//! The run is stepped again at dt, dt/2 and dt/4 up to the end of what is asked. The error of a
//! contact hangs on where in a step it begins, so that each is stepped from several phases and
//! the worst error counts for the order.

mod expected;
mod question;
mod seen;

use serde::Serialize;

use self::expected::Expected;
pub use self::question::Question;
use super::line::Line;
use crate::number::{signed, significant};
use crate::particle::Particle;
use crate::simulation::Simulation;

/// Phases of the touch inside a step: as many as [`USUAL_STEPS`] allow, within these bounds.
const PHASES: std::ops::RangeInclusive<f64> = 8.0..=64.0;

/// So many steps in all take about a tenth of a second.
const USUAL_STEPS: f64 = 3e6;

/// The step is divided by these.
const FINER: [f64; 3] = [1.0, 2.0, 4.0];

/// More steps than this in all, and no answer is given: some seconds.
const MOST_STEPS: f64 = 3e7;

/// A relative error below this is rounding, and has no order.
const ROUND_OFF: f64 = 1e-11;

/// One line of the answer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AnswerRow {
    /// What is compared.
    pub what: String,
    /// Its unit; empty for a plain number, r for radii.
    pub unit: &'static str,
    /// What theory says.
    pub theory: f64,
    /// What the run's integrator and step give.
    pub measured: f64,
    /// measured / theory - 1.
    pub error: f64,
    /// p of an error that goes like dt^p, from dt, dt/2 and dt/4.
    pub order: Option<f64>,
}

impl AnswerRow {
    /// The row as text: what, theory, measured, error, order.
    pub fn cells(&self) -> [String; 5] {
        let Self { what, unit, theory, measured, error, order } = self;
        let what = if unit.is_empty() { what.clone() } else { format!("{what}, {unit}") };
        let [theory, measured] = [*theory, *measured].map(|value| significant(value, 6));
        let order = order.map_or("-".to_owned(), |order| format!("{order:.1}"));
        [what, theory, measured, signed(*error, 2), order]
    }
}

/// Theory beside measurement.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Answer {
    rows: Vec<AnswerRow>,
    /// Where theory is not quite that of the run.
    pub remark: Option<String>,
}

impl Answer {
    /// Its lines; none where theory has no answer.
    pub fn rows(&self) -> &[AnswerRow] {
        &self.rows
    }

    /// Whether theory has no answer.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

impl Question {
    /// Theory beside measurement, line by line; nothing where no closed form applies: other than one
    /// or two discs, no contact in time, a contact at the start, or a third body in the way. `build`
    /// makes a simulation of these discs with this time step (s).
    pub fn answer(&self, build: &dyn Fn(Vec<Particle>, f64) -> Option<Simulation>) -> Answer {
        let Some(expected) = self.expected() else { return Answer::default() };
        let Some(rows) = self.compare(&expected, build) else { return Answer::default() };
        Answer { rows, remark: expected.turning().or_else(|| expected.weighing()) }
    }

    fn compare(
        &self,
        expected: &Expected,
        build: &dyn Fn(Vec<Particle>, f64) -> Option<Simulation>,
    ) -> Option<Vec<AnswerRow>> {
        let quantities = self.quantities(expected);
        let steps = expected.ends / self.dt * FINER.iter().sum::<f64>();
        // A contact within the first step leaves no room for another phase.
        let is_soon = expected.begins < 2.0 * self.dt;
        let phases = (USUAL_STEPS / steps).clamp(*PHASES.start(), *PHASES.end()).floor();
        let phases = if is_soon || steps * phases > MOST_STEPS { 1.0 } else { phases };
        if steps > MOST_STEPS {
            return None;
        }
        let phases = phases as u32;
        let mut first = Vec::new();
        let mut worst = vec![Vec::new(); quantities.len()];
        for finer in FINER {
            let mut errors = vec![0.0_f64; quantities.len()];
            for phase in 0..phases {
                let (dt, ahead) = self.step_and_start(expected, finer, phase, phases);
                let simulation = build(self.discs_after(ahead), dt)?;
                let measured = self.measure(expected, simulation, ahead);
                for (k, value) in measured.iter().enumerate() {
                    errors[k] = errors[k].max((value / quantities[k].2 - 1.0).abs());
                }
                if first.is_empty() {
                    first = measured;
                }
            }
            for (worst, error) in worst.iter_mut().zip(errors) {
                worst.push(((self.dt / finer).ln(), error));
            }
        }
        let row = |(((what, unit, theory), measured), worst): (_, &Vec<(f64, f64)>)| AnswerRow {
            what,
            unit,
            theory,
            measured,
            error: measured / theory - 1.0,
            order: order(worst),
        };
        let rows = quantities.into_iter().zip(first).zip(&worst).map(row);
        Some(rows.filter(|row| row.measured.is_finite()).collect())
    }

    /// Time step, s, and how much later the run starts, s. With the phase the number of steps in the
    /// contact changes by a part of one, too: whole numbers look better than they are.
    fn step_and_start(
        &self,
        expected: &Expected,
        finer: f64,
        phase: u32,
        phases: u32,
    ) -> (f64, f64) {
        let part = f64::from(phase) / f64::from(phases);
        // By the golden section, so that the two parts together fill the square evenly.
        let other_part = (0.618_034 * f64::from(phase)).fract();
        let dt = self.dt / finer;
        let steps = expected.bounce.parting.map_or(f64::INFINITY, |parting| parting.duration / dt);
        let dt = dt / (1.0 + other_part / steps);
        (dt, part * dt)
    }

    /// Name, unit and theory of all that is compared.
    fn quantities(&self, expected: &Expected) -> Vec<(String, &'static str, f64)> {
        let depth = expected.bounce.depth / self.smaller_radius();
        let mut quantities = vec![("largest overlap".to_owned(), "r", depth)];
        if let Some(parting) = expected.bounce.parting {
            let e = parting.speed / expected.touch.speed;
            quantities.push(("contact time".to_owned(), "s", parting.duration));
            quantities.push(("restitution".to_owned(), "", e));
        }
        for (k, &height) in expected.heights.iter().enumerate() {
            quantities.push((format!("height after bounce {}", k + 1), "m", height));
        }
        quantities
    }

    fn smaller_radius(&self) -> f64 {
        self.discs.iter().map(|disc| disc.radius).fold(f64::INFINITY, f64::min)
    }

    /// The discs after a free flight of `time` s.
    fn discs_after(&self, time: f64) -> Vec<Particle> {
        let mut discs = self.discs.clone();
        for disc in &mut discs {
            disc.position += time * (disc.velocity + 0.5 * time * self.gravity);
            disc.velocity += time * self.gravity;
        }
        discs
    }
}

/// The order of `(ln dt, error)`; none where an error is round-off.
fn order(errors: &[(f64, f64)]) -> Option<f64> {
    let is_clear = errors.iter().all(|&(_, error)| error > ROUND_OFF);
    let logarithms: Vec<_> = errors.iter().map(|&(dt, error)| (dt, error.ln())).collect();
    Line::through(&logarithms).filter(|_| is_clear).map(|line| line.slope)
}
