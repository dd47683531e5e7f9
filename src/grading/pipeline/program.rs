//! What the rubric says of building and running, as the sandbox wants it.

use std::time::Duration;

use crate::grading::judge::rubric::Rubric;
use crate::grading::judge::rubric::program::Program;
use crate::grading::sandbox::{Invocation, Limits};

/// A course: what is asked of discs, and how submissions become programs.
#[derive(Clone, Debug)]
pub struct Course {
    /// What is asked of discs, and points.
    pub rubric: Rubric,
    /// Commands, word by word.
    pub(super) build: Vec<String>,
    pub(super) run: Vec<String>,
    pub(super) warnings: Vec<Vec<String>>,
    pub(super) sanitizer: Vec<Vec<String>>,
}

impl Course {
    /// The programs that its commands begin with, to build and to run.
    pub fn tools(&self) -> impl Iterator<Item = &String> {
        self.build.first().into_iter().chain(self.run.first())
    }

    /// The course of a rubric.
    ///
    /// Fails where a command has a quotation mark without its other half.
    pub fn of(rubric: Rubric) -> Result<Self, String> {
        let Program { build, run, warnings, sanitizer, .. } = &rubric.program;
        let words = |key: &str, command: &str| {
            shlex::split(command).ok_or_else(|| {
                format!("program.{key} = {command:?}: a quotation mark has no other half")
            })
        };
        Ok(Self {
            build: words("build", build)?,
            run: words("run", run)?,
            warnings: warnings
                .iter()
                .map(|one| words("warnings", one))
                .collect::<Result<_, _>>()?,
            sanitizer: sanitizer
                .iter()
                .map(|one| words("sanitizer", one))
                .collect::<Result<_, _>>()?,
            rubric,
        })
    }

    /// What the rubric says of building and running.
    pub fn program(&self) -> &Program {
        &self.rubric.program
    }

    /// How much of everything a submission may have.
    pub(super) fn limits(&self) -> Limits {
        let program = self.program();
        Limits {
            build_wall: Duration::from_secs_f64(program.build_seconds),
            run_wall: Duration::from_secs_f64(program.run_seconds),
            ..Limits::default()
        }
    }

    /// A run of `n` discs, of which `frames` are wanted.
    pub(super) fn invocation(&self, n: usize, frames: usize) -> Invocation {
        let filled = |text: &str| {
            let numbers =
                [("{n}", n as u64), ("{seed}", self.program().seed), ("{frames}", frames as u64)];
            numbers.into_iter().fold(text.to_owned(), |text, (name, number)| {
                text.replace(name, &number.to_string())
            })
        };
        let arguments = self.program().arguments.iter().map(|text| filled(text));
        Invocation {
            command: self.run.iter().cloned().chain(arguments).collect(),
            stdin: filled(&self.program().stdin).into_bytes(),
            frames: Some(frames),
            rows: Some(n + self.program().extra_rows),
        }
    }
}
