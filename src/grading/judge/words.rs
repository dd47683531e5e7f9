//! What reports of grading say: one table of words for each language. A new language is a new
//! constant; the compiler asks for every entry.

mod english;

use serde::Serialize;

use super::check::Check;
use super::mistake::Mistake;
use super::wall::Wall;

pub use self::english::ENGLISH;

/// What a check found amiss.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Finding {
    /// A file that was asked for is not there.
    FileMissing,
    /// It asks for more on its standard input than there is.
    AsksForInput,
    /// make, the compiler or the linker failed.
    BuildFails,
    /// The build took too long.
    BuildTakesTooLong,
    /// A signal or an exit code other than 0.
    Crashed,
    /// It ended and wrote nothing.
    EndedWithoutFrames,
    /// Fewer frames than the rubric wants.
    TooFewFrames,
    /// It wrote too few frames in the time it has.
    TakesTooLong,
    /// It wrote too much.
    WritesTooMuch,
    /// It was stopped by a limit on memory, processes or processor time.
    Stopped,
    /// The compiler warns.
    Warned,
    /// A sanitizer reports.
    Misused,
    /// Another number of discs than asked for.
    CountNotAsked,
    /// Contacts are much softer than asked.
    ContactTooSoft,
    /// A wall is felt elsewhere.
    WallShifted,
    /// Both of a pair are pushed the same way.
    PushedAlike,
    /// Some pairs pass through one another.
    SomePassThrough,
    /// The pull grows from frame to frame.
    PullGrows,
    /// A free disc stops.
    StopsInFlight,
    /// Contacts are stiffer than asked.
    ContactTooStiff,
    /// An empty file.
    NothingWritten,
    /// No line is a disc.
    NoRows,
    /// More frames are cut than whole.
    MostlyTorn,
    /// NaN or infinity.
    NotFinite,
    /// Another number of discs.
    CountChanges,
    /// Rows continue each other's paths.
    OrderChanges,
    /// A radius that was not asked for.
    WrongRadius,
    /// x, y and r are in other columns.
    ColumnsExchanged,
    /// Lengths are in another unit.
    OtherUnit,
    /// The box has another corner.
    BoxShifted,
    /// A radius that changes.
    RadiusChanges,
    /// A disc too far beyond a wall.
    LeavesTheBox,
    /// A disc that leaves by a wall and comes in by the opposite one.
    ComesBackOpposite,
    /// A disc in a wall at the start.
    StartsInWall,
    /// Two discs overlap at the start.
    StartsOverlapping,
    /// A constant acceleration, but not the asked one.
    WrongPull,
    /// All frames are the same.
    NothingMoves,
    /// An acceleration that changes in flight.
    PullNotConstant,
    /// A wall changes the velocity along it.
    WallDragsAlong,
    /// Discs pass through one another.
    PassThrough,
    /// Pushes are not equal and opposite.
    PushesUnequal,
    /// Pushes are not along the line of centres.
    PushCrooked,
    /// Another restitution.
    WrongRestitution,
    /// Energy grows.
    EnergyGrows,
    /// Energy falls.
    EnergyFalls,
    /// The probe cannot be built with what was handed in.
    ProbeNotBuilt,
    /// The probe ended with an error, or not in its time.
    ProbeEndsBadly,
    /// The probe printed fewer numbers than expected.
    TooFewNumbers,
    /// The probe printed other numbers.
    OtherNumbers,
    /// Late in a long film a disc is where no heap reaches.
    HangsInTheEnd,
    /// Late in a long film discs that lose speed still move.
    NeverRests,
    /// Velocities in a long film are not those of a gas.
    NotGaussian,
    /// Heights in a long film are not those of a gas.
    NotExponential,
}

/// What the reader should know, though it costs nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Note {
    /// Discs that touch never part: eta_n as the guide prints it.
    PrintedEta,
    /// Contacts multiply speeds: eta_n as the guide prints it, with the guide's own step.
    PrintedEtaExplodes,
    /// Columns were taken for x, y and r without a word of which they are.
    ColumnsTaken,
    /// What ran was handed in, and the build did not make it anew.
    ProgramNotRebuilt,
    /// The program asks for more on its standard input than there is.
    AsksForInput,
    /// Less than half of what is asked of motion could be judged.
    LittleJudged,
}

