//! Whether discs that meet nobody fall as they should.

use super::{Flights, odd};
use crate::grading::judge::film::Film;
use crate::grading::judge::mistake::Mistake;
use crate::grading::judge::rubric::Rubric;
use crate::grading::judge::verdict::{Failure, Status, Verdict};
use crate::grading::judge::words::{Finding, Quantity};

/// Whether discs that meet nobody fall, straight and evenly.
pub fn verdict(film: &Film, flights: &Flights, rubric: &Rubric) -> Verdict {
    if let Some(failure) = odd::grows(film) {
        return Status::Failed(failure);
    }
    let samples = &flights.samples;
    if samples.len() < 3 {
        return Status::NotSeen;
    }
    let off = samples.iter().filter(|sample| flights.off(sample) > 1.0).count();
    // One in ten: something may have been met between frames all the same.
    if 10 * off > samples.len() {
        let stops = odd::stops(film, flights);
        return Status::Failed(stops.unwrap_or_else(|| odd::not_constant(flights, off)));
    }
    let (pull, blur) = (flights.pull, flights.pull_blur);
    let may = blur + 0.02 * pull.length();
    let cause = if rubric.gravity == 0.0 {
        (pull.length() > blur).then_some(Mistake::GravitySideways)
    } else if pull.length() <= blur {
        if !has_moved(film) {
            return Status::NotSeen; // too short a film to see anything fall
        }
        Some(Mistake::GravityMissing)
    } else if pull.x.abs() > may {
        Some(Mistake::GravitySideways)
    } else {
        (pull.y > 0.0).then_some(Mistake::GravitySign)
    };
    let Some(cause) = cause else { return Status::Passed };
    let shown = samples[samples.len() / 2];
    let failure = Failure::of(Finding::WrongPull, cause).at(shown.middle, &[shown.disc]);
    // Nothing that digits cannot show.
    let [x, y] = [pull.x, pull.y].map(|one| if one.abs() > blur { one } else { 0.0 });
    let failure = failure.with(Quantity::PullX, x).with(Quantity::PullY, y);
    Status::Failed(failure.with(Quantity::Blur, blur))
}

/// Whether some disc went a tenth of the box: gravity would have shown by then.
fn has_moved(film: &Film) -> bool {
    let last = film.frames.len() - 1;
    (0..film.n()).any(|i| (film.at(last, i) - film.at(0, i)).length() > 0.1 * film.side)
}
