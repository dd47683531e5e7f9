//! What a submission wrote, judged by physics, without knowing its time step.
//!
//! Reading order: [`check`] (what is asked, and what hangs on what), [`rubric`] (the numbers and
//! points of a course), [`frames`] (bytes to a [`film::Film`]), [`flight`] (when nobody touches
//! whom, and gravity), then one file a question, [`verdict`] (what came out), [`words`] (how it is said)
//! and [`picture`]. Who builds and runs submissions adds what [`running`] names. Everything is in metres and frames: no column of time is needed.

pub mod bounce;
pub mod check;
pub mod clock;
pub mod collision;
pub mod columns;
pub mod delay;
pub mod digits;
pub mod discs;
pub mod energy;
pub mod film;
pub mod flight;
pub mod frames;
pub mod headings;
pub mod interface;
pub mod lines;
pub mod long_run;
pub mod many;
pub mod misread;
pub mod mistake;
pub mod momentum;
pub mod near;
pub mod overdamped;
pub mod passing;
pub mod picture;
pub mod put_right;
pub mod replay;
pub mod restitution;
pub mod rubric;
pub mod running;
pub mod spot;
pub mod springs;
pub mod stiffness;
pub mod stuck;
pub mod touching;
pub mod verdict;
pub mod wall;
pub mod words;

use self::bounce::Bounce;
use self::check::Check;
use self::collision::Collision;
use self::film::Film;
use self::flight::Flights;
use self::frames::{Footage, read};
use self::mistake::Mistake;
use self::restitution::Restitutions;
use self::rubric::Rubric;
use self::springs::Springs;
use self::stuck::Stuck;
use self::verdict::{Failure, Report, Status};
use self::words::{Finding, Note, Quantity};

/// Judges what a submission wrote (the bytes of a file of many frames).
///
/// ```
/// use parsim2d::grading::judge::{grade, rubric::Rubric};
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

/// The film, if there are as many frames as the rubric wants, and anything moves. Cut ones were written, and
/// count.
fn moving(film: Film, rubric: &Rubric) -> Result<Film, Failure> {
    let (frames, wanted) =
        (film.frames.len() + film.torn, rubric.program.frames_at_least.max(LEAST_FRAMES));
    if frames < wanted {
        return Err(Failure::too_few_frames(frames, wanted));
    }
    if rubric.gravity > 0.0 && film.is_still() {
        let failure = Failure::of(Finding::NothingMoves, Mistake::NothingMoves);
        return Err(failure.with(Quantity::Frames, frames as f64));
    }
    Ok(film)
}

/// Adds the checks of frames, `frames` to `long_run`, to a report that has those before them.
///
/// Gives the film, for pictures, if there is one.
pub fn add_film(report: &mut Report, footage: Footage, rubric: &Rubric) -> Option<Film> {
    let film = match read(footage, rubric).and_then(|film| moving(film, rubric)) {
        Ok(film) => film,
        Err(failure) => {
            report.decide(Check::Frames, || Status::Failed(failure));
            report.skip_frames();
            return None;
        }
    };
    report.decide(Check::Frames, || Status::Passed);
    report.notes.extend(film.is_taken.then_some(Note::ColumnsTaken));
    let film = film.within(MOST_WORK);
    let exploded = overdamped::first_frame(&film, rubric);
    let film = match exploded {
        Some(first) => film.before(first),
        None => film.before_it_blew_up(),
    };
    report.torn = film.torn;
    report.frames = film.frames.len();
    report.discs = film.n();
    let usual = [rubric.program.n];
    let is_endless = film.n() > MOST_DISCS && rubric.n.is_empty();
    let asked = if is_endless { &usual[..] } else { &rubric.n };
    report.decide(Check::Discs, || discs::kept(&film, asked));
    // What follows measures with true radii, whatever was printed.
    let film = film.before_it_ran_wild().with_true_radii(rubric);
    let film = if report.passed(Check::Discs) { film.evenly_timed(rubric) } else { film };
    let as_written = film.failure_as_written(Check::Radii);
    report.decide(Check::Radii, || as_written.unwrap_or_else(|| discs::radii(&film, rubric)));
    if report.passed(Check::Discs) {
        judge(report, &film, exploded.is_some(), rubric);
    } else {
        report.skip_frames();
    }
    Some(film)
}

