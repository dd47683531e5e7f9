//! What the user may say, as flags or as keys of a scenario file: one struct for both, from the table of keys.

use clap::{Args, Command, ValueEnum};
use serde::{Deserialize, Serialize};

use super::error::ScenarioError;
use super::key::Key;
use super::keys::KEYS;
pub use super::keys::Settings;
use super::quantity::{Length, Mass, Pair, Quantity, Speed, Time};
use crate::echo;

/// Flags, one for each key.
impl Args for Settings {
    fn augment_args(command: Command) -> Command {
        command.args(KEYS.iter().map(Key::arg))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl Settings {
    /// Refuses a value that its key does not allow. Discs are checked where they are taken over.
    pub(super) fn check(&self) -> Result<(), ScenarioError> {
        let mut checked = Ok(());
        self.each(&mut |key, said| {
            if let (Ok(()), Some(said)) = (&checked, said) {
                checked = said.check(key);
            }
        });
        checked
    }

    /// Whether the key of this `name` is said.
    pub(super) fn says(&self, name: &str) -> bool {
        let mut is_said = false;
        self.each(&mut |key, said| is_said |= key.name == name && said.is_some());
        is_said
    }

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

impl DtSetting {
    /// The seconds, if they were said.
    pub(super) fn seconds(self) -> Option<f64> {
        if let Self::Seconds(seconds) = self { Some(seconds) } else { None }
    }
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
