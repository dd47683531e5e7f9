//! Which mistake a failure looks like.

use serde::{Deserialize, Serialize};

use crate::named::named;

/// The words for a mistake.
#[derive(Clone, Copy, Debug)]
pub struct MistakeWords {
    /// The mistake.
    pub looks_like: &'static str,
    /// Where to look; it does not give the answer away.
    pub hint: &'static str,
}

/// The mistakes in the order in which submissions come to them, each with its name in files, which is stable, what it
/// looks like, and where to look, in English.
macro_rules! mistakes {
    ($($mistake:ident = $id:literal: $looks_like:literal, $hint:literal;)+) => {
        named! {
            /// A mistake that students make; its name in files is stable.
            #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
            #[serde(rename_all = "snake_case")]
            pub enum Mistake, id { $(#[doc = $looks_like] $mistake = $id,)+ }
        }

        /// English.
        #[allow(clippy::too_many_lines)] // a table
        pub(super) fn english(mistake: Mistake) -> MistakeWords {
            let (looks_like, hint) =
                match mistake { $(Mistake::$mistake => ($looks_like, $hint),)+ };
            MistakeWords { looks_like, hint }
        }
    };
}

mistakes! {
    ArchiveNotUnpacked = "archive_not_unpacked": "files that are still in an archive", "the files themselves belong in the folder: what is in an archive is not looked at";
    NoMakefile = "no_makefile": "a Makefile that was forgotten, or has another name", "list the folder as you handed it in: is it as the assignment says?";
    DoesNotBuild = "does_not_build": "sources or a Makefile that this compiler and make do not take", "read the first error, not the last; build in a fresh copy of the folder";
    ProgramNotRebuilt = "program_not_rebuilt": "an old program that was handed in: the build left it as it was, and what the sources say was not run", "hand in sources only: make clean, and then look whether make builds it";
    WaitsForInput = "waits_for_input": "a program that waits for something to be typed", "what does it read, and who gives it that when nobody sits at the keyboard?";
    Crashes = "crashes": "an access outside of what was reserved, or an error that nobody catches", "run it in a debugger, or build it with -fsanitize=address: where does it stop?";
    EndsWithoutFrames = "ends_without_frames": "a loop over frames that is never entered, or another name of the file", "print the number of frames to be written before the loop begins";
    TooSlow = "too_slow": "a loop that waits or never ends", "which loop has an end that may never come?";
    OutputTooLarge = "output_too_large": "a file that grows without end", "when is out.txt begun anew?";
    StoppedByLimits = "stopped_by_limits": "memory or processes without bound", "what is reserved in a loop, and how often?";
    EmptyFile = "empty_file": "a file that was opened and never filled", "is the loop that writes ever reached, and the file closed or flushed?";
    NoFrames = "no_frames": "a file of another name, or remarks only", "what is the file called that your program opens?";
    WrongColumns = "wrong_columns": "fewer than three columns, or something else than blanks between them", "open out.txt: what stands in a line and between its numbers, and what does gnuplot want there?";
    ColumnsExchanged = "columns_exchanged": "columns in another order", "what does `with circles` take as its first, second and third column?";
    OtherUnit = "other_unit": "lengths in another unit than m", "how large is a disc of the assignment in m, and what stands in your first line?";
    BoxShifted = "box_shifted": "another origin of the coordinates than the assignment's", "where is the point (0, 0) in the assignment's drawing of the box, and where in yours?";
    PrintedOnTheScreen = "printed_on_the_screen": "rows that are printed on the terminal in place of the file", "which stream do you print discs to, and which one is out.txt?";
    OnlyTheLastFrame = "only_the_last_frame": "a frame that is written once, before or after the loop, or one frame asked for", "how often is the line reached that writes a frame?";
    NumberOfDiscsIgnored = "number_of_discs_ignored": "a number of discs that is fixed in the program, or an argument that is not read", "start your program with another number of discs: which line uses it?";
    FrameTorn = "frame_torn": "frames that end before their time", "does every frame run over all discs?";
    NotANumber = "not_a_number": "a division by zero or a root of something negative", "which denominator can be zero, and for which two discs?";
    NothingMoves = "nothing_moves": "positions that are never changed, or copies that are moved and thrown away", "after one step, print a disc's velocity and its position: which of them changed, and in which variable?";
    DiscLost = "disc_lost": "a disc that is removed or not printed", "which condition decides whether a disc is printed?";
    DiscOrderChanges = "disc_order_changes": "discs that are sorted or swapped between frames", "does anything reorder the discs, or copy one over another?";
    DiameterAsRadius = "diameter_as_radius": "the diameter in place of the radius", "what does `with circles` take as its third column?";
    PlacedOverlapping = "placed_overlapping": "discs placed without looking at those already there", "what should happen when a random place is taken?";
    PlacedOutside = "placed_outside": "a random place drawn from the whole box for the centre", "how near to a wall may a centre be?";
    WallMissing = "wall_missing": "a wall that does nothing", "four walls: which one does this disc pass, and who pushes it back?";
    InwardWallNormal = "inward_wall_normal": "a wall that draws discs out", "draw the normal n of Eq. (1) at this wall: which way does a positive overlap push?";
    WallAtCentre = "wall_at_centre": "a wall that is felt by the centre, not by the edge", "when does a disc touch a wall: where is its centre then?";
    WallElsewhere = "wall_elsewhere": "a wall at another place than the box's", "where does your wall begin to push, in m, and how wide is the box of the assignment?";
    GravitySign = "gravity_sign": "gravity upward", "which way does your y axis point?";
    GravityMissing = "gravity_missing": "no gravity", "list the forces on a disc that touches nobody";
    GravitySideways = "gravity_sideways": "gravity along another axis", "which component does gravity belong to?";
    FrictionInFlight = "friction_in_flight": "something that brakes free discs", "which force acts although nothing is touched, and on which velocity does it hang?";
    TimeStepNotConstant = "time_step_not_constant": "frames that are not equally far apart in time", "how many steps lie between two frames, and is each step as long as the others? If they are: which line changes all velocities at once?";
    ForcesNotReset = "forces_not_reset": "forces that are added to those of the step before", "what is a disc's force at the beginning of the second step, before anything is added?";
    ForceOverWrongMass = "force_over_wrong_mass": "a force over another mass than the disc's, or over none: contacts or gravity", "from force to acceleration: what does Newton's second law divide by, for every force?";
    StiffnessWrong = "stiffness_wrong": "another k_n, mass or gravity than the assignment's", "compare k_n, m and g in your program with the assignment's, with their powers of ten; which forces are divided by the mass, and how is the overlap computed?";
    NormalNotNormalised = "normal_not_normalised": "a normal that is not of length 1", "what is the length of the vector that you multiply the overlap with?";
    ForceAppliedTwice = "force_applied_twice": "a force that each pair feels twice", "how often does your loop meet discs 3 and 7?";
    ForceOnOneDiscOnly = "force_on_one_disc_only": "a force that one disc feels and its partner does not", "what does Newton's third law say about the second disc?";
    ReactionSign = "reaction_sign": "a reaction that points the same way as the action", "two discs meet: which way is each pushed, and which sign has the normal for each?";
    ContactAtOneRadius = "contact_at_one_radius": "a contact that begins only when centres are a radius apart", "two discs touch: how far apart are their centres?";
    Tunnelling = "tunnelling": "contacts that are never noticed, or pushes far too small", "which pairs do your loops go through, in every step? how far does a disc go in one, compared to its radius? what length has your normal?";
    PairsLeftOut = "pairs_left_out": "pairs of discs that are never looked at", "write down for 4 discs which pairs your loops go through: are there 6?";
    ExplicitEuler = "explicit_euler": "a position that is updated with the old velocity", "in Eq. (3), which velocity moves the disc, and is it there already when you use it?";
    SticksToWall = "sticks_to_wall": "a wall that takes all speed, by setting a place or a velocity", "beside the forces, which line changes a position or a velocity at a wall?";
    DampingSign = "damping_sign": "a dashpot that pushes where it should brake", "two discs come nearer: which sign has v_rn then, and which way should the dashpot act? If that is right: which velocity moves the disc in Eq. (3)?";
    EnergyPump = "energy_pump": "something that makes energy", "follow one disc through one contact: how much work is done on the way in, how much on the way out?";
    StoppedInTheAir = "stopped_in_the_air": "discs that are put to sleep where nothing holds them", "when does your program leave a disc out of a step: is it slow there, or is it held?";
    SpeedsSet = "speeds_set": "velocities that are set, limited or corrected by something else than forces", "which lines change a velocity, beside the one that adds F dt / m?";
    EnergyLostElastic = "energy_lost_elastic": "something that takes energy though nothing should", "which term of the force hangs on a velocity?";
    DashpotMissing = "dashpot_missing": "contacts without a dashpot", "Eq. (1) has two terms: which of them brakes, and is it in this contact's force?";
    RestitutionWrong = "restitution_wrong": "another damping than asked", "compare k_n, eta_n and the mass in your contact with the assignment's";
    InterfaceMissing = "interface_missing": "a name, a type or a file that differs from the assignment's interface", "read the first error: which name of the assignment does it not find in your header?";
    InterfaceWrong = "interface_wrong": "a function that computes something else than the assignment's formula", "compute this case by hand, step by step: lengths, signs, directions, units";
}

impl Mistake {
    /// The mistake of that name.
    ///
    /// ```
    /// use parsim2d::grading::judge::mistake::Mistake;
    /// assert_eq!(Mistake::named("explicit_euler"), Some(Mistake::ExplicitEuler));
    /// assert_eq!(Mistake::named("euler"), None);
    /// ```
    pub fn named(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|mistake| mistake.id() == id)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_the_json() {
        for mistake in Mistake::ALL {
            assert_eq!(serde_json::to_value(mistake).unwrap(), mistake.id());
        }
    }
}
