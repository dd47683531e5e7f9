//! Flags of a run that `resume` does not take, and why.

use std::path::Path;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command, CommandFactory};

use crate::cli::Cli;
use crate::cli::claim::shown;
use crate::cli::refusal::Refusal;
use crate::cli::typed::{after_name, quoted};
use crate::output::place::folder_of;
use crate::output::record;

/// What to say of `error` if it is that a flag of a run was given to `resume`.
pub(in crate::cli) fn refusal(error: &clap::Error) -> Option<Refusal> {
    let is_resume = std::env::args_os().nth(1).is_some_and(|word| word == "resume");
    if error.kind() != ErrorKind::UnknownArgument || !is_resume {
        return None;
    }
    let Some(ContextValue::String(said)) = error.get(ContextKind::InvalidArg) else { return None };
    let flag = said.split('=').next().unwrap_or(said);
    let command = Cli::command();
    flag_called(&command, flag)?;
    let words = after_name();
    let said = as_typed(&words, flag).unwrap_or_else(|| format!("{flag} ..."));
    let again = match record_of_run(&command, &words) {
        Some(record) => format!("a new run: parsim2d {record} --out-dir again {said}"),
        None => format!("a new run of its scenario, with {said}"),
    };
    Some(Refusal {
        why: format!(
            "{flag} cannot be given to `resume`: what is simulated and written cannot change on the way, \
             for the run ends as if it had never been interrupted"
        ),
        way_out: format!(
            "{again}; `resume` takes --time, --out-dir, --checkpoint-every, --slowdown, --threads, --json, \
             --quiet"
        ),
    })
}

/// The flag of `command` that is written as `word`, with its dashes.
fn flag_called<'a>(command: &'a Command, word: &str) -> Option<&'a Arg> {
    command.get_arguments().find(|known| {
        let long = known.get_long().map(|long| format!("--{long}"));
        let short = known.get_short().map(|short| format!("-{short}"));
        [long, short].iter().flatten().any(|known| known == word)
    })
}

/// Whether the word behind `word` is its value.
fn takes_next(command: &Command, word: &str) -> bool {
    let resume = command.find_subcommand("resume");
    let flag = resume.and_then(|resume| flag_called(resume, word));
    let flag = flag.or_else(|| flag_called(command, word));
    flag.is_some_and(|flag| flag.get_action().takes_values() && !flag.is_require_equals_set())
}

/// The `flag` with its value, as they stand among `words`; nothing if its value is missing.
fn as_typed(words: &[String], flag: &str) -> Option<String> {
    let command = Cli::command();
    let with_value = format!("{flag}=");
    let at = words.iter().position(|word| word == flag || word.starts_with(&with_value))?;
    if words[at] != flag || !takes_next(&command, flag) {
        return Some(quoted(&words[at]));
    }
    words.get(at + 1).map(|value| format!("{flag} {}", quoted(value)))
}

/// The record of the run that was to go on, as a word of a command; nothing if there is none.
fn record_of_run(command: &Command, words: &[String]) -> Option<String> {
    let mut rest = words.iter().skip(1);
    let mut named = None;
    while let Some(word) = rest.next() {
        if takes_next(command, word) {
            rest.next();
        } else if !word.starts_with('-') {
            // Behind a flag whose value is missing comes a number, and no path.
            named = named.or_else(|| Some(Path::new(word)).filter(|path| path.exists()));
        }
    }
    let folder = match named {
        Some(path) if path.is_dir() => path,
        Some(path) => folder_of(path),
        None => Path::new("."),
    };
    record::is_there(folder).then(|| quoted(&shown(&folder.join(record::FILE))))
}
