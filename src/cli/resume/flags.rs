//! Flags of a run that `resume` does not take, and why.

use std::path::Path;

use clap::Command;
use clap::error::{ContextKind, ContextValue, ErrorKind};

use crate::cli::flags::Flags;
use crate::cli::refusal::Refusal;
use crate::cli::typed::{after_name, quoted, shown};
use crate::output::place::folder_of;
use crate::output::record;

/// What to say of `error` if it is that a flag of a run was given to `resume`.
pub(in crate::cli) fn refusal(command: &Command, error: &clap::Error) -> Option<Refusal> {
    let is_resume = std::env::args_os().nth(1).is_some_and(|word| word == "resume");
    if error.kind() != ErrorKind::UnknownArgument || !is_resume {
        return None;
    }
    let Some(ContextValue::String(said)) = error.get(ContextKind::InvalidArg) else { return None };
    let flag = said.split('=').next().unwrap_or(said);
    Flags::of(command, &[]).called(flag).filter(|_| flag.starts_with('-'))?;
    let words = after_name();
    let flags = Flags::of(command, &words);
    let said = as_typed(&flags, &words, flag).unwrap_or_else(|| format!("{flag} ..."));
    let again = match record_of_run(&flags, &words) {
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

/// The `flag` with its value, as they stand among `words`; nothing if its value is missing.
fn as_typed(flags: &Flags, words: &[String], flag: &str) -> Option<String> {
    let with_value = format!("{flag}=");
    let at = words.iter().position(|word| word == flag || word.starts_with(&with_value))?;
    if words[at] != flag || !flags.takes_next(flag) {
        return Some(quoted(&words[at]));
    }
    words.get(at + 1).map(|value| format!("{flag} {}", quoted(value)))
}

/// The record of the run that was to go on, as a word of a command; nothing if there is none.
fn record_of_run(flags: &Flags, words: &[String]) -> Option<String> {
    let mut rest = words.iter().skip(1);
    let mut named = None;
    while let Some(word) = rest.next() {
        if flags.takes_next(word) {
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
