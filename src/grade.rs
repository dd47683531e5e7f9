//! Grading: what a submission wrote, judged by physics, without knowing its time step.
//!
//! Reading order: [`check`] (what is asked, and what hangs on what), [`rubric`] (the numbers and
//! points of a course), [`frames`] (bytes to a [`film::Film`]), [`flight`] (when nobody touches
//! whom, and gravity), then one file a question, [`verdict`] (what came out), [`words`] (how it is said)
//! and [`picture`]. Who builds and runs submissions adds what [`running`] names. Everything is in metres and frames: no column of time is needed.

pub mod bounce;
pub mod check;
pub mod collision;
pub mod delay;
pub mod digits;
pub mod discs;
pub mod energy;
pub mod film;
pub mod flight;
pub mod frames;
pub mod interface;
pub mod long_run;
pub mod many;
pub mod mistake;
pub mod near;
pub mod picture;
pub mod replay;
pub mod restitution;
pub mod rubric;
pub mod running;
pub mod stiffness;
pub mod stuck;
pub mod verdict;
pub mod words;

use self::check::Check;
use self::film::Film;
use self::flight::Flights;
use self::frames::{Footage, read};
use self::mistake::Mistake;
use self::restitution::Restitutions;
use self::rubric::Rubric;
use self::stiffness::Stiffness;
use self::stuck::Stuck;
use self::verdict::{Failure, Report, Status};
use self::words::Note;

/// Judges what a submission wrote (the bytes of a file of many frames).
///
/// ```
/// use parsim2d::grade::{grade, rubric::Rubric};
/// let report = grade(b"", &Rubric::default());
/// assert_eq!(report.percent(), 0.0); // an empty file: there is nothing to earn points by
/// ```
pub fn grade(bytes: &[u8], rubric: &Rubric) -> Report {
    grade_film(Footage::File(bytes), rubric)
}

/// Judges frames as they were caught.
pub fn grade_film(footage: Footage, rubric: &Rubric) -> Report {
    let mut report = Report::of_frames(rubric);
    add_film(&mut report, footage, rubric);
    report
}

/// Discs of which no course asks for more in a film that is looked at in detail.
const MOST_DISCS: usize = 5000;

/// Frames times the square of discs that are looked at: some seconds of work, whatever was written.
const MOST_WORK: usize = 400_000_000;

/// Fewer frames than these show no motion, whatever the rubric wants: a second difference takes three.
const LEAST_FRAMES: usize = 3;

/// The film, if there are as many frames as the rubric wants. Cut ones were written, and count.
fn long_enough(film: Film, rubric: &Rubric) -> Result<Film, Failure> {
    let (frames, wanted) =
        (film.frames.len() + film.torn, rubric.program.frames_at_least.max(LEAST_FRAMES));
    if frames < wanted { Err(Failure::too_few_frames(frames, wanted)) } else { Ok(film) }
}

/// Adds the checks of frames, `frames` to `long_run`, to a report that has those before them.
///
/// Gives the film, for pictures, if there is one.
pub fn add_film(report: &mut Report, footage: Footage, rubric: &Rubric) -> Option<Film> {
    let film = match read(footage, rubric).and_then(|film| long_enough(film, rubric)) {
        Ok(film) => film,
        Err(failure) => {
            report.decide(Check::Frames, || Status::Failed(failure));
            report.skip_frames();
            return None;
        }
    };
    report.decide(Check::Frames, || Status::Passed);
    let film = film.before_it_blew_up().within(MOST_WORK);
    report.torn = film.torn;
    report.frames = film.frames.len();
    report.discs = film.n();
    let usual = [rubric.program.n];
    let is_endless = film.n() > MOST_DISCS && rubric.n.is_empty();
    let asked = if is_endless { &usual[..] } else { &rubric.n };
    report.decide(Check::Discs, || discs::kept(&film, asked));
    // What follows measures with true radii, whatever was printed.
    let film = film.with_true_radii(rubric);
    report.decide(Check::Radii, || discs::radii(&film, rubric));
    if report.passed(Check::Discs) {
        judge(report, &film, rubric);
    } else {
        report.skip_frames();
    }
    Some(film)
}

/// Adds `many`: a few frames of a box of a thousand discs, or why there are none.
pub fn add_many(report: &mut Report, footage: Footage, n: usize, rubric: &Rubric) {
    report.decide(Check::Many, || many::verdict(footage, n, rubric));
}

/// The checks of motion, on discs that are all there in every frame.
fn judge(report: &mut Report, film: &Film, rubric: &Rubric) {
    let flights = Flights::of(film, rubric);
    report.uneven = flights.uneven;
    let stiffness = Stiffness::of(film, &flights, rubric);
    let soft_walls = stiffness[0].as_ref().filter(|walls| walls.is_soft());
    report.decide(Check::Box, || discs::inside(film, &flights, 1.0, soft_walls, rubric));
    report.decide(Check::Start, || discs::start(film, rubric));
    report.decide(Check::FreeFlight, || flight::verdict(film, &flights, rubric));
    let is_told = report.failed(Check::Box);
    let bounces = bounce::all(film, &flights, rubric);
    let collisions = collision::all(film, &flights);
    let stuck = Stuck::of(film, &flights, rubric);
    report.decide(Check::WallBounce, || match soft_walls {
        Some(_) if is_told => Status::NotSeen,
        Some(walls) => Status::Failed(walls.failure(Mistake::ForceOverWrongMass)),
        None => bounce::verdict(&bounces),
    });
    let is_told = soft_walls.is_some();
    report.decide(Check::PairCollision, || match &stiffness[1] {
        Some(pairs) if pairs.is_soft() && is_told => Status::NotSeen,
        _ => collision::verdict(&collisions, &stiffness),
    });
    let seen = Restitutions::of(&bounces, &collisions, &stuck, &flights, rubric);
    // A force over the wrong mass changes restitution as well: one mistake, one check.
    let restitution = |is_wall| match soft_walls {
        Some(_) => Status::NotSeen,
        None => seen.verdict(is_wall, rubric),
    };
    report.decide(Check::RestitutionWall, || restitution(true));
    report.decide(Check::RestitutionPair, || restitution(false));
    report.notes.extend(seen.is_printed_eta(rubric).then_some(Note::PrintedEta));
    // So does a start or a contact that is wrong to the energy.
    let contacts = [Check::Start, Check::WallBounce, Check::PairCollision];
    let contacts = contacts.iter().chain(&[Check::RestitutionWall, Check::RestitutionPair]);
    let told = is_told || contacts.into_iter().any(|&check| report.failed(check));
    report.decide(Check::Energy, || energy::verdict(film, &flights, rubric, &seen, told));
    report.forgive_walls_that_were_shot_through();
    let told = report.failures().any(|(check, _)| check.is_of_frames());
    let moves = (&flights, &collisions[..]);
    report.decide(Check::LongRun, || long_run::verdict(film, moves, rubric, &seen, told));
}
