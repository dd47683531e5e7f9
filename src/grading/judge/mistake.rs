//! Which mistake a failure looks like.

use serde::{Deserialize, Serialize};

/// A mistake that students make; its name in files is stable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Mistake {
    /// The files are still in an archive.
    ArchiveNotUnpacked,
    /// The Makefile was not handed in.
    NoMakefile,
    /// The compiler, the linker or make gives up.
    DoesNotBuild,
    /// A program that was handed in, and not made anew by the build.
    ProgramNotRebuilt,
    /// It asks for input that nobody gives.
    WaitsForInput,
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
    /// x, y and r stand in other columns.
    ColumnsExchanged,
    /// Lengths in another unit than m.
    OtherUnit,
    /// The box lies elsewhere.
    BoxShifted,
    /// Rows of discs were printed, and not written to the file.
    PrintedOnTheScreen,
    /// One frame is all there is.
    OnlyTheLastFrame,
    /// As many discs whatever number is asked for.
    NumberOfDiscsIgnored,
    /// Most frames are cut.
    FrameTorn,
    /// NaN or infinity.
    NotANumber,
    /// No disc ever moves.
    NothingMoves,
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
    /// A wall stands at another place.
    WallElsewhere,
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
    /// Forces of the step before are added to.
    ForcesNotReset,
    /// A contact force over another mass than the disc's, or over none.
    ForceOverWrongMass,
    /// Another stiffness, mass or gravity than asked.
    StiffnessWrong,
    /// The push of a pair hangs on the distance of the centres twice.
    NormalNotNormalised,
    /// Each pair pushes twice.
    ForceAppliedTwice,
    /// One disc is pushed, its partner is not.
    ForceOnOneDiscOnly,
    /// Both discs are pushed the same way.
    ReactionSign,
    /// Discs push only when nearer than one radius.
    ContactAtOneRadius,
    /// Discs pass through one another.
    Tunnelling,
    /// Some pairs of discs are never looked at.
    PairsLeftOut,
    /// Position updated with the old velocity.
    ExplicitEuler,
    /// A wall takes all speed.
    SticksToWall,
    /// The dashpot pushes where it should brake.
    DampingSign,
    /// Energy grows, elsewhere than in bounces.
    EnergyPump,
    /// Discs are put to sleep where nothing holds them.
    StoppedInTheAir,
    /// Velocities are set, limited or corrected by something else than forces.
    SpeedsSet,
    /// Elastic discs lose energy.
    EnergyLostElastic,
    /// Contacts have no dashpot.
    DashpotMissing,
    /// Another restitution than asked.
    RestitutionWrong,
    /// The header does not declare what the assignment asks for.
    InterfaceMissing,
    /// A function of the header gives other numbers.
    InterfaceWrong,
}

impl Mistake {
    /// All of them, in the order in which submissions come to them.
    pub const ALL: [Self; 57] = [
        Self::ArchiveNotUnpacked,
        Self::NoMakefile,
        Self::DoesNotBuild,
        Self::ProgramNotRebuilt,
        Self::WaitsForInput,
        Self::Crashes,
        Self::EndsWithoutFrames,
        Self::TooSlow,
        Self::OutputTooLarge,
        Self::StoppedByLimits,
        Self::EmptyFile,
        Self::NoFrames,
        Self::WrongColumns,
        Self::ColumnsExchanged,
        Self::OtherUnit,
        Self::BoxShifted,
        Self::PrintedOnTheScreen,
        Self::OnlyTheLastFrame,
        Self::NumberOfDiscsIgnored,
        Self::FrameTorn,
        Self::NotANumber,
        Self::NothingMoves,
        Self::DiscLost,
        Self::DiscOrderChanges,
        Self::DiameterAsRadius,
        Self::PlacedOverlapping,
        Self::PlacedOutside,
        Self::WallMissing,
        Self::InwardWallNormal,
        Self::WallAtCentre,
        Self::WallElsewhere,
        Self::GravitySign,
        Self::GravityMissing,
        Self::GravitySideways,
        Self::FrictionInFlight,
        Self::TimeStepNotConstant,
        Self::ForcesNotReset,
        Self::ForceOverWrongMass,
        Self::StiffnessWrong,
        Self::NormalNotNormalised,
        Self::ForceAppliedTwice,
        Self::ForceOnOneDiscOnly,
        Self::ReactionSign,
        Self::ContactAtOneRadius,
        Self::Tunnelling,
        Self::PairsLeftOut,
        Self::ExplicitEuler,
        Self::SticksToWall,
        Self::DampingSign,
        Self::EnergyPump,
        Self::StoppedInTheAir,
        Self::SpeedsSet,
        Self::EnergyLostElastic,
        Self::DashpotMissing,
        Self::RestitutionWrong,
        Self::InterfaceMissing,
        Self::InterfaceWrong,
    ];

    /// The mistake of that name.
    ///
    /// ```
    /// use parsim2d::grading::judge::mistake::Mistake;
    /// assert_eq!(Mistake::named("explicit_euler"), Some(Mistake::ExplicitEuler));
    /// assert_eq!(Mistake::named("euler"), None);
    /// ```
    pub fn named(id: &str) -> Option<Self> {
        serde_json::from_value(id.into()).ok()
    }

    /// Its name in files.
    pub fn id(self) -> String {
        serde_json::to_value(self)
            .ok()
            .and_then(|v| v.as_str().map(str::to_owned))
            .unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_are_listed_once_in_their_order_and_found_by_name() {
        assert!(Mistake::ALL.windows(2).all(|pair| pair[0] < pair[1]));
        // The last of an enum has the highest number.
        assert_eq!(Mistake::ALL.len(), Mistake::InterfaceWrong as usize + 1);
        for mistake in Mistake::ALL {
            assert_eq!(Mistake::named(&mistake.id()), Some(mistake));
        }
    }
}
