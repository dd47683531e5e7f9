//! The guide's own trap: eta_n = 1.5e3 as printed, with the step of Eq. (2).
//!
//! In one step the dashpot changes the velocity of a contact by eta dt/m of itself, m the reduced mass: with the
//! guide's numbers by 13.3 at a wall if N_t = 50 and by 66.6 if N_t = 10, twice as much for two discs. So a step in
//! contact does not brake, it multiplies the velocity by -(eta dt/m - 1): discs come back 12 to 66 times as fast, fly
//! out of the box, stay in contact with its walls there and are multiplied again at every step, until numbers end.
//!
//! It is told by contacts that give back so much, or by that growth: (eta dt/m - 1) for each dt makes 9e4 to 3e5
//! e-foldings a second, where a wall that pulls makes omega0, 7e3. Whoever has contacts that are no such thing had another
//! accident. What follows the first of these contacts shows nothing of the program but that; what comes before it does.

use glam::DVec2;

use super::bounce::{self, Bounce};
use super::check::Check;
use super::collision::{self, Collision};
use super::film::Film;
use super::flight::{Flights, median};
use super::mistake::Mistake;
use super::rubric::{Law, PrintedEta, Rubric};
use super::spot::Spot;
use super::verdict::{Report, Status};
use super::words::Note;

/// The damping that the guide prints, kg/s.
const PRINTED: f64 = 1.5e3;

/// Steps of half a swing, Eq. (2): N_t is 10 to 50; a fifth to spare for what springs and gravity add.
const STEPS: [f64; 2] = [50.0, 10.0];
const SPARE: f64 = 1.2;

/// No contact of an unharmed program gives back so much; those of the trap all do.
const LEAST: f64 = 5.0;

/// E-foldings a second that nothing but a step too long for its forces makes.
const GROWTH: f64 = 5e4;

/// The same a frame, if gravity does not tell how long that is: frames are at most some ms apart.
const GROWTH_A_FRAME: f64 = 20.0;

/// So many times as far in a frame as anybody went before: no contact of springs does that.
const JUMP: f64 = 4.0;

/// The number of the first frame that shows what the trap did, if that is what happened.
pub fn first_frame(film: &Film, rubric: &Rubric) -> Option<usize> {
    let is_forgiven = rubric.printed_eta == PrintedEta::Forgiven && rubric.law == Law::Spring;
    let is_another = rubric.expected_restitution(true).0 > 0.05;
    let n = film.n();
    if !is_forgiven || !is_another || n == 0 || film.frames.iter().any(|frame| frame.len() != n) {
        return None;
    }
    let calm = before_it_is_lost(film);
    let flights = Flights::of(&calm, rubric);
    let bounces = bounce::all(&calm, &flights, rubric);
    let collisions = collision::all(&calm, &flights);
    let jump = jump(film, &flights, rubric);
    let told = Told::of(&bounces, &collisions, jump, rubric);
    let grows = || jump.is_some_and(|k| explodes(film, k, flights.interval(rubric)));
    let is_trap = told.as_it >= told.unlike && (told.as_it >= 2 || told.at_wall > 0 || grows());
    let first = [told.first, jump].into_iter().flatten().min();
    first.filter(|_| is_trap).map(|k| k.max(1))
}

/// The film up to where a disc is out by half the box, goes through half of it in a frame, or is no number.
fn before_it_is_lost(film: &Film) -> Film {
    let middle = film.corner + DVec2::splat(0.5 * film.side);
    let is_lost = |k: usize, i: usize| {
        let place = film.at(k, i);
        let is_near = (place - middle).abs().max_element() <= film.side;
        let is_slow = k == 0 || (place - film.at(k - 1, i)).length() < 0.5 * film.side;
        !(is_near && is_slow)
    };
    let end = (0..film.frames.len()).find(|&k| (0..film.n()).any(|i| is_lost(k, i)));
    film.clone().before(end.unwrap_or(film.frames.len()).max(1))
}

/// What contacts say.
struct Told {
    /// Those that give back what the trap does.
    as_it: usize,
    at_wall: usize,
    /// Those that give back what others do.
    unlike: usize,
    /// The frame after the last one before the first of the trap's.
    first: Option<usize>,
}

