//! `parsim2d check`: the diagnosis of a scenario, without running it.

use std::io::{self, Write};
use std::process::ExitCode;

use anstream::AutoStream;
use clap::Command;
use clap::builder::styling::AnsiColor;
use serde_json::json;

use super::failure::Failure;
use super::memory;
use super::run::{RunArguments, scenario};
use super::say::say;
use super::wrapped::wrapped;
use crate::number::{at_most, bytes, counted};
use crate::scenario::diagnosis::{CAVEAT, Diagnosis, cell};
use crate::scenario::finding::Verdict;
use crate::scenario::notes;

pub(super) const EXAMPLES: &str = "\
Examples:
  parsim2d check                           the guide's run
  parsim2d check --eta 1.5e3               why this one is refused
  parsim2d check -n 1000 --nt 10 --json    for a script: keys verdict, fault, ways_out
  parsim2d check examples/settling.toml

Exit codes: 0 good or coarse, 2 unstable, or refused for another reason.";

/// Prints the diagnosis. What cannot be run for another reason than its time step is an error, which
/// `--json` puts into the same keys.
pub(super) fn check(arguments: &RunArguments, command: &Command) -> Result<ExitCode, Failure> {
    let mut lenient = arguments.clone();
    lenient.settings.allow_unstable = Some(true);
    let json = arguments.settings.json.unwrap_or(false);
    let diagnosis = scenario(&lenient, command).and_then(|(scenario, _)| {
        scenario.notes_on_file().iter().for_each(|note| say("note", note));
        memory::check(&scenario)?;
        scenario.build()?; // places the discs: no change of the time step makes room for them
        let particle_steps = scenario.n() as f64 * scenario.steps() as f64;
        Ok((scenario.diagnosis(), particle_steps, scenario.reading_of_the_guide()))
    });
    // Without colours where nobody sees them: in a pipe, with NO_COLOR.
    let mut out = AutoStream::auto(io::stdout().lock());
    match diagnosis {
        Ok((diagnosis, particle_steps, reading)) => {
            match json {
                true => {
                    serde_json::to_writer(&mut out, &diagnosis).map_err(io::Error::from)?;
                    writeln!(out)?;
                }
                false => write_text(&mut out, &diagnosis, particle_steps, reading.as_deref())?,
            }
            let is_unstable = diagnosis.verdict == Verdict::Unstable;
            Ok(ExitCode::from(if is_unstable { 2 } else { 0 }))
        }
        Err(Failure::Scenario(error)) if json => {
            let ways_out = error.way_out().into_iter().collect();
            let fault = (error.fault(), error.value());
            write_refusal(&mut out, &error.to_string(), fault, ways_out)
        }
        Err(Failure::Refused(refusal)) if json => {
            let file = arguments.scenario.as_deref().map(|file| file.display().to_string());
            let fault = (file.unwrap_or_default(), None);
            write_refusal(&mut out, &refusal.why, fault, vec![refusal.way_out])
        }
        Err(failure) => Err(failure),
    }
}

/// A refusal in the keys of a diagnosis; `fault` is a parameter and its value.
fn write_refusal(
    out: &mut impl Write,
    text: &str,
    fault: (String, Option<String>),
    ways_out: Vec<String>,
) -> Result<ExitCode, Failure> {
    let refused = json!({
        "verdict": "refused",
        "fault": fault.0,
        "value": fault.1,
        "ways_out": ways_out,
        "sentence": text.split("\n  way out").next(),
    });
    writeln!(out, "{refused}")?;
    Ok(ExitCode::from(2))
}

fn write_text(
    out: &mut impl Write,
    diagnosis: &Diagnosis,
    particle_steps: f64,
    reading: Option<&str>,
) -> io::Result<()> {
    let Diagnosis { dt_s, speed_m_s, contact_end, .. } = diagnosis;
    writeln!(out, "{:<40} {:>11} {:>11}", "contact", "two discs", "wall")?;
    for figure in &diagnosis.figures {
        let [pair, wall] = [figure.pair, figure.wall].map(cell);
        let verdict = figure.verdict.map(|v| format!("   {}", coloured(v))).unwrap_or_default();
        writeln!(out, "{:<40} {pair:>11} {wall:>11}{verdict}", figure.name)?;
    }
    writeln!(out, "a contact ends at {contact_end}; \"a fall\" is one at {speed_m_s:.3} m/s\n")?;

    let step = format!("largest time step, s (dt = {})", at_most(*dt_s, 5));
    writeln!(out, "{step:<40} {:>11} {:>11}", "limit", "dt/limit")?;
    for limit in &diagnosis.limits {
        let [dt, fraction] = [Some(limit.dt_s), Some(limit.fraction)].map(cell);
        writeln!(out, "{:<40} {dt:>11} {fraction:>11}   {}", limit.by, coloured(limit.verdict))?;
    }
    writeln!(out, "{}", wrapped(CAVEAT, 80))?;
    let time = rough_time(particle_steps / notes::USUAL_SPEED);
    writeln!(out, "the run: {particle_steps:.1e} particle-steps, {time}")?;
    writeln!(out, "memory: about {}\n", bytes(diagnosis.memory_bytes))?;

    if let Some(reading) = reading {
        writeln!(out, "{}\n", wrapped(&format!("the damping: {reading}"), 80))?;
    }
    writeln!(out, "{}: {}", coloured(diagnosis.verdict), diagnosis.sentence)?;
    for more in diagnosis.findings.iter().skip(1) {
        writeln!(out, "also {}: {}", coloured(more.verdict), more.sentence())?;
    }
    if diagnosis.verdict == Verdict::Unstable {
        writeln!(out, "`run` refuses this; --allow-unstable runs it anyway, for the lesson")?;
    }
    Ok(())
}

/// About so many `seconds` of wall time, in words.
fn rough_time(seconds: f64) -> String {
    match seconds {
        seconds if seconds < 1.0 => "under a second".to_owned(),
        seconds if seconds < 100.0 => {
            format!("roughly {}", counted(seconds.round() as usize, "second"))
        }
        seconds => format!("roughly {:.1} minutes", seconds / 60.0),
    }
}

/// The verdict in the colour of a traffic light.
fn coloured(verdict: Verdict) -> String {
    let colour = match verdict {
        Verdict::Good => AnsiColor::Green,
        Verdict::Coarse => AnsiColor::Yellow,
        Verdict::Unstable => AnsiColor::Red,
    };
    let style = colour.on_default();
    format!("{style}{verdict}{style:#}")
}
