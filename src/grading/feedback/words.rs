//! What sheets say beside the words of grading.

use crate::grading::judge::words as grade;
use crate::named::named;
use crate::table::table;

type Text = &'static str;

named! {
    /// How a check came out, as a reader sees it.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Face, id {
        /// Passed.
        Passed = "passed",
        /// Failed, and part of the points were kept.
        Partly = "partly",
        /// Failed.
        Failed = "failed",
        /// Nothing decided it.
        NotSeen = "not_seen",
        /// It hangs on a check that failed.
        Skipped = "skipped",
        /// The assignment's own trap hides it.
        Masked = "masked",
    }
}

impl Face {
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

table! {
    /// The words of a language.
    #[derive(Clone, Copy, Debug)]
    pub struct Words, const ENGLISH {
        /// The words of grading in the same language.
        grade: &'static grade::Words = &grade::ENGLISH;
        /// Title of a student's sheet, before the name.
        sheet: Text = "Graded:";
        /// Title of the page of a class.
        class: Text = "The class";
        /// Of faces.
        face: fn(Face) -> Text = face;
        /// Below the faces: what the last two mean for points.
        kindly: fn(Face) -> Text = kindly;
        /// In its place for `many` where the program is not told how many discs.
        not_told: Text = "Programs of this course are not told how many discs to take. It costs no points.";
        /// In its place for `interface` where the rubric has no unit tests.
        no_interface: Text = "This course does not test functions one by one. It costs no points.";
        /// Heading of the checks.
        checks: Text = "Check by check";
        /// Before what was found.
        found: Text = "found";
        /// Heading of what is good to know.
        notes: Text = "Good to know";
        /// Said of a sheet on which checks are still to come.
        partial: Text = "Grading has not ended: checks are still to come, and the points are those so far.";
        /// Before the number of checks that count and are not shown.
        hidden: Text = "checks that count and are not shown:";
        /// Name of the checks that count and are not shown, taken together.
        hidden_test: Text = "checks that are not shown";
        /// Heading of what a tool printed.
        said: Text = "what was printed";
        /// Heading of what build and run printed.
        log: Text = "What building and running printed";
        /// After the beginning of a long text.
        cut: Text = "(and more, left out here)";
        /// Below a picture.
        picture: Text = "The discs of that frame; those that are meant have their numbers. Arrows: which way they \
                  move, the longer the faster.";
        /// Heading of how it was graded.
        how: Text = "How it was graded";
        /// What it was graded with: version, frames, discs, time.
        how_rows: [Text; 4] = ["graded by", "whole frames", "discs", "time that grading took, s"];
        /// Before the tier, for instructors.
        sandbox: Text = "sandbox";
        /// In place of the tier if nothing was run.
        no_tier: Text = "nothing was run: the frames were handed in";
        /// Heading of the numbers of the rubric.
        rubric: Text = "The numbers it was measured by";
        /// Names of its numbers: n, side, radius, mass, gravity, stiffness, damping, e of walls, e of pairs.
        rubric_rows: [Text; 9] = [
            "discs",
            "side of the box, m",
            "radius, m",
            "mass, kg",
            "gravity, m/s²",
            "stiffness k_n, N/m",
            "damping η_n, kg/s",
            "expected e of walls",
            "expected e of pairs",
        ];
        /// In place of numbers that may be any.
        any: Text = "any";
        /// Heads of the table of a class: whose, per cent, mistakes.
        class_head: [Text; 3] = ["submission", "%", "looks like"];
        /// Below the title of a class: one submission, several, median.
        class_line: [Text; 3] = ["submission", "submissions", "median, %"];
        /// Heading of the distribution.
        distribution: Text = "How many per cent";
        /// Below it.
        distribution_caption: Text = "Submissions by per cent of the points that could be judged.";
        /// Heading of the mistakes of a class.
        mistakes: Text = "What to teach again";
        /// Heads: what, submissions, check.
        mistakes_head: [Text; 3] = ["looks like", "submissions", "check"];
        /// Said of a class without mistakes.
        no_mistakes: Text = "No check failed.";
        /// For a failure of which no mistake is known.
        unknown_mistake: Text = "a mistake of another kind";
        /// Heading of those that could not be graded.
        ungraded: Text = "Could not be graded, through no fault of the students";
        /// For a check of which no point is decided: a score was scaled.
        scaled: Text = "what could not be judged is left out, and the score is scaled to the points of all checks";
    }
}

fn face(face: Face) -> &'static str {
    match face {
        Face::Passed => "passed",
        Face::Partly => "partly",
        Face::Failed => "not passed",
        Face::NotSeen => "not seen",
        Face::Skipped => "not asked yet",
        Face::Masked => "masked",
    }
}

fn kindly(face: Face) -> &'static str {
    match face {
        Face::NotSeen => "Nothing in these frames decides it. It costs no points.",
        Face::Skipped => "It can be judged only when this is right:",
        Face::Masked => "It cannot be seen behind what the printed eta_n does. It costs no points.",
        Face::Passed | Face::Partly | Face::Failed => "",
    }
}
