//! What the program says on standard error: all of it goes through here, for there are words of others in it.

use std::fmt::Display;
use std::io::{self, Write};

use crate::echo;

/// Says `what` after a word for what `kind` of remark it is: error, warning, note. That standard error is closed is no
/// failure, and nobody is left to be told.
pub(super) fn say(kind: &str, what: impl Display) {
    let _ = writeln!(io::stderr(), "{kind}: {}", echo::message(&what.to_string()));
}
