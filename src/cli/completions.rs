//! `parsim2d completions`: a script with which a shell completes subcommands, flags and names.

use std::io::{self, Write};
use std::process::ExitCode;

use clap::{ArgAction, Args, Command};
use clap_complete::Shell;

use super::failure::Failure;

pub(super) const EXAMPLES: &str = "\
Examples, each for good, from the next shell on:
  parsim2d completions bash > ~/.local/share/bash-completion/completions/parsim2d
  parsim2d completions zsh > ~/.zfunc/_parsim2d        with fpath+=~/.zfunc before compinit in ~/.zshrc
  parsim2d completions fish > ~/.config/fish/completions/parsim2d.fish
  parsim2d completions powershell >> $PROFILE

For this shell only: source <(parsim2d completions bash). The program must be on the PATH as parsim2d.";

#[derive(Args)]
pub(super) struct CompletionsArguments {
    /// The shell
    #[arg(value_enum, value_name = "SHELL")]
    shell: Shell,
}

/// Prints the script for `program`.
pub(super) fn print(
    arguments: &CompletionsArguments,
    program: Command,
) -> Result<ExitCode, Failure> {
    let mut program = with_plain_switches(program);
    let name = program.get_name().to_owned();
    let mut script = Vec::new(); // the generator does not tell of a closed pipe
    clap_complete::generate(arguments.shell, &mut program, name, &mut script);
    io::stdout().write_all(&script)?;
    Ok(ExitCode::SUCCESS)
}

/// Switches take `=true` and `=false`, which shells would offer as a word of its own, behind a space.
fn with_plain_switches(command: Command) -> Command {
    command
        .mut_args(|flag| match flag.is_require_equals_set() {
            true => flag
                .num_args(0)
                .require_equals(false)
                .hide_possible_values(false)
                .action(ArgAction::SetTrue),
            false => flag,
        })
        .mut_subcommands(with_plain_switches)
}
