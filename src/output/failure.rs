//! `failure.json`: what is known of a run that went wrong.

use std::fmt;
use std::io;
use std::path::Path;

use serde::Serialize;

use super::OutputError;
use super::replace::replace;
use crate::number::{energy, seconds};

/// Its name in the output folder.
pub const FILE: &str = "failure.json";

/// A post-mortem; the fields are the keys of the file.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[allow(non_snake_case)] // a key's name ends with its unit
pub struct FailureReport {
    /// Version of the program.
    pub version: &'static str,
    /// Seed of the run.
    pub seed: u64,
    /// What went wrong: not-finite, crossed, beyond-wall or energy-grown.
    pub kind: &'static str,
    /// The same in words.
    pub what: String,
    /// The first step after which it was so.
    pub step: u64,
    /// Its time, s.
    pub time_s: f64,
    /// Ids of the discs in question, from 0.
    pub discs: Vec<usize>,
    /// The wall in question, if there is one.
    pub wall: Option<&'static str>,
    /// The deepest overlap of these discs over the (smaller) radius.
    pub overlap_over_r: f64,
    /// Speed of the first of them, m/s.
    pub speed_m_per_s: f64,
    /// Mechanical energy at the start, J.
    pub energy_start_J: f64,
    /// The same a step before, J.
    pub energy_before_J: f64,
    /// The same at `step`, J.
    pub energy_after_J: f64,
    /// What damping took until then, J; less than nothing where it gave. Absent without a ledger.
    pub dissipated_J: Option<f64>,
    /// The sum of both, J.
    pub total_J: Option<f64>,
    /// The parameter at fault by the diagnosis, as its flag; absent if nothing was found.
    pub fault: Option<String>,
    /// Its value.
    pub value: Option<String>,
    /// What the diagnosis says.
    pub diagnosis: String,
    /// Changes that work.
    pub ways_out: Vec<String>,
    /// Whether the run was stopped at the step before; if not, it went on as asked.
    pub stopped: bool,
}

/// Whether `folder` holds one: its last run went wrong.
pub fn is_there(folder: &Path) -> bool {
    folder.join(FILE).exists()
}

impl FailureReport {
    /// Writes the report into `folder`.
    pub fn write(&self, folder: &Path) -> Result<(), OutputError> {
        replace(&folder.join(FILE), |out| {
            serde_json::to_writer_pretty(&mut *out, self)?;
            io::Write::write_all(out, b"\n")
        })
    }
}

/// The report for a person, several lines.
impl fmt::Display for FailureReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, step, time_s, energy_start_J, energy_before_J, energy_after_J, .. } = self;
        let damping = match self.dissipated_J {
            Some(took) if took >= 0.0 => {
                let sum = energy_after_J + took;
                format!("; with the {} that damping took, {}", energy(took), energy(sum))
            }
            Some(took) => format!("; damping gave {}, which it cannot", energy(-took)),
            None => String::new(),
        };
        writeln!(f, "the run went wrong at step {step}, t = {} s: {what}", seconds(*time_s, 6))?;
        writeln!(
            f,
            "  energy: {} at the start, {} a step before, then {}{damping}",
            energy(*energy_start_J),
            energy(*energy_before_J),
            energy(*energy_after_J)
        )?;
        match (&self.fault, &self.value) {
            (Some(fault), Some(value)) => {
                writeln!(f, "  the parameter at fault: {fault} = {value}")?;
                writeln!(f, "  why: {}", self.diagnosis)?;
            }
            _ => writeln!(f, "  {}", self.diagnosis)?,
        }
        if !self.ways_out.is_empty() {
            writeln!(f, "  ways out: {}", self.ways_out.join(", or "))?;
        }
        let kept = step.saturating_sub(1);
        match self.stopped {
            true => write!(
                f,
                "  kept: all files up to the last good step, {kept}, and {FILE} with these numbers\n  \
                 --allow-unstable lets a run go on past this, for the lesson"
            ),
            false => {
                write!(f, "  the run goes on, as --allow-unstable asks; {FILE} has these numbers")
            }
        }
    }
}
