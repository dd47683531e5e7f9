//! The runs of the drift study: which cases answer the guide's question, "does the total energy
//! stay constant?", and with which numbers.
//!
//! | case | what |
//! |---|---|
//! | wall | one disc meets a wall, without gravity; sixteen phases of the touch in a step |
//! | pair | two discs meet head-on, likewise |
//! | box | the guide's 20 discs fall in their box |
//! | dense | a crowded box: 1000 discs of 5e-4 m, packing fraction 0.49 |

use std::f64::consts::SQRT_2;

use glam::DVec2;

use super::error::ScenarioError;
use super::gravity::Gravity;
use super::quantity::Quantity;
use super::settings::{IntegratorName, Settings};
use super::{DampingChoice, DiscSource, Scenario, StepChoice};
use crate::analysis::collision::angular_frequency;
use crate::analysis::drift::{Course, DOUBLED};
use crate::analysis::twin::next_up;
use crate::named::named;
use crate::particle::Particle;
use crate::simulation::Simulation;

/// Phases of the touch inside a step: an error that hides at one phase shows at another.
const PHASES: u32 = 16;

/// Overlap of the single contacts, in radii. Their relative errors do not depend on it.
const DEPTH: f64 = 0.1;

/// Points of an energy curve.
const POINTS: u64 = 400;

/// Radius of the discs of the dense box (the guide's listing), m.
const DENSE_RADIUS: f64 = 5e-4;

/// Simulated time of the guide's box and of the dense box, s: together with the rest, some
/// seconds of wall time on two cores.
const TIMES: [f64; 2] = [0.5, 0.2];

/// Simulated time of the twins, s: enough for twenty discs to part.
const TWIN_TIME: f64 = 2.0;

named! {
    /// What is run.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Case, name {
        /// One disc meets a wall.
        Wall = "wall",
        /// Two discs meet.
        Pair = "pair",
        /// The guide's box.
        Box = "box",
        /// A crowded box.
        Dense = "dense",
    }
}

impl Case {
    /// Whether it is one contact, not a box of many.
    pub fn is_one_contact(self) -> bool {
        matches!(self, Self::Wall | Self::Pair)
    }
}

/// One run of the study; of a single contact, one for each phase.
#[derive(Clone, Debug)]
pub struct StudyRun {
    /// What is run.
    pub case: Case,
    /// Time integrator.
    pub integrator: IntegratorName,
    /// Restitution e of every contact.
    pub restitution: f64,
    /// Steps in a wall contact.
    pub nt: f64,
    /// One scenario, or one for each phase.
    scenarios: Vec<Scenario>,
}

impl StudyRun {
    /// Particle-steps of the run, for a progress bar.
    pub fn particle_steps(&self) -> u64 {
        self.scenarios.iter().map(|scenario| scenario.n() as u64 * scenario.steps()).sum()
    }

    /// Runs it; of a single contact the worst phase counts. `progress` is told particle-steps.
    pub fn course(&self, progress: &dyn Fn(u64)) -> Result<Course, ScenarioError> {
        let mut worst = None::<Course>;
        for scenario in &self.scenarios {
            let n = scenario.n() as u64;
            let simulation = scenario.build()?;
            let mut tell = |steps: u64| progress(n * steps);
            let most = if self.case.is_one_contact() { f64::INFINITY } else { DOUBLED };
            let course = Course::watch(simulation, scenario.steps(), most, POINTS, &mut tell);
            worst = Some(match worst {
                Some(worst) => worst.worse(&course),
                None => course,
            });
        }
        Ok(worst.expect("every run has a scenario"))
    }
}

/// The guide's box and the dense box, placed and checked.
#[derive(Clone, Debug)]
pub struct Study {
    /// The guide's box and the dense box.
    pub boxes: [Scenario; 2],
    /// Restitution of the damped runs.
    pub restitution: f64,
    /// N_t, ascending.
    pub nt: Vec<f64>,
}

impl Study {
    /// Checks what was `said` and these N_t of Eq. (2), and places the discs. What is not said is as in the guide, with
    /// a seed of 1, so that two students compare, and N_t of 10, 20, 50 and 100; n is that of the dense box.
    pub fn new(said: &Settings, nt: &[f64]) -> Result<Self, ScenarioError> {
        let nt = checked_nt(nt)?;
        let restitution = said.restitution.map_or(0.9, |e| e.si);
        let dense = [(20, None), (said.n.unwrap_or(1000), Some(DENSE_RADIUS))];
        let mut boxes = Vec::new();
        for ((n, radius), time) in dense.into_iter().zip(TIMES) {
            let settings = Settings {
                n: Some(n),
                seed: said.seed.or(Some(1)),
                radius: said.radius.or(radius.map(Quantity::from)),
                time: said.time.or(Some(time.into())),
                restitution: Some(restitution.into()),
                nt: Some(nt[0].into()), // the coarsest: if it is stable, all are
                ..said.clone()
            };
            let mut scenario = Scenario::resolve(&settings, || 1).map_err(too_coarse(nt[0]))?;
            // Placed once; every run starts from the same discs.
            let discs = scenario.build()?.particles().to_vec();
            scenario.discs = DiscSource::Listed(discs, Vec::new());
            boxes.push(scenario);
        }
        let boxes = boxes.try_into().expect("two boxes");
        Ok(Self { boxes, restitution, nt })
    }

