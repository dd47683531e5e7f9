//! What can be wrong with a scenario, said to the person who wrote it.

use std::path::PathBuf;

use thiserror::Error;

use super::finding::Finding;
use crate::echo;
use crate::placement::PlacementError;

/// Why a scenario cannot be run. Nothing has been written when this is returned.
#[derive(Debug, Error)]
pub enum ScenarioError {
    /// A value out of its range.
    #[error("{field} = {value} is not possible: {allowed}\n  way out: {way_out}")]
    OutOfRange {
        /// The flag, or the key with its table.
        field: String,
        /// The value as read.
        value: String,
        /// The allowed range.
        allowed: String,
        /// What to do.
        way_out: String,
    },
    /// Two choices that exclude each other.
    #[error("{one} and {other} exclude each other: {why}\n  way out: leave out one of them")]
    Conflict {
        /// The first choice.
        one: String,
        /// The second choice.
        other: String,
        /// Why.
        why: String,
    },
    /// A scenario file that cannot be read.
    #[error("cannot read the scenario {}: {source}", echo::path(path))]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// A scenario file that is too long to be one.
    #[error(
        "the scenario {} has more than {most} bytes\n  \
         way out: so many discs come from a file of frames: --start FILE",
        echo::path(path)
    )]
    TooLong {
        /// The file.
        path: PathBuf,
        /// The most bytes it may have.
        most: u64,
    },
    /// A scenario file with a mistake in it.
    #[error("{}, line {line}, column {column}: {message}", echo::path(path))]
    Malformed {
        /// The file.
        path: PathBuf,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What is wrong there.
        message: String,
    },
    /// A frame file that cannot serve as a start.
    #[error("cannot start from {}: {why}", echo::path(path))]
    BadStart {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        why: String,
    },
    /// No room for the discs.
    #[error("{source}\n  way out: {way_out}")]
    BoxTooFull {
        /// How far placement came.
        source: PlacementError,
        /// What would fit.
        way_out: String,
    },
    /// Discs that overlap too much at the start.
    #[error("{what} at the start\n  way out: {way_out}")]
    BadOverlap {
        /// The discs at fault.
        who: String,
        /// Who overlaps whom, and by how much.
        what: String,
        /// What to do.
        way_out: String,
    },
    /// A time step above the stable limit.
    #[error("{0}")]
    Unstable(Box<Finding>),
}

impl ScenarioError {
    /// What is at fault: a flag, or the table and key of a scenario file, or the file.
    pub fn fault(&self) -> String {
        match self {
            // A key of its own is a flag too; `disc 0: radius` is not.
            Self::OutOfRange { field, .. } if !field.contains([' ', ':']) => {
                format!("--{}", field.replace('_', "-"))
            }
            Self::OutOfRange { field, .. } => field.clone(),
            Self::Conflict { other, .. } => other.clone(),
            Self::Unreadable { path, .. } | Self::TooLong { path, .. } => echo::path(path),
            Self::Malformed { path, line, .. } => format!("{}, line {line}", echo::path(path)),
            Self::BadStart { .. } => "--start".to_owned(),
            Self::BoxTooFull { .. } => "-n".to_owned(),
            Self::BadOverlap { who, .. } => who.clone(),
            Self::Unstable(finding) => finding.fault.clone(),
        }
    }

    /// The value at fault, where one number is.
    pub fn value(&self) -> Option<String> {
        match self {
            Self::OutOfRange { value, .. } => Some(value.clone()),
            Self::Unstable(finding) => Some(finding.value.clone()),
            _ => None,
        }
    }

    /// What to do.
    pub fn way_out(&self) -> Option<String> {
        match self {
            Self::OutOfRange { way_out, .. }
            | Self::BoxTooFull { way_out, .. }
            | Self::BadOverlap { way_out, .. } => Some(way_out.clone()),
            Self::Conflict { one, other, .. } => Some(format!("leave out {one} or {other}")),
            Self::Unstable(finding) => Some(finding.ways_out.join(", or ")),
            Self::BadStart { why, .. } => {
                why.split_once("way out: ").map(|(_, way_out)| way_out.to_owned())
            }
            _ => None,
        }
    }

    /// An [`OutOfRange`](Self::OutOfRange) from anything printable.
    pub fn out_of_range(
        field: impl Into<String>,
        value: impl ToString,
        allowed: impl Into<String>,
        way_out: impl Into<String>,
    ) -> Self {
        Self::OutOfRange {
            field: field.into(),
            value: value.to_string(),
            allowed: allowed.into(),
            way_out: way_out.into(),
        }
    }
}
