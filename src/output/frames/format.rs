//! The formats of files with discs, told by how they begin.

use clap::ValueEnum;

/// A format that can be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Rows of numbers: frames, CSV, tables with headings
    #[value(name = "frames", alias = "csv")]
    Table,
    /// XYZ and extended XYZ
    Xyz,
    /// LAMMPS dump
    LammpsDump,
    /// LAMMPS data file
    LammpsData,
}

/// What begins so is none of ours, and what to do about it.
const OTHERS: [(&[u8], &str); 6] = [
    (b"\x1f\x8b", "it is compressed by gzip: unpack it first, gunzip FILE"),
    (b"\x28\xb5\x2f\xfd", "it is compressed by zstd: unpack it first, unzstd FILE"),
    (b"PK\x03\x04", "it is a zip archive or a spreadsheet: save it as CSV"),
    (b"\x89HDF", "it is an HDF5 file: save its positions, radii, velocities and masses as CSV"),
    (
        b"# vtk DataFile",
        "it is a VTK file: save its points and radii as CSV (ParaView: File, Save Data)",
    ),
    (
        b"<?xml",
        "it is an XML file: if ParaView wrote it, save its points and radii as CSV (File, Save Data)",
    ),
];

impl Format {
    /// The format of a file that begins with `start`. Fails if it is a known one that is not read here.
    ///
    /// ```
    /// use parsim2d::output::frames::format::Format;
    /// assert_eq!(Format::of(b"ITEM: TIMESTEP\n0\n"), Ok(Format::LammpsDump));
    /// assert_eq!(Format::of(b"2\nProperties=pos:R:2\n"), Ok(Format::Xyz));
    /// assert_eq!(Format::of(b"0.01 0.02 1e-4\n"), Ok(Format::Table));
    /// assert!(Format::of(b"\x1f\x8b\x08").is_err());
    /// ```
    pub fn of(start: &[u8]) -> Result<Self, String> {
        if let Some((_, why)) = OTHERS.iter().find(|(magic, _)| start.starts_with(magic)) {
            return Err((*why).to_owned());
        }
        if matches!(start, [0xff, 0xfe, _, 0, ..] | [0xfe, 0xff, 0, ..]) {
            return Err("it is text in UTF-16: save it as UTF-8".to_owned());
        }
        let text = String::from_utf8_lossy(start);
        let mut lines = text.trim_start_matches('\u{feff}').split(['\n', '\r']).map(str::trim);
        let mut filled = lines.by_ref().filter(|line| !line.is_empty());
        let first = filled.next().unwrap_or_default();
        let is_count =
            |word: &str| !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_digit());
        let second = filled.next();
        let counts_atoms = |line: &str| {
            matches!(line.split_once(char::is_whitespace),
            Some((n, "atoms")) if is_count(n))
        };
        Ok(match first {
            _ if first.starts_with("ITEM:") => Self::LammpsDump,
            _ if is_count(first) && second.is_some() => Self::Xyz,
            _ if second.into_iter().chain(filled.take(8)).any(counts_atoms) => Self::LammpsData,
            _ => Self::Table,
        })
    }
}
