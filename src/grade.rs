//! Grading: what a submission wrote, judged by physics, without knowing its time step.
//!
//! Reading order: [`check`] (what is asked, and what hangs on what), [`rubric`] (the numbers and
//! points of a course), [`frames`] (bytes to a [`film::Film`]), [`flight`] (when nobody touches
//! whom, and gravity), then one file a question, [`verdict`] (what came out) and [`words`] (how it
//! is said). Everything is in metres and frames: no column of time is needed.

pub mod bounce;
pub mod check;
pub mod collision;
pub mod digits;
pub mod discs;
pub mod energy;
pub mod film;
pub mod flight;
pub mod frames;
pub mod mistake;
pub mod near;
pub mod rubric;
pub mod verdict;
pub mod words;

use self::check::Check;
use self::film::Film;
use self::flight::Flights;
use self::frames::read;
use self::rubric::Rubric;
use self::verdict::{Report, Status};

/// Judges what a submission wrote (the bytes of a file of many frames).
///
/// ```
/// use parsim2d::grade::{grade, rubric::Rubric};
/// let report = grade(b"", &Rubric::default());
/// assert_eq!(report.lost(), 1.0); // an empty file: `frames` is lost, the rest is not asked
/// ```
pub fn grade(bytes: &[u8], rubric: &Rubric) -> Report {
    let film = read(bytes, rubric);
    let mut report = Report::new(rubric);
    let film = match film {
        Ok(film) => film,
        Err(failure) => {
            report.push(Check::Frames, Status::Failed(failure));
            report.skip_the_rest();
            return report;
        }
    };
    report.push(Check::Frames, Status::Passed);
    let film = film.before_it_blew_up();
    report.torn = film.torn;
    report.frames = film.frames.len();
    report.discs = film.n();
    report.decide(Check::Discs, || discs::kept(&film));
    // What follows measures with true radii, whatever was printed.
    let film = film.with_true_radii(rubric);
    report.decide(Check::Radii, || discs::radii(&film, rubric));
    if !report.passed(Check::Discs) {
        report.skip_the_rest();
        return report;
    }
    judge(&mut report, &film, rubric);
    report
}

/// The checks of motion, on discs that are all there in every frame.
fn judge(report: &mut Report, film: &Film, rubric: &Rubric) {
    let flights = Flights::of(film, rubric);
    report.uneven = flights.uneven;
    report.decide(Check::Box, || discs::inside(film, &flights, rubric));
    report.decide(Check::Start, || discs::start(film, rubric));
    report.decide(Check::FreeFlight, || flight::verdict(film, &flights, rubric));
    let bounces = bounce::all(film, &flights, rubric);
    let collisions = collision::all(film, &flights);
    report.decide(Check::WallBounce, || bounce::verdict(&bounces));
    report.decide(Check::PairCollision, || collision::verdict(&collisions));
    report.decide(Check::RestitutionWall, || bounce::restitution(&bounces, rubric));
    report.decide(Check::RestitutionPair, || collision::restitution(&collisions, rubric));
    // A start or a contact that is wrong changes the energy as well: one mistake, one check.
    let contacts = [Check::Start, Check::WallBounce, Check::PairCollision];
    let told = contacts
        .iter()
        .chain(&[Check::RestitutionWall, Check::RestitutionPair])
        .any(|&check| matches!(report.status(check), Some(Status::Failed(_))));
    let seen = energy::Seen { bounces: &bounces, collisions: &collisions, told };
    report.decide(Check::Energy, || energy::verdict(film, &flights, rubric, seen));
    report.forgive_walls_that_were_shot_through();
}
