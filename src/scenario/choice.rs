//! What is chosen among several ways: of damping, of a time step, of discs.

use std::sync::Arc;

use super::framed::FramedDiscs;
use crate::named::named;
use crate::output::frames::layout::Layout;
use crate::particle::Particle;

/// How contacts are damped, as said by the user.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DampingChoice {
    /// eta_n, kg/s.
    Eta(f64),
    /// gamma, 1/s, with eta_n = m_eff gamma.
    Gamma(f64),
    /// Restitution e of every contact, pair or wall.
    Restitution(f64),
}

/// How the time step is chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StepChoice {
    /// Eq. (2) with this N_t.
    Nt(f64),
    /// So many seconds.
    Seconds(f64),
    /// The fraction [`AUTO`](crate::analysis::stability::AUTO) of the stable limit.
    Auto,
}

named! {
    /// Who chose the time step.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum DtSetBy, name {
        /// `--nt`.
        Nt = "nt",
        /// `--dt` with a number.
        Dt = "dt",
        /// `--dt auto`.
        Auto = "auto",
        /// The preset's N_t.
        Preset = "preset",
    }
}

/// Where the discs come from.
#[derive(Clone, Debug, PartialEq)]
pub enum DiscSource {
    /// n equal discs, placed by the program.
    Equal(usize),
    /// Listed discs first, then groups placed by the program around them.
    Listed(Vec<Particle>, Vec<Population>),
    /// A frame of a file.
    Frame {
        /// The file and frame as said.
        said: String,
        /// Which column is what, if that was said by hand.
        columns: Option<Layout>,
        /// The discs read, shared by all variants of a scenario.
        discs: Arc<FramedDiscs>,
        /// Whether the file has columns for velocities.
        has_velocities: bool,
        /// Whether the file has a column for masses.
        has_masses: bool,
        /// Whether the file has a column for radii.
        has_radii: bool,
        /// The side that the frame says, m.
        side: Option<f64>,
        /// Whether its columns are named, by the file or by hand.
        are_named: bool,
        /// What is to be said of how the file was read.
        notes: Vec<String>,
    },
}

/// A group of equal discs placed by the program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Population {
    /// How many.
    pub n: usize,
    /// Radius, m.
    pub radius: f64,
    /// Mass, kg.
    pub mass: f64,
    /// Rms speed at the start, m/s.
    pub speed: f64,
}
