//! `drift.csv`, `drift_energy.csv` and `twin.csv`: what the drift study measured. Numbers have as
//! many digits as bring the same number back.

use std::io::Read;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::OutputError;
use super::recorder::make_folder;
use super::replace::{NewFile, replace};

/// The columns of `drift.csv`, in order.
pub const HEADER: &str =
    "case,integrator,restitution,nt,dt_s,largest_error,final_error,dissipated_J,work_error_J";
/// The columns of `drift_energy.csv`, in order.
pub const CURVE_HEADER: &str = "case,integrator,restitution,nt,time_s,error";

/// One line of `drift.csv`: one run of the study. Errors are relative to the energy at the start.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[allow(non_snake_case)] // a column's name ends with its unit
pub struct DriftRow {
    /// wall, pair, box or dense.
    pub case: String,
    /// Time integrator.
    pub integrator: String,
    /// Restitution e of every contact.
    pub restitution: f64,
    /// Steps in a wall contact, N_t of Eq. (2).
    pub nt: f64,
    /// Time step, s.
    pub dt_s: f64,
    /// Largest |E/E0 - 1|; of one contact, while it lasts.
    pub largest_error: f64,
    /// E/E0 - 1 at the end.
    pub final_error: f64,
    /// Energy that the dashpots took, J.
    pub dissipated_J: f64,
    /// Work residue of the ledger, J.
    pub work_error_J: f64,
}

/// One line of `drift_energy.csv`: a point of a run's energy curve.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CurveRow {
    /// box or dense.
    pub case: String,
    /// Time integrator.
    pub integrator: String,
    /// Restitution e of every contact.
    pub restitution: f64,
    /// Steps in a wall contact, N_t of Eq. (2).
    pub nt: f64,
    /// Simulated time, s.
    pub time_s: f64,
    /// E/E0 - 1.
    pub error: f64,
}

/// One line of `twin.csv`: how far two runs are apart.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TwinRow {
    /// Simulated time, s.
    pub time_s: f64,
    /// Root mean square distance of a disc from its twin, m.
    pub distance_m: f64,
}

/// Makes `folder` if need be, and tries whether files of these names can be written there: to be
/// known before hours of work, not after. Leaves nothing behind.
pub fn probe(folder: &Path, names: &[&str]) -> Result<(), OutputError> {
    make_folder(folder)?;
    names.iter().try_for_each(|name| NewFile::create(&folder.join(name)).map(drop))
}

/// Writes `rows` to `path`, under a header of the field names.
pub fn write<R: Serialize>(path: &Path, rows: &[R]) -> Result<(), OutputError> {
    replace(path, |out| {
        let mut out = csv::Writer::from_writer(out);
        rows.iter().try_for_each(|row| out.serialize(row))?;
        out.flush()
    })
}

/// Reads `drift.csv`. Errors are sentences that name the line.
///
/// ```
/// use parsim2d::output::drift::{HEADER, read};
/// let file = format!("{HEADER}\nwall,symplectic-euler,1,50.5,8.9e-6,0.03,5.6e-4,0,0\n");
/// assert_eq!(read(file.as_bytes()).unwrap()[0].final_error, 5.6e-4);
/// ```
pub fn read(input: impl Read) -> Result<Vec<DriftRow>, String> {
    super::rows(input, &[HEADER])
}

/// Reads `drift_energy.csv`, likewise.
pub fn read_curves(input: impl Read) -> Result<Vec<CurveRow>, String> {
    super::rows(input, &[CURVE_HEADER])
}
