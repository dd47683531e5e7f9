//! What the user may say, as flags or as keys of a scenario file: one struct for both.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use serde::{Deserialize, Serialize};

use super::gravity::Gravity;
use super::preset::Preset;
use super::quantity::{
    Coefficient, Length, Mass, Number, Pair, Quantity, Rate, Speed, Stiffness, Time, thread_count,
    whole_number,
};
use crate::echo;
use crate::output::frames::layout::Layout;

/// Declares the settings once; merges them field by field.
macro_rules! settings {
    ($($(#[$attribute:meta])* $name:ident: $kind:ty,)+) => {
        /// Every choice of a run, where one was made. Flags are `--long-names`, keys the same
        /// with `_` for `-`.
        #[derive(Args, Clone, Debug, Default, Deserialize)]
        #[serde(deny_unknown_fields, default)]
        pub struct Settings {
            $($(#[$attribute])* pub $name: Option<$kind>,)+
            /// Listed discs (scenario files only).
            #[arg(skip)]
            #[serde(rename = "disc")]
            pub discs: Vec<DiscSettings>,
            /// Groups of random discs (scenario files only).
            #[arg(skip)]
            #[serde(rename = "population")]
            pub populations: Vec<PopulationSettings>,
        }

        impl Settings {
            /// These settings, and where they are silent the `other` ones.
            fn or(self, other: Self) -> Self {
                Self {
                    $($name: self.$name.or(other.$name),)+
                    discs: if self.discs.is_empty() { other.discs } else { self.discs },
                    populations: if self.populations.is_empty() {
                        other.populations
                    } else {
                        self.populations
                    },
                }
            }
        }
    };
}

settings! {
    /// Number of discs, n [default: 20]
    #[arg(short = 'n', long = "n", value_name = "N", allow_hyphen_values = true)]
    #[arg(value_parser = whole_number)]
    n: i64,
    /// Seed of the random numbers [default: drawn, and printed]
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    #[arg(value_parser = whole_number)]
    seed: i64,
    /// Set of parameters to start from [default: guide]
    #[arg(long, value_enum, value_name = "P")]
    preset: Preset,

    /// Side of the box, l [default: 0.04]
    #[arg(long, value_name = "M", allow_hyphen_values = true, help_heading = "Physics")]
    side: Quantity<Length>,
    /// Radius of a disc, r [default: 1e-4]
    #[arg(long, value_name = "M", allow_hyphen_values = true, help_heading = "Physics")]
    radius: Quantity<Length>,
    /// Mass of a disc, m [default: 1e-3]
    #[arg(long, value_name = "KG", allow_hyphen_values = true, help_heading = "Physics")]
    mass: Quantity<Mass>,
    /// Gravity g, downward; or a vector, y up: --gravity=[0,-9.81] [default: 9.81]
    #[arg(long, value_name = "M/S2", allow_hyphen_values = true, help_heading = "Physics")]
    gravity: Gravity,
    /// Normal stiffness, k_n [default: 5e4]
    #[arg(long, value_name = "N/M", allow_hyphen_values = true, help_heading = "Physics")]
    #[arg(aliases = ["k_n", "k-n"])]
    kn: Quantity<Stiffness>,
    /// Normal damping, eta_n [default: 1.5e-3]
    #[arg(long, value_name = "KG/S", allow_hyphen_values = true, help_heading = "Physics")]
    #[arg(conflicts_with_all = ["gamma", "restitution"])]
    #[arg(aliases = ["eta_n", "eta-n"])]
    eta: Quantity<Coefficient>,
    /// Damping as a rate: eta_n = m_eff gamma
    #[arg(long, value_name = "1/S", allow_hyphen_values = true, help_heading = "Physics")]
    #[arg(conflicts_with = "restitution")]
    gamma: Quantity<Rate>,
    /// Damping from the restitution e of every contact, 0 < e <= 1
    #[arg(long, value_name = "E", allow_hyphen_values = true, help_heading = "Physics")]
    restitution: Quantity<Number>,
    /// Clip the contact force at zero: contacts never pull
    #[arg(long, num_args = 0..=1, default_missing_value = "true", require_equals = true)]
    #[arg(value_name = "BOOL", hide_possible_values = true, help_heading = "Physics")]
    no_tension: bool,
    /// No walls: an open plane
    #[arg(long, num_args = 0..=1, default_missing_value = "true", require_equals = true)]
    #[arg(value_name = "BOOL", hide_possible_values = true, help_heading = "Physics")]
    #[arg(conflicts_with = "walls")]
    no_walls: bool,
    /// Walls around the box [default: true]
    #[arg(long, num_args = 0..=1, default_missing_value = "true", require_equals = true)]
    #[arg(value_name = "BOOL", hide_possible_values = true, help_heading = "Physics", hide = true)]
    walls: bool,

    /// Steps in a wall contact, N_t of Eq. (2) [default: 50]
    #[arg(long, value_name = "N_T", allow_hyphen_values = true, help_heading = "Time")]
    #[arg(conflicts_with = "dt")]
    #[arg(aliases = ["N_t", "n_t", "Nt"])]
    nt: Quantity<Number>,
    /// Time step itself, or `auto`: 0.08 of the stable limit
    #[arg(long, value_name = "SECONDS|auto", allow_hyphen_values = true, help_heading = "Time")]
    dt: DtSetting,
    /// Simulated time [default: 1]
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true, help_heading = "Time")]
    time: Quantity<Time>,
    /// Time integrator [default: symplectic-euler]
    #[arg(long, value_enum, value_name = "NAME", help_heading = "Time")]
    integrator: IntegratorName,
    /// Run even if the time step is unstable, for the lesson
    #[arg(long, num_args = 0..=1, default_missing_value = "true", require_equals = true)]
    #[arg(value_name = "BOOL", hide_possible_values = true, help_heading = "Time")]
    allow_unstable: bool,

    /// How discs are placed [default: random]
    #[arg(long, value_enum, value_name = "NAME", help_heading = "Start")]
    placement: PlacementName,
    /// Rms speed at the start of discs placed by the program, in random directions and with no momentum of
    /// all, where they are two or more [default: 0]
    #[arg(long, value_name = "M/S", allow_hyphen_values = true, help_heading = "Start")]
    speed: Quantity<Speed>,
    /// Start from a frame file, at its last frame or at frame K (from 0)
    #[arg(long, value_name = "FILE[:K]", help_heading = "Start")]
    start: String,
    /// What the columns of that file are, in their order: x, y, r, d (diameter), vx, vy, m, id, and - for
    /// one to pass over [default: by its heading]
    #[arg(long, value_name = "x,y,-,r", allow_hyphen_values = true, help_heading = "Start")]
    columns: Layout,

    /// Folder for out.txt, trajectory.txt and energy.csv [default: .]
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    out_dir: PathBuf,
    /// Steps between frames [default: about 200 frames in a run]
    #[arg(long, value_name = "STEPS", allow_hyphen_values = true, help_heading = "Output")]
    #[arg(value_parser = whole_number)]
    every: i64,
    /// Steps between lines of energy.csv, 0 for none [default: about 2000 lines in a run]
    #[arg(long, value_name = "STEPS", allow_hyphen_values = true, help_heading = "Output")]
    #[arg(value_parser = whole_number)]
    energy_every: i64,
    /// Seconds of wall time for a simulated second, to watch the run [default: full speed]
    #[arg(long, value_name = "X", allow_hyphen_values = true, help_heading = "Output")]
    slowdown: Quantity<Number>,
    /// Threads that share the steps; the results are the same to the bit [default: one for few
    /// discs, all cores from 4000 on]
    #[arg(long, value_name = "T", allow_hyphen_values = true, help_heading = "Time")]
    #[arg(value_parser = thread_count)]
    threads: i64,
    /// Write parsim2d.ckpt every so many seconds of wall time, and at the end: `parsim2d resume` goes on
    /// from there [default: on Ctrl-C only]
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true, help_heading = "Output")]
    checkpoint_every: Quantity<Time>,
    /// Add the guide's fictitious border discs to out.txt
    #[arg(long, num_args = 0..=1, default_missing_value = "true", require_equals = true)]
    #[arg(value_name = "BOOL", hide_possible_values = true, help_heading = "Output")]
    border: bool,
    /// Summary as one JSON object on stdout
    #[arg(long, num_args = 0..=1, default_missing_value = "true", require_equals = true)]
    #[arg(value_name = "BOOL", hide_possible_values = true, help_heading = "Output")]
    json: bool,
    /// No progress bar, no remarks, no text summary
    #[arg(short = 'q', long, num_args = 0..=1, default_missing_value = "true", require_equals = true)]
    #[arg(value_name = "BOOL", hide_possible_values = true, help_heading = "Output")]
    quiet: bool,
}