    /// All runs, in the order of the table.
    pub fn runs(&self) -> Vec<StudyRun> {
        use IntegratorName::{ExplicitEuler, SymplecticEuler, VelocityVerlet};
        let mut runs = Vec::new();
        for case in [Case::Wall, Case::Pair] {
            for integrator in [SymplecticEuler, ExplicitEuler, VelocityVerlet] {
                // Twice as fine as the boxes: so cheap that the order may show.
                let finest = 2.0 * self.nt[self.nt.len() - 1];
                for nt in self.nt.iter().copied().chain([finest]) {
                    runs.push(self.contact(case, integrator, nt));
                }
            }
        }
        for case in [Case::Box, Case::Dense] {
            let mut restitutions = vec![1.0, self.restitution];
            restitutions.dedup();
            for restitution in restitutions {
                for integrator in [SymplecticEuler, ExplicitEuler, VelocityVerlet] {
                    for nt in self.box_steps(case, integrator, restitution) {
                        runs.push(self.crowd(case, integrator, restitution, nt));
                    }
                }
            }
        }
        // Two close N_t may round to the same contact.
        runs.dedup_by_key(|run| {
            (run.case, run.integrator.name(), run.nt.to_bits(), run.restitution.to_bits())
        });
        runs
    }

    /// The N_t a box is run with. Dense boxes cost seconds: velocity Verlet, whose discs move as
    /// under Eq. (3), shows there at the coarsest step, and explicit Euler at the guide's. The finest
    /// step costs as much as all others together; beyond the guide's it is run without damping only,
    /// where errors pile up.
    fn box_steps(&self, case: Case, integrator: IntegratorName, restitution: f64) -> Vec<f64> {
        match (case, integrator) {
            (Case::Dense, IntegratorName::SymplecticEuler) if restitution < 1.0 => {
                let guide = nearest(&self.nt, 50.0);
                self.nt.iter().copied().filter(|&nt| nt <= guide).collect()
            }
            (_, IntegratorName::SymplecticEuler) | (Case::Box, _) => self.nt.clone(),
            _ if restitution < 1.0 => Vec::new(),
            (_, IntegratorName::VelocityVerlet) => vec![self.nt[0]],
            (_, IntegratorName::ExplicitEuler) => vec![nearest(&self.nt, 50.0)],
        }
    }

    /// One contact without gravity, at sixteen phases. It lasts about N_t steps (a pair's as many
    /// less sqrt(2)) and a half: with a whole number it looks better than it is.
    fn contact(&self, case: Case, integrator: IntegratorName, nt: f64) -> StudyRun {
        let shorter = if case == Case::Wall { 1.0 } else { SQRT_2 };
        let nt = shorter * ((nt / shorter).floor() + 0.5);
        let scenarios = (0..PHASES).map(|phase| {
            let Scenario { radius, mass, .. } = self.boxes[0];
            let side = 100.0 * radius;
            let mut scenario = Scenario {
                side,
                gravity: Gravity::down(0.0),
                integrator,
                step: StepChoice::Nt(nt),
                damping: DampingChoice::Eta(0.0),
                walls: case == Case::Wall,
                ..self.boxes[0].clone()
            };
            let reduced_mass = if case == Case::Wall { mass } else { 0.5 * mass };
            let stiffness = self.boxes[0].linear(reduced_mass).stiffness;
            let speed = DEPTH * radius * angular_frequency(stiffness, reduced_mass);
            let gap = f64::from(phase) / f64::from(PHASES) * speed * scenario.dt();
            let disc = |x: f64, y: f64, velocity: DVec2| {
                let mut disc = Particle::at_rest(DVec2::new(x, y), radius, mass);
                disc.velocity = velocity;
                disc
            };
            let discs = if case == Case::Wall {
                vec![disc(0.5 * side, radius + gap, -speed * DVec2::Y)]
            } else {
                let (x, v) = (radius + 0.5 * gap, 0.5 * speed * DVec2::X);
                vec![disc(-x, 0.0, v), disc(x, 0.0, -v)]
            };
            scenario.discs = DiscSource::Listed(discs, Vec::new());
            // Up to one step of flight, the contact, and half of it again.
            scenario.time = (1.5 * nt + 2.0).ceil() * scenario.dt();
            scenario
        });
        StudyRun { case, integrator, restitution: 1.0, nt, scenarios: scenarios.collect() }
    }

