//! The energy of all discs, per mass and in frames: v²/2 + c y of each disc's last free flight.
//!
//! A disc in contact counts with what it had before, so the energy in the springs needs not be known.
//! Read where it must be constant or fall, the sum tells an integrator or a dashpot that makes energy.

use super::check::Check;
use super::film::Film;
use super::flight::{Flights, median};
use super::mistake::Mistake;
use super::restitution::Restitutions;
use super::rubric::Rubric;
use super::verdict::{Failure, Status, Verdict};
use super::words::{Finding, Quantity};

/// The energy never grows, and does not fall if nothing takes it.
///
/// `told`: whether a start or a contact was already said to be wrong.
pub fn verdict(
    film: &Film,
    flights: &Flights,
    rubric: &Rubric,
    seen: &Restitutions,
    told: bool,
) -> Verdict {
    let energy = sums(film, flights, rubric);
    let ends = ends(&energy).filter(|_| flights.is_sharp(rubric));
    let change = ends.map(|(start, end)| end / start - 1.0);
    let failed = |finding, cause| {
        let failure = Failure::of(finding, cause).at(film.frames.len() - 1, &[]);
        // Contacts tell that energy is made, though something else may take more.
        let fits = |change: &f64| finding != Finding::EnergyGrows || *change > 0.0;
        let shown = change.into_iter().filter(fits);
        let failure = shown.fold(failure, |f, c| f.with(Quantity::EnergyChange, c));
        let e = [&seen.wall, &seen.pair].into_iter().flatten().next();
        Status::Failed(e.into_iter().fold(failure, |f, e| f.with(Quantity::Restitution, e.e)))
    };
    // Contacts that make energy each time tell it before the sum does.
    let maker = seen.maker().filter(|(check, _)| *check == Check::Energy && !told);
    if let Some((_, cause)) = maker {
        return failed(Finding::EnergyGrows, cause);
    }
    if film.is_wild && !told {
        return failed(Finding::EnergyGrows, Mistake::EnergyPump);
    }
    let Some(change) = change else { return Status::NotSeen };
    if change.abs() > rubric.energy_tolerance && told {
        return Status::NotSeen; // it comes from what was judged already
    }
    if change > rubric.energy_tolerance {
        return failed(Finding::EnergyGrows, Mistake::EnergyPump);
    }
    let falls = rubric.is_elastic() && change < -rubric.energy_tolerance - loss(flights, rubric);
    if falls && !seen.is_printed_eta(rubric) {
        return failed(Finding::EnergyFalls, Mistake::EnergyLostElastic);
    }
    Status::Passed
}

/// What contacts of discs that are all but elastic may take: each 1 - e² at most.
fn loss(flights: &Flights, rubric: &Rubric) -> f64 {
    let contacts: usize = flights.runs.iter().map(|runs| runs.len().saturating_sub(1)).sum();
    let e = rubric.expected_restitution(true).0.min(rubric.expected_restitution(false).0);
    contacts as f64 / flights.runs.len().max(1) as f64 * (1.0 - e * e)
}

/// The sum over all discs at each frame; a disc counts with its last free flight, or its first.
fn sums(film: &Film, flights: &Flights, rubric: &Rubric) -> Vec<f64> {
    let frames = film.frames.len();
    let mut sums = vec![0.0; frames];
    for i in 0..film.n() {
        let runs = &flights.runs[i];
        let floor = rubric.corner[1] + film.radius(i);
        let of = |k: usize| {
            let run = runs[k];
            let velocity = flights.velocity(film, i, run, run.begin);
            0.5 * velocity.length_squared() - flights.pull.y * (film.at(run.begin, i).y - floor)
        };
        if runs.is_empty() {
            continue;
        }
        let mut known = 0;
        let mut energy = of(0);
        for (k, sum) in sums.iter_mut().enumerate() {
            while runs.get(known + 1).is_some_and(|next| next.begin <= k) {
                known += 1;
                energy = of(known);
            }
            *sum += energy;
        }
    }
    sums
}

/// Medians over the first and the last tenth, if there are frames enough and anything moves.
fn ends(energy: &[f64]) -> Option<(f64, f64)> {
    let tenth = energy.len() / 10;
    if tenth < 1 {
        return None;
    }
    let start = median(energy[..tenth].iter().copied());
    let end = median(energy[energy.len() - tenth..].iter().copied());
    (start > 0.0 && end.is_finite()).then_some((start, end))
}
