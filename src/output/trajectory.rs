//! `trajectory.txt`: many frames, `x y r vx vy m`, two blank lines between them.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::PathBuf;

use super::OutputError;
use super::frames::{Columns, write_frame};
use super::growing::{Extent, GrowingFile};
use super::marks::Marks;
use crate::simulation::Simulation;

/// More bytes than this, and the default interval between frames grows.
const MOST_BYTES: u64 = 500_000_000;
/// At most: a row has five numbers of nine digits and their signs, dots and exponents, and a mass; most
/// rows are some 55 bytes.
const BYTES_PER_ROW: u64 = 80;

/// Steps between frames if none were asked for: about 200 frames in a run of `n` discs and
/// `steps` steps, fewer if the file would pass 500 MB.
///
/// ```
/// use parsim2d::output::trajectory::default_every;
/// assert_eq!(default_every(20, 112_540), 563);
/// assert_eq!(default_every(1_000_000, 1000), 167); // seven frames of a million rows
/// ```
pub fn default_every(n: usize, steps: u64) -> u64 {
    let most_frames = (MOST_BYTES / (BYTES_PER_ROW * n.max(1) as u64)).clamp(1, 200);
    steps.div_ceil(most_frames).max(1)
}

/// The frames of a run, appended one by one.
pub struct Trajectory {
    path: PathBuf,
    out: BufWriter<GrowingFile>,
    side: f64, // m
    frames: u64,
    marks: Marks,
}

impl Trajectory {
    /// A trajectory that goes to `file`, named `path` in messages; box of `side` (m).
    pub fn new(file: File, path: PathBuf, side: f64) -> Self {
        let out = BufWriter::with_capacity(1 << 16, GrowingFile::new(file));
        Self { path, out, side, frames: 0, marks: Marks::default() }
    }

    /// The same for a `file` that is cut back to `extent`, where the frame of step `last` ends.
    pub fn continued(
        file: File,
        path: PathBuf,
        side: f64,
        extent: Extent,
        last: u64,
    ) -> Result<Self, OutputError> {
        let file = GrowingFile::cut(file, extent)
            .map_err(|source| OutputError::Write { path: path.clone(), source })?;
        let out = BufWriter::with_capacity(1 << 16, file);
        let mut marks = Marks::default();
        marks.add(last, extent);
        Ok(Self { path, out, side, frames: 1, marks })
    }

    /// Appends the present state.
    pub fn append(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let gap = if self.frames > 0 { "\n\n" } else { "" };
        self.frames += 1;
        let columns = Columns::Discs;
        self.out
            .write_all(gap.as_bytes())
            .and_then(|()| write_frame(&mut self.out, simulation, self.side, columns))
            .and_then(|()| self.out.flush())
            .map(|()| self.marks.add(simulation.steps(), self.out.get_ref().extent()))
            .map_err(|source| OutputError::Write { path: self.path.clone(), source })
    }

    /// How far the file has come, once that is on the disk.
    pub fn sync(&self) -> Result<Extent, OutputError> {
        let file = self.out.get_ref(); // every frame is flushed as it is written
        file.sync()
            .map(|()| file.extent())
            .map_err(|source| OutputError::Write { path: self.path.clone(), source })
    }

    /// Takes back the frames of steps after `step`; returns the step of the last frame left.
    pub fn cut_back_to(&mut self, step: u64) -> Result<u64, OutputError> {
        self.marks
            .cut_back_to(step, self.out.get_mut())
            .map_err(|source| OutputError::Write { path: self.path.clone(), source })
    }
}
