//! Who grades: a sandbox, and what a course asks for.

use std::path::{Path, PathBuf};

use super::program::Course;
use crate::grading::sandbox::{Sandbox, SandboxError, Submission, Workspace};

/// Grades submissions of one course in one sandbox.
#[derive(Clone, Copy)]
pub struct Grader<'a> {
    /// Where submissions are built and run.
    pub sandbox: &'a Sandbox,
    /// What the course asks for.
    pub course: &'a Course,
}

impl Grader<'_> {
    /// Copies and builds by this command.
    pub(super) fn prepare(
        &self,
        folder: &Path,
        build: &[String],
    ) -> Result<Workspace<'_>, SandboxError> {
        let files = self.course.program().files.iter().map(PathBuf::from).collect();
        let submission = Submission { folder: folder.to_owned(), files, build: build.to_vec() };
        self.sandbox.prepare(&submission, &self.course.limits())
    }
}
