//! `parsim2d resume`: go on from a checkpoint, and end with the same bits as a run never interrupted.

pub(super) mod flags;
mod refused;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;

use self::refused::{is_done, not_continued, unfit, unreadable};
use super::claim::Claim;
use super::failure::Failure;
use super::file_kind::FileKind;
use super::interrupt::Interrupt;
use super::memory;
use super::refusal::Refusal;
use super::run::{conclude, say_all};
use super::say::say;
use super::terminal::Terminal;
use super::typed::{quoted, with_new_end};
use crate::analysis::energy::MechanicalEnergy;
use crate::analysis::guard::Memory;
use crate::number::{counted, seconds};
use crate::output::checkpoint::{self, Checkpoint, Progress};
use crate::output::place::{folder_of, is_same};
use crate::output::record;
use crate::output::recorder::Recorder;
use crate::scenario::Scenario;
use crate::scenario::quantity::{Number, Quantity, Time, thread_count};
use crate::scenario::settings::Settings;
use crate::session::Session;
use crate::session::checkpoints::Origin;
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
own from a frame, which has positions, velocities, radii and masses (out.txt has not: x y r only), as
  parsim2d last-run.toml --start trajectory.txt --out-dir next --nt 100";

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
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = thread_count)]
    threads: Option<i64>,
    /// Summary as one JSON object on stdout [default: as the run did]
    #[arg(long, num_args = 0..=1, default_missing_value = "true", require_equals = true)]
    #[arg(value_name = "BOOL", hide_possible_values = true)]
    json: Option<bool>,
    /// No progress bar, no remarks, no text summary
    #[arg(short, long, num_args = 0..=1, default_missing_value = "true", require_equals = true)]
    #[arg(value_name = "BOOL", hide_possible_values = true)]
    quiet: Option<bool>,
}

impl ResumeArguments {
    /// The checkpoint that was named, by its folder or itself; what is none is told by what it is.
    fn checkpoint(&self) -> Result<PathBuf, Failure> {
        let file = match self.file.is_dir() {
            true => self.file.join(checkpoint::FILE),
            false => self.file.clone(),
        };
        // A damaged checkpoint may look like anything.
        let is_named_so = file.extension().is_some_and(|ending| ending == "ckpt");
        match FileKind::of(&file) {
            Some(kind) if kind != FileKind::Checkpoint && !is_named_so => {
                Err(Failure::Refused(kind.in_place_of("a checkpoint", &file)))
            }
            _ => Ok(file),
        }
    }

    /// Quiet is a matter of this command: whoever goes on with a run may be another than who began it.
    fn is_quiet(&self) -> bool {
        self.quiet.unwrap_or(false)
    }

    /// What is said now, as settings over those of the run that go on in `folder`. How a run is computed,
    /// and not what, may be said here too.
    fn changes(&self, folder: &Path) -> Settings {
        Settings {
            time: self.time,
            out_dir: Some(self.out_dir.clone().unwrap_or_else(|| folder.to_owned())),
            checkpoint_every: self.checkpoint_every,
            slowdown: self.slowdown,
            threads: self.threads,
            json: self.json,
            quiet: Some(self.is_quiet()),
            ..Settings::default()
        }
    }
}

pub(super) fn resume(arguments: &ResumeArguments) -> Result<ExitCode, Failure> {
    let interrupt = Interrupt::listen();
    let file = arguments.checkpoint()?;
    let from = folder_of(&file);
    let folder = arguments.out_dir.as_deref().unwrap_or(from);
    let mut claim = match arguments.out_dir.is_none() || is_same(from, folder) {
        true => Claim::of_same_run(from)?,
        false => Claim::of_new_run(folder)?,
    };
    if let Some(said) = is_done(&file).filter(|_| arguments.time.is_none()) {
        return Ok(nothing_to_do(&said, arguments.is_quiet()));
    }
    let checkpoint = Checkpoint::read(&file).map_err(|why| unreadable(&file, &why))?;
    let Checkpoint { scenario: text, progress, mut arrays } = checkpoint;
    let progress = &progress;
    let changes = arguments.changes(from);
    let (scenario, has_new_end) =
        Scenario::continued(&text, &mut arrays, &progress.written, changes)?;
    memory::check(&scenario)?;
    let simulation = simulation(&scenario, progress, arrays).map_err(|why| unfit(&file, &why))?;
    check_end(&scenario, progress)?;
    let plan = scenario.continued_plan(&progress.written)?;
    progress.written.check(from).map_err(|why| not_continued(&file, why))?;
    let note = claim.complete()?;
    interrupt.finish_files_first();
    let recorder = Recorder::resume(&plan, &simulation, from, &progress.written)
        .map_err(|why| not_continued(&file, why))?;
    say_all(&scenario, note.as_slice());
    say_where(&scenario, progress, &file);
    let origin = origin(&scenario, progress, has_new_end, folder);
    // Only the latest checkpoint of the folder may become the previous one.
    let is_latest = file.file_name().is_some_and(|name| name == checkpoint::FILE);
    let last = (is_latest && arguments.out_dir.is_none()).then_some(progress.step);
    let past = Some((memory(progress), last));
    let mut session = Session::new(&scenario, simulation, Some(recorder), origin, past);
    if has_new_end {
        session.keep_end(&mut Terminal::of(&session, &interrupt));
    }
    conclude(session, &interrupt)
}

/// What the run that goes on in `folder` was begun with.
fn origin(scenario: &Scenario, progress: &Progress, has_new_end: bool, folder: &Path) -> Origin {
    Origin {
        command: match has_new_end {
            true => with_new_end(&progress.command, scenario.time, &progress.written),
            false => progress.command.clone(),
        },
        overlap: progress.overlap_at_start,
        resumed: Some(folder.join(record::FILE)),
    }
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
        return Err(format!("it has {}, its scenario says {said}", counted(n, "disc")));
    }
    let mut simulation = scenario.assemble(particles, state.is_of_engine());
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

/// The run has reached its end and left no checkpoint.
fn nothing_to_do(said: &Refusal, is_quiet: bool) -> ExitCode {
    if !is_quiet {
        say("note", format!("nothing is left to do: {said}"));
    }
    ExitCode::SUCCESS
}

/// The new end must not lie before the checkpoint.
fn check_end(scenario: &Scenario, progress: &Progress) -> Result<(), Failure> {
    if scenario.steps() >= progress.step {
        return Ok(());
    }
    let (end, now) = (scenario.time, progress.time_s);
    Err(Failure::Refused(Refusal {
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
    Memory {
        start,
        movable: progress.movable_at_start_J,
        supplied: progress.supplied_at_start_J,
        grown_at: progress.grown_at,
    }
}

fn say_where(scenario: &Scenario, progress: &Progress, file: &Path) {
    if scenario.output.quiet {
        return;
    }
    let (step, steps, time) = (progress.step, scenario.steps(), progress.time_s);
    let said = match step < steps {
        true => format!("going on from step {step} of {steps}, t = {} s", seconds(time, 6)),
        false => format!(
            "nothing is left to do: the run has reached its end, step {step}, t = {} s; to prolong \
             it: parsim2d resume {} --time {:?}",
            seconds(time, 6),
            quoted(&file.to_string_lossy()),
            2.0 * scenario.time
        ),
    };
    say("note", said);
}
