//! A scenario: every choice of a run with its default, unit and check, and the building of a
//! [`Simulation`] from it. The one place that knows all the rooms of the physics.
//!
//! Values come in layers: preset, then scenario file, then flags.

mod choice;
pub mod continued;
pub mod diagnosis;
mod disc_settings;
mod discs;
mod dt_setting;
pub mod error;
mod exclusive;
pub mod expected;
mod far;
pub mod file;
pub mod finding;
pub mod framed;
pub mod gravity;
pub mod judgement;
pub mod key;
pub mod keys;
mod malformed;
pub mod memory;
pub mod names;
pub mod nearest;
pub mod notes;
mod offers;
mod output_plan;
mod overlap;
mod place;
pub mod post_mortem;
pub mod preset;
mod printed;
pub mod quantity;
mod range;
mod resolve;
pub mod settings;
pub mod start;
pub mod study;
mod suspects;
pub mod wished;

use std::path::Path;

use glam::DVec2;

pub use self::choice::{DampingChoice, DiscSource, DtSetBy, Population, StepChoice};
use self::error::ScenarioError;
pub use self::keys::{OutputChoices, Scenario};
use self::settings::IntegratorName;
use crate::analysis::collision::{ContactEnd, damping_ratio_for};
use crate::analysis::linear::{Linear, linear};
use crate::analysis::stability::{self, Assembly, Limit, Species};
use crate::discs::Discs;
use crate::engine::{Engine, WORTH_SHARING};
use crate::force::HalfPlane;
use crate::integrator::{ExplicitEuler, Integrator, SymplecticEuler, VelocityVerlet};
use crate::particle::{Damping, Particle, SpringDashpot};
use crate::simulation::{PlainDiscs, Simulation, time_step};

/// Fewer discs than this are stepped the plain way: nothing is gained by storing them by cell.
const CROWD: usize = 100;

impl Scenario {
    /// A scenario from the text of a scenario file; seed 0 if it does not say one.
    ///
    /// ```
    /// let scenario = parsim2d::scenario::Scenario::from_toml("n = 3\nradius = '0.5mm'").unwrap();
    /// let mut simulation = scenario.build().unwrap();
    /// simulation.step();
    /// assert_eq!(simulation.particles().len(), 3);
    /// assert!((simulation.time() - 8.8857658763e-6).abs() < 1e-15); // s, Eq. (2)
    /// ```
    pub fn from_toml(text: &str) -> Result<Self, ScenarioError> {
        Self::resolve(&file::parse(text, Path::new("scenario"))?, || 0)
    }

    /// Number of discs.
    pub fn n(&self) -> usize {
        match &self.discs {
            DiscSource::Equal(n) => *n,
            DiscSource::Listed(listed, groups) => {
                listed.len() + groups.iter().map(|group| group.n).sum::<usize>()
            }
            DiscSource::Frame { discs, .. } => discs.len(),
        }
    }

    /// What is to be said of how the file was read from which the discs come.
    pub fn notes_on_file(&self) -> &[String] {
        match &self.discs {
            DiscSource::Frame { notes, .. } => notes,
            _ => &[],
        }
    }

    /// Masses of the lightest and the heaviest disc, kg.
    pub fn mass_range(&self) -> (f64, f64) {
        range(self.species().iter().map(|species| species.mass))
    }

    /// Radii of the smallest and the largest disc, m.
    pub fn radius_range(&self) -> (f64, f64) {
        range(self.species().iter().map(|species| species.radius))
    }

    /// Whether the seed matters: anything is placed, or thrown, by the program.
    pub fn is_random(&self) -> bool {
        match &self.discs {
            DiscSource::Equal(_) => true,
            DiscSource::Listed(_, groups) => !groups.is_empty(),
            DiscSource::Frame { .. } => self.speed > 0.0,
        }
    }

    /// The contact law, the same for pairs and walls.
    pub fn law(&self) -> SpringDashpot {
        SpringDashpot {
            stiffness: self.stiffness,
            damping: match self.damping {
                DampingChoice::Eta(eta) => Damping::Coefficient(eta),
                DampingChoice::Gamma(gamma) => Damping::Rate(gamma),
                DampingChoice::Restitution(e) => {
                    Damping::Ratio(damping_ratio_for(e, self.contact_end()))
                }
            },
            tension: self.tension,
        }
    }

    /// The spring and dashpot that the contact law is for small changes of a contact of this reduced mass (kg): all
    /// that closed forms and the diagnosis know of it.
    pub fn linear(&self, reduced_mass: f64) -> Linear {
        linear(&self.law(), self.radius, reduced_mass)
    }

    /// When a contact ends under this scenario's law.
    pub fn contact_end(&self) -> ContactEnd {
        if self.tension { ContactEnd::OverlapZero } else { ContactEnd::ForceZero }
    }

