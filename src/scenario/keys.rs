//! The table of keys: all that may be said of a run, and the scenario that comes of it.
//!
//! A new key is one row here, and its value a field of the scenario, or of its section: flag, key of a file, help, check,
//! way out, the file that a run leaves behind, completions and manual page follow.

use std::path::PathBuf;

use clap::{ArgMatches, FromArgMatches};
use serde::Deserialize;

use super::gravity::Gravity;
use super::key::{Key, Kind, Said, keys};
use super::preset::{Preset, PresetValues};
use super::quantity::{
    Coefficient, Length, MOST_THREADS, Mass, Number, Quantity, Rate, Speed, Stiffness, Time,
};
use super::range::{ABOVE_0, ANY, FROM_0, FROM_1, Range, above_to, from_to};
use super::settings::{DiscSettings, DtSetting, IntegratorName, PlacementName, PopulationSettings};
use super::{DampingChoice, DiscSource, DtSetBy, StepChoice};
use crate::output::frames::layout::Layout;

/// Of radii more is asked where discs are taken over: there it is known which are in use, and how large the box is.
const RADII: Range = Range { words: "must be above 0 and below half the side of the box", ..ANY };

/// Steps in a contact.
const NT: Range =
    Range { words: "must be at least 1 step in a contact; the guide says 10 to 50", ..FROM_1 };

/// Wall seconds for a simulated second: up to thirty years.
const SLOWDOWNS: Range = from_to(1e-9, 1e9);

/// Wall seconds between checkpoints. More often than that a run does little else; more than thirty years are more
/// than some clocks can tell.
const INTERVALS: Range = from_to(1e-3, 1e9);

