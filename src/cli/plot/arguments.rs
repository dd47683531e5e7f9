//! What may be asked of `parsim2d plot`.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Args, Subcommand};

use crate::figure::frame::ColourBy;
use crate::figure::history;
use crate::output::frames::layout::Layout;
use crate::scenario::Scenario;
use crate::scenario::error::ScenarioError;
use crate::scenario::preset::Preset;
use crate::scenario::quantity::{Coefficient, Mass, Number, Quantity, Rate, Stiffness};
use crate::scenario::settings::Settings;

const EXAMPLES: &str = "\
Examples:
  parsim2d plot frame out.txt                        discs to scale
  parsim2d plot frame trajectory.txt --frame 0       how it began, coloured by speed
  parsim2d plot trajectory trajectory.txt            paths, or moments of many discs
  parsim2d plot trajectory trajectory.txt --gif      an animated GIF
  parsim2d plot trajectory trajectory.txt --html     a player: one page for any browser
  parsim2d plot energy energy.csv                    where the energy is, and two errors
  parsim2d plot velocity trajectory.txt              the velocity field
  parsim2d plot forces trajectory.txt --kn 5e4       who presses on whom
  parsim2d plot speeds trajectory.txt --pool         speeds beside Maxwell's curve
  parsim2d plot history trajectory.txt --disc 3 y vy  a disc over time

Beside every picture a gnuplot script of the same name is written, which draws the same:
  gnuplot energy.gp                                  writes energy.png
  gnuplot -e \"out='energy.pdf'\" energy.gp            writes energy.pdf";

/// Pictures of what a run wrote, without gnuplot.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct PlotArguments {
    #[command(subcommand)]
    pub kind: Kind,
}

#[derive(Subcommand)]
pub enum Kind {
    /// One frame: discs to scale in their box
    Frame(FrameArguments),
    /// All frames: paths of up to 50 discs, moments of more; or an animated GIF, or a player
    Trajectory(TrajectoryArguments),
    /// The energy ledger and its errors; several ledgers are compared
    Energy(EnergyArguments),
    /// The velocity field of a frame
    Velocity(OneFrame),
    /// The contact forces of a frame, from its overlaps and velocities
    Forces(ForcesArguments),
    /// Histogram of speeds beside Maxwell's distribution in two dimensions
    Speeds(SpeedsArguments),
    /// Discs over time: position, velocity, speed
    History(HistoryArguments),
    /// The drift study: drift.csv, with drift_energy.csv beside it
    Drift(EnergyArguments),
}

/// How a file of frames is read.
#[derive(Args)]
pub struct ReadingArguments {
    /// What the columns of the file are, in their order: x, y, r, d (diameter), vx, vy, m, id, and - for one
    /// to pass over [default: by its heading]
    #[arg(long, value_name = "x,y,-,r", allow_hyphen_values = true)]
    pub columns: Option<Layout>,
}

/// A frame of a file, and where its picture goes.
#[derive(Args)]
pub struct OneFrame {
    /// A file of frames: trajectory.txt has velocities, out.txt has none
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    #[command(flatten)]
    pub reading: ReadingArguments,
    /// Which frame, from 0 [default: the last]
    #[arg(long, value_name = "K")]
    pub frame: Option<usize>,
    /// The picture; the script beside it has its name [default: the kind's name.svg]
    #[arg(short, long, value_name = "FILE.svg")]
    pub out: Option<PathBuf>,
}

#[derive(Args)]
pub struct FrameArguments {
    #[command(flatten)]
    pub of: OneFrame,
    /// What the discs' colours say [default: speed, where the file has velocities]
    #[arg(long, value_enum, value_name = "WHAT", alias = "color")]
    pub colour: Option<ColourBy>,
    /// Draw arrows along the velocities, the longest 5 % of the box
    #[arg(long)]
    pub vectors: bool,
}

#[derive(Args)]
pub struct TrajectoryArguments {
    /// A file of frames: trajectory.txt
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    #[command(flatten)]
    pub reading: ReadingArguments,
    /// Write an animated GIF
    #[arg(long)]
    pub gif: bool,
    /// Write a player: one page for any browser, with the energies of energy.csv beside the file
    #[arg(long, conflicts_with = "gif")]
    pub html: bool,
    /// Take every K-th frame
    #[arg(long, value_name = "K", default_value = "1")]
    pub every: NonZeroUsize,
    /// Take frames 0 to K only [default: all]
    #[arg(long, value_name = "K")]
    pub until: Option<usize>,
    /// Width of the GIF, 64 to 2000
    #[arg(long, value_name = "PIXELS", default_value = "500", requires = "gif")]
    #[arg(value_parser = clap::value_parser!(u16).range(64..=2000))]
    pub size: u16,
    /// Frames of the GIF a second, 0.1 to 50
    #[arg(long, value_name = "FPS", default_value = "20", requires = "gif")]
    #[arg(value_parser = frames_per_second)]
    pub fps: f64,
    /// The picture [default: trajectory.svg, trajectory.gif, trajectory.html]
    #[arg(short, long, value_name = "FILE.svg|FILE.gif|FILE.html")]
    pub out: Option<PathBuf>,
}

