//! Frames: one disc a line, `x y r` or `x y r vx vy`, for gnuplot, numpy and people.
//!
//! A frame begins with one `#` line of names and values, `# step 0 time_s 0 n 20 side_m 0.04 ...`.
//! In a file of many frames two blank lines stand *before* every frame but the first, which is
//! what gnuplot's `index` counts (a trailing gap would add a phantom frame).

use std::io::{self, BufRead, Write};

use glam::DVec2;

use super::number::push_g9;
use crate::simulation::Simulation;

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

/// Writes the present state as one frame of a box of `side` (m), rows in id order.
pub fn write_frame(
    out: &mut impl Write,
    simulation: &Simulation,
    side: f64,
    columns: Columns,
) -> io::Result<()> {
    let mut text = Vec::new();
    text.extend(format!("# step {} time_s ", simulation.steps()).as_bytes());
    push_g9(&mut text, simulation.time());
    text.extend(format!(" n {} side_m ", simulation.particles().len()).as_bytes());
    push_g9(&mut text, side);
    writeln!(text, " columns {}", columns.names())?;
    out.write_all(&text)?;
    for disc in simulation.particles() {
        text.clear();
        push_row(&mut text, &[disc.position.x, disc.position.y, disc.radius]);
        if columns == Columns::PositionsAndVelocities {
            text.push(b' ');
            push_row(&mut text, &[disc.velocity.x, disc.velocity.y]);
        }
        text.push(b'\n');
        out.write_all(&text)?;
    }
    Ok(())
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
                "n" => self.declared = pair[1].parse().ok(),
                "side_m" => self.side = pair[1].parse().ok(),
                _ => {}
            }
        }
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
pub fn read_frame(mut input: impl BufRead, wanted: Option<usize>) -> Result<Frame, String> {
    let mut frame = Frame::default();
    let (mut finished, mut in_gap, mut number) = (0, false, 0);
    let mut text = Vec::new();
    loop {
        text.clear();
        number += 1;
        let at = |why: String| format!("line {number}: {why}");
        if input.read_until(b'\n', &mut text).map_err(|why| at(why.to_string()))? == 0 {
            break;
        }
        let is_cut = frame.declared.is_some() && text.last() != Some(&b'\n');
        let line = std::str::from_utf8(&text).map_err(|_| at("this is not text".to_owned()))?;
        let line = line.trim_start_matches('\u{feff}').trim(); // some editors begin with a mark
        if line.is_empty() {
            in_gap = true;
            continue;
        }
        if std::mem::take(&mut in_gap) && !frame.rows.is_empty() {
            if wanted == Some(finished) {
                return frame.whole();
            }
            finished += 1;
            frame = Frame::default();
        }
        match line.strip_prefix('#') {
            Some(header) => frame.read_header(header),
            None if is_cut => return Err(at("the line is cut off".to_owned())),
            None => frame.read_row(line).map_err(at)?,
        }
    }
    match wanted {
        _ if frame.rows.is_empty() && finished > 0 => {
            Err(format!("its last frame is cut off; frames 0 to {} are whole", finished - 1))
        }
        _ if frame.rows.is_empty() => Err("it holds no frame".to_owned()),
        Some(k) if k > finished => {
            Err(format!("frame {k} was asked for; it holds frames 0 to {finished}"))
        }
        _ => frame.whole(),
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
