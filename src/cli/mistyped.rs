//! What was probably meant by words of the command line that are none of its flags and files.

use std::path::Path;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command};

use super::failure::Failure;
use super::file_kind::FileKind;
use super::flags::Flags;
use super::refusal::Refusal;
use super::typed::{after_name, quoted};
use crate::scenario::nearest::did_you_mean;
use crate::scenario::quantity::is_unit;

/// A long flag with one dash, `-radius`: clap would take it for `-r` and a value. Looked for before anything
/// is read, as `-out x` is a good `-o ut`.
pub(super) fn one_dash(command: &Command, words: &[String]) -> Option<Refusal> {
    let flags = Flags::of(command, words);
    let before = words.iter().take_while(|word| *word != "--");
    let is_long = |word: &&String| {
        word.len() > 2 && word.starts_with('-') && word.as_bytes()[1].is_ascii_alphabetic()
    };
    before.filter(is_long).find_map(|word| {
        let (name, value) = word[1..].split_once('=').map_or((&word[1..], ""), |(n, v)| (n, v));
        let long = flags.long(name)?;
        let value = if value.is_empty() { String::new() } else { format!("={value}") };
        Some(Refusal {
            why: format!("-{name} has one dash; long flags have two"),
            way_out: format!("--{long}{value}"),
        })
    })
}

/// What to say in place of clap's `error`, whose tips do not fit here.
pub(super) fn refusal(command: &Command, words: &[String], error: &clap::Error) -> Option<Refusal> {
    let said = |kind| match error.get(kind) {
        Some(ContextValue::String(said)) => Some(said.as_str()),
        _ => None,
    };
    let flags = Flags::of(command, words);
    let is_misplaced =
        matches!(error.kind(), ErrorKind::UnknownArgument | ErrorKind::ArgumentConflict);
    if let Some(refusal) = is_misplaced.then(|| misspelt(command, words)).flatten() {
        return Some(refusal);
    }
    match error.kind() {
        ErrorKind::UnknownArgument if is_stray(command, words, said(ContextKind::InvalidArg)?) => {
            two_scenarios(command, words, said(ContextKind::InvalidArg)?)
        }
        ErrorKind::UnknownArgument => flags.unknown(words, said(ContextKind::InvalidArg)?),
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => {
            let (flag, value) = (said(ContextKind::InvalidArg)?, said(ContextKind::InvalidValue)?);
            if let Some(ContextValue::Strings(known)) = error.get(ContextKind::ValidValue) {
                return no_such_name(flag, value, known);
            }
            if value.starts_with('=') {
                return Some(spaces_around_equals());
            }
            flags.not_whole(flag, value, &std::error::Error::source(error)?.to_string())
        }
        ErrorKind::InvalidSubcommand => {
            let path = Path::new(said(ContextKind::InvalidSubcommand)?);
            let kind = FileKind::of(path)?;
            let why = format!(
                "the kind of picture comes first, and {} is {}",
                path.display(),
                kind.name()
            );
            Some(Refusal { why, way_out: kind.picture(path) })
        }
        ErrorKind::ArgumentConflict => {
            two_scenarios(command, words, said(ContextKind::InvalidSubcommand)?)
        }
        _ => None,
    }
}

/// Whether `unknown` is no flag and one word too many of a run, or of its diagnosis.
fn is_stray(command: &Command, words: &[String], unknown: &str) -> bool {
    let sub = words.first().and_then(|first| command.find_subcommand(first));
    !unknown.starts_with('-') && sub.is_none_or(|sub| ["run", "check"].contains(&sub.get_name()))
}

/// What to say of a first word that is a subcommand but for a slip, with words of its own behind it.
fn misspelt(command: &Command, words: &[String]) -> Option<Refusal> {
    let (first, rest) = words.split_first().filter(|(_, rest)| !rest.is_empty())?;
    let known: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
    let is_word = first.chars().all(char::is_alphanumeric) && first.len() > 2;
    if !is_word || known.contains(&first.as_str()) || Path::new(first).exists() {
        return None;
    }
    if Flags::of(command, words).without_dashes(first).is_some() {
        return None;
    }
    let near = did_you_mean(first, &known)?;
    let rest: Vec<String> = rest.iter().map(|word| quoted(word)).collect();
    Some(Refusal {
        why: format!("`{first}` is no subcommand; did you mean `{near}`?"),
        way_out: format!("parsim2d {near} {}", rest.join(" ")),
    })
}

