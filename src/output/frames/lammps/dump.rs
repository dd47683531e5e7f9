//! LAMMPS dumps: sections that begin with `ITEM:`, a frame from one `TIMESTEP` to the next.

use std::io::{self, BufRead, Write};

use crate::output::frames::column::Column;
use crate::output::frames::frame::{Frame, FrameRow, frame_of_rows};
use crate::output::frames::layout::Layout;
use crate::output::frames::lines::Lines;
use crate::output::frames::remarks::{IS_PERIODIC, Remarks};
use crate::output::frames::rows::push_values;
use crate::output::frames::separator::Separator;
use crate::output::frames::xyz::{each_row, push_in_space};
use crate::output::number::push_g9;

/// A dump while it is read.
#[derive(Debug, Default)]
pub struct Dump {
    /// The columns said by hand.
    pub by_hand: Option<Layout>,
    /// The radius of all discs, m, where no column says it.
    pub radius: Option<f64>,
}

/// What the sections before the rows say.
#[derive(Default)]
struct Head {
    step: Option<u64>,
    time: Option<f64>, // s
    n: Option<usize>,
    bounds: [Option<[f64; 2]>; 2], // m
}

impl Dump {
    /// The next frame, its discs in order of their ids.
    pub fn next_frame<R: BufRead>(
        &mut self,
        lines: &mut Lines<R>,
        remarks: &mut Remarks,
    ) -> Result<Option<Frame>, String> {
        let mut head = Head::default();
        loop {
            let Some(line) = lines.next()? else {
                return match head.step {
                    Some(step) => Err(format!("the frame of step {step} is cut off")),
                    None => Ok(None),
                };
            };
            if line.text.is_empty() {
                continue;
            }
            let Some(item) = line.text.strip_prefix("ITEM:") else {
                return Err(line.at("a section of a dump begins with `ITEM:`"));
            };
            let item = item.trim().to_owned();
            if let Some(names) = item.strip_prefix("ATOMS") {
                let layout = match &self.by_hand {
                    Some(layout) => layout.clone(),
                    None => columns(names, self.radius).map_err(|why| line.at(why))?,
                };
                return self.rows(lines, &head, &layout, names, remarks).map(Some);
            }
            head.take(&item, lines, remarks)?;
        }
    }

    fn rows<R: BufRead>(
        &self,
        lines: &mut Lines<R>,
        head: &Head,
        layout: &Layout,
        names: &str,
        remarks: &mut Remarks,
    ) -> Result<Frame, String> {
        let n = head.n.ok_or("there is no `ITEM: NUMBER OF ATOMS` before its atoms")?;
        let rows = each_row(lines, n, |row| layout.row(row.split_whitespace(), Separator::BLANK))?;
        let mut frame = frame_of_rows(&rows, lines.number(), remarks)?;
        if is_scaled(names) && self.by_hand.is_none() {
            let [Some(x), Some(y)] = head.bounds else {
                return Err("xs and ys are fractions of a box, and there is none".to_owned());
            };
            for row in &mut frame.rows {
                row.position.x = x[0] + row.position.x * (x[1] - x[0]);
                row.position.y = y[0] + row.position.y * (y[1] - y[0]);
            }
        }
        (frame.step, frame.time) = (head.step, head.time);
        frame.side = super::side(head.bounds, remarks);
        super::sort(&mut frame);
        Ok(frame)
    }
}

