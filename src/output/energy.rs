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
    "step,time_s,kinetic_J,gravitational_J,elastic_J,dissipated_J,total_J,work_error_J,supplied_J";

/// The columns of older ledgers: nothing was supplied.
pub const OLD_HEADER: &str =
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
    /// Whether it was begun with [`OLD_HEADER`].
    is_old: bool,
}

impl EnergyFile {
    /// A ledger file that goes to `file`, named `path` in messages.
    pub fn new(file: File, path: PathBuf) -> Self {
        Self { path, out: csv::Writer::from_writer(GrowingFile::new(file)), is_old: false }
    }

    /// The same for a `file` that is cut back to `extent`, the end of one of its lines.
    pub fn continued(file: File, path: PathBuf, extent: Extent) -> Result<Self, OutputError> {
        let failed = |source| OutputError::Write { path: path.clone(), source };
        let is_old = is_old(&path).map_err(failed)?;
        let file = GrowingFile::cut(file, extent).map_err(failed)?;
        let out = csv::WriterBuilder::new().has_headers(false).from_writer(file);
        Ok(Self { path, out, is_old })
    }

    /// How far the file has come, once that is on the disk.
    pub fn sync(&mut self) -> Result<Extent, OutputError> {
        self.flush()?;
        let file = self.out.get_ref();
        file.sync().map(|()| file.extent()).map_err(|why| self.failed(why))
    }

    /// Appends `row`, after the header if it is the first.
    #[allow(non_snake_case)] // the columns' names
    pub fn append(&mut self, row: &LedgerRow) -> Result<(), OutputError> {
        let LedgerRow { step, time_s, kinetic_J, gravitational_J, elastic_J, .. } = *row;
        let LedgerRow { dissipated_J, total_J, work_error_J, .. } = *row;
        let appended = if self.is_old {
            let energies = [kinetic_J, gravitational_J, elastic_J, dissipated_J];
            self.out.serialize((step, time_s, energies, total_J, work_error_J))
        } else {
            self.out.serialize(row)
        };
        appended.map_err(|why| self.failed(why.into()))
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

/// Whether the ledger at `path` was begun before there was the last column.
fn is_old(path: &Path) -> io::Result<bool> {
    let mut header = String::new();
    BufReader::new(File::open(path)?).take(4096).read_line(&mut header)?;
    Ok(header.trim_end() == OLD_HEADER)
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
/// let text = format!("{HEADER}\n0,0,0.5,1.5,0,0,2,0,0\n");
/// assert_eq!(read(text.as_bytes()).unwrap()[0].total_J, 2.0);
/// assert!(read("x,y\n".as_bytes()).unwrap_err().starts_with("its columns are x,y"));
/// ```
pub fn read(input: impl Read) -> Result<Vec<LedgerRow>, String> {
    super::rows(input, &[HEADER, OLD_HEADER])
}
