//! parsim2d: a teaching-oriented 2D particle simulator, as a library and as one program.
//!
//! n discs in a square box fall, collide by springs and dashpots, and every joule is accounted
//! for. The program grew from a course guideline (D'Ambrosio, University of Calabria, 2019),
//! "the guide" below, whose three equations are the heart of it:
//!
//! | equation | where |
//! |---|---|
//! | Eq. (1) `f_c = -k_n delta_n - eta_n v_rn` | [`particle::SpringDashpot`] |
//! | Eq. (2) `dt = pi sqrt(m / k_n) / N_t` | [`simulation::time_step`] |
//! | Eq. (3) `v' = v + a dt; x' = x + v' dt` | [`particle::Particle::kick`], [`particle::Particle::drift`], [`integrator::SymplecticEuler`] |
//!
//! Reading order, an hour in all: [`particle`] (a disc, a contact, Eq. (1)), [`simulation`] (Eq. (2), the step, and
//! m a = m g + sum f_c in [`simulation::PlainDiscs`]), [`integrator`] (Eq. (3) in sequence), [`force`] (forces of your own, where
//! walls stand). Then what they rest on ([`placement`], [`neighbours`], [`work`], [`discs`]), the fast way ([`engine`]), what is read off a run
//! ([`analysis`]), what is written ([`output`]) and drawn ([`figure`]), how a run is described ([`scenario`]) and led to its end ([`session`]),
//! the report of a run ([`page`]), how students' programs are built, run, judged and told of it
//! ([`grading`]), and the command line ([`cli`]). Arrows between them go
//! one way; `tests/arrows.rs` guards them.
//!
//! SI units and f64 throughout.
//!
//! ```
//! use parsim2d::analysis::energy::MechanicalEnergy;
//! use parsim2d::scenario::Scenario;
//!
//! let scenario = Scenario::from_toml("n = 20\nseed = 1\nrestitution = 1").unwrap();
//! let mut simulation = scenario.build().unwrap();
//! let start = MechanicalEnergy::of(&simulation).total();
//! for _ in 0..10_000 {
//!     simulation.step();
//! }
//! let end = MechanicalEnergy::of(&simulation).total();
//! assert!((end / start - 1.0).abs() < 0.01); // elastic discs keep their energy
//! ```
#![deny(missing_docs, unsafe_code)]

pub mod analysis;
pub mod boundary;
pub mod cli;
pub mod discs;
pub mod echo;
pub mod engine;
pub mod field;
pub mod figure;
pub mod force;
pub mod grading;
pub mod integrator;
mod named;
pub mod neighbours;
pub mod number;
pub mod output;
pub mod page;
pub mod pair;
pub mod particle;
pub mod placement;
pub mod scenario;
pub mod session;
pub mod simulation;
mod table;
pub mod wall;
pub mod work;
