//! Tables of a scenario file: single discs, and groups of discs.

use serde::Deserialize;

use super::quantity::{Length, Mass, Pair, Quantity, Speed};

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
