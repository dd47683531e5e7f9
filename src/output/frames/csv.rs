//! One table of all frames, for pandas and spreadsheets: its columns named in the first line.

use std::io::{self, Write};

use super::column::Column;
use super::frame::Frame;
use crate::output::number::push_g9;

/// The columns of a table of frames like `frame`: what it does not say is left out.
pub fn columns(frame: &Frame) -> Vec<Column> {
    let has_velocity = frame.has_velocities();
    let all = [
        (Column::Frame, true),
        (Column::Step, frame.step.is_some()),
        (Column::Time, frame.time.is_some()),
        (Column::Side, frame.side.is_some()),
        (Column::Id, true),
        (Column::X, true),
        (Column::Y, true),
        (Column::Radius, true),
        (Column::Vx, has_velocity),
        (Column::Vy, has_velocity),
        (Column::Mass, frame.has_masses()),
    ];
    all.into_iter().filter(|(_, is_there)| *is_there).map(|(column, _)| column).collect()
}

/// Writes the first line.
pub fn write_names(out: &mut impl Write, columns: &[Column]) -> io::Result<()> {
    let names: Vec<&str> = columns.iter().map(|column| column.name()).collect();
    writeln!(out, "{}", names.join(","))
}

/// Writes the rows of a frame, number `index` of its file, that has all of these `columns`.
pub fn write(
    out: &mut impl Write,
    index: usize,
    frame: &Frame,
    columns: &[Column],
) -> io::Result<()> {
    let mut text = Vec::new();
    for (k, row) in frame.rows.iter().enumerate() {
        let velocity = row.velocity.unwrap_or_default();
        for (at, column) in columns.iter().enumerate() {
            if at > 0 {
                text.push(b',');
            }
            match column {
                Column::Frame => text.extend(index.to_string().bytes()),
                Column::Step => text.extend(frame.step.unwrap_or_default().to_string().bytes()),
                Column::Id => text.extend(row.id.unwrap_or(k as u64).to_string().bytes()),
                Column::Time => push_g9(&mut text, frame.time.unwrap_or_default()),
                Column::Side => push_g9(&mut text, frame.side.unwrap_or_default()),
                Column::X => push_g9(&mut text, row.position.x),
                Column::Y => push_g9(&mut text, row.position.y),
                Column::Radius => push_g9(&mut text, row.radius),
                Column::Vx => push_g9(&mut text, velocity.x),
                Column::Vy => push_g9(&mut text, velocity.y),
                Column::Mass => push_g9(&mut text, row.mass.unwrap_or_default()),
                Column::Z | Column::Diameter | Column::Kind | Column::Other => {}
            }
        }
        text.push(b'\n');
    }
    out.write_all(&text)
}