keys! {
    (settings, usual, seed)

    /// Every choice of a run, checked. SI units.
    Scenario {
        "" {
            /// Number of discs, n [default: 20]
            n: i64, "N", ANY, "-n 20", { letter: Some('n') };
            /// Seed of the random numbers [default: drawn, and printed]
            seed: i64, "S", FROM_0, "--seed 1" => seed: u64 = seed;
            /// Set of parameters to start from [default: guide]
            preset: Preset, "P", ANY, "", { comes_first: true } => preset: Preset = Preset::default();
        }
        "Physics" {
            /// Side of the box, l [default: 0.04]
            side: Quantity<Length>, "M", ABOVE_0, "--side 4cm" => side: f64 = usual.side;
            /// Radius of a disc, r [default: 1e-4]
            radius: Quantity<Length>, "M", RADII, "--radius 1e-4" => radius: f64 = usual.radius;
            /// Mass of a disc, m [default: 1e-3]
            mass: Quantity<Mass>, "KG", ABOVE_0, "--mass 1g" => mass: f64 = usual.mass;
            /// Gravity g, downward; or a vector, y up: --gravity=[0,-9.81] [default: 9.81]
            gravity: Gravity, "M/S2", ANY, "write a number" => gravity: Gravity = Gravity::down(usual.gravity);
            /// Normal stiffness, k_n [default: 5e4]
            kn: Quantity<Stiffness>, "N/M", ABOVE_0, "--kn 5e4", { aliases: &["k_n", "k-n"] }
                => stiffness: f64 = usual.stiffness;
            /// Normal damping, eta_n [default: 1.5e-3]
            eta: Quantity<Coefficient>, "KG/S", FROM_0, "--eta 1.5e-3", { aliases: &["eta_n", "eta-n"] };
            /// Damping as a rate: eta_n = m_eff gamma
            gamma: Quantity<Rate>, "1/S", FROM_0, "--gamma 1.5e3";
            /// Damping from the restitution e of every contact, 0 < e <= 1
            restitution: Quantity<Number>, "E", above_to(0.0, 1.0),
                "--restitution 0.9 (1 is elastic; for more damping than any e gives, --eta)";
            /// Clip the contact force at zero: contacts never pull
            no_tension: bool, "BOOL", ANY, "";
            /// No walls: an open plane
            no_walls: bool, "BOOL", ANY, "";
            /// Walls around the box [default: true]
            walls: bool, "BOOL", ANY, "", { is_hidden: true } => walls: bool = !settings.no_walls.unwrap_or(false);
        }
        "Time" {
            /// Steps in a wall contact, N_t of Eq. (2) [default: 50]
            nt: Quantity<Number>, "N_T", NT, "--nt 50", { aliases: &["N_t", "n_t", "Nt"] };
            /// Time step itself, or `auto`: 0.08 of the stable limit
            dt: DtSetting, "SECONDS|auto", ABOVE_0, "--dt auto";
            /// Simulated time [default: 1]
            time: Quantity<Time>, "SECONDS", FROM_0, "--time 1s" => time: f64 = 1.0;
            /// Time integrator [default: symplectic-euler]
            integrator: IntegratorName, "NAME", ANY, "" => integrator: IntegratorName = IntegratorName::default();
            /// Run even if the time step is unstable, for the lesson
            allow_unstable: bool, "BOOL", ANY, "" => allow_unstable: bool = false;
        }
        "Start" {
            /// How discs are placed [default: random]
            placement: PlacementName, "NAME", ANY, "" => placement: PlacementName = PlacementName::default();
            /// Rms speed at the start of discs placed by the program, in random directions and with no momentum of
            /// all, where they are two or more [default: 0]
            speed: Quantity<Speed>, "M/S", FROM_0, "--speed 0.1" => speed: f64 = 0.0;
            /// Start from a frame file, at its last frame or at frame K (from 0)
            start: String, "FILE[:K]", ANY, "", { comes_first: true };
            /// What the columns of that file are, in their order: x, y, r, d (diameter), vx, vy, m, id, and - for
            /// one to pass over [default: by its heading]
            columns: Layout, "x,y,-,r", ANY, "", { comes_first: true };
        }
        made {
            /// Damping of contacts.
            damping: DampingChoice = DampingChoice::of(settings).unwrap_or(usual.damping);
            /// Whether contacts may pull as they end.
            tension: bool = !settings.no_tension.unwrap_or(false);
            /// How the time step is chosen.
            step: StepChoice = StepChoice::of(settings).unwrap_or(usual.step);
            /// Who chose it.
            dt_set_by: DtSetBy = DtSetBy::of(settings);
            /// Where the discs come from; taken over next.
            discs: DiscSource = DiscSource::Equal(usual.n);
            /// What is written, where and how often, and who computes it.
            output: OutputChoices = OutputChoices::of(settings, usual, seed);
        }
    }

    /// What is written, where and how often, and who computes it.
    OutputChoices {
        "Output" {
            /// Folder for out.txt, trajectory.txt and energy.csv [default: .]
            out_dir: PathBuf, "DIR", ANY, "", { is_of_machine: true } => folder: PathBuf = ".".into();
            /// Steps between frames [default: about 200 frames in a run]
            every: i64, "STEPS", FROM_1, "leave it out for the default", { unit: "steps" } => every: Option<u64> = None;
            /// Steps between lines of energy.csv, 0 for none [default: about 2000 lines in a run]
            energy_every: i64, "STEPS", FROM_0, "leave it out for the default", { unit: "steps" }
                => energy_every: Option<u64> = None;
            /// Seconds of wall time for a simulated second, to watch the run [default: full speed]
            slowdown: Quantity<Number>, "X", SLOWDOWNS, "--slowdown 10", { is_of_machine: true }
                => slowdown: Option<f64> = None;
            /// Threads that share the steps; the results are the same to the bit [default: one for few
            /// discs, all cores from 4000 on]
            threads: i64, "T", from_to(1.0, MOST_THREADS as f64), "--threads 1, or as many as there are cores",
                { is_of_machine: true, heading: Some("Time") } => threads: Option<u64> = None;
            /// Write parsim2d.ckpt every so many seconds of wall time, and at the end: `parsim2d resume` goes on
            /// from there [default: on Ctrl-C only]
            checkpoint_every: Quantity<Time>, "SECONDS", INTERVALS, "--checkpoint-every 10min",
                { is_of_machine: true, unit: "s of wall time" } => checkpoint_every: Option<f64> = None;
            /// Add the guide's fictitious border discs to out.txt
            border: bool, "BOOL", ANY, "" => border: bool = false;
            /// Summary as one JSON object on stdout
            json: bool, "BOOL", ANY, "", { is_of_machine: true } => json: bool = false;
            /// No progress bar, no remarks, no text summary
            quiet: bool, "BOOL", ANY, "", { is_of_machine: true, letter: Some('q') } => quiet: bool = false;
        }
        made {}
    }
}
