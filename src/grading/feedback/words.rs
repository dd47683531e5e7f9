//! What sheets say beside the words of grading: one table for each language.

mod english;

pub use self::english::ENGLISH;

/// How a check came out, as a reader sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// Passed.
    Passed,
    /// Failed, and part of the points were kept.
    Partly,
    /// Failed.
    Failed,
    /// Nothing decided it.
    NotSeen,
    /// It hangs on a check that failed.
    Skipped,
    /// The assignment's own trap hides it.
    Masked,
}

impl Face {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Passed, Self::Partly, Self::Failed, Self::NotSeen, Self::Skipped, Self::Masked];

    /// Its name in style sheets and files.
    pub fn id(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Partly => "partly",
            Self::Failed => "failed",
            Self::NotSeen => "not_seen",
            Self::Skipped => "skipped",
            Self::Masked => "masked",
        }
    }

    /// A sign for it, legible without colours.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Passed => "✓",
            Self::Partly => "◐",
            Self::Failed => "✗",
            Self::NotSeen => "·",
            Self::Skipped => "–",
            Self::Masked => "≈",
        }
    }
}

/// The words of a language.
#[derive(Clone, Copy, Debug)]
pub struct Words {
    /// The words of grading in the same language.
    pub grade: &'static crate::grading::judge::words::Words,
    /// Title of a student's sheet, before the name.
    pub sheet: &'static str,
    /// Title of the page of a class.
    pub class: &'static str,
    /// Of faces.
    pub face: fn(Face) -> &'static str,
    /// Below the faces: what the last two mean for points.
    pub kindly: fn(Face) -> &'static str,
    /// In its place for `many` where the program is not told how many discs.
    pub not_told: &'static str,
    /// In its place for `interface` where the rubric has no unit tests.
    pub no_interface: &'static str,
    /// Heading of the checks.
    pub checks: &'static str,
    /// Before what was found.
    pub found: &'static str,
    /// Heading of what is good to know.
    pub notes: &'static str,
    /// Said of a sheet on which checks are still to come.
    pub partial: &'static str,
    /// Before the number of checks that count and are not shown.
    pub hidden: &'static str,
    /// Name of the checks that count and are not shown, taken together.
    pub hidden_test: &'static str,
    /// Heading of what a tool printed.
    pub said: &'static str,
    /// Heading of what build and run printed.
    pub log: &'static str,
    /// After the beginning of a long text.
    pub cut: &'static str,
    /// Below a picture.
    pub picture: &'static str,
    /// Heading of how it was graded.
    pub how: &'static str,
    /// What it was graded with: version, frames, discs, time.
    pub how_rows: [&'static str; 4],
    /// Before the tier, for instructors.
    pub sandbox: &'static str,
    /// In place of the tier if nothing was run.
    pub no_tier: &'static str,
    /// Heading of the numbers of the rubric.
    pub rubric: &'static str,
    /// Names of its numbers: n, side, radius, mass, gravity, stiffness, damping, e of walls, e of pairs.
    pub rubric_rows: [&'static str; 9],
    /// In place of numbers that may be any.
    pub any: &'static str,
    /// Heads of the table of a class: whose, per cent, mistakes.
    pub class_head: [&'static str; 3],
    /// Below the title of a class: one submission, several, median.
    pub class_line: [&'static str; 3],
    /// Heading of the distribution.
    pub distribution: &'static str,
    /// Below it.
    pub distribution_caption: &'static str,
    /// Heading of the mistakes of a class.
    pub mistakes: &'static str,
    /// Heads: what, submissions, check.
    pub mistakes_head: [&'static str; 3],
    /// Said of a class without mistakes.
    pub no_mistakes: &'static str,
    /// For a failure of which no mistake is known.
    pub unknown_mistake: &'static str,
    /// Heading of those that could not be graded.
    pub ungraded: &'static str,
    /// For a check of which no point is decided: a score was scaled.
    pub scaled: &'static str,
}
