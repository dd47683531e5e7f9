//! Flags of a run that `resume` does not take, and why.

use clap::CommandFactory;
use clap::error::{ContextKind, ContextValue, ErrorKind};

use crate::cli::Cli;
use crate::cli::refusal::Refusal;

/// What to say of `error` if it is that a flag of a run was given to `resume`.
pub(in crate::cli) fn refusal(error: &clap::Error) -> Option<Refusal> {
    let is_resume = std::env::args_os().nth(1).is_some_and(|word| word == "resume");
    if error.kind() != ErrorKind::UnknownArgument || !is_resume {
        return None;
    }
    let Some(ContextValue::String(said)) = error.get(ContextKind::InvalidArg) else { return None };
    let flag = said.split('=').next().unwrap_or(said);
    let command = Cli::command();
    let is_of_run = command.get_arguments().any(|known| {
        let long = known.get_long().map(|long| format!("--{long}"));
        let short = known.get_short().map(|short| format!("-{short}"));
        [long, short].iter().flatten().any(|known| known == flag)
    });
    is_of_run.then(|| Refusal {
        why: format!(
            "{flag} cannot be given to `resume`: what is simulated and written cannot change on the way, \
             for the run ends as if it had never been interrupted"
        ),
        way_out: format!(
            "a new run: parsim2d last-run.toml --out-dir again {flag} ...; `resume` takes --time, --out-dir, \
             --checkpoint-every, --slowdown, --threads, --json, --quiet"
        ),
    })
}
