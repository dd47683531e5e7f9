//! `out.txt`: the present frame, `x y r`, replaced whole at every refresh.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::PathBuf;

use super::OutputError;
use super::frames::{Columns, Head, write_border, write_frame, write_rows};
use super::replace::replace_fleeting;
use crate::simulation::Simulation;

/// Where the discs are at one moment: all that a live frame shows, at 24 bytes a disc where all have one
/// radius. They are taken as they lie in memory, which is quick, and put in order by who writes them.
pub struct Still {
    head: Head,
    places: Vec<[f64; 2]>, // x, y in m
    radii: Vec<f64>,       // m; one, if all are the same
    ids: Vec<u32>,         // empty if the discs are in id order
    order: Vec<u32>,       // where each id is, once it is asked for
}

impl Still {
    /// No moment yet.
    pub fn empty() -> Self {
        let head = Head { step: 0, time: 0.0, n: 0, side: 0.0 };
        let (places, radii) = (Vec::new(), Vec::new());
        Self { head, places, radii, ids: Vec::new(), order: Vec::new() }
    }

    /// Takes the present state instead of what was there.
    pub fn take(&mut self, simulation: &Simulation) {
        self.head = Head::of(simulation, 0.0); // the box is the live frame's
        let (discs, ids) = simulation.as_stored();
        self.ids.clear();
        self.ids.extend_from_slice(ids);
        let first = discs.first().map_or(0.0, |p| p.radius);
        let mut is_one_radius = true;
        self.places.clear();
        self.places.extend(discs.iter().map(|p| {
            is_one_radius &= p.radius == first;
            p.position.to_array()
        }));
        self.radii.clear();
        match is_one_radius {
            true => self.radii.push(first),
            false => self.radii.extend(discs.iter().map(|p| p.radius)),
        }
    }

    /// `x y r` of each disc, in id order.
    fn rows(&mut self) -> impl Iterator<Item = [f64; 3]> {
        let Self { places, radii, ids, order, .. } = self;
        order.clear();
        order.resize(places.len(), 0);
        for (place, &id) in (0..).zip(ids.iter()) {
            order[id as usize] = place;
        }
        if ids.is_empty() {
            (0..).zip(order.iter_mut()).for_each(|(id, place)| *place = id);
        }
        order.iter().map(|&place| {
            let [x, y] = places[place as usize];
            [x, y, if let [all] = radii[..] { all } else { radii[place as usize] }]
        })
    }
}

/// The live frame of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct LiveFrame {
    /// The file.
    pub path: PathBuf,
    /// Side of the box, m.
    pub side: f64,
    /// Radius of the guide's fictitious border discs, m, if they are wanted.
    pub border: Option<f64>,
}

impl LiveFrame {
    /// Replaces the file by the present state, and the border after it.
    pub fn refresh(&self, simulation: &Simulation) -> Result<(), OutputError> {
        replace_fleeting(&self.path, |out| self.write(out, simulation))
    }

    /// Replaces the file by the state at the moment of `still`, and the border after it.
    pub fn refresh_from(&self, still: &mut Still) -> Result<(), OutputError> {
        replace_fleeting(&self.path, |out| {
            let head = Head { side: self.side, ..still.head };
            write_rows(out, head, Columns::Positions, still.rows())?;
            self.write_border(out)
        })
    }

    /// Writes what the file holds to `file`, which will take its place.
    pub fn write_all(&self, file: File, simulation: &Simulation) -> Result<(), OutputError> {
        let mut out = BufWriter::new(file);
        let failed = |source| OutputError::Write { path: self.path.clone(), source };
        self.write(&mut out, simulation).and_then(|()| out.flush()).map_err(failed)
    }

    /// Writes what the file holds to `out`.
    pub fn write(&self, out: &mut impl Write, simulation: &Simulation) -> io::Result<()> {
        write_frame(out, simulation, self.side, Columns::Positions)?;
        self.write_border(out)
    }

    fn write_border(&self, out: &mut impl Write) -> io::Result<()> {
        match self.border {
            Some(radius) => write_border(out, self.side, radius),
            None => Ok(()),
        }
    }
}
