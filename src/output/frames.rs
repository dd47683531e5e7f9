//! Frames: one disc a line, `x y r` or `x y r vx vy`, for gnuplot, numpy and people.
//!
//! A frame begins with one `#` line of names and values, `# step 0 time_s 0 n 20 side_m 0.04 ...`.
//! In a file of many frames two blank lines stand *before* every frame but the first, which is
//! what gnuplot's `index` counts (a trailing gap would add a phantom frame).

mod rows;

use std::io::{self, BufRead, Read, Write};

use glam::DVec2;

pub(super) use self::rows::write_rows;
use super::number::push_g9;
use crate::simulation::Simulation;

/// No line of a frame is so long, bytes; a file without lines is not read into memory.
const LONGEST_LINE: u64 = 1 << 16;

/// What a row of a frame holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Columns {
    /// `x y r`
    Positions,
    /// `x y r vx vy`
    PositionsAndVelocities,
}

impl Columns {
    fn names(self) -> &'static str {
        match self {
            Self::Positions => "x y r",
            Self::PositionsAndVelocities => "x y r vx vy",
        }
    }
}

/// What the head of a frame says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Head {
    /// Steps done.
    pub step: u64,
    /// Simulated time, s.
    pub time: f64,
    /// Number of discs.
    pub n: usize,
    /// Side of the box, m.
    pub side: f64,
}

impl Head {
    /// The head of a frame of the present state in a box of `side` (m).
    pub fn of(simulation: &Simulation, side: f64) -> Self {
        Self { step: simulation.steps(), time: simulation.time(), n: simulation.n(), side }
    }

    fn push(self, text: &mut Vec<u8>, columns: Columns) {
        text.extend(format!("# step {} time_s ", self.step).as_bytes());
        push_g9(text, self.time);
        text.extend(format!(" n {} side_m ", self.n).as_bytes());
        push_g9(text, self.side);
        text.extend(format!(" columns {}\n", columns.names()).as_bytes());
    }
}

/// Writes the present state as one frame of a box of `side` (m), rows in id order.
pub fn write_frame(
    out: &mut impl Write,
    simulation: &Simulation,
    side: f64,
    columns: Columns,
) -> io::Result<()> {
    let head = Head::of(simulation, side);
    let discs = simulation.each_particle();
    match columns {
        Columns::Positions => {
            write_rows(out, head, columns, discs.map(|p| [p.position.x, p.position.y, p.radius]))
        }
        Columns::PositionsAndVelocities => {
            let rows =
                discs.map(|p| [p.position.x, p.position.y, p.radius, p.velocity.x, p.velocity.y]);
            write_rows(out, head, columns, rows)
        }
    }
}

/// Writes the guide's border: fictitious discs of about `radius` (m) that touch the box of `side`
/// (m) from outside. They have no part in the physics.
pub fn write_border(out: &mut impl Write, side: f64, radius: f64) -> io::Result<()> {
    // At most 200 a side; a whole number, so that corners meet.
    let per_side = (side / (2.0 * radius)).round().clamp(1.0, 200.0) as usize;
    let radius = 0.5 * side / per_side as f64;
    let mut text = Vec::new();
    for k in 0..per_side {
        let along = (2 * k + 1) as f64 * radius;
        for (x, y) in
            [(along, -radius), (along, side + radius), (-radius, along), (side + radius, along)]
        {
            push_row(&mut text, &[x, y, radius]);
            text.push(b'\n');
        }
    }
    out.write_all(&text)
}

fn push_row(text: &mut Vec<u8>, values: &[f64]) {
    for (column, &value) in values.iter().enumerate() {
        if column > 0 {
            text.push(b' ');
        }
        push_g9(text, value);
    }
}

/// One row of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameRow {
    /// Centre, m.
    pub position: DVec2,
    /// Radius, m.
    pub radius: f64,
    /// Velocity, m/s, if the file has columns for it.
    pub velocity: Option<DVec2>,
}

/// A frame as read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frame {
    /// The discs, in the order of the file.
    pub rows: Vec<FrameRow>,
    /// Steps done, if the header says it.
    pub step: Option<u64>,
    /// Simulated time, s, if the header says it.
    pub time: Option<f64>,
    /// Side of the box, m, if the header says it.
    pub side: Option<f64>,
    /// Number of discs that the header says.
    declared: Option<usize>,
}

impl Frame {
    /// The frame, unless it is shorter than its header says: what a full disk leaves.
    fn whole(self) -> Result<Self, String> {
        match self.declared {
            Some(n) if self.rows.len() < n => {
                Err(format!("the frame is cut off: {} of {n} discs", self.rows.len()))
            }
            _ => Ok(self),
        }
    }

    fn read_header(&mut self, header: &str) {
        let words: Vec<&str> = header.split_whitespace().collect();
        if words.first() != Some(&"step") {
            return; // a remark of somebody else's
        }
        for pair in words.windows(2) {
            match pair[0] {
                "step" => self.step = pair[1].parse().ok(),
                "time_s" => self.time = pair[1].parse().ok(),
                "n" => self.declared = pair[1].parse().ok(),
                "side_m" => self.side = pair[1].parse().ok(),
                _ => {}
            }
        }
    }

    fn take_line(&mut self, line: &str, is_cut: bool) -> Result<(), String> {
        match line.strip_prefix('#') {
            Some(header) => self.read_header(header),
            None if is_cut && self.declared.is_some() => {
                return Err("the line is cut off".to_owned());
            }
            None => self.read_row(line)?,
        }
        Ok(())
    }

