//! The kinds of values that keys have: how each is read, checked and printed.

use std::path::PathBuf;

use clap::builder::ValueParser;
use clap::{Arg, value_parser};

use super::Key;
use crate::output::frames::layout::Layout;
use crate::scenario::error::ScenarioError;
use crate::scenario::gravity::Gravity;
use crate::scenario::preset::Preset;
use crate::scenario::quantity::{Dimension, Quantity, whole_number};
use crate::scenario::settings::{DtSetting, IntegratorName, PlacementName};

/// A value that was said.
pub trait Said {
    /// As it is written in a scenario file, with its `unit` behind it.
    fn text(&self, unit: &str) -> String;

    /// Refuses what `key` does not allow.
    fn check(&self, key: &Key) -> Result<(), ScenarioError>;
}

/// A kind of such values.
pub trait Kind: Said + Sized {
    /// What a scenario holds of it.
    type Held;

    /// The unit of its numbers.
    const UNIT: &'static str = "";

    /// What is held of what was said.
    fn held(&self) -> Self::Held;

    /// How it is said.
    fn say(held: Self::Held) -> Self;

    /// Makes `arg` the flag of `key`.
    fn flag(key: &'static Key, arg: Arg) -> Arg;
}

impl<D: Dimension> Said for Quantity<D> {
    fn text(&self, unit: &str) -> String {
        with_unit(self.si, unit)
    }

    fn check(&self, key: &Key) -> Result<(), ScenarioError> {
        key.check(&[self.si])
    }
}

impl<D: Dimension + Clone + Send + Sync + 'static> Kind for Quantity<D> {
    type Held = f64;
    const UNIT: &'static str = D::SUFFIXES[0].0;

    fn held(&self) -> f64 {
        self.si
    }

    fn say(held: f64) -> Self {
        held.into()
    }

    fn flag(_: &'static Key, arg: Arg) -> Arg {
        arg.allow_hyphen_values(true).value_parser(str::parse::<Self>)
    }
}

/// A whole number, held as one that is not negative.
impl Said for i64 {
    fn text(&self, unit: &str) -> String {
        with_unit(self, unit)
    }

    fn check(&self, key: &Key) -> Result<(), ScenarioError> {
        key.allowed.check_whole(key.name, *self, key.way_out).map(|_| ())
    }
}

impl Kind for i64 {
    type Held = u64;

    fn held(&self) -> u64 {
        *self as u64
    }

    fn say(held: u64) -> Self {
        held as Self
    }

    fn flag(key: &'static Key, arg: Arg) -> Arg {
        let parser = |text: &str| {
            whole_number(text).map_err(|why| match key.allowed.most {
                f64::INFINITY => why,
                most => format!("not a whole number from {} to {most}", key.allowed.least),
            })
        };
        arg.allow_hyphen_values(true).value_parser(ValueParser::new(parser))
    }
}

/// Kinds that are held as they are said: the flag, the text in a file, and numbers to check.
macro_rules! held_as_said {
    ($($kind:ty: $flag:expr, $text:expr, $numbers:expr;)+) => {$(
        impl Said for $kind {
            fn text(&self, _: &str) -> String {
                let text: fn(&Self) -> String = $text;
                text(self)
            }

            fn check(&self, key: &Key) -> Result<(), ScenarioError> {
                let numbers: fn(&Self) -> Vec<f64> = $numbers;
                key.check(&numbers(self))
            }
        }

        impl Kind for $kind {
            type Held = Self;

            fn held(&self) -> Self {
                self.clone()
            }

            fn say(held: Self) -> Self {
                held
            }

            fn flag(_: &'static Key, arg: Arg) -> Arg {
                let flag: fn(Arg) -> Arg = $flag;
                flag(arg)
            }
        }
    )+};
}

held_as_said! {
    bool: switch, |is_so| is_so.to_string(), |_| vec![];
    Gravity: |arg| arg.allow_hyphen_values(true).value_parser(str::parse::<Self>),
        |g| format!("{g} # m/s2, {}", if g.is_vertical() { "downward" } else { "y up" }),
        |g| g.vector.to_array().to_vec();
    DtSetting: |arg| arg.allow_hyphen_values(true).value_parser(str::parse::<Self>),
        |dt| dt.seconds().map_or(quoted("auto"), |seconds| with_unit(seconds, "s")),
        |dt| dt.seconds().into_iter().collect();
    Layout: |arg| arg.allow_hyphen_values(true).value_parser(str::parse::<Self>),
        |layout| quoted(&layout.to_string()), |_| vec![];
    String: |arg| arg.value_parser(value_parser!(Self)), |text| quoted(text), |_| vec![];
    PathBuf: |arg| arg.value_parser(value_parser!(Self)), |path| quoted(&path.to_string_lossy()), |_| vec![];
    Preset: |arg| arg.value_parser(value_parser!(Self)), |preset| quoted(preset.name()), |_| vec![];
    IntegratorName: |arg| arg.value_parser(value_parser!(Self)), |it| quoted(it.name()), |_| vec![];
    PlacementName: |arg| arg.value_parser(value_parser!(Self)), |it| quoted(it.name()), |_| vec![];
}

/// A flag that may stand alone.
fn switch(arg: Arg) -> Arg {
    let arg = arg.num_args(0..=1).default_missing_value("true").require_equals(true);
    arg.hide_possible_values(true).value_parser(value_parser!(bool))
}

fn with_unit(number: impl std::fmt::Debug, unit: &str) -> String {
    if unit.is_empty() { format!("{number:?}") } else { format!("{number:?} # {unit}") }
}

fn quoted(text: &str) -> String {
    if text.contains(char::is_control) {
        // On one line, whatever is in it; JSON's escapes are TOML's too.
        return serde_json::Value::from(text).to_string();
    }
    toml::Value::String(text.to_owned()).to_string()
}
