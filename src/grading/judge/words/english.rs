//! English.

use super::{CheckWords, Finding, FindingWords, MistakeWords, Note, Quantity, Words};
use crate::grading::judge::check::Check;
use crate::grading::judge::mistake::Mistake;
use crate::grading::judge::wall::Wall;

/// English.
pub const ENGLISH: Words = Words {
    code: "en",
    check,
    finding,
    quantity,
    wall,
    note,
    mistake,
    case: ["case", "given", "hint of this case"],
    missing: ["missing", "still packed"],
    bad_line: "the first of these lines",
    no_program: "the build ended well, but there is no program",
    frame: "frame",
    discs: "disc",
    expected: "expected",
    looks_like: "looks like",
    hint: "hint",
    masked: "masked: the printed eta_n made contacts explode, and this cannot be seen behind it; no points are lost",
    not_seen: "not seen: nothing in these frames decides it",
    not_told: "not seen: the program is not told how many discs ({n} is neither in `arguments` nor in `stdin` of the rubric)",
    no_interface: "not seen: the rubric has no [interface]",
    skipped: "can't be judged until this is right:",
    points: ["of", "not judged"],
    left_out: ["cut frames left out:", "frames at uneven times left out:"],
    point: ["point", "points"],
    after: "asked after",
    part_left: "part of the points that it leaves",
};

#[rustfmt::skip]
#[allow(clippy::too_many_lines)] // a table
fn check(check: Check) -> CheckWords {
    let (title, explained) = match check {
        Check::Files => ("all files were handed in",
            "The files that the rubric asks for lie in the folder; links are not followed."),
        Check::Builds => ("the program can be built",
            "The build command ends well within its time, and the program to be run is there."),
        Check::Runs => ("the program runs",
            "It writes frames, and ends well or goes on until it is stopped: that is no mistake."),
        Check::Frames => ("out.txt holds frames",
            "Lines of `x y r`, frames apart by blank lines. CRLF, remarks, a line of names, more \
             columns and a constant border are forgiven; cut frames are left out and cost nothing."),
        Check::Discs => ("the same discs in every frame",
            "As many rows in every frame, in the same order, with finite numbers. Rows that continue \
             each other's paths have changed places."),
        Check::Radii => ("radii as asked and constant",
            "The third column is the radius, one of those that the rubric allows, to the printed digits."),
        Check::Box => ("nobody leaves the box",
            "A soft wall lets a disc in: by v/omega0 for the largest speed seen or the fall through the \
             box, with a third to spare, and twice that if it is more than a radius. Further is outside."),
        Check::Start => ("nobody overlaps at the start",
            "In the first frame centres are apart by the sum of radii, and by a radius from walls, up \
             to the printed digits."),
        Check::FreeFlight => ("free discs fall, all alike",
            "While nothing is near, p(k+1) - 2 p(k) + p(k-1) is one constant vector (0, -c), the same for \
             all discs: exact for every integrator of the course, without knowing the time step. The \
             tolerance is half a unit of the last printed place, over the square of the frames used."),
        Check::WallBounce => ("walls push straight",
            "From the flights before and after a bounce: the velocity along the wall stays as it was. They tell \
             when the disc touched and when it parted, too: how long that takes shows how stiff the wall is, and where it \
             stands, with the time between frames from gravity."),
        Check::PairCollision => ("two discs push each other equally, along their centres",
            "From the flights before and after: the sum of the velocities and the relative angular momentum \
             are the same, whatever the force law. Discs on course for each other must not fly on unmoved, \
             whichever two they are, nor touch for longer or shorter than the \
             rubric's spring lets them."),
        Check::RestitutionWall => ("bounces on walls give back the right speed",
            "The median over the bounces on each wall of the speed after over the speed before, at the place of touch."),
        Check::RestitutionPair => ("collisions give back the right speed",
            "The median over collisions that are not too oblique of the relative speed along the centres \
             after over before. What an oblique contact gives back more, by turning, is computed and taken off."),
        Check::Energy => ("energy is never made",
            "The sum over discs of v²/2 + c y in free flight, first tenth of the film beside the last: \
             it never grows, and stays for elastic discs. A trajectory is never compared: two right \
             programs part after ten collisions."),
        Check::LongRun => ("in the end discs lie at the bottom, or are a gas",
            "Asked of long films only. Discs that lose speed come to rest: in the last quarter of a film, if that begins \
             4 t_f/(1 - e) after the start (t_f: a fall from ceiling to floor), they are slower than an eighth of the fall \
             speed and none is above the heap. Elastic ones, if there are ten and more and each has met others often, \
             are a gas: heights exponential, velocities Gaussian, by the test of Kolmogorov and Smirnov at 1e-4, with \
             frames in between of which nearly all met somebody and something to spare for few discs of finite size."),
        Check::Many => ("a box of many discs works as well",
            "A few frames of a second run with as many discs as `many` of the rubric says (1000 if it does not): all there, apart at the start, finite, in the box."),
        Check::Warnings => ("the compiler has nothing to warn of",
            "Built once more with -Wall -Wextra."),
        Check::Sanitizer => ("memory and arithmetic are used as the language asks",
            "Built and run once more with the address and undefined behaviour sanitizers."),
        Check::Interface => ("functions of the header give the right numbers",
            "A small program of your instructor's includes your header, hands numbers to your functions and prints what \
             they return. The last numbers that it prints are compared with those expected. Asked only if the rubric \
             has an [interface]."),
    };
    CheckWords { title, explained }
}

