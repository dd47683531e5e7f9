//! A key: what may be said of a run by a flag or in a scenario file, and all that is known of it before anybody says it.
//!
//! The keys themselves stand in one table, `keys.rs`.

mod kind;
#[macro_use]
mod table;

use clap::Arg;

pub use self::kind::{Kind, Said};
pub(super) use self::table::keys;
use super::error::ScenarioError;
use super::exclusive;
use super::range::{ANY, Range};

/// What is known of a key. In a scenario file it has its name, as a flag `-` for `_`.
#[derive(Debug)]
pub struct Key {
    /// Its name.
    pub name: &'static str,
    /// What it says, as the help has it.
    pub help: &'static str,
    /// What stands for its value in the help.
    pub value: &'static str,
    /// The section of a scenario file that it is printed in.
    pub section: &'static str,
    /// The heading of the help that it stands under; none for the first ones.
    pub heading: Option<&'static str>,
    /// Its unit; empty for what has none.
    pub unit: &'static str,
    /// The values it takes.
    pub allowed: Range,
    /// What to do about another value.
    pub way_out: &'static str,
    /// Its letter on the command line.
    pub letter: Option<char>,
    /// Other names on the command line.
    pub aliases: &'static [&'static str],
    /// Whether the help leaves it out.
    pub is_hidden: bool,
    /// Whether it says only where and how a run is computed and told, so that its files do not hang on it.
    pub is_of_machine: bool,
    /// Whether it is printed before the others of its section.
    pub comes_first: bool,
    /// Makes a flag one of its kind.
    pub(super) flag: fn(&'static Self, Arg) -> Arg,
}

impl Key {
    /// What most keys are.
    pub(super) const PLAIN: Self = Self {
        name: "",
        help: "",
        value: "",
        section: "",
        heading: None,
        unit: "",
        allowed: ANY,
        way_out: "",
        letter: None,
        aliases: &[],
        is_hidden: false,
        is_of_machine: false,
        comes_first: false,
        flag: |_, arg| arg,
    };

    /// Refuses `numbers` of its value that it does not allow.
    fn check(&self, numbers: &[f64]) -> Result<(), ScenarioError> {
        let check = |number: &f64| self.allowed.check(self.name, *number, self.way_out).map(|_| ());
        numbers.iter().try_for_each(check)
    }

    /// Its flag.
    pub fn arg(&'static self) -> Arg {
        let heading = self.heading.unwrap_or(self.section);
        let arg = Arg::new(self.name)
            .long(self.name.replace('_', "-"))
            .help(self.help.trim())
            .value_name(self.value)
            .aliases(self.aliases)
            .hide(self.is_hidden)
            .conflicts_with_all(exclusive::flags(self.name))
            .help_heading((!heading.is_empty()).then_some(heading));
        let arg = self.letter.map_or(arg.clone(), |letter| arg.short(letter));
        (self.flag)(self, arg)
    }
}
