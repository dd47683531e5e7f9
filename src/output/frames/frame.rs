//! A frame as read, and its rows.

use glam::DVec2;

use super::ids::Ids;
use super::remarks::Remarks;

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
    pub(super) lacks_radii: bool,
    /// Number of discs that the header says.
    pub(super) declared: Option<usize>,
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
    pub(super) fn whole(self) -> Result<Self, String> {
        match self.declared {
            Some(n) if self.rows.len() < n => {
                Err(format!("the frame is cut off: {} of {n} discs", self.rows.len()))
            }
            _ => Ok(self),
        }
    }
}

/// What a row says.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The disc.
    pub disc: FrameRow,
    /// A third coordinate, m.
    pub z: Option<f64>,
    /// The kind of the particle; 0 is one that moves freely.
    pub kind: f64,
    /// Number of the frame.
    pub frame: Option<f64>,
    /// Steps done.
    pub step: Option<f64>,
    /// Simulated time, s.
    pub time: Option<f64>,
    /// Whether its radius is said by a column.
    pub has_radius: bool,
    /// Side of the box, m.
    pub side: Option<f64>,
}

/// The frame of these rows, which may differ in z.
///
/// `last` is the line of the last of them. Fails if two have one id.
pub(super) fn frame_of_rows(
    rows: &[Row],
    last: usize,
    remarks: &mut Remarks,
) -> Result<Frame, String> {
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