#[rustfmt::skip]
#[allow(clippy::too_many_lines)] // a table
fn finding(finding: Finding) -> FindingWords {
    let (what, expected) = match finding {
        Finding::FileMissing => ("a file that was asked for is not there", "the files that the assignment names"),
        Finding::AsksForInput => ("the program asks for more on its standard input than there is, and wrote no frames or too few", "a program that needs nobody at the keyboard"),
        Finding::BuildFails => ("the program cannot be built", "a build without errors, and the program under the name asked for"),
        Finding::BuildTakesTooLong => ("the build did not end in its time", "a build of seconds"),
        Finding::Crashed => ("the program ended with an error", "exit code 0, or a program that goes on"),
        Finding::EndedWithoutFrames => ("the program ended and left no frame", "frames in out.txt"),
        Finding::TooFewFrames => ("there are too few frames to see anything move", "one frame after another with a blank line between them, as many as the assignment asks for"),
        Finding::TakesTooLong => ("the program wrote too few frames in the time it has", "frames one after another"),
        Finding::WritesTooMuch => ("the program wrote more than there is room for", "frames of some hundred bytes to some hundred kilobytes"),
        Finding::Stopped => ("the program was stopped by a limit on memory, processes or processor time", "one process and some megabytes"),
        Finding::Warned => ("the compiler warns", "no warning with -Wall -Wextra"),
        Finding::Misused => ("a sanitizer reports a fault", "no report"),
        Finding::CountNotAsked => ("not the number of discs asked for", "every disc, from the first frame on"),
        Finding::ContactTooSoft => ("contacts push too weakly: they last too long", "the stiffness of the assignment"),
        Finding::WallShifted => ("discs turn at another place than the wall", "a push as soon as the edge of a disc touches the wall"),
        Finding::PushedAlike => ("two discs are pushed the same way", "opposite changes of velocity of the same size"),
        Finding::SomePassThrough => ("some discs lie or fly through one another, while others push", "a push as soon as their edges touch, whichever two they are"),
        Finding::PullGrows => ("free discs fall faster and faster from frame to frame, all alike", "the same second difference (0, -c) in every frame"),
        Finding::StopsInFlight => ("a disc that meets nobody stops in the air", "the same (0, -c) for every disc at every moment"),
        Finding::ContactTooStiff => ("contacts push too strongly: they are over too soon", "the stiffness of the assignment"),
        Finding::NothingWritten => ("nothing was written", "frames of `x y r` lines"),
        Finding::NoRows => ("no line is a disc", "lines of three numbers, `x y r`, with blanks between them"),
        Finding::MostlyTorn => ("more frames are cut than whole", "as many rows in every frame"),
        Finding::NotFinite => ("a number is NaN or infinite", "finite numbers"),
        Finding::CountChanges => ("the number of discs changes", "every disc in every frame"),
        Finding::OrderChanges => ("two rows have changed places", "each disc in its own row"),
        Finding::WrongRadius => ("the third column is not a radius of this assignment", "the radius of the assignment, in m"),
        Finding::ColumnsExchanged => ("x, y and r are not the first three columns", "`x y r` at the beginning of each line; more columns may follow"),
        Finding::OtherUnit => ("all lengths are too large by the same factor", "x, y and r in m"),
        Finding::BoxShifted => ("the box of these frames is not where the assignment has it", "the lower left corner of the assignment's box"),
        Finding::RadiusChanges => ("a radius changes", "the same radius in every frame"),
        Finding::LeavesTheBox => ("a disc goes further into a wall than its spring lets it", "at most the depth at which the wall's spring has stopped it"),
        Finding::ComesBackOpposite => ("a disc leaves by a wall and comes back by the opposite one", "walls that push discs back"),
        Finding::StartsInWall => ("a disc begins in a wall or outside", "centres at least a radius from every wall"),
        Finding::StartsOverlapping => ("two discs overlap at the start", "centres at least the sum of radii apart"),
        Finding::WrongPull => ("discs that meet nobody do not fall as they should", "one constant second difference, (0, -c) with c > 0"),
        Finding::NothingMoves => ("nothing moves: all frames are the same", "discs that fall from frame to frame"),
        Finding::PullNotConstant => ("the second difference of free discs changes", "the same (0, -c) for every disc at every moment"),
        Finding::WallDragsAlong => ("a wall changes the velocity along it", "a wall without friction pushes along its normal only"),
        Finding::PassThrough => ("discs on course for each other fly on as if nobody were there", "a push as soon as their edges touch"),
        Finding::PushesUnequal => ("two discs do not push each other equally and oppositely", "opposite changes of velocity of the same size"),
        Finding::PushCrooked => ("discs push each other aside from the line of their centres", "the relative angular momentum as before"),
        Finding::WrongRestitution => ("the speed after contacts is not what it should be", "the restitution that follows from the assignment"),
        Finding::EnergyGrows => ("the energy of all discs grows", "energy that stays, or falls with damping"),
        Finding::EnergyFalls => ("elastic discs lose energy", "energy that stays"),
        Finding::ProbeNotBuilt => ("the instructor's program that includes your header cannot be built", "names, types and files as in the assignment's interface"),
        Finding::ProbeEndsBadly => ("the instructor's program that calls your functions ended with an error, or not in its time", "functions that return"),
        Finding::TooFewNumbers => ("the instructor's program that calls your functions printed too few numbers", "the numbers of the case"),
        Finding::OtherNumbers => ("a function gives other numbers than it should", "the numbers of the case, to its tolerance"),
        Finding::HangsInTheEnd => ("a disc stays in the air after all should have come to rest", "a heap at the bottom"),
        Finding::NeverRests => ("discs go on moving after they should have come to rest", "discs that each contact makes slower, until they lie still"),
        Finding::NotGaussian => ("the velocities of elastic discs are not those of a gas", "Gaussian components of one variance"),
        Finding::NotExponential => ("the heights of elastic discs are not those of a gas", "an exponential, with a scale of kT/(m g) by the velocities"),
    };
    FindingWords { what, expected }
}