impl Settings {
    /// Flags over file. A damping, a time step or a choice of discs said in a flag replaces any said
    /// in the file; `--start` replaces all that the file says of them, their speed too.
    pub fn over(self, mut file: Self) -> Self {
        if self.eta.is_some() || self.gamma.is_some() || self.restitution.is_some() {
            (file.eta, file.gamma, file.restitution) = (None, None, None);
        }
        if self.nt.is_some() || self.dt.is_some() {
            (file.nt, file.dt) = (None, None);
        }
        if self.walls.is_some() || self.no_walls.is_some() {
            (file.walls, file.no_walls) = (None, None);
        }
        if self.start.is_some() || self.n.is_some() {
            (file.start, file.columns, file.n) = (None, None, None);
            (file.discs, file.populations) = (Vec::new(), Vec::new());
        }
        if self.start.is_some() {
            (file.radius, file.placement, file.speed) = (None, None, None);
        }
        self.or(file)
    }
}

/// One `[[disc]]`. What is not said is as for all discs; at rest.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DiscSettings {
    /// Centre.
    pub position: Pair<Length>,
    /// Velocity.
    pub velocity: Option<Pair<Speed>>,
    /// Radius.
    pub radius: Option<Quantity<Length>>,
    /// Mass.
    pub mass: Option<Quantity<Mass>>,
}

