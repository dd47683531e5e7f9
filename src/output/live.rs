//! `out.txt`: the present frame, `x y r`, replaced whole at every refresh.

use std::io::{self, Write};
use std::path::PathBuf;

use super::OutputError;
use super::frames::{Columns, write_border, write_frame};
use super::replace::replace;
use crate::simulation::Simulation;

/// The live frame of a run.
pub struct LiveFrame {
    /// The file.
    pub path: PathBuf,
    /// Side of the box, m.
    pub side: f64,
    /// Radius of the guide's fictitious border discs, m, if they are wanted.
    pub border: Option<f64>,
}

impl LiveFrame {
    /// Replaces the file by the present state, and the border after it.
    pub fn refresh(&self, simulation: &Simulation) -> Result<(), OutputError> {
        replace(&self.path, |out| self.write(out, simulation))
    }

    /// Writes what the file holds to `out`.
    pub fn write(&self, out: &mut impl Write, simulation: &Simulation) -> io::Result<()> {
        write_frame(out, simulation, self.side, Columns::Positions)?;
        match self.border {
            Some(radius) => write_border(out, self.side, radius),
            None => Ok(()),
        }
    }
}
