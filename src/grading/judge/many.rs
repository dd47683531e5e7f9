//! A box of many discs, a thousand if the rubric does not say: what can be said from a few frames.
//!
//! Nothing of motion is asked again. What goes wrong only with many is room (arrays of a fixed size,
//! places that cannot be found), time, and contacts of several discs at once.

use super::discs;
use super::flight::Flights;
use super::frames::{Footage, read};
use super::mistake::Mistake;
use super::overdamped;
use super::rubric::Rubric;
use super::verdict::{Failure, Status, Verdict};
use super::words::Finding;

/// In a crowd discs that touch a wall are pushed further by others: twice the depth of one alone.
const CROWDED: f64 = 2.0;

/// All there, as large as asked, apart at the start, finite, in the box.
pub fn verdict(footage: Footage, n: usize, rubric: &Rubric) -> Verdict {
    let rubric = Rubric { n: vec![n], ..rubric.clone() };
    let film = match read(footage, &rubric) {
        // One frame of many shows that they were placed, not that they were stepped.
        Ok(film) if film.frames.len() < 2 => {
            return Status::Failed(Failure::too_few_frames(film.frames.len(), 2));
        }
        Ok(film) if overdamped::first_frame(&film, &rubric).is_some() => return Status::Masked,
        Ok(film) => film.before_it_blew_up(),
        Err(failure) => return Status::Failed(failure),
    };
    match discs::kept(&film, &rubric.n) {
        Status::Passed => {}
        Status::Failed(mut failure) if failure.finding == Finding::CountNotAsked => {
            // As many as in the first film, whatever it was told.
            if film.n() == rubric.program.n && film.n() != n {
                failure.cause = Some(Mistake::NumberOfDiscsIgnored);
            }
            return Status::Failed(failure);
        }
        other => return other,
    }
    let film = film.with_true_radii(&rubric);
    let flights = Flights::of(&film, &rubric);
    match discs::start(&film, &flights, &rubric) {
        Status::Passed => discs::inside(&film, &flights, CROWDED, None, &rubric),
        other => other,
    }
}
