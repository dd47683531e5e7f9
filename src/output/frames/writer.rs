//! Frames written in a format of choice.

use std::io::{self, Write};
use std::path::Path;

use clap::ValueEnum;

use super::column::Column;
use super::frame::Frame;
use super::lammps::dump;
use super::{csv, text, xyz};

/// A format that can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Target {
    /// Frames, as runs write them
    Frames,
    /// One table
    Csv,
    /// Extended XYZ
    Xyz,
    /// LAMMPS dump
    LammpsDump,
}

impl Target {
    /// The format that the ending of a file's name means.
    ///
    /// ```
    /// use parsim2d::output::frames::writer::Target;
    /// assert_eq!(Target::of("run/frames.extxyz".as_ref()), Some(Target::Xyz));
    /// assert_eq!(Target::of("frames".as_ref()), None);
    /// ```
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_lowercase().as_str() {
            "txt" | "dat" => Some(Self::Frames),
            "csv" => Some(Self::Csv),
            "xyz" | "extxyz" => Some(Self::Xyz),
            "dump" | "lammpstrj" => Some(Self::LammpsDump),
            _ => None,
        }
    }
}

/// Writes frames one after the other.
pub struct Writer {
    target: Target,
    /// How many have been written.
    pub frames: usize,
    /// Columns of a table: those of its first frame.
    columns: Vec<Column>,
}

impl Writer {
    /// A writer of frames in this format.
    pub fn new(target: Target) -> Self {
        Self { target, frames: 0, columns: Vec::new() }
    }

    /// Whether `frame` can follow those before it; if not, why.
    pub fn fits(&self, frame: &Frame) -> Result<(), String> {
        if self.target != Target::Csv || self.frames == 0 || csv::columns(frame) == self.columns {
            return Ok(());
        }
        Err(format!(
            "frame {} says other things than frame 0, and a table has the same columns throughout",
            self.frames
        ))
    }

    /// Appends a frame.
    pub fn add(&mut self, out: &mut impl Write, frame: &Frame) -> io::Result<()> {
        let index = self.frames;
        self.frames += 1;
        match self.target {
            Target::Frames => text::write(out, index, frame),
            Target::Xyz => xyz::write(out, frame),
            Target::LammpsDump => dump::write(out, index, frame),
            Target::Csv => {
                if index == 0 {
                    self.columns = csv::columns(frame);
                    csv::write_names(out, &self.columns)?;
                }
                csv::write(out, index, frame, &self.columns)
            }
        }
    }

    /// What such a file has to say and `frame` does not, and what became of it: sentences.
    pub fn missing(&self, frame: &Frame) -> Vec<String> {
        let is_dump = self.target == Target::LammpsDump;
        let left_out = |what: &str| format!("holds no {what}: left out");
        let mut missing = Vec::new();
        for (what, is_there) in
            [("velocities", frame.has_velocities()), ("masses", frame.has_masses())]
        {
            missing.extend((!is_there).then(|| left_out(what)));
        }
        missing.extend(frame.time.is_none().then(|| left_out("times")));
        missing.extend(
            (is_dump && frame.step.is_none())
                .then(|| "holds no numbers of steps: TIMESTEP counts its frames".to_owned()),
        );
        missing.extend(frame.side.is_none().then(|| match is_dump {
            true => "holds no side of a box: BOX BOUNDS are those of its discs".to_owned(),
            false => left_out("side of a box"),
        }));
        missing
    }
}