#[allow(clippy::too_many_lines)] // a table
fn quantity(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::BadLines => "lines that are no disc",
        Quantity::TornFrames => "cut frames",
        Quantity::Count => "discs here",
        Quantity::CountAtStart => "discs at the start",
        Quantity::Radius => "printed, m",
        Quantity::RadiusAsked => "asked for, m",
        Quantity::RadiusAtStart => "in the first frame, m",
        Quantity::DepthOverRadius => "depth, radii",
        Quantity::LargestDepthOverRadius => "largest depth to be expected, radii",
        Quantity::PullX => "second difference of x, m a frame²",
        Quantity::PullY => "second difference of y, m a frame²",
        Quantity::UsualPullX => "usual one of x",
        Quantity::UsualPullY => "usual one of y",
        Quantity::Blur => "what rounding of the digits makes at most",
        Quantity::Share => "part of the places looked at",
        Quantity::SlipOverSpeed => "change along the wall over the speed across it",
        Quantity::Aim => "distance at which they would pass, touching distances",
        Quantity::KickFirst => "kick of the first, relative speeds",
        Quantity::KickSecond => "kick of the second, relative speeds",
        Quantity::Twist => "change of the relative angular momentum, touching distance times speed",
        Quantity::Restitution => "median restitution e",
        Quantity::ExpectedRestitution => "expected e",
        Quantity::EnergyChange => "change of the energy, parts of it",
        Quantity::CountAsked => "discs asked for",
        Quantity::Stiffness => "stiffness, parts of the one asked for",
        Quantity::ShiftOverRadius => "beyond the wall, radii",
        Quantity::BendFirst => "second difference of the first, m a frame²",
        Quantity::BendSecond => "second difference of the second, m a frame²",
        Quantity::Meetings => "such meetings",
        Quantity::Seconds => "time, s",
        Quantity::ExitCode => "exit code",
        Quantity::Frames => "frames",
        Quantity::FramesWanted => "frames wanted, at least",
        Quantity::Signal => "signal",
        Quantity::Came => "came out",
        Quantity::Expected => "should be",
        Quantity::Numbers => "numbers printed",
        Quantity::NumbersWanted => "numbers expected",
        Quantity::Bytes => "written, bytes",
        Quantity::HeightOverRadius => "height over the floor, radii",
        Quantity::SpeedOverFall => {
            "speed (root mean square) over that of a fall from ceiling to floor"
        }
        Quantity::Distance => "largest distance of the distributions",
        Quantity::LargestDistance => "largest distance to be expected",
        Quantity::Places => "places of discs that were used",
        Quantity::Column => "x, y, r in turn: right if read from column",
        Quantity::CornerX => "left wall of the box in these frames, x, m",
        Quantity::CornerY => "floor of the box in these frames, y, m",
    }
}