fn frames_per_second(text: &str) -> Result<f64, String> {
    let fps: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    // A GIF counts in hundredths of a second, and browsers take two at least.
    if (0.1..=50.0).contains(&fps) { Ok(fps) } else { Err("must be 0.1 to 50".to_owned()) }
}

#[derive(Args)]
pub struct EnergyArguments {
    /// The csv file
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// The picture; the script beside it has its name [default: the kind's name.svg]
    #[arg(short, long, value_name = "FILE.svg")]
    pub out: Option<PathBuf>,
}

#[derive(Args)]
pub struct SpeedsArguments {
    #[command(flatten)]
    pub of: OneFrame,
    /// Count the speeds of all frames
    #[arg(long, conflicts_with = "frame")]
    pub pool: bool,
    /// Pool frames 0 to K only [default: all]
    #[arg(long, value_name = "K", requires = "pool")]
    pub until: Option<usize>,
}

#[derive(Args)]
pub struct HistoryArguments {
    /// A file of frames: trajectory.txt
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What is drawn, a panel each: velocities need trajectory.txt [default: y]
    #[arg(value_enum, value_name = "WHAT")]
    pub quantities: Vec<history::Quantity>,
    /// Which disc, from 0, or several: 0,3,4 [default: all of up to 8, else 0]
    #[arg(long, value_name = "K", value_delimiter = ',')]
    pub disc: Vec<usize>,
    /// Take frames 0 to K only [default: all]
    #[arg(long, value_name = "K")]
    pub until: Option<usize>,
    #[command(flatten)]
    pub reading: ReadingArguments,
    /// The picture; the script beside it has its name [default: history.svg]
    #[arg(short, long, value_name = "FILE.svg")]
    pub out: Option<PathBuf>,
}

/// The contact law is the run's: the same flags, the same defaults.
#[derive(Args)]
pub struct ForcesArguments {
    #[command(flatten)]
    pub of: OneFrame,
    /// The run's set of parameters [default: that of last-run.toml beside the file, or guide]
    #[arg(long, value_enum, value_name = "P", help_heading = "The run's contact law")]
    pub preset: Option<Preset>,
    /// Mass of a disc, m, where the file has no masses [default: the run's]
    #[arg(long, value_name = "KG", allow_hyphen_values = true)]
    #[arg(help_heading = "The run's contact law")]
    pub mass: Option<Quantity<Mass>>,
    /// Normal stiffness, k_n [default: the run's]
    #[arg(long, value_name = "N/M", allow_hyphen_values = true, aliases = ["k_n", "k-n"])]
    #[arg(help_heading = "The run's contact law")]
    pub kn: Option<Quantity<Stiffness>>,
    /// Normal damping, eta_n [default: the run's]
    #[arg(long, value_name = "KG/S", allow_hyphen_values = true, aliases = ["eta_n", "eta-n"])]
    #[arg(conflicts_with_all = ["gamma", "restitution"], help_heading = "The run's contact law")]
    pub eta: Option<Quantity<Coefficient>>,
    /// Damping as a rate: eta_n = m_eff gamma
    #[arg(long, value_name = "1/S", allow_hyphen_values = true, conflicts_with = "restitution")]
    #[arg(help_heading = "The run's contact law")]
    pub gamma: Option<Quantity<Rate>>,
    /// Damping from the restitution e of every contact, 0 < e <= 1
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    #[arg(help_heading = "The run's contact law")]
    pub restitution: Option<Quantity<Number>>,
    /// Contacts never pull
    #[arg(long, help_heading = "The run's contact law")]
    pub no_tension: bool,
    /// No walls
    #[arg(long, help_heading = "The run's contact law")]
    pub no_walls: bool,
}

impl ForcesArguments {
    /// Whether nothing of the law has to be taken from elsewhere, for a frame that has masses or not.
    pub fn says_all(&self, has_masses: bool) -> bool {
        let damping = [self.eta.is_some(), self.gamma.is_some(), self.restitution.is_some()];
        (has_masses || self.mass.is_some()) && self.kn.is_some() && damping.contains(&true)
    }

    /// A scenario with the law that was said.
    pub fn scenario(&self, run: Option<Settings>) -> Result<Scenario, ScenarioError> {
        let flags = Settings {
            preset: self.preset,
            mass: self.mass,
            kn: self.kn,
            eta: self.eta,
            gamma: self.gamma,
            restitution: self.restitution,
            no_tension: self.no_tension.then_some(true),
            no_walls: self.no_walls.then_some(true),
            ..Settings::default()
        };
        let run = run.unwrap_or_default();
        let law = Settings {
            preset: run.preset,
            mass: run.mass,
            kn: run.kn,
            eta: run.eta,
            gamma: run.gamma,
            restitution: run.restitution,
            no_tension: run.no_tension,
            walls: run.walls,
            // No time step is made here: none can be unstable, or too long for the time.
            allow_unstable: Some(true),
            time: "0".parse().ok(),
            ..Settings::default()
        };
        Scenario::resolve(&flags.over(law), || 0)
    }
}
