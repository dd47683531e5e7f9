//! What a number of a failure is.

use serde::Serialize;

/// The quantities, each with its name and unit in English.
macro_rules! quantities {
    ($($quantity:ident: $name:literal;)+) => {
        /// What a number of a failure is.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
        #[serde(rename_all = "snake_case")]
        pub enum Quantity { $(#[doc = $name] $quantity,)+ }

        /// English.
        #[allow(clippy::too_many_lines)] // a table
        pub(super) fn english(quantity: Quantity) -> &'static str {
            match quantity { $(Quantity::$quantity => $name,)+ }
        }
    };
}

quantities! {
    BadLines: "lines that are no disc";
    TornFrames: "cut frames";
    Count: "discs here";
    CountAtStart: "discs at the start";
    Radius: "printed, m";
    RadiusAsked: "asked for, m";
    RadiusAtStart: "in the first frame, m";
    DepthOverRadius: "depth, radii";
    LargestDepthOverRadius: "largest depth to be expected, radii";
    PullX: "second difference of x, m a frame²";
    PullY: "second difference of y, m a frame²";
    UsualPullX: "usual one of x";
    UsualPullY: "usual one of y";
    Blur: "what rounding of the digits makes at most";
    Share: "part of the places looked at";
    SlipOverSpeed: "change along the wall over the speed across it";
    Aim: "distance at which they would pass, touching distances";
    KickFirst: "kick of the first, relative speeds";
    KickSecond: "kick of the second, relative speeds";
    Twist: "change of the relative angular momentum, touching distance times speed";
    Restitution: "median restitution e";
    ExpectedRestitution: "expected e";
    EnergyChange: "change of the energy, parts of it";
    CountAsked: "discs asked for";
    Stiffness: "stiffness, parts of the one asked for";
    ShiftOverRadius: "beyond the wall, radii";
    BendFirst: "second difference of the first, m a frame²";
    BendSecond: "second difference of the second, m a frame²";
    Meetings: "such meetings";
    Seconds: "time, s";
    ExitCode: "exit code";
    Signal: "signal";
    Bytes: "written, bytes";
    Frames: "frames";
    FramesWanted: "frames wanted, at least";
    Came: "came out";
    Expected: "should be";
    Numbers: "numbers printed";
    NumbersWanted: "numbers expected";
    HeightOverRadius: "height over the floor, radii";
    SpeedOverFall: "speed (root mean square) over that of a fall from ceiling to floor";
    Distance: "largest distance of the distributions";
    LargestDistance: "largest distance to be expected";
    Places: "places of discs that were used";
    Column: "x, y, r in turn: right if read from column";
    CornerX: "left wall of the box in these frames, x, m";
    CornerY: "floor of the box in these frames, y, m";
}