    fn read_row(&mut self, line: &str) -> Result<(), String> {
        if self.declared.is_some_and(|n| self.rows.len() >= n) {
            return Ok(()); // a border
        }
        let row = parse_row(line)?;
        if self.rows.last().is_some_and(|last| last.velocity.is_some() != row.velocity.is_some()) {
            return Err("fewer or more columns than the line before".to_owned());
        }
        self.rows.push(row);
        Ok(())
    }
}

/// Reads one frame, number `wanted` from 0, or the last. Lines that begin with `#` and columns
/// past the fifth are passed over; any run of blank lines ends a frame; rows past the `n` of the
/// frame's header (a border) are left out.
///
/// Errors are sentences that name the line.
pub fn read_frame(input: impl BufRead, wanted: Option<usize>) -> Result<Frame, String> {
    let mut frames = Frames::of(input);
    let mut last = None;
    while let Some(frame) = frames.next_frame()? {
        if wanted == Some(frames.finished - 1) {
            return frame.whole();
        }
        last = Some(frame);
    }
    match (wanted, last) {
        (_, None) => Err("it holds no frame".to_owned()),
        (Some(k), Some(_)) => {
            Err(format!("frame {k} was asked for; it holds frames 0 to {}", frames.finished - 1))
        }
        (None, Some(frame)) => frame.whole(),
    }
}

/// The frames of a file one after the other, read as they are asked for: a file of any size
/// takes the memory of one frame. The same rules as [`read_frame`]; nothing comes after an
/// error.
///
/// ```
/// use parsim2d::output::frames::Frames;
/// let text = "# step 0 time_s 0\n0.01 0.02 1e-4\n\n\n# step 9 time_s 0.5\n0.01 0.03 1e-4\n";
/// let times: Vec<_> = Frames::of(text.as_bytes()).map(|frame| frame.unwrap().time).collect();
/// assert_eq!(times, [Some(0.0), Some(0.5)]); // s
/// ```
pub struct Frames<R> {
    input: R,
    line: Vec<u8>,
    number: usize, // of the line, from 1
    begun: Frame,
    finished: usize,
    failure: Option<String>,
    has_ended: bool,
}

impl<R: BufRead> Frames<R> {
    /// The frames of `input`.
    pub fn of(input: R) -> Self {
        Self {
            input,
            line: Vec::new(),
            number: 0,
            begun: Frame::default(),
            finished: 0,
            failure: None,
            has_ended: false,
        }
    }

    /// The next frame, which may be shorter than its header says.
    fn next_frame(&mut self) -> Result<Option<Frame>, String> {
        if let Some(why) = self.failure.take() {
            return Err(why);
        }
        let mut in_gap = false;
        loop {
            self.line.clear();
            self.number += 1;
            let number = self.number;
            let at = |why: String| format!("line {number}: {why}");
            let mut some = self.input.by_ref().take(LONGEST_LINE);
            let read = some.read_until(b'\n', &mut self.line);
            if read.map_err(|why| at(why.to_string()))? == 0 {
                return self.last_frame();
            }
            if self.line.len() as u64 == LONGEST_LINE {
                return Err(at(format!(
                    "a line of {LONGEST_LINE} bytes: this is no file of frames"
                )));
            }
            let is_cut = self.line.last() != Some(&b'\n');
            let line = std::str::from_utf8(&self.line);
            let line = line.map_err(|_| at("this is not text".to_owned()))?;
            let line = line.trim_start_matches('\u{feff}').trim(); // some editors begin with a mark
            if line.is_empty() {
                in_gap = true;
                continue;
            }
            let gap_ends = std::mem::take(&mut in_gap) && !self.begun.rows.is_empty();
            let finished = gap_ends.then(|| std::mem::take(&mut self.begun));
            let frame = &mut self.begun;
            let taken = frame.take_line(line, is_cut).map_err(at);
            if finished.is_some() {
                self.finished += 1;
                self.failure = taken.err(); // of the frame after this one
                return Ok(finished);
            }
            taken?;
        }
    }

    /// What stands at the end of the file.
    fn last_frame(&mut self) -> Result<Option<Frame>, String> {
        if std::mem::replace(&mut self.has_ended, true) {
            return Ok(None);
        }
        let frame = std::mem::take(&mut self.begun);
        if !frame.rows.is_empty() {
            self.finished += 1;
            return Ok(Some(frame));
        }
        match self.finished {
            0 => Ok(None),
            // A header without rows is what a full disk leaves.
            n => Err(format!("its last frame is cut off; frames 0 to {} are whole", n - 1)),
        }
    }
}

impl<R: BufRead> Iterator for Frames<R> {
    type Item = Result<Frame, String>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.has_ended {
            return None;
        }
        let frame = self.next_frame().and_then(|frame| frame.map(Frame::whole).transpose());
        self.has_ended |= frame.is_err();
        frame.transpose()
    }
}

fn parse_row(line: &str) -> Result<FrameRow, String> {
    let mut values = [0.0_f64; 5];
    let mut columns = 0;
    for (value, word) in values.iter_mut().zip(line.split_whitespace()) {
        *value = word.parse().map_err(|_| format!("`{word}` is not a number"))?;
        if !value.is_finite() {
            return Err(format!("`{word}` is not finite"));
        }
        columns += 1;
    }
    let [x, y, radius, vx, vy] = values;
    let velocity = match columns {
        3 | 4 => None,
        5 => Some(DVec2::new(vx, vy)),
        _ => return Err(format!("{columns} columns; a disc is `x y r` or `x y r vx vy`")),
    };
    Ok(FrameRow { position: DVec2::new(x, y), radius, velocity })
}
