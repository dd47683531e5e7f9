//! Frames: where the discs are at one moment, and what they are. One disc a line, `x y r` and more, for
//! gnuplot, numpy and people.
//!
//! A frame begins with one `#` line of names and values, `# step 0 time_s 0 n 20 side_m 0.04 columns x y r`.
//! In a file of many frames two blank lines stand *before* every frame but the first, which is
//! what gnuplot's `index` counts (a trailing gap would add a phantom frame).
//!
//! Files of others are read, too, each format in a file of its own: [`table`] (headings by name, CSV, Poeschel
//! and Schwager's), [`xyz`], [`lammps`]. What their columns are is said by a heading, by hand ([`layout`]),
//! or guessed ([`guess`]).

pub mod column;
mod comment;
pub mod csv;
pub mod format;
pub mod guess;
mod ids;
pub mod lammps;
pub mod layout;
mod lines;
mod reader;
mod remarks;
mod rows;
mod separator;
pub mod table;
pub mod text;
pub mod writer;
pub mod xyz;

use std::io::BufRead;

use glam::DVec2;

use self::ids::Ids;
use self::layout::Row;
pub use self::reader::{Frames, Reading};
use self::remarks::Remarks;
pub(super) use self::rows::write_rows;
pub use self::text::{Columns, Head, write_border, write_frame};
use super::number::push_g9;

/// One row of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameRow {
    /// Centre, m.
    pub position: DVec2,
    /// Radius, m.
    pub radius: f64,
    /// Velocity, m/s, if the file has columns for it.
    pub velocity: Option<DVec2>,
    /// Mass, kg, if the file has a column for it.
    pub mass: Option<f64>,
    /// The number of the disc, if the file has a column for it; else discs count from 0.
    pub id: Option<u64>,
}

/// A frame as read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frame {
    /// The discs, in the order of the file; in that of their ids in files of LAMMPS.
    pub rows: Vec<FrameRow>,
    /// Steps done, if the header says it.
    pub step: Option<u64>,
    /// Simulated time, s, if the header says it.
    pub time: Option<f64>,
    /// Side of the box, m, if the header says it.
    pub side: Option<f64>,
    /// Whether its radii are none of the file's.
    lacks_radii: bool,
    /// Number of discs that the header says.
    declared: Option<usize>,
}

impl Frame {
    /// Whether each disc has a velocity.
    pub fn has_velocities(&self) -> bool {
        !self.rows.is_empty() && self.rows.iter().all(|row| row.velocity.is_some())
    }

    /// Whether the file says the radii of the discs.
    pub fn has_radii(&self) -> bool {
        !self.lacks_radii
    }

    /// Whether each disc has a mass.
    pub fn has_masses(&self) -> bool {
        !self.rows.is_empty() && self.rows.iter().all(|row| row.mass.is_some())
    }

    /// Whether the ids are others than 0, 1, 2 ... in the order of the rows.
    pub fn has_own_ids(&self) -> bool {
        (0..).zip(&self.rows).any(|(k, row)| row.id.is_some_and(|id| id != k))
    }

    /// The frame, unless it is shorter than its header says: what a full disk leaves.
    fn whole(self) -> Result<Self, String> {
        match self.declared {
            Some(n) if self.rows.len() < n => {
                Err(format!("the frame is cut off: {} of {n} discs", self.rows.len()))
            }
            _ => Ok(self),
        }
    }
}

/// Reads one frame, number `wanted` from 0, or the last. Of tables: rows past the `n` of the
/// frame's header (a border) are left out, and any run of blank lines ends a frame.
///
/// Errors are sentences that name the line.
pub fn read_frame(input: impl BufRead, wanted: Option<usize>) -> Result<Frame, String> {
    read_frame_as(input, &Reading::default(), wanted).map(|(frame, _)| frame)
}

/// What is to be told of a file that was read.
#[derive(Clone, Debug, Default)]
pub struct Told {
    /// What was not certain, and what was left out: sentences.
    pub remarks: Vec<String>,
    /// Whether its columns are named, by the file or by hand.
    pub names_columns: bool,
}

/// The same of a file that is read as `said`; also what is to be told of it.
pub fn read_frame_as(
    input: impl BufRead,
    said: &Reading,
    wanted: Option<usize>,
) -> Result<(Frame, Told), String> {
    let mut frames = Frames::read_as(input, said);
    let mut last = None;
    while let Some(frame) = frames.next_frame()? {
        if wanted == Some(frames.read() - 1) {
            let told = frames.told();
            frames.check_order_after(&frame)?;
            return Ok((frame.whole()?, told));
        }
        last = Some(frame);
    }
    match (wanted, last) {
        (_, None) => Err("it holds no frame".to_owned()),
        (Some(k), Some(_)) => {
            Err(format!("frame {k} was asked for; it holds frames 0 to {}", frames.read() - 1))
        }
        (None, Some(frame)) => Ok((frame.whole()?, frames.told())),
    }
}

/// The frame of these rows, which may differ in z.
///
/// `last` is the line of the last of them. Fails if two have one id.
fn frame_of_rows(rows: &[Row], last: usize, remarks: &mut Remarks) -> Result<Frame, String> {
    if let Some((k, id)) = Ids::repeated(rows.iter().map(|row| row.disc.id)) {
        let line = (last + k + 1).saturating_sub(rows.len());
        return Err(format!(
            "line {line}: id {id} comes twice in one frame\n  way out: give each disc a number of its own"
        ));
    }
    if rows.windows(2).any(|two| two[0].z != two[1].z) {
        remarks.add("its discs have different z, which is left out: there are two dimensions here");
    }
    let lacks_radii = rows.iter().any(|row| !row.has_radius);
    Ok(Frame { rows: rows.iter().map(|row| row.disc).collect(), lacks_radii, ..Frame::default() })
}

/// What is to be said of a periodic box.
const IS_PERIODIC: &str = "its box is periodic: a run from it has walls (--no-walls for none)";

/// What is to be said of a box that is not square.
fn no_square(width: f64, height: f64) -> String {
    format!(
        "its box is {width} m by {height} m, not a square: its side is not taken, --side says one"
    )
}

/// What is to be said of a box that has its corner elsewhere.
fn no_corner(corner: &[f64]) -> String {
    let [x, y] = [0, 1].map(|axis| corner.get(axis).copied().unwrap_or_default());
    format!(
        "its box begins at ({x} m, {y} m), where ours begins at (0, 0): its side is not taken, and its discs stay \
         where they are"
    )
}

/// Appends numbers with blanks between them.
fn push_values(text: &mut Vec<u8>, values: &[f64]) {
    for (column, &value) in values.iter().enumerate() {
        if column > 0 {
            text.push(b' ');
        }
        push_g9(text, value);
    }
}
