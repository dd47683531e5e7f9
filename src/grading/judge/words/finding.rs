//! What a check found amiss.

use serde::Serialize;

/// The words for a finding.
#[derive(Clone, Copy, Debug)]
pub struct FindingWords {
    /// What is seen.
    pub what: &'static str,
    /// What should be seen.
    pub expected: &'static str,
}

/// The findings, each with what is seen and what should be seen, in English.
macro_rules! findings {
    ($($finding:ident: $what:literal, $expected:literal;)+) => {
        /// What a check found amiss.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
        #[serde(rename_all = "snake_case")]
        pub enum Finding { $(#[doc = $what] $finding,)+ }

        /// English.
        #[allow(clippy::too_many_lines)] // a table
        pub(super) fn english(finding: Finding) -> FindingWords {
            let (what, expected) = match finding { $(Finding::$finding => ($what, $expected),)+ };
            FindingWords { what, expected }
        }
    };
}

findings! {
    FileMissing: "a file that was asked for is not there", "the files that the assignment names";
    AsksForInput: "the program asks for more on its standard input than there is, and wrote no frames or too few", "a program that needs nobody at the keyboard";
    BuildFails: "the program cannot be built", "a build without errors, and the program under the name asked for";
    BuildTakesTooLong: "the build did not end in its time", "a build of seconds";
    Crashed: "the program ended with an error", "exit code 0, or a program that goes on";
    EndedWithoutFrames: "the program ended and left no frame", "frames in out.txt";
    TooFewFrames: "there are too few frames to see anything move", "one frame after another with a blank line between them, as many as the assignment asks for";
    TakesTooLong: "the program wrote too few frames in the time it has", "frames one after another";
    WritesTooMuch: "the program wrote more than there is room for", "frames of some hundred bytes to some hundred kilobytes";
    Stopped: "the program was stopped by a limit on memory, processes or processor time", "one process and some megabytes";
    Warned: "the compiler warns", "no warning with -Wall -Wextra";
    Misused: "a sanitizer reports a fault", "no report";
    CountNotAsked: "not the number of discs asked for", "every disc, from the first frame on";
    ContactTooSoft: "contacts push too weakly: they last too long", "the stiffness of the assignment";
    WallShifted: "discs turn at another place than the wall", "a push as soon as the edge of a disc touches the wall";
    PushedAlike: "two discs are pushed the same way", "opposite changes of velocity of the same size";
    SomePassThrough: "some discs lie or fly through one another, while others push", "a push as soon as their edges touch, whichever two they are";
    PullGrows: "free discs fall faster and faster from frame to frame, all alike", "the same second difference (0, -c) in every frame";
    StopsInFlight: "a disc that meets nobody stops in the air", "the same (0, -c) for every disc at every moment";
    ContactTooStiff: "contacts push too strongly: they are over too soon", "the stiffness of the assignment";
    NothingWritten: "nothing was written", "frames of `x y r` lines";
    NoRows: "no line is a disc", "lines of three numbers, `x y r`, with blanks between them";
    MostlyTorn: "more frames are cut than whole", "as many rows in every frame";
    NotFinite: "a number is NaN or infinite", "finite numbers";
    CountChanges: "the number of discs changes", "every disc in every frame";
    OrderChanges: "two rows have changed places", "each disc in its own row";
    WrongRadius: "the third column is not a radius of this assignment", "the radius of the assignment, in m";
    ColumnsExchanged: "x, y and r are not the first three columns", "`x y r` at the beginning of each line; more columns may follow";
    OtherUnit: "all lengths are too large by the same factor", "x, y and r in m";
    BoxShifted: "the box of these frames is not where the assignment has it", "the lower left corner of the assignment's box";
    RadiusChanges: "a radius changes", "the same radius in every frame";
    LeavesTheBox: "a disc goes further into a wall than its spring lets it", "at most the depth at which the wall's spring has stopped it";
    ComesBackOpposite: "a disc leaves by a wall and comes back by the opposite one", "walls that push discs back";
    StartsInWall: "a disc begins in a wall or outside", "centres at least a radius from every wall";
    StartsOverlapping: "two discs overlap at the start", "centres at least the sum of radii apart";
    WrongPull: "discs that meet nobody do not fall as they should", "one constant second difference, (0, -c) with c > 0";
    NothingMoves: "nothing moves: all frames are the same", "discs that fall from frame to frame";
    PullNotConstant: "the second difference of free discs changes", "the same (0, -c) for every disc at every moment";
    WallDragsAlong: "a wall changes the velocity along it", "a wall without friction pushes along its normal only";
    PassThrough: "discs on course for each other fly on as if nobody were there", "a push as soon as their edges touch";
    PushesUnequal: "two discs do not push each other equally and oppositely", "opposite changes of velocity of the same size";
    PushCrooked: "discs push each other aside from the line of their centres", "the relative angular momentum as before";
    WrongRestitution: "the speed after contacts is not what it should be", "the restitution that follows from the assignment";
    EnergyGrows: "the energy of all discs grows", "energy that stays, or falls with damping";
    EnergyFalls: "elastic discs lose energy", "energy that stays";
    ProbeNotBuilt: "the instructor's program that includes your header cannot be built", "names, types and files as in the assignment's interface";
    ProbeEndsBadly: "the instructor's program that calls your functions ended with an error, or not in its time", "functions that return";
    TooFewNumbers: "the instructor's program that calls your functions printed too few numbers", "the numbers of the case";
    OtherNumbers: "a function gives other numbers than it should", "the numbers of the case, to its tolerance";
    HangsInTheEnd: "a disc stays in the air after all should have come to rest", "a heap at the bottom";
    NeverRests: "discs go on moving after they should have come to rest", "discs that each contact makes slower, until they lie still";
    NotGaussian: "the velocities of elastic discs are not those of a gas", "Gaussian components of one variance";
    NotExponential: "the heights of elastic discs are not those of a gas", "an exponential, with a scale of kT/(m g) by the velocities";
}
