//! `out.txt`: the present frame, `x y r`, replaced whole at every refresh.

use std::io::{self, Write};
use std::path::PathBuf;

use super::OutputError;
use super::frames::{Columns, Head, write_border, write_frame, write_rows};
use super::replace::replace;
use crate::simulation::Simulation;

/// Where the discs are at one moment: all that a live frame shows, at 24 bytes a disc.
pub struct Still {
    head: Head,
    discs: Vec<[f64; 3]>, // x, y, r in m
}

impl Still {
    /// No moment yet.
    pub fn empty() -> Self {
        Self { head: Head { step: 0, time: 0.0, n: 0, side: 0.0 }, discs: Vec::new() }
    }

    /// Takes the present state instead of what was there.
    pub fn take(&mut self, simulation: &Simulation) {
        self.head = Head::of(simulation, 0.0); // the box is the live frame's
        self.discs.clear();
        let discs = simulation.each_particle();
        self.discs.extend(discs.map(|p| [p.position.x, p.position.y, p.radius]));
    }
}

/// The live frame of a run.
#[derive(Clone, Debug, PartialEq)]
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

    /// Replaces the file by the state at the moment of `still`, and the border after it.
    pub fn refresh_from(&self, still: &Still) -> Result<(), OutputError> {
        replace(&self.path, |out| {
            let head = Head { side: self.side, ..still.head };
            write_rows(out, head, Columns::Positions, still.discs.iter().copied())?;
            self.write_border(out)
        })
    }

    /// Writes what the file holds to `out`.
    pub fn write(&self, out: &mut impl Write, simulation: &Simulation) -> io::Result<()> {
        write_frame(out, simulation, self.side, Columns::Positions)?;
        self.write_border(out)
    }

    fn write_border(&self, out: &mut impl Write) -> io::Result<()> {
        match self.border {
            Some(radius) => write_border(out, self.side, radius),
            None => Ok(()),
        }
    }
}
