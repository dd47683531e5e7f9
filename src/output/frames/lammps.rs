//! The text files of LAMMPS: dumps, which OVITO and VMD read, and data files.
//!
//! Their columns are documented at <https://docs.lammps.org/dump.html> and
//! <https://docs.lammps.org/read_data.html>.

pub mod data;
pub mod dump;

use super::frame::Frame;
use super::remarks::{Remarks, no_corner, no_square};

/// A box from `[low, high]` along x and along y, m: its side if it is square and has a corner at 0 as ours.
fn side(bounds: [Option<[f64; 2]>; 2], remarks: &mut Remarks) -> Option<f64> {
    let [x, y] = [bounds[0]?, bounds[1]?];
    if x[0] != 0.0 || y[0] != 0.0 {
        remarks.add(no_corner(&[x[0], y[0]]));
        return None;
    }
    if x[1] != y[1] {
        remarks.add(no_square(x[1], y[1]));
        return None;
    }
    Some(x[1])
}

/// Puts the rows in order of their ids: LAMMPS writes them as they lie in its memory.
fn sort(frame: &mut Frame) {
    frame.rows.sort_by_key(|row| row.id);
}