/// One `[[population]]` of discs placed at random. What is not said is as for all discs.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PopulationSettings {
    /// How many.
    pub n: i64,
    /// Radius.
    pub radius: Option<Quantity<Length>>,
    /// Mass.
    pub mass: Option<Quantity<Mass>>,
    /// Rms speed, in random directions; of two or more without a common motion.
    pub speed: Option<Quantity<Speed>>,
}

/// A time step in seconds, or `auto`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DtSetting {
    /// A fixed fraction of the stable limit.
    Auto,
    /// So many seconds.
    Seconds(f64),
}

impl std::str::FromStr for DtSetting {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.trim() == "auto" {
            return Ok(Self::Auto);
        }
        let seconds: Quantity<Time> = text.parse().map_err(|why| format!("{why}, nor `auto`"))?;
        Ok(Self::Seconds(seconds.si))
    }
}

impl<'de> Deserialize<'de> for DtSetting {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged, expecting = "a number of seconds, a string with a unit, or \"auto\"")]
        enum Said {
            Whole(i64),
            Number(f64),
            Text(String),
        }
        match Said::deserialize(deserializer)? {
            Said::Whole(seconds) => Ok(Self::Seconds(seconds as f64)),
            Said::Number(seconds) => Ok(Self::Seconds(seconds)),
            Said::Text(text) => {
                let refused = |why| format!("`{}` is {why}", echo::value(&text));
                text.parse().map_err(|why: String| serde::de::Error::custom(refused(why)))
            }
        }
    }
}

/// The time integrators, by name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum IntegratorName {
    /// Eq. (3): the new velocity moves the disc
    #[default]
    SymplecticEuler,
    /// The old velocity moves the disc: gains energy at every bounce
    ExplicitEuler,
    /// Two half-kicks around a drift: second order, with a dashpot first
    VelocityVerlet,
}

impl IntegratorName {
    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::SymplecticEuler => "symplectic-euler",
            Self::ExplicitEuler => "explicit-euler",
            Self::VelocityVerlet => "velocity-verlet",
        }
    }
}

/// The ways to place discs, by name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PlacementName {
    /// Uniformly at random, up to a packing fraction of about 0.53
    #[default]
    Random,
    /// On a slightly jittered lattice: denser
    Lattice,
}

impl PlacementName {
    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Lattice => "lattice",
        }
    }
}
