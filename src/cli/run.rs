//! `parsim2d run`: place the discs, step, write, report.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, Command};
use glam::DVec2;
use rand::TryRng;

use super::claim::{Claim, keep_start};
use super::failure::Failure;
use super::file_kind::{FileKind, near_scenario};
use super::interrupt::Interrupt;
use super::mistyped::unknown_command;
use super::terminal::{Terminal, placing_spinner};
use super::typed::{self, quoted, shown};
use super::{answer, memory, say};
use crate::analysis::energy::MechanicalEnergy;
use crate::output::OutputError;
use crate::output::failure::FailureReport;
use crate::output::recorder::Recorder;
use crate::output::summary::Summary;
use crate::output::{record, wants_room};
use crate::scenario::error::ScenarioError;
use crate::scenario::finding::Matter;
use crate::scenario::settings::Settings;
use crate::scenario::{Scenario, file, judgement, post_mortem};
use crate::session::Session;
use crate::session::checkpoints::{Checkpoints, Origin};

#[derive(Args, Clone)]
pub(super) struct RunArguments {
    /// Scenario file (TOML); flags override it
    #[arg(value_name = "SCENARIO.toml")]
    pub(super) scenario: Option<PathBuf>,
    #[command(flatten)]
    pub(super) settings: Settings,
    /// Print every choice of the run as a scenario file, and do not run
    #[arg(long, help_heading = "Output")]
    print_config: bool,
}

pub(super) fn run(arguments: &RunArguments, command: &Command) -> Result<ExitCode, Failure> {
    let (scenario, seed_was_drawn) = scenario(arguments, command)?;
    if arguments.print_config {
        io::stdout().write_all(scenario.to_toml().as_bytes())?;
        return Ok(ExitCode::SUCCESS);
    }
    memory::check(&scenario)?;
    let interrupt = Interrupt::listen();
    let mut claim = Claim::of_new_run(&scenario.output.folder)?;
    keep_start(&scenario)?;
    let spinner = placing_spinner(scenario.output.quiet);
    let discs = scenario.place()?;
    // What the discs at the start have to say, before they are handed over: the engine stores them anew.
    let record = scenario.record(&discs);
    let notes = if scenario.output.quiet { Vec::new() } else { scenario.notes(&discs) };
    let mut simulation = scenario.build_of(discs);
    spinner.finish_and_clear();
    let note = claim.complete()?;
    interrupt.finish_files_first();
    let plan = scenario.output_plan_with(record);
    let recorder = Recorder::create(&plan, &mut simulation)?;
    say_all(&scenario, note.as_slice());
    say_notes(&scenario, &notes, seed_was_drawn);
    let overlap = simulation.largest_overlap();
    let command = typed::words_with(seed_was_drawn.then_some(scenario.seed));
    let origin = Origin { command, overlap, resumed: None };
    conclude(Session::new(&scenario, simulation, Some(recorder), origin, None), &interrupt)
}

/// Steps to the end and reports.
pub(super) fn conclude(mut session: Session, interrupt: &Interrupt) -> Result<ExitCode, Failure> {
    let scenario = session.scenario;
    let mut terminal = Terminal::of(&session, interrupt);
    let done = session.run(&mut terminal);
    drop(terminal);
    if let Err(failure) = done {
        if let Some(way_back) = way_back(&session.checkpoints) {
            let when = match &failure {
                OutputError::Write { source, .. } if !wants_room(source) => {
                    "once it can be written"
                }
                _ => "once there is room",
            };
            say(scenario, &format!("{when}, {way_back}"));
        }
        return Err(failure.into());
    }
    let summary = summary(scenario, &session);
    let command = format!("{} = {}", record::COMMAND, typed::line(&session.origin.command));
    session.record_results(&[vec![command], summary.results()].concat())?;
    let velocities = answer::velocities(scenario, session.simulation());
    match report(scenario, &summary, session.origin.overlap, &velocities) {
        Err(error) if is_unheard(&error) => {}
        done => done?,
    }
    match &session.failure {
        Some(failure) if failure.stopped => {
            let again = session.origin.resumed.as_deref().map(|path| new_run(path, failure));
            return Err(Failure::WentWrong { report: Box::new(failure.clone()), again });
        }
        Some(failure) => say(scenario, &failure.to_string()),
        None => {}
    }
    if session.is_done() {
        return Ok(ExitCode::SUCCESS);
    }
    let way_back = way_back(&session.checkpoints);
    let way_back = way_back.unwrap_or("no good state was left to go on from".to_owned());
    say(scenario, &format!("interrupted; {way_back}"));
    Ok(ExitCode::from(130))
}