fn wall(wall: Wall) -> &'static str {
    match wall {
        Wall::Left => "left wall",
        Wall::Right => "right wall",
        Wall::Floor => "floor",
        Wall::Ceiling => "ceiling",
    }
}

fn note(note: Note) -> &'static str {
    match note {
        Note::PrintedEta => {
            "discs that touch never part. That is what eta_n = 1.5e3 of the guide does if it is taken in \
             kg/s: 150 times critical damping. You did as told, and no points are lost; we think a minus \
             sign was lost in print. Try 1.5e-3 and see discs bounce."
        }
        Note::PrintedEtaExplodes => {
            "contacts give back 12 times the speed and more, and soon numbers end. That is what eta_n = 1.5e3 of the \
             guide does, if it is taken in kg/s, with the guide's own step: in one step of Eq. (2) the dashpot changes a \
             velocity by eta_n dt/m of itself, which is 13 for N_t = 50 and 67 for N_t = 10, so it turns the velocity \
             round and makes it larger, step after step. You did as told, and no points are lost. What this hides is \
             masked: it is out of the total. We think a minus sign was lost in print. For the instructor: let it run \
             again with eta_n = 1.5e-3, and grade what is seen then."
        }
        Note::ColumnsTaken => {
            "there are more than three columns, no heading says which is which, and the rubric has no radius to know one \
             by: the first three were taken for x, y and r."
        }
        Note::ProgramNotRebuilt => {
            "the program that ran was handed in as it is: the build found it newer than the sources, or makes another, \
             and did not make it anew. Whether the sources do the same was not seen."
        }
        Note::LittleJudged => {
            "less than half of what is asked of motion could be judged, and the percentage is of that part: more discs, \
             larger ones, speeds at the start or more frames would show more."
        }
        Note::AsksForInput => {
            "the program asks for more on its standard input than the course gives it, and got nothing."
        }
    }
}

