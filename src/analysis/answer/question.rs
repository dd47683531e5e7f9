//! What is asked: a run of one or two discs.

use glam::DVec2;

use crate::particle::{Particle, SpringDashpot};

/// A run of one or two discs.
#[derive(Clone, Debug)]
pub struct Question {
    /// The discs at the start.
    pub discs: Vec<Particle>,
    /// The contact law.
    pub law: SpringDashpot,
    /// Gravity, m/s2.
    pub gravity: DVec2,
    /// Side of the box, m, if there are walls.
    pub side: Option<f64>,
    /// Time step, s.
    pub dt: f64,
    /// End of the run, s.
    pub time: f64,
}
