//! The command line: one file a subcommand.

mod answer;
mod check;
mod claim;
mod completions;
mod convert;
mod doctor;
mod drift;
mod failure;
mod file_kind;
mod flags;
mod grade;
mod interrupt;
mod man;
mod memory;
mod mistyped;
mod plot;
mod presets;
mod refusal;
mod report;
mod resume;
mod run;
mod say;
mod signals;
mod terminal;
mod told;
mod typed;
mod wrapped;

use std::io::{self, Write};
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, Parser, Subcommand};

use self::failure::Failure;
use self::refusal::Refusal;
use crate::echo;
use crate::output::OutputError;
use crate::scenario::wished::{Wish, wish};

/// Runs the program on the process's arguments.
pub fn run() -> ExitCode {
    let cli = match parsed(&typed::after_name()) {
        Ok(cli) => cli,
        Err(code) => return code,
    };
    let done = match cli.command {
        None => run::run(&cli.run, &Cli::command()),
        Some(Command::Run(arguments)) => run::run(&arguments, &Cli::command()),
        Some(Command::Check(arguments)) => check::check(&arguments, &Cli::command()),
        Some(Command::Convert(arguments)) => convert::convert(&arguments),
        Some(Command::Doctor(arguments)) => doctor::examine(&arguments),
        Some(Command::Drift(arguments)) => drift::run(&arguments),
        Some(Command::Grade(arguments)) => grade::run(&arguments),
        Some(Command::Plot(arguments)) => plot::plot(&arguments),
        Some(Command::Report(arguments)) => report::report(&arguments),
        Some(Command::Resume(arguments)) => resume::resume(&arguments),
        Some(Command::Presets) => presets::print(),
        Some(Command::Completions(arguments)) => completions::print(&arguments, Cli::command()),
        Some(Command::Man(arguments)) => man::print(&arguments, Cli::command()),
    };
    // What is still to be written may find no room.
    let done = done.and_then(|code| io::stdout().flush().map(|()| code).map_err(Failure::from));
    ended(done)
}

/// Prints what clap has to say: help, or what is wrong with the command line.
fn not_parsed(error: &clap::Error) -> ExitCode {
    if error.use_stderr() {
        let is_plain = |word: &std::ffi::OsString| {
            let word = word.to_string_lossy();
            echo::value(&word) == word
        };
        // Colours only where nothing else could turn into one.
        match std::env::args_os().all(|word| is_plain(&word)) {
            true => drop(error.print()), // nowhere left to say that this failed
            false => {
                let text = echo::message(error.render().to_string().trim_end());
                let _ = writeln!(io::stderr(), "{text}");
            }
        }
        return ExitCode::from(2);
    }
    let printed = error.print().and_then(|()| io::stdout().flush());
    ended(printed.map(|()| ExitCode::SUCCESS).map_err(Failure::from))
}

/// The exit code of a command that is done, or why it is not.
fn ended(done: Result<ExitCode, Failure>) -> ExitCode {
    match done {
        Ok(code) => code,
        Err(Failure::Output(OutputError::Write { source, .. }) | Failure::Stdout(source))
            if source.kind() == io::ErrorKind::BrokenPipe =>
        {
            ExitCode::SUCCESS // whoever read us has seen enough
        }
        Err(failure) => {
            say::say("error", &failure);
            failure.exit_code()
        }
    }
}

/// What was typed, the `words` behind the program's name; or, when all has been said, the exit code.
fn parsed(words: &[String]) -> Result<Cli, ExitCode> {
    if let Some(refusal) = mistyped::one_dash(&Cli::command(), words) {
        return Err(refused(&refusal));
    }
    Cli::try_parse().map_err(|error| {
        let refusal = resume::flags::refusal(&Cli::command(), &error)
            .or_else(|| wished(&error))
            .or_else(|| mistyped::refusal(&Cli::command(), words, &error));
        refusal.map_or_else(|| not_parsed(&error), |refusal| refused(&refusal))
    })
}

/// A command line that is not understood.
fn refused(why: &Refusal) -> ExitCode {
    say::say("error", why);
    ExitCode::from(2)
}

