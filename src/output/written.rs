//! How far the files of a run had come: by this they are known again, and cut back.

use std::io::{self, BufReader};
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::OutputError;
use super::growing::Extent;
use super::place::plain_file;

/// Name of the file of all frames.
pub const TRAJECTORY: &str = "trajectory.txt";
/// Name of the ledger.
pub const ENERGY: &str = "energy.csv";

/// How far the files of a run had come.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(non_snake_case)] // a key's name ends with its unit
pub struct Written {
    /// Steps between frames.
    pub frame_every: u64,
    /// Step of the last frame.
    pub frame_at: u64,
    /// Steps between lines of the ledger; 0 for none.
    pub energy_every: u64,
    /// Step of the last line.
    pub energy_at: u64,
    /// Kinetic energy when the ledger was opened, J.
    pub ledger_kinetic_J: f64,
    /// `trajectory.txt`.
    pub trajectory: Extent,
    /// `energy.csv`, if there is one.
    pub energy: Option<Extent>,
}

impl Written {
    /// Whether the files in `folder` begin with what was written then; if not, which and why.
    pub fn check(&self, folder: &Path) -> Result<(), OutputError> {
        self.extents().try_for_each(|(name, extent)| check(&folder.join(name), extent))
    }

    fn extents(&self) -> impl Iterator<Item = (&'static str, Extent)> + use<> {
        let extents = [(TRAJECTORY, Some(self.trajectory)), (ENERGY, self.energy)];
        extents.into_iter().filter_map(|(name, extent)| Some((name, extent?)))
    }
}

/// The file at `path` must begin with `extent`.
fn check(path: &Path, extent: Extent) -> Result<(), OutputError> {
    let refuse = |why: String| Err(OutputError::NotOfThatRun { path: path.to_owned(), why });
    let file = match plain_file(path) {
        Ok(file) => file,
        Err(why) if why.kind() == io::ErrorKind::NotFound => {
            return refuse("it is not there".to_owned());
        }
        Err(why) => return refuse(why.to_string()),
    };
    let bytes = extent.bytes;
    match extent.is_begin_of(BufReader::new(file)) {
        Ok(Some(true)) => Ok(()),
        Ok(Some(false)) => refuse(format!("its first {bytes} bytes are not those of that run")),
        Ok(None) => refuse(format!("it is shorter than the {bytes} bytes it had then")),
        Err(why) => refuse(why.to_string()),
    }
}