/// What a number of a failure is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Lines that are no disc.
    BadLines,
    /// Cut frames.
    TornFrames,
    /// Discs.
    Count,
    /// Discs in the first frame.
    CountAtStart,
    /// Radius, m.
    Radius,
    /// Radius that the rubric has, m.
    RadiusAsked,
    /// Radius in the first frame, m.
    RadiusAtStart,
    /// Depth over radius.
    DepthOverRadius,
    /// The largest that is right.
    LargestDepthOverRadius,
    /// Second difference of x, m a frame².
    PullX,
    /// Second difference of y, m a frame².
    PullY,
    /// The usual one of x.
    UsualPullX,
    /// The usual one of y.
    UsualPullY,
    /// What printing makes of it.
    Blur,
    /// Part of the places looked at.
    Share,
    /// Change of the speed along a wall over the speed across it.
    SlipOverSpeed,
    /// Nearest distance of the undisturbed paths over the sum of radii.
    Aim,
    /// Kick of the first disc over the relative speed.
    KickFirst,
    /// Kick of the second.
    KickSecond,
    /// Change of the relative angular momentum.
    Twist,
    /// Median restitution.
    Restitution,
    /// The expected one.
    ExpectedRestitution,
    /// Change of the energy over the energy.
    EnergyChange,
    /// Discs asked for.
    CountAsked,
    /// Stiffness of contacts over the rubric's.
    Stiffness,
    /// How far beyond the wall discs touch, over the radius.
    ShiftOverRadius,
    /// Second difference of the first disc of a pair, m a frame².
    BendFirst,
    /// Of the second.
    BendSecond,
    /// Meetings of two discs.
    Meetings,
    /// Seconds of wall time.
    Seconds,
    /// Exit code.
    ExitCode,
    /// Signal.
    Signal,
    /// Bytes.
    Bytes,
    /// Frames.
    Frames,
    /// Frames that the rubric wants.
    FramesWanted,
    /// A number that a function gave.
    Came,
    /// The number that it should give.
    Expected,
    /// Numbers printed.
    Numbers,
    /// Numbers that should be printed.
    NumbersWanted,
    /// Height of a disc's lowest point over the floor, radii.
    HeightOverRadius,
    /// Speed over that of a fall from ceiling to floor.
    SpeedOverFall,
    /// Largest distance of two distributions.
    Distance,
    /// The largest that a right program's may have.
    LargestDistance,
    /// Places of discs that were used.
    Places,
    /// Column of x, y or r, from 1.
    Column,
    /// Lower left corner of the box as it seems, x, m.
    CornerX,
    /// The same, y, m.
    CornerY,
}

/// The words for a check.
#[derive(Clone, Copy, Debug)]
pub struct CheckWords {
    /// What is so if it is passed.
    pub title: &'static str,
    /// What is measured, and why.
    pub explained: &'static str,
}

/// The words for a finding.
#[derive(Clone, Copy, Debug)]
pub struct FindingWords {
    /// What is seen.
    pub what: &'static str,
    /// What should be seen.
    pub expected: &'static str,
}

/// The words for a mistake.
#[derive(Clone, Copy, Debug)]
pub struct MistakeWords {
    /// The mistake.
    pub looks_like: &'static str,
    /// Where to look; it does not give the answer away.
    pub hint: &'static str,
}

/// The words of a language.
#[derive(Clone, Copy, Debug)]
pub struct Words {
    /// Its code.
    pub code: &'static str,
    /// Of checks.
    pub check: fn(Check) -> CheckWords,
    /// Of findings.
    pub finding: fn(Finding) -> FindingWords,
    /// Of numbers, with units.
    pub quantity: fn(Quantity) -> &'static str,
    /// Of walls.
    pub wall: fn(Wall) -> &'static str,
    /// Of notes.
    pub note: fn(Note) -> &'static str,
    /// Of mistakes.
    pub mistake: fn(Mistake) -> MistakeWords,
    /// Before the name, the numbers and the own hint of a unit test.
    pub case: [&'static str; 3],
    /// Before files that are not there, and before archives that are.
    pub missing: [&'static str; 2],
    /// Before the first line that is no disc.
    pub bad_line: &'static str,
    /// Before the name of a program that should have been built and was not.
    pub no_program: &'static str,
    /// Before the frame of a failure.
    pub frame: &'static str,
    /// Before its discs.
    pub discs: &'static str,
    /// Before what was expected.
    pub expected: &'static str,
    /// Before the mistake.
    pub looks_like: &'static str,
    /// Before the hint.
    pub hint: &'static str,
    /// Said of a check that could not be decided.
    pub not_seen: &'static str,
    /// Said of `many` where the program is not told how many discs.
    pub not_told: &'static str,
    /// Said of `interface` where the rubric has no unit tests.
    pub no_interface: &'static str,
    /// Said of a check that the assignment's trap hides.
    pub masked: &'static str,
    /// Before the failed check that a skipped one hangs on.
    pub skipped: &'static str,
    /// Between points earned and all, and after those that are left out.
    pub points: [&'static str; 2],
    /// Before the numbers of cut and of unevenly spaced frames.
    pub left_out: [&'static str; 2],
    /// One point, and several.
    pub point: [&'static str; 2],
    /// Before the needed check in an explanation.
    pub after: &'static str,
    /// Before the part of the points that a mistake leaves.
    pub part_left: &'static str,
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