impl Head {
    /// Reads the lines of a section.
    fn take<R: BufRead>(
        &mut self,
        item: &str,
        lines: &mut Lines<R>,
        remarks: &mut Remarks,
    ) -> Result<(), String> {
        if let Some(kind) = item.strip_prefix("BOX BOUNDS") {
            let kinds = kind.split_whitespace().filter(|word| !["xy", "xz", "yz"].contains(word));
            if kinds.take(2).any(|kind| kind == "pp") {
                remarks.add(IS_PERIODIC);
            }
            let is_tilted = kind.contains("xy") || kind.contains("abc");
            for axis in 0..3 {
                let Some(line) = lines.next()? else { break };
                let numbers: Vec<f64> =
                    line.text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
                let &[low, high, ..] = &numbers[..] else {
                    return Err(line.at("the bounds of a box are two numbers"));
                };
                if axis < 2 && !is_tilted {
                    self.bounds[axis] = Some([low, high]);
                }
            }
            return Ok(());
        }
        let Some(line) = lines.next()? else { return Ok(()) };
        let bad = |what: &str| line.at(format!("`{}` is no {what}", line.text));
        match item {
            "TIMESTEP" => self.step = Some(line.text.parse().map_err(|_| bad("number of steps"))?),
            "TIME" => self.time = Some(line.text.parse().map_err(|_| bad("time"))?),
            "NUMBER OF ATOMS" => {
                self.n = Some(line.text.parse().map_err(|_| bad("number of atoms"))?)
            }
            "UNITS" if *line.text != *"si" => {
                remarks.add(format!(
                    "its units are `{}`: its numbers are taken as SI units",
                    line.text
                ));
            }
            _ => {}
        }
        Ok(())
    }
}

/// Whether the coordinates are fractions of the box.
fn is_scaled(names: &str) -> bool {
    names.split_whitespace().any(|name| name == "xs" || name == "xsu")
}

fn columns(names: &str, radius: Option<f64>) -> Result<Layout, String> {
    let column = |name: &str| match name {
        "xs" | "xsu" => Ok(Column::X),
        "ys" | "ysu" => Ok(Column::Y),
        _ => Column::named(name),
    };
    let columns = names.split_whitespace().map(column).collect::<Result<_, _>>()?;
    let layout = Layout::of(columns).map_err(|why| {
        format!("{why} (ATOMS{names})\n  way out: dump custom ... id x y radius vx vy mass, or --columns")
    })?;
    layout.with_radius(radius, &format!("ATOMS{names}; dump custom ... x y radius writes one"))
}

/// Writes a frame, number `index` of its file, as a dump. What the frame does not say is left out, but for
/// what each dump must have: a time step (`index` stands for it) and a box (that of the discs stands for it).
pub fn write(out: &mut impl Write, index: usize, frame: &Frame) -> io::Result<()> {
    let (has_velocity, has_mass) = (frame.has_velocities(), frame.has_masses());
    let mut text = Vec::new();
    if index == 0 {
        text.extend(b"ITEM: UNITS\nsi\n");
    }
    if let Some(time) = frame.time {
        text.extend(b"ITEM: TIME\n");
        push_g9(&mut text, time);
        text.push(b'\n');
    }
    let step = frame.step.unwrap_or(index as u64);
    text.extend(
        format!("ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{}\n", frame.rows.len()).bytes(),
    );
    text.extend(b"ITEM: BOX BOUNDS ff ff pp\n");
    let thick = frame.rows.iter().map(|row| row.radius).fold(0.0, f64::max);
    for axis in [bounds(frame, 0), bounds(frame, 1), [-thick, thick]] {
        push_values(&mut text, &axis);
        text.push(b'\n');
    }
    text.extend(b"ITEM: ATOMS id type x y z radius");
    text.extend(if has_velocity { &b" vx vy vz"[..] } else { b"" });
    text.extend(if has_mass { &b" mass\n"[..] } else { b"\n" });
    for (k, row) in frame.rows.iter().enumerate() {
        text.extend(format!("{} 1 ", row.id.unwrap_or(k as u64)).bytes());
        push_in_space(&mut text, row);
        text.push(b'\n');
    }
    out.write_all(&text)
}

/// The box along an axis, m, or what its discs take.
fn bounds(frame: &Frame, axis: usize) -> [f64; 2] {
    if let Some(side) = frame.side {
        return [0.0, side];
    }
    let ends = |sign: f64| move |row: &FrameRow| row.position[axis] + sign * row.radius;
    let low = frame.rows.iter().map(ends(-1.0)).fold(f64::INFINITY, f64::min);
    [low, frame.rows.iter().map(ends(1.0)).fold(low, f64::max)]
}
