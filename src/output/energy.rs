//! `energy.csv`: the energy ledger, a line every so many steps.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

use super::OutputError;
use super::growing::{Extent, GrowingFile};
use super::place::plain_file;
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
    out: csv::Writer<GrowingFile>,
}

impl EnergyFile {
    /// A ledger file that goes to `file`, named `path` in messages.
    pub fn new(file: File, path: PathBuf) -> Self {
        Self { path, out: csv::Writer::from_writer(GrowingFile::new(file)) }
    }

    /// The same for a `file` that is cut back to `extent`, the end of one of its lines.
    pub fn continued(file: File, path: PathBuf, extent: Extent) -> Result<Self, OutputError> {
        let file = GrowingFile::cut(file, extent)
            .map_err(|source| OutputError::Write { path: path.clone(), source })?;
        let out = csv::WriterBuilder::new().has_headers(false).from_writer(file);
        Ok(Self { path, out })
    }

    /// How far the file has come, once that is on the disk.
    pub fn sync(&mut self) -> Result<Extent, OutputError> {
        self.flush()?;
        let file = self.out.get_ref();
        file.sync().map(|()| file.extent()).map_err(|why| self.failed(why))
    }

    /// Appends `row`, after the header if it is the first.
    pub fn append(&mut self, row: &LedgerRow) -> Result<(), OutputError> {
        self.out.serialize(row).map_err(|why| self.failed(why.into()))
    }

    /// Writes out what is still held back.
    pub fn flush(&mut self) -> Result<(), OutputError> {
        self.out.flush().map_err(|why| self.failed(why))
    }

    /// Takes back the lines of steps after `step`; returns the step of the last line left.
    pub fn cut_back_to(&mut self, step: u64) -> Result<u64, OutputError> {
        self.flush()?;
        let (end, last) = end_of(&self.path, step).map_err(|why| self.failed(why))?;
        let file = self.out.get_ref().handle().map_err(|why| self.failed(why))?;
        *self = Self::continued(file, self.path.clone(), end)?;
        Ok(last)
    }

    fn failed(&self, source: std::io::Error) -> OutputError {
        OutputError::Write { path: self.path.clone(), source }
    }
}

/// Where the lines up to `step` end in the file at `path`, and the step of the last of them.
fn end_of(path: &Path, step: u64) -> io::Result<(Extent, u64)> {
    let (mut bytes, mut sum, mut last) = (0, crc32fast::Hasher::new(), 0);
    for line in BufReader::new(plain_file(path)?).split(b'\n') {
        let line = line?;
        let first = line.split(|&byte| byte == b',').next().unwrap_or_default();
        if let Some(of) = std::str::from_utf8(first).ok().and_then(|step| step.parse().ok()) {
            if of > step {
                break;
            }
            last = of;
        }
        bytes += line.len() as u64 + 1;
        sum.update(&line);
        sum.update(b"\n");
    }
    Ok((Extent { bytes, crc32: sum.finalize() }, last))
}

/// Reads a ledger back.
///
/// Errors are sentences that name the line.
///
/// ```
/// use parsim2d::output::energy::{HEADER, read};
/// let text = format!("{HEADER}\n0,0,0.5,1.5,0,0,2,0\n");
/// assert_eq!(read(text.as_bytes()).unwrap()[0].total_J, 2.0);
/// assert!(read("x,y\n".as_bytes()).unwrap_err().starts_with("its columns are x,y"));
/// ```
pub fn read(input: impl Read) -> Result<Vec<LedgerRow>, String> {
    super::rows(input, HEADER)
}
