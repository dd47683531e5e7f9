//! Why a command did not do its work.

use std::io;
use std::process::ExitCode;

use super::grade::GradeError;
use super::refusal::Refusal;
use crate::echo;
use crate::output::OutputError;
use crate::output::failure::FailureReport;
use crate::scenario::error::ScenarioError;

/// Why a command did not do its work.
#[derive(Debug, thiserror::Error)]
pub(super) enum Failure {
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    #[error(transparent)]
    Output(#[from] OutputError),
    #[error(transparent)]
    Grade(#[from] GradeError),
    #[error(transparent)]
    Refused(#[from] Refusal),
    #[error(
        "`{}` is neither a subcommand ({known}) nor a scenario file{advice}",
        echo::value(word)
    )]
    UnknownCommand { word: String, known: String, advice: String },
    #[error("{report}{}", again.as_deref().unwrap_or_default())]
    WentWrong { report: Box<FailureReport>, again: Option<String> },
    #[error("writing to standard output failed: {0}")]
    Stdout(#[from] io::Error),
}

impl Failure {
    /// The exit code that tells of it.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::Output(OutputError::Write { .. }) | Self::Stdout(_) | Self::WentWrong { .. } => {
                ExitCode::FAILURE
            }
            Self::Grade(why) => ExitCode::from(why.exit_code()),
            Self::Scenario(_)
            | Self::Output(_)
            | Self::Refused(_)
            | Self::UnknownCommand { .. } => ExitCode::from(2),
        }
    }
}
