//! Names of things that a run is put together of.

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use crate::named::named;

named! {
    /// The time integrators, by name.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum, Deserialize, Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum IntegratorName, name {
        /// Eq. (3): the new velocity moves the disc
        #[default]
        SymplecticEuler = "symplectic-euler",
        /// The old velocity moves the disc: gains energy at every bounce
        ExplicitEuler = "explicit-euler",
        /// Two half-kicks around a drift: second order, with a dashpot first
        VelocityVerlet = "velocity-verlet",
    }
}

named! {
    /// The ways to place discs, by name.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum, Deserialize, Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum PlacementName, name {
        /// Uniformly at random, up to a packing fraction of about 0.53
        #[default]
        Random = "random",
        /// On a slightly jittered lattice: denser
        Lattice = "lattice",
    }
}