/// Adds `many`: a few frames of a box of a thousand discs, or why there are none.
pub fn add_many(report: &mut Report, footage: Footage, n: usize, rubric: &Rubric) {
    report.decide(Check::Many, || many::verdict(footage, n, rubric));
    let is_masked = report.status(Check::Many) == Some(&Status::Masked);
    report.notes.extend(is_masked.then_some(Note::PrintedEtaExplodes));
}

/// The checks of motion, on discs that are all there in every frame. `is_masked`: the film ends where the printed
/// eta made a contact explode.
fn judge(report: &mut Report, film: &Film, is_masked: bool, rubric: &Rubric) {
    let flights = Flights::of(film, rubric);
    report.uneven = flights.uneven;
    let bounces = bounce::all(film, &flights, rubric);
    let collisions = collision::all(film, &flights);
    let springs = Springs::of(film, (&flights, &bounces, &collisions), rubric);
    let told = springs.cause_at_walls(rubric);
    let inside = || discs::inside(film, &flights, 1.0, told, rubric);
    report.decide(Check::Box, || film.failure_as_written(Check::Box).unwrap_or_else(inside));
    // Who has another box in mind fills it.
    let is_told = report.failed_by(Check::Box, Mistake::WallElsewhere);
    report.decide(Check::Start, || match discs::start(film, &flights, rubric) {
        Status::Failed(why) if is_told && why.finding == Finding::StartsInWall => Status::NotSeen,
        other => other,
    });
    report.decide(Check::FreeFlight, || flight::verdict(film, &flights, rubric));
    let is_told = report.failed(Check::Box);
    report.decide(Check::WallBounce, || springs.of_walls(is_told, &bounces, rubric));
    let is_apart = !report.failed(Check::Start);
    let meetings = (&flights, &collisions[..]);
    report.decide(Check::PairCollision, || springs.pairs(film, meetings, is_apart, rubric));
    judge_energy(report, film, (&flights, &bounces, &collisions), &springs, rubric);
    report.forgive_walls_that_were_shot_through();
    let is_explained = report.notes.contains(&Note::PrintedEta);
    let is_little = report.is_little_judged() && !is_explained && !is_masked;
    report.notes.extend(is_little.then_some(Note::LittleJudged));
    if is_masked {
        return report.mask_contacts();
    }
    report.lose_what_is_not_seen_out_of_the_box();
}

/// What contacts give back, the energy of all, and what becomes of it in long films.
fn judge_energy(
    report: &mut Report,
    film: &Film,
    (flights, bounces, collisions): (&Flights, &[Bounce], &[Collision]),
    springs: &Springs,
    rubric: &Rubric,
) {
    let stuck = Stuck::of(film, flights, rubric);
    let seen = Restitutions::of(bounces, collisions, &stuck, flights, rubric);
    // Another stiffness, or a wall elsewhere, changes restitution as well: one mistake, one check.
    let is_told = springs.wall.is_some() || springs.shift.is_some();
    let restitution = |is_wall: bool| match is_told || (!is_wall && springs.pair.is_some()) {
        true => Status::NotSeen,
        false => seen.verdict(is_wall, rubric),
    };
    report.decide(Check::RestitutionWall, || restitution(true));
    report.decide(Check::RestitutionPair, || restitution(false));
    report.notes.extend(seen.is_printed_eta(rubric).then_some(Note::PrintedEta));
    // So does a start or a contact that is wrong to the energy.
    let contacts = [Check::Start, Check::WallBounce, Check::PairCollision];
    let contacts = contacts.iter().chain(&[Check::RestitutionWall, Check::RestitutionPair]);
    // Who comes in by the opposite wall may meet somebody who lies there.
    let wraps = report.found(Check::Box, Finding::ComesBackOpposite);
    let told = is_told || wraps || contacts.into_iter().any(|&check| report.failed(check));
    report.decide(Check::Energy, || energy::verdict(film, flights, rubric, &seen, told));
    let told = report.failures().any(|(check, _)| check.is_of_frames());
    let moves = (flights, collisions);
    report.decide(Check::LongRun, || long_run::verdict(film, moves, rubric, &seen, told));
}
