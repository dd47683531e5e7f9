//! What the diagnosis finds: how grave it is, which parameter is at fault, what would work.

use std::fmt;

use serde::Serialize;

use crate::named::named;

named! {
    /// How far a run can be trusted, by what can be told before it.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
    #[serde(rename_all = "lowercase")]
    pub enum Verdict, name {
        /// Nothing against it.
        Good = "good",
        /// It runs, and its numbers are rough.
        Coarse = "coarse",
        /// It does not describe discs in contact: it explodes, or they jump over each other.
        Unstable = "unstable",
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// What a finding is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Matter {
    /// The time step against the limits of linear contacts.
    Step,
    /// The path of a disc in one time step.
    Travel,
    /// The stiffness of contacts.
    Softness,
    /// The time integrator.
    Integrator,
    /// The restitution that the time step gives.
    Restitution,
    /// Where the discs are at the start.
    Start,
}

/// Something found wrong with a scenario.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// What it is about.
    pub matter: Matter,
    /// How grave it is.
    pub verdict: Verdict,
    /// What is wrong, with its number and its limit.
    pub what: String,
    /// The parameter at fault, as its flag (or as the disc that has it): the one that, put back
    /// to the preset's value, would mend it.
    pub fault: String,
    /// Its value.
    pub value: String,
    /// Changes that work, each tried against the limit.
    pub ways_out: Vec<String>,
}

impl Finding {
    /// One line, as a note before a run.
    pub fn note(&self) -> String {
        match self.ways_out.is_empty() {
            true => self.what.clone(),
            false => format!("{}; try {}", self.what, self.ways_out.join(" or ")),
        }
    }

    /// One sentence with the parameter at fault, as the last word of a diagnosis.
    pub fn sentence(&self) -> String {
        let Self { what, fault, value, .. } = self;
        let ways_out = match self.ways_out.is_empty() {
            true => String::new(),
            false => format!("; use {}", self.ways_out.join(", or ")),
        };
        format!("{what}, set by {fault} = {value}{ways_out}")
    }
}

/// The refusal of a run: several lines.
impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { verdict, what, fault, value, ways_out, .. } = self;
        writeln!(f, "{verdict}: {what}")?;
        writeln!(f, "  the parameter at fault: {fault} = {value}")?;
        if !ways_out.is_empty() {
            writeln!(f, "  ways out: {}", ways_out.join(", or "))?;
        }
        write!(f, "  --allow-unstable runs it anyway, for the lesson")
    }
}
