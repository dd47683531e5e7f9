//! LAMMPS data files, as `read_data` takes them: one state. Of the styles of atoms `sphere` has a radius;
//! `atomic` is told from it, and refused.

use std::collections::HashMap;
use std::io::BufRead;

use glam::DVec2;

use crate::output::frames::frame::{Frame, FrameRow};
use crate::output::frames::lines::Lines;
use crate::output::frames::remarks::Remarks;

/// A data file while it is read.
#[derive(Debug, Default)]
pub struct Data {
    is_read: bool,
}

/// What has been read.
#[derive(Default)]
struct Parts {
    n: Option<usize>,
    bounds: [Option<[f64; 2]>; 2],   // m
    atoms: Vec<(FrameRow, f64)>,     // and density, kg/m3
    velocities: HashMap<u64, DVec2>, // m/s
}

impl Data {
    /// The one frame.
    pub fn next_frame<R: BufRead>(
        &mut self,
        lines: &mut Lines<R>,
        remarks: &mut Remarks,
    ) -> Result<Option<Frame>, String> {
        if std::mem::replace(&mut self.is_read, true) {
            return Ok(None);
        }
        let mut parts = Parts::default();
        let mut section = String::new();
        lines.next()?; // a remark, always
        while let Some(line) = lines.next()? {
            let (text, remark) = line.text.split_once('#').unwrap_or((&line.text, ""));
            let text = text.trim();
            if text.is_empty() {
                continue;
            }
            if text.starts_with(|c: char| c.is_ascii_alphabetic()) {
                section = text.to_owned();
                if section == "Atoms" && !["", "sphere"].contains(&remark.trim()) {
                    return Err(line.at(no_radius(remark.trim())));
                }
                continue;
            }
            parts.take(&section, text).map_err(|why| line.at(why))?;
        }
        parts.frame(remarks).map(Some)
    }
}

fn no_radius(style: &str) -> String {
    format!(
        "atoms of style `{style}` have no radius\n  way out: a data file with atom_style sphere, or a dump with \
         id x y radius vx vy mass"
    )
}

impl Parts {
    fn take(&mut self, section: &str, text: &str) -> Result<(), String> {
        let words: Vec<&str> = text.split_whitespace().collect();
        let number = |k: usize| -> Result<f64, String> {
            let word = words.get(k).ok_or("the line is cut off")?;
            let value: f64 = word.parse().map_err(|_| format!("`{word}` is not a number"))?;
            if value.is_finite() { Ok(value) } else { Err(format!("`{word}` is not finite")) }
        };
        let id = || words[0].parse::<u64>().map_err(|_| format!("`{}` is no id", words[0]));
        match (section, &words[..]) {
            ("", [n, "atoms"]) => self.n = n.parse().ok(),
            ("", [_, _, "xlo", "xhi"]) => self.bounds[0] = Some([number(0)?, number(1)?]),
            ("", [_, _, "ylo", "yhi"]) => self.bounds[1] = Some([number(0)?, number(1)?]),
            // id type diameter density x y z, and three counts of crossings of the box
            ("Atoms", row) if row.len() == 7 || row.len() == 10 => {
                let disc = FrameRow {
                    position: DVec2::new(number(4)?, number(5)?),
                    radius: 0.5 * number(2)?,
                    velocity: None,
                    mass: None,
                    id: Some(id()?),
                };
                self.atoms.push((disc, number(3)?));
            }
            ("Atoms", row) if row.len() == 5 || row.len() == 8 => return Err(no_radius("atomic")),
            ("Atoms", row) => {
                return Err(format!("{} columns; atoms of style sphere have 7 or 10", row.len()));
            }
            ("Velocities", _) => {
                self.velocities.insert(id()?, DVec2::new(number(1)?, number(2)?));
            }
            _ => {}
        }
        Ok(())
    }

    fn frame(self, remarks: &mut Remarks) -> Result<Frame, String> {
        let Self { n, bounds, atoms, velocities } = self;
        if let Some(n) = n.filter(|&n| n != atoms.len()) {
            return Err(format!("the frame is cut off: {} of {n} discs", atoms.len()));
        }
        let has_all = !velocities.is_empty()
            && atoms.iter().all(|(row, _)| row.id.is_some_and(|id| velocities.contains_key(&id)));
        let mut frame = Frame { side: super::side(bounds, remarks), ..Frame::default() };
        for (mut row, density) in atoms {
            // In a data file of spheres the density makes the mass of a ball, also in two dimensions.
            row.mass = Some(density * 4.0 / 3.0 * std::f64::consts::PI * row.radius.powi(3));
            row.velocity = row.id.filter(|_| has_all).and_then(|id| velocities.get(&id).copied());
            frame.rows.push(row);
        }
        remarks.add("its masses are those of balls of its densities");
        super::sort(&mut frame);
        Ok(frame)
    }
}
