//! Which mistake a failure looks like.

use serde::{Deserialize, Serialize};

/// A mistake that students make; its name in files is stable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Mistake {
    /// The Makefile was not handed in.
    NoMakefile,
    /// The compiler, the linker or make gives up.
    DoesNotBuild,
    /// A signal or an exit code other than 0.
    Crashes,
    /// It ends well and wrote nothing.
    EndsWithoutFrames,
    /// Not ready when the time was over.
    TooSlow,
    /// It wrote more than there is room for.
    OutputTooLarge,
    /// It asked for more memory or processes than allowed.
    StoppedByLimits,
    /// Nothing was written.
    EmptyFile,
    /// Lines, but no frame.
    NoFrames,
    /// Fewer than three columns.
    WrongColumns,
    /// Most frames are cut.
    FrameTorn,
    /// NaN or infinity.
    NotANumber,
    /// A disc is gone.
    DiscLost,
    /// Rows change places.
    DiscOrderChanges,
    /// The third column is twice the radius.
    DiameterAsRadius,
    /// Discs overlap in the first frame.
    PlacedOverlapping,
    /// A disc begins outside the box or in a wall.
    PlacedOutside,
    /// Discs fly on through a wall.
    WallMissing,
    /// Discs are drawn out through a wall.
    InwardWallNormal,
    /// The wall is met by the centre.
    WallAtCentre,
    /// Discs fall upward.
    GravitySign,
    /// Nothing falls.
    GravityMissing,
    /// Discs fall to a side.
    GravitySideways,
    /// Something slows discs in flight.
    FrictionInFlight,
    /// Frames are not equally far apart in time.
    TimeStepNotConstant,
    /// A contact force over another mass than the disc's, or over none.
    ForceOverWrongMass,
    /// The push of a pair hangs on the distance of the centres twice.
    NormalNotNormalised,
    /// Each pair pushes twice.
    ForceAppliedTwice,
    /// One disc is pushed, its partner is not.
    ForceOnOneDiscOnly,
    /// Discs push only when nearer than one radius.
    ContactAtOneRadius,
    /// Discs pass through one another.
    Tunnelling,
    /// Position updated with the old velocity.
    ExplicitEuler,
    /// The dashpot pushes where it should brake.
    DampingSign,
    /// Energy grows, elsewhere than in bounces.
    EnergyPump,
    /// Elastic discs lose energy.
    EnergyLostElastic,
    /// Another restitution than asked.
    RestitutionWrong,
}

impl Mistake {
    /// Its name in files.
    pub fn id(self) -> String {
        serde_json::to_value(self)
            .ok()
            .and_then(|v| v.as_str().map(str::to_owned))
            .unwrap_or_default()
    }
}
