#![deny(missing_docs)]
//! parsim2d: a teaching-oriented 2D particle simulator.
pub mod analysis;
pub mod cli;
pub mod force;
pub mod integrator;
pub mod neighbours;
pub mod output;
pub mod particle;
pub mod placement;
pub mod scenario;
pub mod simulation;
pub mod work;
