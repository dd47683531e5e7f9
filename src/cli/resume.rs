//! `parsim2d resume`: go on from a checkpoint, and end with the same bits as a run never interrupted.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;

use super::Failure;
use super::interrupt::Interrupt;
use super::keeper::Origin;
use super::run::conclude;
use super::stepping::Stepping;
use super::typed::{quoted, with_new_end};
use crate::analysis::energy::MechanicalEnergy;
use crate::analysis::guard::Memory;
use crate::output::OutputError;
use crate::output::checkpoint::container::Flaw;
use crate::output::checkpoint::{self, Checkpoint, CheckpointError, Progress};
use crate::output::recorder::Recorder;
use crate::scenario::Scenario;
use crate::scenario::quantity::{Number, Quantity, Time};
use crate::scenario::settings::Settings;
use crate::simulation::state::Array;
use crate::simulation::{Simulation, State};

pub(super) const EXAMPLES: &str = "\
Examples:
  parsim2d resume parsim2d.ckpt            go on after Ctrl-C, kill or a power cut
  parsim2d resume parsim2d.ckpt --time 2s  the same run to a later end
  parsim2d resume parsim2d.previous.ckpt   the one before, if the latest is damaged
  parsim2d resume a/parsim2d.ckpt --out-dir b  go on in b; a stays as it is

The files of the run must lie beside the checkpoint. They are cut back to its moment and continued, and
end as if the run had never been interrupted. Physics cannot be changed on the way: start a run of its
own with --start trajectory.txt.";

#[derive(Args)]
pub(super) struct ResumeArguments {
    /// The checkpoint, or the folder it lies in
    #[arg(value_name = "FILE", default_value = checkpoint::FILE)]
    file: PathBuf,
    /// A new end, simulated time [default: that of the run]
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true)]
    time: Option<Quantity<Time>>,
    /// Folder to go on in; the files of the run are copied there [default: that of the checkpoint]
    #[arg(long, value_name = "DIR")]
    out_dir: Option<PathBuf>,
    /// Write a checkpoint every so many seconds of wall time [default: as the run did]
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true)]
    checkpoint_every: Option<Quantity<Time>>,
    /// Seconds of wall time for a simulated second [default: as the run did]
    #[arg(long, value_name = "X", allow_hyphen_values = true)]
    slowdown: Option<Quantity<Number>>,
    /// Threads that share the steps; the results are the same to the bit [default: as the run did]
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    threads: Option<i64>,
    /// Summary as one JSON object on stdout [default: as the run did]
    #[arg(long)]
    json: bool,
    /// No progress bar, no remarks, no text summary [default: as the run did]
    #[arg(short, long)]
    quiet: bool,
}

impl ResumeArguments {
    /// What is said now, as settings over those of the run that go on in `folder`. How a run is computed,
    /// and not what, may be said here too.
    fn changes(&self, folder: &Path) -> Settings {
        Settings {
            time: self.time,
            out_dir: Some(self.out_dir.clone().unwrap_or_else(|| folder.to_owned())),
            checkpoint_every: self.checkpoint_every,
            slowdown: self.slowdown,
            threads: self.threads,
            json: self.json.then_some(true),
            quiet: self.quiet.then_some(true),
            ..Settings::default()
        }
    }
}

/// Why a run cannot go on, and what can be done.
#[derive(Debug, thiserror::Error)]
#[error("{why}\n  way out: {way_out}")]
pub(super) struct ResumeError {
    why: String,
    way_out: String,
}

pub(super) fn resume(arguments: &ResumeArguments) -> Result<ExitCode, Failure> {
    let interrupt = Interrupt::listen();
    let file = match arguments.file.is_dir() {
        true => arguments.file.join(checkpoint::FILE),
        false => arguments.file.clone(),
    };
    let from = file.parent().filter(|folder| !folder.as_os_str().is_empty());
    let from = from.unwrap_or(Path::new("."));
    let checkpoint = Checkpoint::read(&file).map_err(|why| unreadable(&file, &why))?;
    let Checkpoint { scenario: text, progress, mut arrays } = checkpoint;
    let progress = &progress;
    let changes = arguments.changes(from);
    let (scenario, has_new_end) =
        Scenario::continued(&text, &mut arrays, &progress.written, changes)?;
    let simulation = simulation(&scenario, progress, arrays)
        .map_err(|why| refusal(&file, format!("cannot resume from {}: {why}", file.display())))?;
    check_end(&scenario, progress)?;
    interrupt.finish_files_first();
    let plan = scenario.continued_plan(&progress.written)?;
    let recorder = Recorder::resume(&plan, &simulation, from, &progress.written)
        .map_err(|why| other_or(&file, why))?;
    say_where(&scenario, progress, &file);
    let origin = Origin {
        command: match has_new_end {
            true => with_new_end(&progress.command, scenario.time, &progress.written),
            false => progress.command.clone(),
        },
        overlap: progress.overlap_at_start,
    };
    // Only the latest checkpoint of the folder may become the previous one.
    let is_latest = file.file_name().is_some_and(|name| name == checkpoint::FILE);
    let last = (is_latest && arguments.out_dir.is_none()).then_some(progress.step);
    let stepping =
        Stepping::resume(&scenario, simulation, recorder, origin, memory(progress), last);
    conclude(stepping, &interrupt)
}

