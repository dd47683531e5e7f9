//! `energy.csv`: the energy ledger, a line every so many steps.

use std::fs::File;
use std::path::PathBuf;

use super::OutputError;
use crate::analysis::energy::LedgerRow;

/// The columns, in order.
pub const HEADER: &str =
    "step,time_s,kinetic_J,gravitational_J,elastic_J,dissipated_J,total_J,work_error_J";

/// Steps between lines if none were asked for: about 2000 lines in a run of `steps` steps.
pub fn default_every(steps: u64) -> u64 {
    steps.div_ceil(2000).max(1)
}

/// The ledger file of a run. Numbers are written with as many digits as bring the same number
/// back.
pub struct EnergyFile {
    path: PathBuf,
    out: csv::Writer<File>,
}

impl EnergyFile {
    /// A ledger file that goes to `file`, named `path` in messages.
    pub fn new(file: File, path: PathBuf) -> Self {
        Self { path, out: csv::Writer::from_writer(file) }
    }

    /// Appends `row`, after the header if it is the first.
    pub fn append(&mut self, row: &LedgerRow) -> Result<(), OutputError> {
        self.out.serialize(row).map_err(|why| self.failed(why.into()))
    }

    /// Writes out what is still held back.
    pub fn flush(&mut self) -> Result<(), OutputError> {
        self.out.flush().map_err(|why| self.failed(why))
    }

    fn failed(&self, source: std::io::Error) -> OutputError {
        OutputError::Write { path: self.path.clone(), source }
    }
}
