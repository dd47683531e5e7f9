//! What may be said to `parsim2d drift`.

use std::path::PathBuf;

use clap::Args;

use crate::scenario::quantity::{Length, Mass, Number, Quantity, Stiffness, Time, whole_number};
use crate::scenario::settings::Settings;

#[derive(Args)]
pub(in crate::cli) struct DriftArguments {
    /// Run one box twice instead, the second time with the last bit of one number changed
    #[arg(long)]
    pub twin: bool,
    /// Discs of the dense box [default: 1000; --twin: 20]
    #[arg(short = 'n', long = "n", value_name = "N", allow_hyphen_values = true)]
    #[arg(value_parser = whole_number)]
    pub n: Option<i64>,
    /// Seed of the discs' places [default: 1, so that two students compare]
    #[arg(long, value_name = "S", allow_hyphen_values = true, value_parser = whole_number)]
    pub seed: Option<i64>,
    /// Steps in a wall contact, N_t of Eq. (2), from 4 to 1000 [default: 10,20,50,100; --twin: 50]
    #[arg(long, value_name = "LIST", value_delimiter = ',', allow_hyphen_values = true)]
    pub nt: Vec<Quantity<Number>>,
    /// Simulated time of the boxes [default: 0.5, and 0.2 for the dense one; --twin: 2]
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true)]
    pub time: Option<Quantity<Time>>,
    /// Restitution of the damped runs, 0 < e <= 1 [default: 0.9; --twin: 1]
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    pub restitution: Option<Quantity<Number>>,
    /// Radius of a disc, r [default: 1e-4, and 5e-4 in the dense box]
    #[arg(long, value_name = "M", allow_hyphen_values = true, help_heading = "Physics")]
    pub radius: Option<Quantity<Length>>,
    /// Mass of a disc, m [default: 1e-3]
    #[arg(long, value_name = "KG", allow_hyphen_values = true, help_heading = "Physics")]
    pub mass: Option<Quantity<Mass>>,
    /// Normal stiffness, k_n [default: 5e4]
    #[arg(long, value_name = "N/M", allow_hyphen_values = true, help_heading = "Physics")]
    #[arg(aliases = ["k_n", "k-n"])]
    pub kn: Option<Quantity<Stiffness>>,
    /// Folder for the csv files [default: .]
    #[arg(long, value_name = "DIR", help_heading = "Output", default_value = ".")]
    #[arg(hide_default_value = true)]
    pub out_dir: PathBuf,
    /// Rows and key numbers as one JSON object on stdout
    #[arg(long, help_heading = "Output")]
    pub json: bool,
    /// No progress bar, no table, no words: the files only (and --json)
    #[arg(short = 'q', long, help_heading = "Output")]
    pub quiet: bool,
}

impl DriftArguments {
    /// What was said, but for N_t.
    pub fn settings(&self) -> Settings {
        Settings {
            n: self.n,
            seed: self.seed,
            radius: self.radius,
            mass: self.mass,
            kn: self.kn,
            time: self.time,
            restitution: self.restitution,
            ..Settings::default()
        }
    }

    pub fn nt(&self) -> Vec<f64> {
        self.nt.iter().map(|nt| nt.si).collect()
    }
}
