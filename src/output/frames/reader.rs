//! The frames of a file of any format, one after the other.

use std::io::{BufRead, Chain, Cursor, Read};

use super::format::Format;
use super::frame::Frame;
use super::lammps::data::Data;
use super::lammps::dump::Dump;
use super::layout::Layout;
use super::lines::Lines;
use super::remarks::{Remarks, Told};
use super::table::Table;
use super::xyz::Xyz;

/// So many bytes are looked at to tell the format.
const START: u64 = 4096;

/// What is said by hand of how a file is to be read; nothing, by default.
#[derive(Clone, Debug, Default)]
pub struct Reading {
    /// Which column is what, where the file does not say it, or says it wrongly.
    pub columns: Option<Layout>,
    /// The format, where it is not told by how the file begins.
    pub format: Option<Format>,
    /// The radius of all discs, m, of a file that says none.
    pub radius: Option<f64>,
}

/// The frames of a file one after the other, read as they are asked for: a file of any size
/// takes the memory of one frame. Nothing comes after an error.
///
/// ```
/// use parsim2d::output::frames::Frames;
/// let text = "# step 0 time_s 0\n0.01 0.02 1e-4\n\n\n# step 9 time_s 0.5\n0.01 0.03 1e-4\n";
/// let times: Vec<_> = Frames::of(text.as_bytes()).map(|frame| frame.unwrap().time).collect();
/// assert_eq!(times, [Some(0.0), Some(0.5)]); // s
/// ```
pub struct Frames<R> {
    lines: Lines<Chain<Cursor<Vec<u8>>, R>>,
    source: Source,
    remarks: Remarks,
    /// Why no frame can be read.
    failure: Option<String>,
    has_ended: bool,
    read: usize,
}

enum Source {
    Table(Box<Table>),
    Xyz(Xyz),
    Dump(Dump),
    Data(Data),
}

impl<R: BufRead> Frames<R> {
    /// The frames of `input`.
    pub fn of(input: R) -> Self {
        Self::read_as(input, &Reading::default())
    }

    /// The frames of `input`, read as `said`.
    pub fn read_as(mut input: R, said: &Reading) -> Self {
        let mut start = Vec::new();
        let looked =
            input.by_ref().take(START).read_to_end(&mut start).map_err(|why| why.to_string());
        let format = looked.and_then(|_| Format::of(&start));
        let (format, failure) = match (said.format, format) {
            (Some(format), _) | (None, Ok(format)) => (format, None),
            (None, Err(why)) => (Format::Table, Some(why)),
        };
        let radius = said.radius;
        let by_hand = said.columns.clone().map(|columns| columns.with_radius(radius, "--columns"));
        let (by_hand, failure) = match by_hand.transpose() {
            Ok(by_hand) => (by_hand, failure),
            Err(why) => (None, failure.or(Some(why))),
        };
        let source = match format {
            Format::Table => Source::Table(Box::new(Table::new(by_hand, radius))),
            Format::Xyz => Source::Xyz(Xyz::new(by_hand, radius)),
            Format::LammpsDump => Source::Dump(Dump { by_hand, radius }),
            Format::LammpsData => Source::Data(Data::default()),
        };
        let lines = Lines::of(Cursor::new(start.clone()).chain(input), &start);
        Self { lines, source, remarks: Remarks::default(), failure, has_ended: false, read: 0 }
    }

    /// What is to be said of the file so far: what was not certain, and what was left out.
    pub fn remarks(&self) -> &[String] {
        self.remarks.all()
    }

    /// Whether gnuplot reads the file as it has been read here so far: `x y r` in columns 1 to 3, velocities
    /// in 4 and 5.
    pub fn are_plain(&self) -> bool {
        let is_plain = match &self.source {
            Source::Table(table) => table.is_plain(),
            _ => false,
        };
        is_plain && self.lines.are_usual()
    }

    /// What is to be told of the file so far.
    pub(super) fn told(&self) -> Told {
        let names_columns = match &self.source {
            Source::Table(table) => table.names_columns(),
            Source::Xyz(xyz) => xyz.names_columns(),
            Source::Dump(_) | Source::Data(_) => true,
        };
        Told { remarks: self.remarks().to_vec(), names_columns }
    }

    /// Reads on after a frame of one disc, to see that the table is not sorted by disc: then all of its frames
    /// seem to be such. Other faults further down are none of the frame's.
    pub(crate) fn check_order_after(&mut self, frame: &Frame) -> Result<(), String> {
        if frame.rows.len() != 1 || !matches!(self.source, Source::Table(_)) {
            return Ok(());
        }
        loop {
            match self.next_frame() {
                Ok(Some(_)) => {}
                Err(why) if matches!(&self.source, Source::Table(table) if table.goes_back()) => {
                    return Err(why);
                }
                Ok(None) | Err(_) => return Ok(()),
            }
        }
    }

    /// How many frames have been read.
    pub(super) fn read(&self) -> usize {
        self.read
    }

    /// The next frame, which may be shorter than its head says.
    pub(super) fn next_frame(&mut self) -> Result<Option<Frame>, String> {
        if let Some(why) = self.failure.take() {
            return Err(why);
        }
        let (lines, remarks) = (&mut self.lines, &mut self.remarks);
        let frame = match &mut self.source {
            Source::Table(table) => table.next_frame(lines, remarks),
            Source::Xyz(xyz) => xyz.next_frame(lines, remarks),
            Source::Dump(dump) => dump.next_frame(lines, remarks),
            Source::Data(data) => data.next_frame(lines, remarks),
        }?;
        self.read += usize::from(frame.is_some());
        Ok(frame)
    }
}

impl<R: BufRead> Iterator for Frames<R> {
    type Item = Result<Frame, String>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.has_ended {
            return None;
        }
        let frame = self.next_frame().and_then(|frame| frame.map(Frame::whole).transpose());
        self.has_ended |= !matches!(frame, Ok(Some(_)));
        frame.transpose()
    }
}