/// How to go on from the latest of these checkpoints, if there is one.
fn way_back(checkpoints: &Checkpoints) -> Option<String> {
    let (path, step) = checkpoints.latest()?;
    Some(format!("to go on from step {step}: parsim2d resume {}", quoted(&shown(&path))))
}

/// Whether nobody listens any more: a pipe or a terminal was closed.
fn is_unheard(error: &io::Error) -> bool {
    const EIO: i32 = 5; // on every Unix; what writing to a closed terminal gives
    error.kind() == io::ErrorKind::BrokenPipe || cfg!(unix) && error.raw_os_error() == Some(EIO)
}

/// Where to give the flags that the `failure` of a resumed run names: `resume` takes none of them.
fn new_run(record: &Path, failure: &FailureReport) -> String {
    let flags = failure.ways_out.iter().find(|way| way.starts_with("--"));
    let flags = flags.map_or("--allow-unstable", |way| post_mortem::flags(way));
    let record = quoted(&shown(record));
    format!(
        "\n  `resume` cannot change them, a new run can: parsim2d {record} --out-dir again {flags}"
    )
}

/// Remarks on standard error.
pub(super) fn say_all(scenario: &Scenario, notes: &[String]) {
    notes.iter().for_each(|note| say(scenario, note));
}

/// A remark on standard error.
fn say(scenario: &Scenario, what: &str) {
    if !scenario.output.quiet {
        say::say("note", what);
    }
}

/// The scenario file at `path`; what is none is told by what it is.
fn read(path: &Path) -> Result<Settings, Failure> {
    file::read(path).map_err(|why| match FileKind::of(path) {
        Some(kind) => Failure::Refused(kind.in_place_of("a scenario", path)),
        None => near_scenario(path).map_or(why.into(), Failure::Refused),
    })
}

/// Flags over file over preset; and whether a seed was drawn that matters.
pub(super) fn scenario(
    arguments: &RunArguments,
    command: &Command,
) -> Result<(Scenario, bool), Failure> {
    let said = match &arguments.scenario {
        // `radius=0.5mm` has an ending, and is no file.
        Some(path) if (path.extension().is_none() || is_assignment(path)) && !path.exists() => {
            return Err(unknown_command(command, &path.to_string_lossy()));
        }
        Some(path) => arguments.settings.clone().over(read(path)?),
        None => arguments.settings.clone(),
    };
    let scenario = Scenario::resolve(&said, drawn_seed).map_err(|why| match &why {
        ScenarioError::BadStart { path, .. } => match FileKind::of(path) {
            Some(kind) if kind != FileKind::Frames => {
                Failure::Refused(kind.in_place_of("a file of frames", path))
            }
            _ => why.into(),
        },
        _ => why.into(),
    })?;
    let was_drawn = said.seed.is_none() && scenario.is_random();
    Ok((scenario, was_drawn))
}

/// Whether `path` is rather `KEY=VALUE` than a file.
fn is_assignment(path: &Path) -> bool {
    path.to_string_lossy().split_once('=').is_some_and(|(key, _)| !key.contains(['/', '.']))
}

/// A seed from the operating system, short enough to type.
fn drawn_seed() -> u64 {
    let drawn = rand::rngs::SysRng.try_next_u32();
    // Without the system's random numbers any seed will do: it is printed.
    u64::from(drawn.unwrap_or_else(|_| std::process::id()))
}

/// The seed shares a line with the first note: a usual run has one line of notes.
fn say_notes(scenario: &Scenario, notes: &[String], seed_was_drawn: bool) {
    let seed = scenario.seed;
    let drawn =
        seed_was_drawn.then(|| format!("seed {seed}, drawn; --seed {seed} repeats this run"));
    match (drawn, notes) {
        (Some(drawn), [first, rest @ ..]) => {
            say(scenario, &format!("{drawn}; {first}"));
            say_all(scenario, rest);
        }
        (Some(drawn), []) => say(scenario, &drawn),
        (None, notes) => say_all(scenario, notes),
    }
}

