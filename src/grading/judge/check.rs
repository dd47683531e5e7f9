//! What is asked of a submission, and which question makes sense only after which.

use serde::{Deserialize, Serialize};

/// A question; its name in files is stable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Check {
    /// All files were handed in.
    Files,
    /// The program can be built.
    Builds,
    /// It runs, and ends or goes on by itself.
    Runs,
    /// The file holds frames.
    Frames,
    /// The same discs in every frame, with finite numbers.
    Discs,
    /// Radii constant and as asked.
    Radii,
    /// Nobody leaves the box.
    Box,
    /// Nobody overlaps at the start.
    Start,
    /// Constant acceleration, downward, the same for all, while nothing is near.
    FreeFlight,
    /// A wall changes the velocity across it only.
    WallBounce,
    /// Two discs push each other equally, oppositely, along their centres.
    PairCollision,
    /// Speed after over speed before, at a wall.
    RestitutionWall,
    /// The same for two discs.
    RestitutionPair,
    /// The energy of all never grows, and stays if nothing takes it.
    Energy,
    /// In a long film discs come to rest at the bottom, or are a gas in equilibrium.
    LongRun,
    /// A box of many discs: a thousand, if the rubric does not say.
    Many,
    /// The compiler has nothing to warn of.
    Warnings,
    /// Memory and arithmetic are as the language asks.
    Sanitizer,
    /// Functions of a header give the numbers that the instructor's probe asks for.
    Interface,
}

impl Check {
    /// All, in the order in which they are asked.
    pub const ALL: [Self; 19] = [
        Self::Files,
        Self::Builds,
        Self::Runs,
        Self::Frames,
        Self::Discs,
        Self::Radii,
        Self::Box,
        Self::Start,
        Self::FreeFlight,
        Self::WallBounce,
        Self::PairCollision,
        Self::RestitutionWall,
        Self::RestitutionPair,
        Self::Energy,
        Self::LongRun,
        Self::Many,
        Self::Warnings,
        Self::Sanitizer,
        Self::Interface,
    ];

    /// Whether frames alone decide it; the others need a submission that can be built and run.
    pub fn is_of_frames(self) -> bool {
        use Check as C;
        !matches!(
            self,
            C::Files | C::Builds | C::Runs | C::Many | C::Warnings | C::Sanitizer | C::Interface
        )
    }

    /// Whether it is about how discs move.
    pub fn is_of_motion(self) -> bool {
        self.is_of_frames() && self >= Self::FreeFlight
    }

    /// Its name in files and on the command line.
    pub fn id(self) -> &'static str {
        match self {
            Self::Files => "files",
            Self::Builds => "builds",
            Self::Runs => "runs",
            Self::Frames => "frames",
            Self::Discs => "discs",
            Self::Radii => "radii",
            Self::Box => "box",
            Self::Start => "start",
            Self::FreeFlight => "free_flight",
            Self::WallBounce => "wall_bounce",
            Self::PairCollision => "pair_collision",
            Self::RestitutionWall => "restitution_wall",
            Self::RestitutionPair => "restitution_pair",
            Self::Energy => "energy",
            Self::LongRun => "long_run",
            Self::Many => "many",
            Self::Warnings => "warnings",
            Self::Sanitizer => "sanitizer",
            Self::Interface => "interface",
        }
    }

    /// The check of that name.
    pub fn named(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|check| check.id() == id)
    }

    /// The check that must be passed, or not seen, before this one is asked.
    pub fn needs(self) -> Option<Self> {
        match self {
            Self::Files => None,
            Self::Builds => Some(Self::Files),
            Self::Runs | Self::Warnings | Self::Interface => Some(Self::Builds),
            Self::Frames | Self::Sanitizer => Some(Self::Runs),
            Self::Discs => Some(Self::Frames),
            Self::Radii | Self::Box | Self::Start | Self::FreeFlight => Some(Self::Discs),
            Self::WallBounce | Self::PairCollision | Self::Energy => Some(Self::FreeFlight),
            Self::RestitutionWall => Some(Self::WallBounce),
            Self::RestitutionPair => Some(Self::PairCollision),
            Self::LongRun | Self::Many => Some(Self::Energy),
        }
    }

    /// Points, unless the rubric says otherwise: what is physics weighs more.
    pub fn usual_points(self) -> f64 {
        match self {
            Self::FreeFlight => 3.0,
            Self::WallBounce | Self::PairCollision | Self::Energy => 2.0,
            _ => 1.0,
        }
    }
}
