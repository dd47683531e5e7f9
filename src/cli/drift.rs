//! `parsim2d drift`: does the total energy stay constant? Measured, then answered in words.

mod arguments;
mod findings;
mod table;
mod twin;
mod words;

use std::io::{self, Write};
use std::process::ExitCode;

use serde::Serialize;

pub(super) use self::arguments::DriftArguments;
use self::findings::{Findings, Outcome};
use super::failure::Failure;
use super::plot::{Target, plot_drift};
use super::terminal::progress_bar;
use crate::output::drift::{self as files, CurveRow, DriftRow};
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