/// What to say of a `word` that is a flag, or a key of a scenario, without its dashes: `n 1000`, `n=1000`.
fn no_dashes(command: &Command, words: &[String], word: &str) -> Option<Refusal> {
    let at = words.iter().position(|this| this == word)?;
    let flags = Flags::of(command, words);
    if Path::new(word).exists() || at > 0 && flags.takes_next(&words[at - 1]) {
        return None;
    }
    let (name, value) = match word.split_once('=') {
        Some((name, value)) => (name, Some(value.to_owned())),
        None => {
            let mut behind = words[at + 1..].iter().filter(|word| *word != "=");
            (word, behind.next().filter(|next| !next.starts_with("--")).cloned())
        }
    };
    let known: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
    if name == word && value.is_none() && did_you_mean(word, &known).is_some() {
        return None; // `preset`, alone, is rather `presets`
    }
    let flag = flags.without_dashes(name)?;
    let dashed = match flag.get_short() {
        Some(letter) if name.len() == 1 => format!("-{letter}"),
        _ => format!("--{}", flag.get_long()?),
    };
    let is_switch = flag.is_require_equals_set();
    Some(Refusal {
        why: format!("{name} is a flag, and flags begin with dashes"),
        way_out: match value.filter(|value| !value.is_empty()) {
            Some(value) if is_switch && word.contains('=') => format!("{dashed}={value}"),
            _ if is_switch => dashed,
            Some(value) => format!("{dashed} {}", quoted(&value)),
            None => usage(flag),
        },
    })
}

/// What to say of a `word` where a scenario or a subcommand was to come.
fn stray(command: &Command, words: &[String], word: &str) -> Option<Refusal> {
    let refusal = |why: String, way_out: String| Some(Refusal { why, way_out });
    if let Some(flag) = word.strip_prefix(['–', '—', '−']) {
        let why = format!("{word} begins with a long dash, as some programs make of two hyphens");
        return refusal(why, format!("--{}", flag.trim_start_matches(['-', '–', '—', '−'])));
    }
    match before(words, word) {
        Some(before) if is_unit(word) && before.parse::<f64>().is_ok() => {
            let why = format!("`{before} {word}` are two words to a shell");
            return refusal(why, format!("no space before the unit: {before}{word}"));
        }
        Some(before) if before == "=" || word == "=" => return Some(spaces_around_equals()),
        _ => {}
    }
    no_dashes(command, words, word)
}

/// What a single `word` was probably meant for that no file has for its name.
pub(super) fn unknown_command(command: &Command, word: &str) -> Failure {
    let words = after_name();
    if let Some(refusal) = stray(command, &words, word) {
        return Failure::Refused(refusal);
    }
    let known: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
    if known.contains(&word) {
        let why = format!("`{word}` stands where a scenario file was to be");
        let way_out = format!("a subcommand comes first: parsim2d {word}");
        return Failure::Refused(Refusal { why, way_out });
    }
    let advice = match word {
        "true" | "false" => {
            let flag = before(&words, word).filter(|flag| flag.starts_with("--"));
            let flag = flag.map_or("--border", String::as_str);
            Some(format!("; a switch takes it with `=`: {flag}={word}"))
        }
        _ => did_you_mean(word, &known).map(|near| format!("; did you mean `{near}`?")),
    };
    Failure::UnknownCommand {
        word: word.to_owned(),
        known: known.join(", "),
        advice: advice.unwrap_or_default(),
    }
}

/// The word before `word`.
fn before<'a>(words: &'a [String], word: &str) -> Option<&'a String> {
    let at = words.iter().position(|this| this == word)?;
    words.get(at.checked_sub(1)?)
}

fn spaces_around_equals() -> Refusal {
    Refusal {
        why: "there are spaces around `=`".to_owned(),
        way_out: "a flag and its value: --radius 5e-4, or --radius=5e-4".to_owned(),
    }
}

/// What to say of `value`, which is none of the names that the `flag` knows.
fn no_such_name(flag: &str, value: &str, known: &[String]) -> Option<Refusal> {
    let known: Vec<&str> = known.iter().map(String::as_str).collect();
    let (name, near) = (flag.split_whitespace().next()?, did_you_mean(value, &known)?);
    // A value without a flag, as the shell of `completions`, is shown as <SHELL>.
    let near = if name.starts_with('-') { format!("{name} {near}") } else { near.to_owned() };
    Some(Refusal {
        why: format!("{flag} knows no `{value}`; it knows {}", known.join(", ")),
        way_out: near,
    })
}