/// What to say of `error` if a run, or `check`, was asked for something that is not there.
fn wished(error: &clap::Error) -> Option<Refusal> {
    let first = std::env::args_os().nth(1)?;
    let is_other = |command: &clap::Command| *command.get_name() == first;
    let is_of_run =
        first == "run" || first == "check" || !Cli::command().get_subcommands().any(is_other);
    let said = match (error.kind(), error.get(ContextKind::InvalidArg)?) {
        (ErrorKind::UnknownArgument, ContextValue::String(flag)) if is_of_run => {
            flag.split('=').next().unwrap_or(flag)
        }
        (ErrorKind::InvalidValue, _) if is_of_run => match error.get(ContextKind::InvalidValue)? {
            ContextValue::String(name) => name,
            _ => return None,
        },
        _ => return None,
    };
    let Wish { lacks, nearest, .. } = wish(said)?;
    Some(Refusal { why: format!("{said}: {lacks}"), way_out: (*nearest).to_owned() })
}

const EXAMPLES: &str = "\
Examples:
  parsim2d                                 the guide's run: 20 discs, 1 s
  parsim2d -n 1000 --radius 5e-4           its harder case
  parsim2d --restitution 1 --time 0.1s     elastic discs
  parsim2d examples/settling.toml          a scenario file
  parsim2d plot trajectory trajectory.txt  pictures of it: parsim2d plot --help
  parsim2d --slowdown 20                   slow enough to watch: gnuplot plot/loop.plot
  parsim2d drift                           does the energy stay constant?

Exit codes: 0 done, 1 the run failed, 2 bad usage or refused parameters, 3 out of memory, 130 interrupted.";

/// A 2D particle simulator for teaching: discs, springs and dashpots in a box.
///
/// Writes out.txt (the present frame, x y r), trajectory.txt (all frames, x y r vx vy m) and
/// energy.csv (the energy ledger). All values in SI units; a unit may be added: 4cm, 1ms, 2g.
#[derive(Parser)]
#[command(name = "parsim2d", version, after_help = EXAMPLES)]
#[command(args_conflicts_with_subcommands = true, subcommand_precedence_over_arg = true)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    run: run::RunArguments,
}

#[derive(Subcommand)]
enum Command {
    /// Run a simulation; the same as no subcommand
    #[command(after_help = EXAMPLES)]
    Run(Box<run::RunArguments>),
    /// Say what is wrong with a scenario, by which parameter, and what would work; run nothing
    #[command(after_help = check::EXAMPLES)]
    Check(Box<run::RunArguments>),
    /// Does the total energy stay constant? Measure it for each integrator and time step
    #[command(after_help = drift::EXAMPLES)]
    Drift(Box<drift::DriftArguments>),
    /// Grade frames that a program wrote: points, causes and hints
    #[command(after_help = grade::EXAMPLES)]
    Grade(Box<grade::GradeArguments>),
    /// Draw what a run wrote: SVG, animated GIF, and gnuplot scripts
    Plot(Box<plot::PlotArguments>),
    /// Write one HTML page of a run, to hand in: parameters, diagnosis, pictures
    #[command(after_help = report::EXAMPLES)]
    Report(report::ReportArguments),
    /// Go on from a checkpoint, and end with the same bits as a run never interrupted
    #[command(after_help = resume::EXAMPLES)]
    Resume(Box<resume::ResumeArguments>),
    /// List the presets and their numbers
    Presets,
    /// Write frames in another format: text, extended XYZ, LAMMPS dump, CSV
    #[command(after_help = convert::EXAMPLES)]
    Convert(Box<convert::ConvertArguments>),
    /// Say which optional programs are there, and what each is good for
    Doctor(doctor::DoctorArguments),
    /// Print a script with which a shell completes subcommands and flags
    #[command(after_help = completions::EXAMPLES)]
    Completions(completions::CompletionsArguments),
    /// Print the help as manual pages
    #[command(after_help = man::EXAMPLES)]
    Man(man::ManArguments),
}