#[rustfmt::skip]
#[allow(clippy::too_many_lines)] // a table
fn mistake(mistake: Mistake) -> MistakeWords {
    let (looks_like, hint) = match mistake {
        Mistake::InterfaceMissing => ("a name, a type or a file that differs from the assignment's interface", "read the first error: which name of the assignment does it not find in your header?"),
        Mistake::InterfaceWrong => ("a function that computes something else than the assignment's formula", "compute this case by hand, step by step: lengths, signs, directions, units"),
        Mistake::NoMakefile => ("a Makefile that was forgotten, or has another name", "list the folder as you handed it in: is it as the assignment says?"),
        Mistake::ArchiveNotUnpacked => ("files that are still in an archive", "the files themselves belong in the folder: what is in an archive is not looked at"),
        Mistake::ProgramNotRebuilt => ("an old program that was handed in: the build left it as it was, and what the sources say was not run", "hand in sources only: make clean, and then look whether make builds it"),
        Mistake::WaitsForInput => ("a program that waits for something to be typed", "what does it read, and who gives it that when nobody sits at the keyboard?"),
        Mistake::DoesNotBuild => ("sources or a Makefile that this compiler and make do not take", "read the first error, not the last; build in a fresh copy of the folder"),
        Mistake::Crashes => ("an access outside of what was reserved, or an error that nobody catches", "run it in a debugger, or build it with -fsanitize=address: where does it stop?"),
        Mistake::EndsWithoutFrames => ("a loop over frames that is never entered, or another name of the file", "print the number of frames to be written before the loop begins"),
        Mistake::TooSlow => ("a loop that waits or never ends", "which loop has an end that may never come?"),
        Mistake::OutputTooLarge => ("a file that grows without end", "when is out.txt begun anew?"),
        Mistake::StoppedByLimits => ("memory or processes without bound", "what is reserved in a loop, and how often?"),
        Mistake::ForceOverWrongMass => ("a force over another mass than the disc's, or over none: contacts or gravity", "from force to acceleration: what does Newton's second law divide by, for every force?"),
        Mistake::NormalNotNormalised => ("a normal that is not of length 1", "what is the length of the vector that you multiply the overlap with?"),
        Mistake::ForceAppliedTwice => ("a force that each pair feels twice", "how often does your loop meet discs 3 and 7?"),
        Mistake::EmptyFile => ("a file that was opened and never filled", "is the loop that writes ever reached, and the file closed or flushed?"),
        Mistake::NoFrames => ("a file of another name, or remarks only", "what is the file called that your program opens?"),
        Mistake::WrongColumns => ("fewer than three columns, or something else than blanks between them", "open out.txt: what stands in a line and between its numbers, and what does gnuplot want there?"),
        Mistake::ColumnsExchanged => ("columns in another order", "what does `with circles` take as its first, second and third column?"),
        Mistake::OtherUnit => ("lengths in another unit than m", "how large is a disc of the assignment in m, and what stands in your first line?"),
        Mistake::BoxShifted => ("another origin of the coordinates than the assignment's", "where is the point (0, 0) in the assignment's drawing of the box, and where in yours?"),
        Mistake::PrintedOnTheScreen => ("rows that are printed on the terminal in place of the file", "which stream do you print discs to, and which one is out.txt?"),
        Mistake::OnlyTheLastFrame => ("a frame that is written once, before or after the loop, or one frame asked for", "how often is the line reached that writes a frame?"),
        Mistake::NumberOfDiscsIgnored => ("a number of discs that is fixed in the program, or an argument that is not read", "start your program with another number of discs: which line uses it?"),
        Mistake::FrameTorn => ("frames that end before their time", "does every frame run over all discs?"),
        Mistake::NotANumber => ("a division by zero or a root of something negative", "which denominator can be zero, and for which two discs?"),
        Mistake::DiscLost => ("a disc that is removed or not printed", "which condition decides whether a disc is printed?"),
        Mistake::DiscOrderChanges => ("discs that are sorted or swapped between frames", "does anything reorder the discs, or copy one over another?"),
        Mistake::DiameterAsRadius => ("the diameter in place of the radius", "what does `with circles` take as its third column?"),
        Mistake::PlacedOverlapping => ("discs placed without looking at those already there", "what should happen when a random place is taken?"),
        Mistake::PlacedOutside => ("a random place drawn from the whole box for the centre", "how near to a wall may a centre be?"),
        Mistake::WallMissing => ("a wall that does nothing", "four walls: which one does this disc pass, and who pushes it back?"),
        Mistake::InwardWallNormal => ("a wall that draws discs out", "draw the normal n of Eq. (1) at this wall: which way does a positive overlap push?"),
        Mistake::WallAtCentre => ("a wall that is felt by the centre, not by the edge", "when does a disc touch a wall: where is its centre then?"),
        Mistake::GravitySign => ("gravity upward", "which way does your y axis point?"),
        Mistake::GravityMissing => ("no gravity", "list the forces on a disc that touches nobody"),
        Mistake::GravitySideways => ("gravity along another axis", "which component does gravity belong to?"),
        Mistake::FrictionInFlight => ("something that brakes free discs", "which force acts although nothing is touched, and on which velocity does it hang?"),
        Mistake::TimeStepNotConstant => ("frames that are not equally far apart in time", "how many steps lie between two frames, and is each step as long as the others? If they are: which line changes all velocities at once?"),
        Mistake::ForceOnOneDiscOnly => ("a force that one disc feels and its partner does not", "what does Newton's third law say about the second disc?"),
        Mistake::ContactAtOneRadius => ("a contact that begins only when centres are a radius apart", "two discs touch: how far apart are their centres?"),
        Mistake::Tunnelling => ("contacts that are never noticed, or pushes far too small", "which pairs do your loops go through, in every step? how far does a disc go in one, compared to its radius? what length has your normal?"),
        Mistake::ExplicitEuler => ("a position that is updated with the old velocity", "in Eq. (3), which velocity moves the disc, and is it there already when you use it?"),
        Mistake::DampingSign => ("a dashpot that pushes where it should brake", "two discs come nearer: which sign has v_rn then, and which way should the dashpot act? If that is right: which velocity moves the disc in Eq. (3)?"),
        Mistake::EnergyPump => ("something that makes energy", "follow one disc through one contact: how much work is done on the way in, how much on the way out?"),
        Mistake::NothingMoves => ("positions that are never changed, or copies that are moved and thrown away", "after one step, print a disc's velocity and its position: which of them changed, and in which variable?"),
        Mistake::WallElsewhere => ("a wall at another place than the box's", "where does your wall begin to push, in m, and how wide is the box of the assignment?"),
        Mistake::ForcesNotReset => ("forces that are added to those of the step before", "what is a disc's force at the beginning of the second step, before anything is added?"),
        Mistake::StiffnessWrong => ("another k_n, mass or gravity than the assignment's", "compare k_n, m and g in your program with the assignment's, with their powers of ten; which forces are divided by the mass, and how is the overlap computed?"),
        Mistake::ReactionSign => ("a reaction that points the same way as the action", "two discs meet: which way is each pushed, and which sign has the normal for each?"),
        Mistake::PairsLeftOut => ("pairs of discs that are never looked at", "write down for 4 discs which pairs your loops go through: are there 6?"),
        Mistake::SticksToWall => ("a wall that takes all speed, by setting a place or a velocity", "beside the forces, which line changes a position or a velocity at a wall?"),
        Mistake::DashpotMissing => ("contacts without a dashpot", "Eq. (1) has two terms: which of them brakes, and is it in this contact's force?"),
        Mistake::StoppedInTheAir => ("discs that are put to sleep where nothing holds them", "when does your program leave a disc out of a step: is it slow there, or is it held?"),
        Mistake::SpeedsSet => ("velocities that are set, limited or corrected by something else than forces", "which lines change a velocity, beside the one that adds F dt / m?"),
        Mistake::EnergyLostElastic => ("something that takes energy though nothing should", "which term of the force hangs on a velocity?"),
        Mistake::RestitutionWrong => ("another damping than asked", "compare k_n, eta_n and the mass in your contact with the assignment's"),
    };
    MistakeWords { looks_like, hint }
}
