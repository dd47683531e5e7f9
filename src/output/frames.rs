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
        for (x, y) in [
            (along, -radius),
            (along, side + radius),
            (-radius, along),
            (side + radius, along),
        ] {
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

/// Reads one frame, number `wanted` from 0, or the last. Lines that begin with `#` and columns
/// past the fifth are passed over; any run of blank lines ends a frame; rows past the `n` of the
/// frame's header (a border) are left out.
///
/// Errors are sentences that name the line.
pub fn read_frame(input: impl BufRead, wanted: Option<usize>) -> Result<Vec<FrameRow>, String> {
    let mut rows: Vec<FrameRow> = Vec::new();
    let (mut finished, mut in_gap, mut declared) = (0, false, usize::MAX);
    for (number, line) in input.lines().enumerate() {
        let line = line.map_err(|why| format!("line {}: {why}", number + 1))?;
        let line = line.trim();
        if line.is_empty() {
            in_gap = true;
            continue;
        }
        if std::mem::take(&mut in_gap) && !rows.is_empty() {
            if wanted == Some(finished) {
                return Ok(rows);
            }
            finished += 1;
            rows.clear();
            declared = usize::MAX;
        }
        if let Some(header) = line.strip_prefix('#') {
            declared = declared_rows(header).unwrap_or(declared);
        } else if rows.len() < declared {
            rows.push(parse_row(line).map_err(|why| format!("line {}: {why}", number + 1))?);
        }
    }
    match wanted {
        _ if rows.is_empty() => Err("it holds no frame".to_owned()),
        Some(k) if k > finished => Err(format!(
            "frame {k} was asked for; it holds frames 0 to {finished}"
        )),
        _ => Ok(rows),
    }
}

fn declared_rows(header: &str) -> Option<usize> {
    let mut words = header.split_whitespace();
    words.find(|&word| word == "n")?;
    words.next()?.parse().ok()
}

fn parse_row(line: &str) -> Result<FrameRow, String> {
    let mut values = [0.0_f64; 5];
    let mut columns = 0;
    for (value, word) in values.iter_mut().zip(line.split_whitespace()) {
        *value = word
            .parse()
            .map_err(|_| format!("`{word}` is not a number"))?;
        if !value.is_finite() {
            return Err(format!("`{word}` is not finite"));
        }
        columns += 1;
    }
    let [x, y, radius, vx, vy] = values;
    match columns {
        3 | 4 => Ok(FrameRow {
            position: DVec2::new(x, y),
            radius,
            velocity: None,
        }),
        5 => Ok(FrameRow {
            position: DVec2::new(x, y),
            radius,
            velocity: Some(DVec2::new(vx, vy)),
        }),
        _ => Err(format!(
            "{columns} columns; a disc is `x y r` or `x y r vx vy`"
        )),
    }
}