impl Told {
    fn of(
        bounces: &[Bounce],
        collisions: &[Collision],
        jump: Option<usize>,
        rubric: &Rubric,
    ) -> Self {
        let end = jump.unwrap_or(usize::MAX);
        // Whoever was hit by somebody too fast to be seen shows nothing.
        let bounces = bounces.iter().filter(|one| one.begin < end);
        let bounces = bounces.map(|one| (true, one.after / one.before, one.begin));
        let straight = collisions.iter().filter(|one| one.aim < 0.8 && one.begin < end);
        let pairs = straight.map(|one| (false, one.restitution, one.begin));
        let mut told = Self { as_it: 0, at_wall: 0, unlike: 0, first: None };
        for (is_wall, e, begin) in bounces.chain(pairs) {
            let [least, most] = given_back(is_wall, rubric);
            if (least / SPARE..most * SPARE).contains(&e) {
                told.as_it += 1;
                told.at_wall += usize::from(is_wall);
                told.first = Some(told.first.map_or(begin + 1, |first| first.min(begin + 1)));
            } else if e < LEAST {
                told.unlike += 1;
            }
        }
        told
    }
}

/// What a step in contact multiplies the speed by, N_t = 50 and 10.
fn given_back(is_wall: bool, rubric: &Rubric) -> [f64; 2] {
    let mass = if is_wall { rubric.mass } else { 0.5 * rubric.mass };
    // Eq. (2) is of a wall's contact.
    let step = |steps: f64| std::f64::consts::PI / (rubric.omega0(true) * steps);
    STEPS.map(|steps| PRINTED * step(steps) / mass - 1.0)
}

/// The first frame to which a disc goes several times as far as anybody went before it, or to no number, from where
/// it may have met something.
fn jump(film: &Film, flights: &Flights, rubric: &Rubric) -> Option<usize> {
    let way = |k: usize, i: usize| (film.at(k, i) - film.at(k - 1, i)).length();
    let (n, frames) = (film.n(), film.frames.len());
    // At first nobody has gone anywhere: twice what most do, and what gravity does in a frame.
    let usual = if frames > 1 { median((0..n).map(|i| way(1, i))) } else { 0.0 };
    let usual = if usual < 0.1 * film.side { usual } else { 0.0 };
    let mut most = (2.0 * usual).max(0.5 * flights.pull.length());
    for k in 1..frames {
        let is_jump = |i: &usize| {
            let way = way(k, *i);
            way.is_nan() || most > 0.0 && way > JUMP * most || way > 0.5 * film.side
        };
        let jumpers: Vec<usize> = (0..n).filter(is_jump).collect();
        if !jumpers.is_empty() {
            let reach = JUMP * most + 4.0 * flights.pull.length() + 0.1 * film.radius(0);
            let near = jumpers.iter().filter(|&&i| is_in_reach(film, k - 1, i, reach, rubric));
            let near = near.count();
            // Whoever divides by zero does it everywhere at once.
            let has_met = near > 0 && (jumpers.len() < n || near == n);
            return has_met.then_some(k);
        }
        most = (0..n).map(|i| way(k, i)).fold(most, f64::max);
    }
    None
}

/// Whether a wall or another disc is so near that a disc may meet it until the next frame.
fn is_in_reach(film: &Film, k: usize, i: usize, reach: f64, rubric: &Rubric) -> bool {
    let (place, radius) = (film.at(k, i), film.radius(i));
    let from = place - DVec2::from(rubric.corner);
    let to_wall = from.min_element().min(rubric.side - from.max_element());
    let is_near = |j: usize| j != i && place.distance(film.at(k, j)) < 2.0 * (radius + reach);
    to_wall < radius + reach || (0..film.n()).any(is_near)
}

/// Whether places grow from frame to frame as nothing else does, from frame `k` on; numbers end at 1e308.
fn explodes(film: &Film, k: usize, interval: Option<f64>) -> bool {
    let middle = film.corner + DVec2::splat(0.5 * film.side);
    let out = |spot: &Spot| {
        let out = (spot.position - middle).abs().max_element() / film.side;
        if out.is_finite() { out } else { f64::MAX }
    };
    let most = |k: usize| film.frames[k].iter().map(out).fold(0.5, f64::max).ln();
    let least = interval.map_or(GROWTH_A_FRAME, |interval| GROWTH * interval);
    // Where numbers end growth is hidden; frames near each other show it over several.
    let grows = |k: usize| most(k) - most(k - 1) > least;
    (k.max(1)..film.frames.len()).any(grows)
}

impl Report {
    /// Sets aside, at no cost, what contacts tell, for they did what the assignment's trap does.
    pub fn mask_contacts(&mut self) {
        use Check as C;
        let is_shifted = self.failed_by(C::Box, Mistake::BoxShifted);
        let is_hidden = |check: C| match check {
            C::Box => !is_shifted,
            check => check.is_of_motion() && check != C::FreeFlight,
        };
        for (_, status) in self.checks.iter_mut().filter(|(check, _)| is_hidden(*check)) {
            *status = Status::Masked;
        }
        self.notes.push(Note::PrintedEtaExplodes);
    }

    /// Whether what contacts tell was set aside.
    pub fn is_masked(&self) -> bool {
        self.notes.contains(&Note::PrintedEtaExplodes)
    }
}
