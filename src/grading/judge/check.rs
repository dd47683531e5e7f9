//! What is asked of a submission, and which question makes sense only after which.

use serde::{Deserialize, Serialize};

use crate::named::named;

/// The words for a check.
#[derive(Clone, Copy, Debug)]
pub struct CheckWords {
    /// What is so if it is passed.
    pub title: &'static str,
    /// What is measured, and why.
    pub explained: &'static str,
}

/// The checks in the order in which they are asked, each with its name in files, which is stable, what is so if it is
/// passed, and what is measured and why, in English.
macro_rules! checks {
    ($($check:ident = $id:literal: $title:literal, $explained:literal;)+) => {
        named! {
            /// A question; its name in files is stable.
            #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
            #[serde(rename_all = "snake_case")]
            pub enum Check, id { $(#[doc = $title] $check = $id,)+ }
        }

        /// English.
        #[allow(clippy::too_many_lines)] // a table
        pub(super) fn english(check: Check) -> CheckWords {
            let (title, explained) = match check { $(Check::$check => ($title, $explained),)+ };
            CheckWords { title, explained }
        }
    };
}

checks! {
    Files = "files": "all files were handed in",
        "The files that the rubric asks for lie in the folder; links are not followed.";
    Builds = "builds": "the program can be built",
        "The build command ends well within its time, and the program to be run is there.";
    Runs = "runs": "the program runs",
        "It writes frames, and ends well or goes on until it is stopped: that is no mistake.";
    Frames = "frames": "out.txt holds frames",
        "Lines of `x y r`, frames apart by blank lines. CRLF, remarks, a line of names, more \
         columns and a constant border are forgiven; cut frames are left out and cost nothing.";
    Discs = "discs": "the same discs in every frame",
        "As many rows in every frame, in the same order, with finite numbers. Rows that continue \
         each other's paths have changed places.";
    Radii = "radii": "radii as asked and constant",
        "The third column is the radius, one of those that the rubric allows, to the printed digits.";
    Box = "box": "nobody leaves the box",
        "A soft wall lets a disc in: by v/omega0 for the largest speed seen or the fall through the \
         box, with a third to spare, and twice that if it is more than a radius. Further is outside.";
    Start = "start": "nobody overlaps at the start",
        "In the first frame centres are apart by the sum of radii, and by a radius from walls, up \
         to the printed digits.";
    FreeFlight = "free_flight": "free discs fall, all alike",
        "While nothing is near, p(k+1) - 2 p(k) + p(k-1) is one constant vector (0, -c), the same for \
         all discs: exact for every integrator of the course, without knowing the time step. The \
         tolerance is half a unit of the last printed place, over the square of the frames used.";
    WallBounce = "wall_bounce": "walls push straight",
        "From the flights before and after a bounce: the velocity along the wall stays as it was. They tell \
         when the disc touched and when it parted, too: how long that takes shows how stiff the wall is, and where it \
         stands, with the time between frames from gravity.";
    PairCollision = "pair_collision": "two discs push each other equally, along their centres",
        "From the flights before and after: the sum of the velocities and the relative angular momentum \
         are the same, whatever the force law. Discs on course for each other must not fly on unmoved, \
         whichever two they are, nor touch for longer or shorter than the \
         rubric's spring lets them.";
    RestitutionWall = "restitution_wall": "bounces on walls give back the right speed",
        "The median over the bounces on each wall of the speed after over the speed before, at the place of touch.";
    RestitutionPair = "restitution_pair": "collisions give back the right speed",
        "The median over collisions that are not too oblique of the relative speed along the centres \
         after over before. What an oblique contact gives back more, by turning, is computed and taken off.";
    Energy = "energy": "energy is never made",
        "The sum over discs of v²/2 + c y in free flight, first tenth of the film beside the last: \
         it never grows, and stays for elastic discs. A trajectory is never compared: two right \
         programs part after ten collisions.";
    LongRun = "long_run": "in the end discs lie at the bottom, or are a gas",
        "Asked of long films only. Discs that lose speed come to rest: in the last quarter of a film, if that begins \
         4 t_f/(1 - e) after the start (t_f: a fall from ceiling to floor), they are slower than an eighth of the fall \
         speed and none is above the heap. Elastic ones, if there are ten and more and each has met others often, \
         are a gas: heights exponential, velocities Gaussian, by the test of Kolmogorov and Smirnov at 1e-4, with \
         frames in between of which nearly all met somebody and something to spare for few discs of finite size.";
    Many = "many": "a box of many discs works as well",
        "A few frames of a second run with as many discs as `many` of the rubric says (1000 if it does not): all there, apart at the start, finite, in the box.";
    Warnings = "warnings": "the compiler has nothing to warn of",
        "Built once more with -Wall -Wextra.";
    Sanitizer = "sanitizer": "memory and arithmetic are used as the language asks",
        "Built and run once more with the address and undefined behaviour sanitizers.";
    Interface = "interface": "functions of the header give the right numbers",
        "A small program of your instructor's includes your header, hands numbers to your functions and prints what \
         they return. The last numbers that it prints are compared with those expected. Asked only if the rubric \
         has an [interface].";
}

impl Check {
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
