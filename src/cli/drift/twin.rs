//! `parsim2d drift --twin`: two runs that differ by the last bit of one number, side by side.

use std::io::{self, Write};
use std::process::ExitCode;

use serde::Serialize;

use super::super::memory;
use super::super::terminal::progress_bar;
use super::arguments::DriftArguments;
use super::words;
use crate::analysis::twin::{Growth, SEPARATE, distances, separation_time};
use crate::cli::failure::Failure;
use crate::number::{counted, shortest, time_step};
use crate::output::drift::{self as files, TwinRow};
use crate::scenario::Scenario;
use crate::scenario::study::{twin_box, twins};

/// Points of `twin.csv`.
const POINTS: u64 = 500;

/// Rows printed.
const PRINTED: usize = 12;

/// What one twin showed.
#[derive(Debug, Serialize)]
#[allow(non_snake_case)] // a key's name ends with its unit
struct Twin {
    /// The number of which the last bit was changed.
    changed: &'static str,
    /// Exponential growth rate, 1/s.
    rate_per_s: Option<f64>,
    doubling_time_s: Option<f64>,
    fitted_from_s: Option<f64>,
    fitted_until_s: Option<f64>,
    /// When the distance reached 1 % of the radius, s.
    comparable_until_s: Option<f64>,
    largest_distance_m: f64,
}

impl Twin {
    fn of(changed: &'static str, distances: &[(f64, f64)], radius: f64) -> Self {
        let growth = Growth::of(distances, radius);
        Self {
            changed,
            rate_per_s: growth.map(|growth| growth.rate),
            doubling_time_s: growth.map(|growth| growth.doubling_time()),
            fitted_from_s: growth.map(|growth| growth.from),
            fitted_until_s: growth.map(|growth| growth.until),
            comparable_until_s: separation_time(distances, radius),
            largest_distance_m: distances.iter().map(|p| p.1).fold(0.0, f64::max),
        }
    }

    /// Growth and its end, in words.
    fn words(&self, scenario: &Scenario) -> String {
        let Scenario { radius, time, .. } = *scenario;
        let one_percent = SEPARATE * radius;
        let reaches = match self.comparable_until_s {
            Some(until) => format!(
                " It reaches {one_percent:.0e} m, 1 % of a radius, at {until:.2} s: until then two \
                 correct programs may be compared disc by disc, afterwards only in their averages."
            ),
            None => format!(
                " It stayed below {one_percent:.0e} m, 1 % of a radius: over these {time} s two \
                 correct programs may be compared disc by disc."
            ),
        };
        format!("{}: {}{reaches}", self.changed, self.growth(scenario))
    }

    fn growth(&self, scenario: &Scenario) -> String {
        let (Some(rate), Some(doubling)) = (self.rate_per_s, self.doubling_time_s) else {
            return format!(
                "no exponential growth in {} s; the distance was at most {:.1e} m.",
                scenario.time, self.largest_distance_m
            );
        };
        let end = if self.comparable_until_s.is_some() { "1 % of a radius" } else { "the end" };
        let mut words = format!(
            "the distance grows like exp({rate:.3} t), doubling every {doubling:.4} s (fitted from \
             {:.3} s, when it is 100 times the first one, to {end}, at {:.3} s).",
            self.fitted_from_s.unwrap_or_default(),
            self.fitted_until_s.unwrap_or_default()
        );
        if scenario.n() == 1 {
            words += " One disc meets no other: this is the time step's doing. The error of a \
                      bounce hangs on where in a step it begins. A larger --nt ends it.";
        }
        words
    }
}

/// What the growth comes from, for a box of several discs.
const CAUSES: &str = "Two causes mix. Round discs scatter a small difference, and no step does \
    away with that. And with a coarse step every bounce errs by where in a step it begins: compare \
    -n 1 with --nt 50 and --nt 1000.";

#[derive(Serialize)]
struct Report<'a> {
    n: usize,
    seed: u64,
    dt_s: f64,
    rows: &'a [TwinRow],
    twins: &'a [Twin],
}

pub(super) fn run(arguments: &DriftArguments) -> Result<ExitCode, Failure> {
    let scenario = twin_box(&arguments.settings(), &arguments.nt())?;
    memory::check(&scenario)?;
    let path = arguments.out_dir.join("twin.csv");
    files::probe(&arguments.out_dir, &["twin.csv"])?;
    let (mut simulation, mut copies) = twins(&scenario)?;
    let bar = progress_bar(scenario.steps(), arguments.quiet || arguments.json);
    let mut tell = |steps| bar.inc(steps);
    let distances = distances(&mut simulation, &mut copies, scenario.steps(), POINTS, &mut tell);
    bar.finish_and_clear();

    let changed = ["x of disc 0 moved by one bit", "dt longer by one bit"];
    let twins: Vec<Twin> = changed
        .into_iter()
        .zip(&distances)
        .map(|(changed, distances)| Twin::of(changed, distances, scenario.radius))
        .collect();
    let row = |&(time_s, distance_m)| TwinRow { time_s, distance_m };
    let rows: Vec<TwinRow> = distances[0].iter().map(row).collect();
    files::write(&path, &rows)?;

    let mut out = io::stdout().lock();
    if arguments.json {
        let Scenario { seed, .. } = scenario;
        let (n, dt_s) = (scenario.n(), scenario.dt());
        let report = Report { n, seed, dt_s, rows: &rows, twins: &twins };
        serde_json::to_writer(&mut out, &report).map_err(io::Error::from)?;
        writeln!(out)?;
    } else if !arguments.quiet {
        write_table(&mut out, &scenario, &distances)?;
        let mut words: Vec<String> = twins.iter().map(|twin| twin.words(&scenario)).collect();
        if scenario.n() > 1 && twins.iter().any(|twin| twin.rate_per_s.is_some()) {
            words.push(CAUSES.to_owned());
        }
        words::write(&mut out, &words)?;
    }
    out.flush()?;
    Ok(ExitCode::SUCCESS)
}

fn write_table(
    out: &mut impl Write,
    scenario: &Scenario,
    distances: &[Vec<(f64, f64)>],
) -> io::Result<()> {
    let (discs, radius, dt) =
        (counted(scenario.n(), "disc"), shortest(scenario.radius), time_step(scenario.dt()));
    writeln!(out, "Distance between two runs of {discs} of {radius} m, dt = {dt}\n")?;
    writeln!(out, "{:>10} {:>16} {:>16}", "time s", "x moved: m", "dt longer: m")?;
    let every = distances[0].len().div_ceil(PRINTED).max(1);
    for (moved, longer) in distances[0].iter().zip(&distances[1]).step_by(every) {
        writeln!(out, "{:>10.4} {:>16.2e} {:>16.2e}", moved.0, moved.1, longer.1)?;
    }
    writeln!(out)
}
