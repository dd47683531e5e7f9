//! The flags that a command line may have.

use clap::{Arg, Command};

/// The flags of the subcommand that was typed, and of those above it.
pub(super) struct Flags {
    all: Vec<Arg>,
}

impl Flags {
    /// Those of `command` and of the subcommands among the `words`.
    pub fn of(command: &Command, words: &[String]) -> Self {
        let mut all: Vec<Arg> = command.get_arguments().cloned().collect();
        let mut here = command;
        for word in words {
            if let Some(sub) = here.find_subcommand(word) {
                here = sub;
                // What the subcommand says of a flag is nearer.
                all = here.get_arguments().cloned().chain(all).collect();
            }
        }
        Self { all }
    }

    /// The long flag called `name`, by its own name, with `_` for `-`, or by another of its names.
    pub fn long(&self, name: &str) -> Option<&str> {
        let dashed = name.replace('_', "-");
        self.all.iter().find_map(|flag| {
            let long = flag.get_long()?;
            let aliases = flag.get_all_aliases().unwrap_or_default();
            (long == dashed || aliases.contains(&name)).then_some(long)
        })
    }

    /// The flag that is called `name` in a scenario file, or in the letters of a book, as `N` and `N_t`.
    pub fn without_dashes(&self, name: &str) -> Option<&Arg> {
        let is_short = |flag: &&Arg| {
            flag.get_short().is_some_and(|letter| name.eq_ignore_ascii_case(&letter.to_string()))
        };
        let long = self.long(name).or_else(|| {
            let small = name.to_ascii_lowercase();
            self.longs().into_iter().find(|long| *long == small.replace('_', "-"))
        });
        let mut all = self.all.iter();
        let is_it = |flag: &&Arg| long.is_some() && flag.get_long() == long || is_short(flag);
        all.find(is_it)
    }

    /// Whether the word behind `word` is its value.
    pub fn takes_next(&self, word: &str) -> bool {
        let flag = Some(word).filter(|word| word.starts_with('-'));
        let flag = flag.and_then(|word| self.called(word));
        flag.is_some_and(|flag| flag.get_action().takes_values() && !flag.is_require_equals_set())
    }

    /// The flag that is written as `word`, with or without its dashes.
    pub fn called(&self, word: &str) -> Option<&Arg> {
        let name = word.trim_start_matches('-');
        self.all.iter().find(|flag| {
            flag.get_long() == Some(name)
                || flag.get_short().is_some_and(|letter| name == letter.to_string())
        })
    }

    pub fn longs(&self) -> Vec<&str> {
        self.all.iter().filter_map(Arg::get_long).collect()
    }
}