/// The simulation of `scenario` in the state that the checkpoint of this `progress` has in its `arrays`, or
/// why they do not fit.
fn simulation(
    scenario: &Scenario,
    progress: &Progress,
    arrays: Vec<(String, Array)>,
) -> Result<Simulation, String> {
    let state = State::from_arrays(arrays)?;
    let particles = state.particles();
    let (n, said) = (particles.len(), scenario.n());
    if n != said {
        return Err(format!("it has {n} discs, its scenario says {said}"));
    }
    let mut simulation = scenario.assemble(particles, state.is_of_crowd());
    simulation.set_state(&state);
    if simulation.works().is_some() != progress.written.energy.is_some() {
        return Err("it has an energy ledger without works, or works without a ledger".to_owned());
    }
    let hash = format!("{:016x}", simulation.state_hash());
    let is_that_time = simulation.time().to_bits() == progress.time_s.to_bits();
    if simulation.steps() != progress.step || hash != progress.state_hash || !is_that_time {
        let (step, then) = (simulation.steps(), &progress.state_hash);
        return Err(format!(
            "its state has step {step} and fingerprint {hash} at t = {:?} s, it says step {}, {then}, \
             t = {:?} s",
            simulation.time(),
            progress.step,
            progress.time_s
        ));
    }
    Ok(simulation)
}

/// The new end must not lie before the checkpoint.
fn check_end(scenario: &Scenario, progress: &Progress) -> Result<(), Failure> {
    if scenario.steps() >= progress.step {
        return Ok(());
    }
    let (end, now) = (scenario.time, progress.time_s);
    Err(Failure::Resume(ResumeError {
        why: format!("--time = {end:?} s is before the checkpoint, which is at t = {now:?} s"),
        way_out: "a later --time, an earlier checkpoint, or a new run".to_owned(),
    }))
}

/// What the guard of the run remembers.
fn memory(progress: &Progress) -> Memory {
    let start = MechanicalEnergy {
        kinetic: progress.kinetic_at_start_J,
        gravitational: progress.gravitational_at_start_J,
        elastic: progress.elastic_at_start_J,
    };
    Memory { start, movable: progress.movable_at_start_J, grown_at: progress.grown_at }
}

fn say_where(scenario: &Scenario, progress: &Progress, file: &Path) {
    if scenario.output.quiet {
        return;
    }
    let (step, steps, time) = (progress.step, scenario.steps(), progress.time_s);
    let said = match step < steps {
        true => format!("going on from step {step} of {steps}, t = {time:.6} s"),
        false => format!(
            "nothing is left to do: the run has reached its end, step {step}, t = {time:.6} s; to prolong \
             it: parsim2d resume {} --time {:?}",
            quoted(&file.to_string_lossy()),
            2.0 * scenario.time
        ),
    };
    let _ = writeln!(io::stderr(), "note: {said}"); // a closed stderr is no failure
}

fn unreadable(file: &Path, why: &CheckpointError) -> Failure {
    match why {
        CheckpointError::Flawed { flaw: Flaw::OtherFormat(_), .. } => {
            Failure::Resume(ResumeError {
                why: why.to_string(),
                way_out: "continue it with the version of parsim2d that wrote it".to_owned(),
            })
        }
        _ => refusal(file, why.to_string()),
    }
}

/// A refusal with the other checkpoint of the folder as a way out, if that is whole.
fn refusal(file: &Path, why: String) -> Failure {
    let other = match file.file_name().is_some_and(|name| name == checkpoint::PREVIOUS) {
        true => checkpoint::FILE,
        false => checkpoint::PREVIOUS,
    };
    let other = file.with_file_name(other);
    let way_out = match Checkpoint::read(&other) {
        Ok(whole) => format!(
            "the other checkpoint there is whole, step {}: parsim2d resume {}",
            whole.progress.step,
            quoted(&other.to_string_lossy())
        ),
        Err(_) if !file.exists() => {
            "name the checkpoint, parsim2d.ckpt, or the folder it lies in; it is written on Ctrl-C and by \
             --checkpoint-every"
                .to_owned()
        }
        Err(_) => "there is no other whole checkpoint beside it; run the scenario again".to_owned(),
    };
    Failure::Resume(ResumeError { why, way_out })
}

/// Files that are not those of the run may still fit the other checkpoint.
fn other_or(file: &Path, why: OutputError) -> Failure {
    match why {
        OutputError::NotOfThatRun { .. } if file.with_file_name(checkpoint::PREVIOUS) != file => {
            refusal(file, why.to_string())
        }
        why => Failure::Output(why),
    }
}
