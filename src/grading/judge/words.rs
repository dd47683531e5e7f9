//! What reports of grading say.

mod finding;
mod note;
mod quantity;

use super::check::{self, Check, CheckWords};
use super::mistake::{self, Mistake, MistakeWords};
use super::wall::{self, Wall};
use crate::table::table;

type Text = &'static str;

pub use self::finding::{Finding, FindingWords};
pub use self::note::Note;
pub use self::quantity::Quantity;

table! {
    /// The words of a language.
    #[derive(Clone, Copy, Debug)]
    pub struct Words, const ENGLISH {
        /// Its code.
        code: Text = "en";
        /// Of checks.
        check: fn(Check) -> CheckWords = check::english;
        /// Of findings.
        finding: fn(Finding) -> FindingWords = finding::english;
        /// Of numbers, with units.
        quantity: fn(Quantity) -> Text = quantity::english;
        /// Of walls.
        wall: fn(Wall) -> Text = wall::english;
        /// Of notes.
        note: fn(Note) -> Text = note::english;
        /// Of mistakes.
        mistake: fn(Mistake) -> MistakeWords = mistake::english;
        /// Before the name, the numbers and the own hint of a unit test.
        case: [Text; 3] = ["case", "given", "hint of this case"];
        /// Before files that are not there, and before archives that are.
        missing: [Text; 2] = ["missing", "still packed"];
        /// Before the first line that is no disc.
        bad_line: Text = "the first of these lines";
        /// Before the name of a program that should have been built and was not.
        no_program: Text = "the build ended well, but there is no program";
        /// Before the frame of a failure.
        frame: Text = "frame";
        /// Before its discs.
        discs: Text = "disc";
        /// Before what was expected.
        expected: Text = "expected";
        /// Before the mistake.
        looks_like: Text = "looks like";
        /// Before the hint.
        hint: Text = "hint";
        /// Said of a check that could not be decided.
        not_seen: Text = "not seen: nothing in these frames decides it";
        /// Said of `many` where the program is not told how many discs.
        not_told: Text = "not seen: the program is not told how many discs ({n} is neither in `arguments` nor in `stdin` of the rubric)";
        /// Said of `interface` where the rubric has no unit tests.
        no_interface: Text = "not seen: the rubric has no [interface]";
        /// Said of a check that the assignment's trap hides.
        masked: Text = "masked: the printed eta_n made contacts explode, and this cannot be seen behind it; no points are lost";
        /// Before the failed check that a skipped one hangs on.
        skipped: Text = "can't be judged until this is right:";
        /// Between points earned and all, and after those that are left out.
        points: [Text; 2] = ["of", "not judged"];
        /// Before the numbers of cut and of unevenly spaced frames.
        left_out: [Text; 2] = ["cut frames left out:", "frames at uneven times left out:"];
        /// One point, and several.
        point: [Text; 2] = ["point", "points"];
        /// Before the needed check in an explanation.
        after: Text = "asked after";
        /// Before the part of the points that a mistake leaves.
        part_left: Text = "part of the points that it leaves";
    }
}

impl Words {
    /// What so many points are called.
    ///
    /// ```
    /// use parsim2d::grading::judge::words::ENGLISH;
    /// assert_eq!([1.0, 0.5, 2.0].map(|points| ENGLISH.points_of(points)), ["point", "points", "points"]);
    /// ```
    pub fn points_of(&self, points: f64) -> &'static str {
        self.point[usize::from(points != 1.0)]
    }
}
