//! `parsim2d check`: the diagnosis of a scenario, without running it.

use std::io::{self, Write};
use std::process::ExitCode;

use serde_json::json;

use super::run::{RunArguments, scenario};
use super::wrapped::wrapped;
use super::{Failure, memory};
use crate::scenario::diagnosis::{CAVEAT, Diagnosis, cell};
use crate::scenario::finding::Verdict;
use crate::scenario::memory::bytes;
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
pub(super) fn check(arguments: &RunArguments) -> Result<ExitCode, Failure> {
    let mut lenient = arguments.clone();
    lenient.settings.allow_unstable = Some(true);
    let json = arguments.settings.json.unwrap_or(false);
    let diagnosis = scenario(&lenient).and_then(|(scenario, _)| {
        memory::check(&scenario)?;
        scenario.build()?; // places the discs: no change of the time step makes room for them
        Ok((scenario.diagnosis(), scenario.n() as f64 * scenario.steps() as f64))
    });
    let mut out = io::stdout().lock();
    match diagnosis {
        Ok((diagnosis, particle_steps)) => {
            match json {
                true => {
                    serde_json::to_writer(&mut out, &diagnosis).map_err(io::Error::from)?;
                    writeln!(out)?;
                }
                false => write_text(&mut out, &diagnosis, particle_steps)?,
            }
            let is_unstable = diagnosis.verdict == Verdict::Unstable;
            Ok(ExitCode::from(if is_unstable { 2 } else { 0 }))
        }
        Err(Failure::Scenario(error)) if json => {
            let (text, way_out) = (error.to_string(), error.way_out());
            let refused = json!({
                "verdict": "refused",
                "fault": error.fault(),
                "value": error.value(),
                "ways_out": way_out.into_iter().collect::<Vec<_>>(),
                "sentence": text.split("\n  way out").next(),
            });
            writeln!(out, "{refused}")?;
            Ok(ExitCode::from(2))
        }
        Err(failure) => Err(failure),
    }
}

fn write_text(out: &mut impl Write, diagnosis: &Diagnosis, particle_steps: f64) -> io::Result<()> {
    let Diagnosis { dt_s, speed_m_s, contact_end, .. } = diagnosis;
    writeln!(out, "{:<40} {:>11} {:>11}", "contact", "two discs", "wall")?;
    for figure in &diagnosis.figures {
        let [pair, wall] = [figure.pair, figure.wall].map(cell);
        let verdict = figure.verdict.map(|v| format!("   {v}")).unwrap_or_default();
        writeln!(out, "{:<40} {pair:>11} {wall:>11}{verdict}", figure.name)?;
    }
    writeln!(out, "a contact ends at {contact_end}; \"a fall\" is one at {speed_m_s:.3} m/s\n")?;

    let step = format!("largest time step, s (dt = {dt_s:.3e})");
    writeln!(out, "{step:<40} {:>11} {:>11}", "limit", "dt/limit")?;
    for limit in &diagnosis.limits {
        let [dt, fraction] = [Some(limit.dt_s), Some(limit.fraction)].map(cell);
        writeln!(out, "{:<40} {dt:>11} {fraction:>11}   {}", limit.by, limit.verdict)?;
    }
    writeln!(out, "{}", wrapped(CAVEAT, 80))?;
    let minutes = particle_steps / notes::USUAL_SPEED / 60.0;
    writeln!(out, "the run: {particle_steps:.1e} particle-steps, roughly {minutes:.1} minutes")?;
    writeln!(out, "memory: about {}\n", bytes(diagnosis.memory_bytes))?;

    writeln!(out, "{}: {}", diagnosis.verdict, diagnosis.sentence)?;
    for more in diagnosis.findings.iter().skip(1) {
        writeln!(out, "also {}: {}", more.verdict, more.sentence())?;
    }
    if diagnosis.verdict == Verdict::Unstable {
        writeln!(out, "`run` refuses this; --allow-unstable runs it anyway, for the lesson")?;
    }
    Ok(())
}