fn summary(scenario: &Scenario, session: &Session) -> Summary {
    let Session { pace, failure, .. } = session;
    let simulation = session.simulation();
    let start = session.energy_at_start();
    let n = simulation.n();
    let particle_steps = n as f64 * pace.steps(simulation) as f64;
    let end = MechanicalEnergy::of(simulation).total();
    let (dissipated, supplied) = match simulation.works() {
        Some(works) => (Some(works.dissipated()), works.supplied()),
        None => (None, 0.0),
    };
    Summary {
        version: env!("CARGO_PKG_VERSION"),
        seed: scenario.seed,
        n,
        preset: scenario.preset.name(),
        integrator: scenario.integrator.name(),
        dt_s: simulation.dt(),
        dt_set_by: scenario.dt_set_by.name(),
        steps_per_contact: scenario.steps_per_contact(),
        steps: simulation.steps(),
        time_s: simulation.time(),
        wall_s: pace.wall_time(),
        threads: scenario.threads(),
        list_rebuilds: simulation.lists_made(),
        particle_steps_per_s: particle_steps / pace.stepping_time().max(1e-9),
        peak_memory_MB: memory::peak_memory(),
        energy_start_J: start,
        energy_end_J: end,
        dissipated_J: dissipated,
        energy_error_J: dissipated.map(|dissipated| end + dissipated - supplied - start),
        max_overlap_over_r: simulation.largest_overlap(),
        state_hash: format!("{:016x}", simulation.state_hash()),
        interrupted: simulation.steps() < scenario.steps() && !session.is_stopped(),
        went_wrong: failure.as_ref().map(|failure| failure.kind),
        went_wrong_at_step: failure.as_ref().map(|failure| failure.step),
        answer: answer::of(scenario),
    }
}

fn report(
    scenario: &Scenario,
    summary: &Summary,
    start_overlap: f64,
    velocities: &[[DVec2; 2]],
) -> io::Result<()> {
    let mut out = io::stdout().lock();
    if scenario.output.json {
        summary.write_json(&mut out)?;
    } else if !scenario.output.quiet {
        summary.write_text(&mut out, remark(scenario, summary, start_overlap).as_deref())?;
        answer::write(&mut out, &summary.answer)?;
        answer::write_velocities(&mut out, velocities)?;
    }
    out.flush()
}

/// Overlap, in radii, at which the centres of two equal discs meet: they may have passed through each other.
const CENTRES_MEET: f64 = 2.0;

/// What to say after the largest overlap; at the start it was `start`. In a run whose energy went astray softness is not the
/// cause, and is not blamed.
fn remark(scenario: &Scenario, summary: &Summary, start: f64) -> Option<String> {
    let (overlap, growth) =
        (summary.max_overlap_over_r, summary.energy_end_J / summary.energy_start_J.abs());
    if !summary.energy_end_J.is_finite() {
        return Some("; the numbers have overflowed, this run says nothing".to_owned());
    }
    if growth > 2.0 && summary.energy_start_J != 0.0 {
        return Some(format!(
            "; the energy has grown {growth:.1e}-fold: the time step or the integrator is at \
             fault; try --integrator symplectic-euler --dt auto"
        ));
    }
    if summary.went_wrong.is_some() || overlap <= judgement::SOFT {
        return None;
    }
    if overlap <= start {
        return Some(": that of the start".to_owned());
    }
    // One number only: the one that was told before the run.
    let findings = scenario.findings();
    let told = findings.into_iter().find(|finding| finding.matter == Matter::Softness);
    let is_told = told.as_ref().is_some_and(|told| scenario.is_of_the_guide(told));
    if is_told && overlap < CENTRES_MEET {
        return None; // told before the run, and `check` tells more
    }
    let cures = told.map_or_else(|| scenario.cure_for_softness(overlap), |told| told.ways_out);
    Some(format!(": more than half a radius, discs too soft; try {}", cures.join(" or ")))
}