    /// One disc in free fall from rest, with Eq. (3), over half the side of the box.
    pub fn saw_tooth(&self, nt: f64) -> Result<SawTooth, ScenarioError> {
        let Scenario { radius, mass, side, gravity, .. } = self.boxes[0];
        let gravity = gravity.size();
        let disc = Particle::at_rest(DVec2::splat(0.5 * side), radius, mass);
        let mut fall = Scenario {
            walls: false,
            discs: DiscSource::Listed(vec![disc], Vec::new()),
            step: StepChoice::Nt(nt),
            integrator: IntegratorName::SymplecticEuler,
            ..self.boxes[0].clone()
        };
        fall.time = (side / gravity).sqrt();
        let course = Course::watch(fall.build()?, fall.steps(), f64::INFINITY, 1, &mut |_| {});
        let speed = gravity * fall.steps() as f64 * fall.dt();
        Ok(SawTooth {
            speed,
            measured: course.final_error * course.energy_at_start,
            formula: -0.5 * mass * gravity * speed * fall.dt(),
        })
    }

    fn crowd(&self, case: Case, integrator: IntegratorName, restitution: f64, nt: f64) -> StudyRun {
        let scenario = Scenario {
            integrator,
            step: StepChoice::Nt(nt),
            damping: match restitution {
                1.0 => DampingChoice::Eta(0.0),
                e => DampingChoice::Restitution(e),
            },
            ..self.boxes[usize::from(case == Case::Dense)].clone()
        };
        StudyRun { case, integrator, restitution, nt, scenarios: vec![scenario] }
    }
}

/// The energy error of Eq. (3) in free fall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SawTooth {
    /// Speed reached, m/s.
    pub speed: f64,
    /// Change of the total energy, J.
    pub measured: f64,
    /// -m g v dt / 2, J.
    pub formula: f64,
}

/// The one of `values` that is nearest to `wanted` in ratio.
pub fn nearest(values: &[f64], wanted: f64) -> f64 {
    let far = |value: f64| (value / wanted).ln().abs();
    values.iter().copied().min_by(|a, b| far(*a).total_cmp(&far(*b))).unwrap_or(wanted)
}

/// A box whose run is to be compared with that of its twins: the guide's 20 discs, elastic,
/// N_t = 50, if nothing else is said.
pub fn twin_box(said: &Settings, nt: &[f64]) -> Result<Scenario, ScenarioError> {
    if nt.len() > 1 {
        let value = format!("{nt:?}");
        return Err(ScenarioError::out_of_range("nt", value, "--twin runs one", "--nt 50"));
    }
    let nt = nt.first().copied();
    let settings = Settings {
        n: said.n.or(Some(20)),
        seed: said.seed.or(Some(1)),
        time: said.time.or(Some(TWIN_TIME.into())),
        restitution: said.restitution.or(Some(1.0.into())),
        nt: nt.map(Quantity::from),
        ..said.clone()
    };
    Scenario::resolve(&settings, || 1).map_err(too_coarse(nt.unwrap_or(50.0)))
}

/// The refusal of an unstable step in the study's own words: it has fewer flags than a run.
fn too_coarse(nt: f64) -> impl Fn(ScenarioError) -> ScenarioError {
    move |error| {
        let ScenarioError::Unstable(finding) = error else { return error };
        let finer = finding.ways_out.iter().find(|way_out| way_out.starts_with("--nt "));
        let way_out = finer.map_or("a larger --nt", String::as_str);
        let allowed = format!("unstable with the damping of these runs: {}", finding.what);
        ScenarioError::out_of_range("nt", nt, allowed, format!("{way_out}, or --restitution 1"))
    }
}

/// A run and its two twins: with the x of disc 0 moved by the last bit of the number, and with
/// dt longer by its last bit.
pub fn twins(scenario: &Scenario) -> Result<(Simulation, [Simulation; 2]), ScenarioError> {
    let mut moved = scenario.build()?;
    moved.act(|discs| discs[0].position.x = next_up(discs[0].position.x));
    let longer = Scenario { step: StepChoice::Seconds(next_up(scenario.dt())), ..scenario.clone() };
    Ok((scenario.build()?, [moved, longer.build()?]))
}

fn checked_nt(said: &[f64]) -> Result<Vec<f64>, ScenarioError> {
    let mut nt = if said.is_empty() { vec![10.0, 20.0, 50.0, 100.0] } else { said.to_vec() };
    if let Some(odd) = nt.iter().find(|nt| !(4.0..=1000.0).contains(*nt)) {
        let allowed =
            "must be from 4 to 1000 steps in a contact (below, a heap of discs is unstable)";
        return Err(ScenarioError::out_of_range("nt", odd, allowed, "--nt 10,20,50,100"));
    }
    nt.sort_by(f64::total_cmp);
    nt.dedup();
    Ok(nt)
}
