//! The head of a frame: one line of names and values.

use crate::output::number::push_g9;
use crate::simulation::Simulation;

/// What a row of a frame holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Columns {
    /// `x y r`
    Positions,
    /// `x y r vx vy m`: all that a disc is.
    Discs,
}

impl Columns {
    fn names(self) -> &'static str {
        match self {
            Self::Positions => "x y r",
            Self::Discs => "x y r vx vy m",
        }
    }
}

/// What the head of a frame says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Head {
    /// Steps done.
    pub step: u64,
    /// Simulated time, s.
    pub time: f64,
    /// Number of discs.
    pub n: usize,
    /// Side of the box, m.
    pub side: f64,
}

impl Head {
    /// The head of a frame of the present state in a box of `side` (m).
    pub fn of(simulation: &Simulation, side: f64) -> Self {
        Self { step: simulation.steps(), time: simulation.time(), n: simulation.n(), side }
    }

    pub(super) fn push(self, text: &mut Vec<u8>, columns: Columns) {
        text.extend(format!("# step {} time_s ", self.step).as_bytes());
        push_g9(text, self.time);
        text.extend(format!(" n {} side_m ", self.n).as_bytes());
        push_g9(text, self.side);
        text.extend(format!(" columns {}\n", columns.names()).as_bytes());
    }
}