    /// The discs by kind: those placed by the program in groups, listed ones one by one, those of a frame
    /// together as far as there are not many kinds.
    pub fn species(&self) -> Vec<Species> {
        let one = |disc: &Particle| Species { n: 1, radius: disc.radius, mass: disc.mass };
        match &self.discs {
            DiscSource::Equal(n) => {
                vec![Species { n: *n, radius: self.radius, mass: self.mass }]
            }
            DiscSource::Listed(listed, groups) => {
                let groups = groups.iter().map(|group| Species {
                    n: group.n,
                    radius: group.radius,
                    mass: group.mass,
                });
                listed.iter().map(one).chain(groups).collect()
            }
            DiscSource::Frame { discs, .. } => kinds(discs.iter().map(|disc| one(&disc))),
        }
    }

    /// The stable limit on the time step.
    pub fn limit(&self) -> Limit {
        stability::limit(&self.law(), &self.assembly())
    }

    /// What the stable limit depends on.
    pub(crate) fn assembly(&self) -> Assembly {
        Assembly::of(&self.species(), self.walled_side())
    }

    /// The time step, s. Eq. (2) takes the lightest disc's mass.
    pub fn dt(&self) -> f64 {
        match self.step {
            StepChoice::Nt(nt) => self.eq_2(nt),
            StepChoice::Seconds(dt) => dt,
            StepChoice::Auto => stability::AUTO * self.limit().dt,
        }
    }

    /// Eq. (2): the time step of this N_t, s.
    fn eq_2(&self, nt: f64) -> f64 {
        let (lightest, _) = self.mass_range();
        time_step(lightest, self.linear(lightest).stiffness, nt)
    }

    /// N_t of the time step, whoever set it.
    pub fn steps_per_contact(&self) -> f64 {
        self.eq_2(1.0) / self.dt()
    }

    /// Number of steps: `time / dt`, rounded.
    pub fn steps(&self) -> u64 {
        (self.time / self.dt()).round() as u64
    }

    /// Side of the box, m, if it has walls.
    pub fn walled_side(&self) -> Option<f64> {
        self.walls.then_some(self.side)
    }

    /// Gravity as a vector, m/s2.
    pub fn gravity_vector(&self) -> DVec2 {
        self.gravity.vector
    }

    /// Places the discs and puts the simulation together, at t = 0.
    pub fn build(&self) -> Result<Simulation, ScenarioError> {
        Ok(self.build_of(self.place()?))
    }

    /// Puts the simulation together of `discs` that [`place`](Self::place) gave, at t = 0.
    pub fn build_of(&self, discs: Vec<Particle>) -> Simulation {
        self.assemble(discs, self.is_many())
    }

    /// Whether there are so many discs that storing them by cell pays.
    fn is_many(&self) -> bool {
        self.n() >= CROWD
    }

    /// Puts the simulation of these discs together, at t = 0: as the engine, or the plain way, one thing
    /// after the other in id order. Both have the same bits.
    pub fn assemble(&self, particles: Vec<Particle>, by_engine: bool) -> Simulation {
        let (law, gravity, dt) = (self.law(), self.gravity_vector(), self.dt());
        let square = HalfPlane::square(self.side);
        let planes = if self.walls { square.to_vec() } else { Vec::new() };
        let discs: Box<dyn Discs> = if by_engine {
            Box::new(Engine::new(particles, gravity, law, planes, dt, self.threads()))
        } else {
            Box::new(PlainDiscs::new(particles, gravity, law, planes))
        };
        Simulation::of(discs, self.new_integrator(), dt)
    }

    fn new_integrator(&self) -> Box<dyn Integrator> {
        match self.integrator {
            IntegratorName::SymplecticEuler => Box::new(SymplecticEuler),
            IntegratorName::ExplicitEuler => Box::new(ExplicitEuler),
            IntegratorName::VelocityVerlet => Box::new(VelocityVerlet),
        }
    }

    /// Threads that share the steps: those said, or one for each core where that pays; one where there
    /// is nothing to share.
    pub fn threads(&self) -> usize {
        if !self.is_many() {
            return 1;
        }
        let cores = || std::thread::available_parallelism().map_or(1, usize::from);
        let usual = || if self.n() < WORTH_SHARING { 1 } else { cores() };
        self.output.threads.map_or_else(usual, |threads| threads as usize)
    }
}

/// Equal ones together; after the first kinds, one by one.
fn kinds(discs: impl Iterator<Item = Species>) -> Vec<Species> {
    const MANY: usize = 64;
    let mut kinds: Vec<Species> = Vec::new();
    for disc in discs {
        let is_like = |kind: &&mut Species| (kind.radius, kind.mass) == (disc.radius, disc.mass);
        match kinds.iter_mut().take(MANY).find(is_like) {
            Some(kind) => kind.n += 1,
            None => kinds.push(disc),
        }
    }
    kinds
}

/// The smallest and the largest of `values`.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, 0.0), |(low, high), value| (low.min(value), high.max(value)))
}
