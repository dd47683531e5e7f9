//! Frames as text, as runs write them: `x y r` or `x y r vx vy m` a line.

use std::io::{self, Write};

use super::frame::Frame;
use super::head::{Columns, Head};
use super::rows::{push_values, write_rows};
use crate::output::number::push_g9;
use crate::simulation::Simulation;

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
        Columns::Discs => {
            let rows = discs.map(|p| {
                [p.position.x, p.position.y, p.radius, p.velocity.x, p.velocity.y, p.mass]
            });
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
            push_values(&mut text, &[x, y, radius]);
            text.push(b'\n');
        }
    }
    out.write_all(&text)
}

/// Writes a frame that was read, number `index` of its file, in the same form; what it does not say is left
/// out. Ids are written where they are not 0, 1, 2 ...
pub fn write(out: &mut impl Write, index: usize, frame: &Frame) -> io::Result<()> {
    let (velocities, masses, ids) =
        (frame.has_velocities(), frame.has_masses(), frame.has_own_ids());
    let mut text = Vec::new();
    text.extend(if index > 0 { &b"\n\n#"[..] } else { b"#" });
    if let Some(step) = frame.step {
        text.extend(format!(" step {step}").bytes());
    }
    if let Some(time) = frame.time {
        text.extend(b" time_s ");
        push_g9(&mut text, time);
    }
    text.extend(format!(" n {}", frame.rows.len()).bytes());
    if let Some(side) = frame.side {
        text.extend(b" side_m ");
        push_g9(&mut text, side);
    }
    text.extend(b" columns x y r");
    for (names, are_there) in [(" vx vy", velocities), (" m", masses), (" id", ids)] {
        text.extend(if are_there { names.bytes() } else { "".bytes() });
    }
    text.push(b'\n');
    for (k, row) in frame.rows.iter().enumerate() {
        push_values(&mut text, &[row.position.x, row.position.y, row.radius]);
        let velocity = row.velocity.map_or([0.0; 2], |velocity| velocity.to_array());
        let mass = [row.mass.unwrap_or_default()];
        for (values, are_there) in [(&velocity[..], velocities), (&mass, masses)] {
            if are_there {
                text.push(b' ');
                push_values(&mut text, values);
            }
        }
        if ids {
            text.extend(format!(" {}", row.id.unwrap_or(k as u64)).bytes());
        }
        text.push(b'\n');
    }
    out.write_all(&text)
}