/// What to say of a unit that was to be set by a flag of its own: `--unit mm`.
fn unit_as_flag(words: &[String], said: &str) -> Option<Refusal> {
    let flag = said.split('=').next().unwrap_or(said);
    let is_unit_flag = ["--unit", "--units"].contains(&flag);
    is_unit_flag.then(|| {
        let at = words.iter().position(|word| word.starts_with(flag));
        let behind = at.and_then(|k| match words[k].split_once('=') {
            Some((_, value)) => Some(value),
            None => words.get(k + 1).map(String::as_str),
        });
        let unit = behind.filter(|unit| ["m", "cm", "mm"].contains(unit)).unwrap_or("mm");
        Refusal {
            why: format!("there is no flag {flag}: values are in SI units"),
            way_out: format!(
                "another unit goes behind its number, without a blank, as in --radius 0.1{unit}"
            ),
        }
    })
}

/// Two files, or a flag behind `--`.
fn two_scenarios(command: &Command, words: &[String], second: &str) -> Option<Refusal> {
    if let Some(refusal) = words.iter().find_map(|word| stray(command, words, word)) {
        return Some(refusal);
    }
    if let Some(k) = words.iter().position(|word| word == "--") {
        let rest = words[k + 1..].join(" ");
        let why = format!("what stands behind `--` is no flag: {rest}");
        return Some(Refusal { why, way_out: "leave out the `--`".to_owned() });
    }
    Some(Refusal {
        why: format!("a run takes one scenario, and {second} is one word too many"),
        way_out: "one command for each; a value goes behind its flag".to_owned(),
    })
}

impl Flags {
    /// What to say of `said`, which is no flag here.
    fn unknown(&self, words: &[String], said: &str) -> Option<Refusal> {
        if let Some(refusal) = unit_as_flag(words, said) {
            return Some(refusal);
        }
        let bare = said.strip_prefix('-').filter(|bare| !bare.starts_with('-'))?;
        if bare.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return Some(self.negative(words, said));
        }
        // clap names the first letter only.
        let word = words.iter().find(|word| word.starts_with(said)).map_or(said, String::as_str);
        let name = word.trim_start_matches('-').split('=').next().unwrap_or_default();
        let near = did_you_mean(name, &self.longs()).map(|near| format!("--{near}"));
        Some(Refusal {
            why: format!("there is no flag {word}"),
            way_out: near.unwrap_or_else(|| "--help lists the flags".to_owned()),
        })
    }

    /// What to say of a negative number behind a flag that takes none.
    fn negative(&self, words: &[String], said: &str) -> Refusal {
        let before = before(words, said);
        let flag = before.and_then(|word| self.called(word));
        let flag = flag.filter(|flag| flag.get_action().takes_values());
        match (before, flag) {
            (Some(before), Some(flag)) => Refusal {
                why: format!("{before} {said} is not possible: it cannot be negative"),
                way_out: usage(flag),
            },
            _ => Refusal {
                why: format!("there is no flag {said}"),
                way_out: "a value goes behind its flag; --help lists them".to_owned(),
            },
        }
    }

    /// What to say of a `value` that clap's own reader of whole numbers refuses.
    fn not_whole(&self, flag: &str, value: &str, why: &str) -> Option<Refusal> {
        let least = match why {
            "invalid digit found in string" | "cannot parse integer from empty string" => 0,
            "number would be zero for non-zero type" => 1,
            _ => return None,
        };
        let name = flag.split_whitespace().next()?;
        let flag = self.called(name)?;
        Some(Refusal {
            why: format!("{name} {value} is not possible: it is a whole number, {least} or more"),
            way_out: usage(flag),
        })
    }
}

/// A flag with its value and what the help says of it.
fn usage(flag: &Arg) -> String {
    let long = flag.get_long().unwrap_or_default();
    let value = flag.get_value_names().and_then(|names| names.first());
    let value = value.map_or("VALUE", |name| name.as_str());
    let help = flag.get_help().map(ToString::to_string).unwrap_or_default();
    let mut letters = help.chars();
    let first = letters.next().map(|letter| letter.to_lowercase().to_string()).unwrap_or_default();
    format!("--{long} {value}: {first}{}", letters.as_str())
}
