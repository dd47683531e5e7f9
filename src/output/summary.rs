//! The summary of a run: a few lines for a person, or one JSON object for a machine.

use std::io::{self, Write};

use serde::Serialize;

use crate::analysis::answer::Answer;
use crate::number::{at_most, bytes, counted, energy, seconds, signed, significant, time_step};

/// Discs from which on a person may want to know the memory.
const MANY: usize = 10_000;

/// What a finished run says of itself; the fields are the keys of `--json`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[allow(non_snake_case)] // a key's name ends with its unit
pub struct Summary {
    /// Version of the program.
    pub version: &'static str,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Number of discs.
    pub n: usize,
    /// Preset the run started from.
    pub preset: &'static str,
    /// Time integrator.
    pub integrator: &'static str,
    /// Time step, s.
    pub dt_s: f64,
    /// What set it: nt, dt, auto or preset.
    pub dt_set_by: &'static str,
    /// Steps in a wall contact, pi sqrt(m / k_n) / dt.
    pub steps_per_contact: f64,
    /// Steps done.
    pub steps: u64,
    /// Simulated time, s.
    pub time_s: f64,
    /// Wall time, s.
    pub wall_s: f64,
    /// Threads.
    pub threads: usize,
    /// Lists of near pairs made, where discs are many enough for it to matter.
    pub list_rebuilds: u64,
    /// Speed of the stepping with its ledger, the guard and what was written on the way (live frames aside).
    pub particle_steps_per_s: f64,
    /// The most memory held at once, MB; absent where the system does not tell it.
    pub peak_memory_MB: Option<f64>,
    /// Mechanical energy at the start, J.
    pub energy_start_J: f64,
    /// Mechanical energy at the end, J.
    pub energy_end_J: f64,
    /// Energy the dashpots took, J; absent without the ledger.
    pub dissipated_J: Option<f64>,
    /// Change of the total, what the dashpots took included, J: the integration error. Absent without
    /// the ledger.
    pub energy_error_J: Option<f64>,
    /// Largest overlap of the run over the (smaller) radius.
    pub max_overlap_over_r: f64,
    /// Fingerprint of the final state, 16 hexadecimal digits.
    pub state_hash: String,
    /// Whether the run was stopped before its end.
    pub interrupted: bool,
    /// What went wrong, if something did: not-finite, crossed, beyond-wall or energy-grown.
    pub went_wrong: Option<&'static str>,
    /// The first step after which it was so.
    pub went_wrong_at_step: Option<u64>,
    /// Theory beside measurement, for runs of one or two discs where there is one.
    #[serde(skip_serializing_if = "Answer::is_empty")]
    pub answer: Answer,
}

impl Summary {
    /// What came out of the run, without anything that depends on the machine: `NAME = VALUE`.
    pub fn results(&self) -> Vec<String> {
        let mut results = vec![
            format!("version = {}", self.version),
            format!("steps = {}", self.steps),
            format!("time_s = {}", self.time_s),
            format!("energy_start_J = {:e}", self.energy_start_J),
            format!("energy_end_J = {:e}", self.energy_end_J),
        ];
        results.extend(self.dissipated_J.map(|took| format!("dissipated_J = {took:e}")));
        results.extend(self.energy_error_J.map(|error| format!("energy_error_J = {error:e}")));
        results.push(format!("max_overlap_over_r = {}", self.max_overlap_over_r));
        results.push(format!("state_hash = {}", self.state_hash));
        if let (Some(what), Some(step)) = (self.went_wrong, self.went_wrong_at_step) {
            results.push(format!("went_wrong = {what} at step {step}"));
        }
        if self.interrupted {
            results.push("interrupted = true".to_owned());
        }
        results
    }

    /// Writes the summary as one JSON object on one line.
    pub fn write_json(&self, out: &mut impl Write) -> io::Result<()> {
        serde_json::to_writer(&mut *out, self)?;
        writeln!(out)
    }

    /// Writes the summary for a person. `remark` is put after the largest overlap.
    pub fn write_text(&self, out: &mut impl Write, remark: Option<&str>) -> io::Result<()> {
        let Self { seed, n, preset, integrator, dt_s, steps, time_s, wall_s, .. } = self;
        let stopped = match (self.interrupted, self.went_wrong_at_step) {
            (true, _) => ", interrupted".to_owned(),
            (_, Some(step)) if step > *steps => ", stopped: it went wrong".to_owned(),
            (_, Some(step)) => format!(", wrong from step {step} on"),
            _ => String::new(),
        };
        let speed = 1e-6 * self.particle_steps_per_s;
        let dissipated = self.dissipated_J.map(|d| format!(", {} dissipated", energy(d)));
        writeln!(out, "n        {}, preset {preset}, seed {seed}", counted(*n, "disc"))?;
        writeln!(out, "dt       {} ({}), {integrator}", time_step(*dt_s), self.who_set_dt())?;
        let steps = counted(*steps as usize, "step");
        writeln!(out, "run      {steps} to t = {} s{stopped}", seconds(*time_s, 6))?;
        let threads = match self.threads {
            1 => String::new(),
            threads => format!(" on {threads} threads"),
        };
        writeln!(
            out,
            "speed    {wall_s:.2} s wall time, {speed:.3} million particle-steps/s{threads}"
        )?;
        if let Some(memory) = self.peak_memory_MB.filter(|_| *n >= MANY) {
            writeln!(out, "memory   at most {}", bytes((1e6 * memory) as u64))?;
        }
        let start = self.energy_start_J;
        write!(out, "energy   {} at start, {} at end", energy(start), energy(self.energy_end_J))?;
        writeln!(out, "{}", dissipated.unwrap_or_default())?;
        if let Some(error) = self.energy_error_J.filter(|error| error.is_finite()) {
            let percent = signed(100.0 * error / start.abs(), 3);
            let share = if start == 0.0 { "" } else { &format!(", {percent} % of the start") };
            let error = signed(error, 3);
            writeln!(out, "error    the total changed by {error} J{share} (integration error)")?;
        }
        write!(out, "overlap  at most {} r", significant(self.max_overlap_over_r, 3))?;
        writeln!(out, "{}", remark.unwrap_or_default())?;
        writeln!(out, "state    {}", self.state_hash)
    }

    fn who_set_dt(&self) -> String {
        let nt = at_most(self.steps_per_contact, 6); // 50, not 49.99999999999999
        match self.dt_set_by {
            "nt" => format!("Eq. (2), N_t = {nt} set by --nt"),
            "dt" => format!("set by --dt, N_t = {nt}"),
            "auto" => format!("set by --dt auto, N_t = {nt}"),
            _ => format!("Eq. (2), N_t = {nt} set by the preset"),
        }
    }
}
