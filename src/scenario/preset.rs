//! Named sets of parameters: the guide's numbers, and three readings of them.

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use super::{DampingChoice, StepChoice};
use crate::named::named;

named! {
    /// Which set of parameters a run starts from. Flags and keys override single ones.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum, Deserialize, Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Preset, name {
        /// The guide's text (r = 1e-4 m), with eta_n = 1.5e-3 kg/s for its printed 1.5e3
        #[default]
        Guide = "guide",
        /// The guide's listing: the same with r = 5e-4 m
        GuideListing = "guide-listing",
        /// eta_n = 1.5e3 kg/s as printed, with a time step small enough for it
        GuidePrinted = "guide-printed",
        /// The printed 1.5e3 read as a rate, gamma = 1.5e3 1/s with eta_n = m_eff gamma
        GuideMassScaled = "guide-mass-scaled",
    }
}

/// What a preset sets. All in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PresetValues {
    /// Number of discs.
    pub n: usize,
    /// Side of the box.
    pub side: f64, // m
    /// Radius.
    pub radius: f64, // m
    /// Mass.
    pub mass: f64, // kg
    /// Gravity, downward.
    pub gravity: f64, // m/s2
    /// Normal stiffness k_n.
    pub stiffness: f64, // N/m
    /// Damping.
    pub damping: DampingChoice,
    /// Time step.
    pub step: StepChoice,
}

impl Preset {
    /// Its numbers.
    pub fn values(self) -> PresetValues {
        let guide = PresetValues {
            n: 20,
            side: 0.04,
            radius: 1e-4,
            mass: 1e-3,
            gravity: 9.81,
            stiffness: 5e4,
            damping: DampingChoice::Eta(1.5e-3),
            step: StepChoice::Nt(50.0),
        };
        match self {
            Self::Guide => guide,
            Self::GuideListing => PresetValues { radius: 5e-4, ..guide },
            // Stable in a heap from N_t = 2033 on; just below the limit these contacts, which never
            // let go, do not heat up (1 s of 300 discs ends at rest to 1e-10 m/s).
            Self::GuidePrinted => PresetValues {
                damping: DampingChoice::Eta(1.5e3),
                step: StepChoice::Nt(2100.0),
                ..guide
            },
            Self::GuideMassScaled => PresetValues { damping: DampingChoice::Gamma(1.5e3), ..guide },
        }
    }
}
