//! `parsim2d drift`: does the total energy stay constant? Measured, then answered in words.

mod findings;
mod table;
mod twin;
mod words;

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use serde::Serialize;

use self::findings::{Findings, Outcome};
use super::Failure;
use super::plot::{Target, plot_drift};
use super::terminal::progress_bar;
use crate::output::drift::{self as files, CurveRow, DriftRow};
use crate::scenario::quantity::{Length, Mass, Number, Quantity, Stiffness, Time, whole_number};
use crate::scenario::settings::Settings;
use crate::scenario::study::{Study, StudyRun};
use crate::session::courses::courses;

pub(super) const EXAMPLES: &str = "\
Examples:
  parsim2d drift                           the whole study, with the guide's numbers
  parsim2d drift --nt 10,25,50             other time steps
  parsim2d drift -n 300 --time 0.5s        another dense box, longer
  parsim2d drift --twin                    how long can two correct programs be compared?
  parsim2d drift --json -q                 rows and key numbers as one JSON object

Writes drift.csv (a line a run), drift_energy.csv (the boxes' energy against time), and the
figure of both, drift.svg, with drift.gp for gnuplot; --twin writes twin.csv (the distance between two runs against time).";

#[derive(Args)]
pub(super) struct DriftArguments {
    /// Run one box twice instead, the second time with the last bit of one number changed
    #[arg(long)]
    twin: bool,
    /// Discs of the dense box [default: 1000; --twin: 20]
    #[arg(short = 'n', long = "n", value_name = "N", allow_hyphen_values = true)]
    #[arg(value_parser = whole_number)]
    n: Option<i64>,
    /// Seed of the discs' places [default: 1, so that two students compare]
    #[arg(long, value_name = "S", allow_hyphen_values = true, value_parser = whole_number)]
    seed: Option<i64>,
    /// Steps in a wall contact, N_t of Eq. (2), from 4 to 1000 [default: 10,20,50,100; --twin: 50]
    #[arg(long, value_name = "LIST", value_delimiter = ',', allow_hyphen_values = true)]
    nt: Vec<Quantity<Number>>,
    /// Simulated time of the boxes [default: 0.5, and 0.2 for the dense one; --twin: 2]
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true)]
    time: Option<Quantity<Time>>,
    /// Restitution of the damped runs, 0 < e <= 1 [default: 0.9; --twin: 1]
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    restitution: Option<Quantity<Number>>,
    /// Radius of a disc, r [default: 1e-4, and 5e-4 in the dense box]
    #[arg(long, value_name = "M", allow_hyphen_values = true, help_heading = "Physics")]
    radius: Option<Quantity<Length>>,
    /// Mass of a disc, m [default: 1e-3]
    #[arg(long, value_name = "KG", allow_hyphen_values = true, help_heading = "Physics")]
    mass: Option<Quantity<Mass>>,
    /// Normal stiffness, k_n [default: 5e4]
    #[arg(long, value_name = "N/M", allow_hyphen_values = true, help_heading = "Physics")]
    #[arg(aliases = ["k_n", "k-n"])]
    kn: Option<Quantity<Stiffness>>,
    /// Folder for the csv files [default: .]
    #[arg(long, value_name = "DIR", help_heading = "Output", default_value = ".")]
    #[arg(hide_default_value = true)]
    out_dir: PathBuf,
    /// Rows and key numbers as one JSON object on stdout
    #[arg(long, help_heading = "Output")]
    json: bool,
    /// No progress bar, no table, no words: the files only (and --json)
    #[arg(short = 'q', long, help_heading = "Output")]
    quiet: bool,
}

impl DriftArguments {
    /// What was said, but for N_t.
    fn settings(&self) -> Settings {
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

    fn nt(&self) -> Vec<f64> {
        self.nt.iter().map(|nt| nt.si).collect()
    }
}

/// What `--json` prints.
#[derive(Serialize)]
struct Report<'a> {
    rows: &'a [DriftRow],
    answer: &'a Findings,
    words: Vec<String>,
}

pub(super) fn run(arguments: &DriftArguments) -> Result<ExitCode, Failure> {
    if arguments.twin {
        return twin::run(arguments);
    }
    let study = Study::new(&arguments.settings(), &arguments.nt())?;
    let folder = &arguments.out_dir;
    files::probe(folder, &["drift.csv", "drift_energy.csv", "drift.svg", "drift.gp"])?;
    let runs = study.runs();
    let steps = runs.iter().map(StudyRun::particle_steps).sum();
    let bar = progress_bar(steps, arguments.quiet || arguments.json);
    let courses = courses(&runs, &|steps| bar.inc(steps))?;
    bar.finish_and_clear();
    let outcomes: Vec<Outcome> = runs.iter().zip(&courses).collect();
    let rows: Vec<DriftRow> = outcomes.iter().map(drift_row).collect();

    files::write(&folder.join("drift.csv"), &rows)?;
    files::write(&folder.join("drift_energy.csv"), &curve_rows(&outcomes))?;
    let figure = Target::new(Some(&folder.join("drift.svg")), "drift", "svg")?;
    plot_drift(&folder.join("drift.csv"), &figure.silent(true))?;

    let findings = Findings::of(&study, &outcomes)?;
    let mut out = io::stdout().lock();
    if arguments.json {
        let words = words::answer(&findings);
        let report = Report { rows: &rows, answer: &findings, words };
        serde_json::to_writer(&mut out, &report).map_err(io::Error::from)?;
        writeln!(out)?;
    } else if !arguments.quiet {
        table::write(&mut out, &study, &outcomes)?;
        words::write(&mut out, &words::answer(&findings))?;
        writeln!(out, "\nwrote drift.csv, drift_energy.csv, drift.svg and drift.gp")?;
    }
    out.flush()?;
    Ok(ExitCode::SUCCESS)
}

fn drift_row((run, course): &Outcome) -> DriftRow {
    DriftRow {
        case: run.case.name().to_owned(),
        integrator: run.integrator.name().to_owned(),
        restitution: run.restitution,
        nt: run.nt,
        dt_s: course.dt,
        largest_error: course.largest_error,
        final_error: course.final_error,
        dissipated_J: course.dissipated,
        work_error_J: course.work_error,
    }
}

fn curve_rows(outcomes: &[Outcome]) -> Vec<CurveRow> {
    let boxes = outcomes.iter().filter(|(run, _)| !run.case.is_one_contact());
    let rows = boxes.flat_map(|(run, course)| {
        course.curve.iter().map(|&(time_s, error)| CurveRow {
            case: run.case.name().to_owned(),
            integrator: run.integrator.name().to_owned(),
            restitution: run.restitution,
            nt: run.nt,
            time_s,
            error,
        })
    });
    rows.collect()
}
