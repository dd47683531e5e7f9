//! Restitution: what was measured beside what should be, and which mistake a difference looks like.

use std::f64::consts::{PI, SQRT_2};

use super::bounce::Bounce;
use super::check::Check;
use super::collision::Collision;
use super::delay::delay;
use super::flight::Flights;
use super::mistake::Mistake;
use super::replay::Replay;
use super::rubric::{Law, PrintedEta, Rubric};
use super::stuck::Stuck;
use super::verdict::{Failure, Status, Verdict};
use super::wall::Wall;
use super::words::{Finding, Quantity};

/// Below it discs do not part: no damping of the course's kind comes near it.
const STUCK: f64 = 0.05;

/// Medians as near to 1 as this are those of contacts without a dashpot (right programs are off by 0.002).
const ELASTIC: f64 = 0.01;

/// Median restitution of some contacts.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// Speed after over speed before, as for a head-on contact.
    pub e: f64,
    /// The smallest and the largest that are right.
    pub expected: (f64, f64),
    /// How far it may be off.
    pub tolerance: f64,
    /// A frame and the discs of one that is as far off as most.
    pub place: (usize, Vec<usize>),
    /// The wall, if one was worse than the others.
    wall: Option<Wall>,
}

impl Seen {
    /// Of single measurements with their places, if there are two.
    fn of(
        mut all: Vec<(f64, (usize, Vec<usize>))>,
        is_wall: bool,
        rubric: &Rubric,
    ) -> Option<Self> {
        if all.len() < 2 {
            return None;
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (e, place) = all.swap_remove(all.len() / 2);
        let expected = rubric.expected_restitution(is_wall);
        let tolerance = tolerance(expected.0, is_wall, rubric);
        Some(Self { e, expected, tolerance, place, wall: None })
    }

    /// By how much it is out of what is right; above 0 if too high.
    pub fn off(&self) -> f64 {
        let (low, high) = self.expected;
        (self.e - high - self.tolerance).max(0.0) + (self.e - low + self.tolerance).min(0.0)
    }

    /// Whether contacts make energy.
    fn makes_energy(&self) -> bool {
        self.e > 1.0 + self.tolerance
    }

    /// The logarithm of how much more speed comes back than should.
    fn gain(&self) -> f64 {
        (self.e / self.expected.1).ln()
    }

    /// Whether e is the inverse of the right one.
    fn is_inverse(&self) -> bool {
        self.expected.1 < 0.97
            && self.makes_energy()
            && (self.e * self.expected.1 - 1.0).abs() < 0.05
    }
}

/// The rubric's tolerance is for springs: with N_t = 10 of Eq. (2) a median at walls is off by up to 0.026 (e =
/// 0.5; touching at any point of a step), of pairs, which have 7 steps, by 0.007 at e = 0.85, 0.04 at 0.53 and
/// 0.047 at 0.37. An impulse has no step to be off by.
fn tolerance(e: f64, is_wall: bool, rubric: &Rubric) -> f64 {
    let wider = if is_wall { 1.0 } else { 1.6 - 0.6 * e };
    match rubric.law {
        Law::Spring => wider * rubric.restitution_tolerance,
        Law::Hard => rubric.restitution_tolerance / 3.0,
    }
}

/// The restitutions of a film.
#[derive(Clone, Debug, PartialEq)]
pub struct Restitutions {
    /// At the wall that is furthest off; of all walls if each was met too seldom.
    pub wall: Option<Seen>,
    /// Of pairs that do not meet too obliquely.
    pub pair: Option<Seen>,
    /// How late forces act in pairs that make energy (see [`delay`]).
    delay: Option<f64>,
    /// Whether discs leave some wall again.
    is_left: bool,
    law: Law,
}

impl Restitutions {
    /// Measures them.
    pub fn of(
        bounces: &[Bounce],
        collisions: &[Collision],
        stuck: &Stuck,
        flights: &Flights,
        rubric: &Rubric,
    ) -> Self {
        let [wall, pair] =
            [walls(bounces, stuck, rubric), pairs(collisions, stuck, flights, rubric)];
        let makes = pair.as_ref().filter(|pair| pair.makes_energy());
        let delay = makes.and_then(|pair| delay(collisions, pair.e, flights, rubric));
        let left = bounces.iter().filter(|one| one.after > 4.0 * STUCK * one.before).count();
        let is_left = 5 * left > stuck.walls.len();
        Self { wall, pair, delay, is_left, law: rubric.law }
    }

    /// Whether discs that touch stay together: a damping far above critical.
    pub fn are_stuck(&self) -> bool {
        let mut seen = [&self.wall, &self.pair].into_iter().flatten().peekable();
        let is_stuck = |one: &Seen| one.e < STUCK && one.expected.0 > STUCK;
        !self.is_left && seen.peek().is_some() && seen.all(is_stuck)
    }

    /// Whether that is to be forgiven, as the guide prints such an eta.
    pub fn is_printed_eta(&self, rubric: &Rubric) -> bool {
        let is_forgiven = rubric.printed_eta == PrintedEta::Forgiven && rubric.law == Law::Spring;
        is_forgiven && self.are_stuck()
    }

    /// The mistake behind contacts that make energy, and the check that says so.
    ///
    /// What is wrong in every contact alike is the integrator's, and a matter of energy; a dashpot's
    /// sign, or one kind of contact, is a matter of restitution.
    pub fn maker(&self) -> Option<(Check, Mistake)> {
        let [wall, pair] = [&self.wall, &self.pair];
        let of = |seen: &Option<Seen>, is: fn(&Seen) -> bool| seen.as_ref().is_some_and(is);
        let makes = [wall, pair].map(|seen| of(seen, Seen::makes_energy));
        let first = if makes[0] { Check::RestitutionWall } else { Check::RestitutionPair };
        if !makes[0] && !makes[1] {
            return self
                .is_explicit_though_damped()
                .then_some((Check::Energy, Mistake::ExplicitEuler));
        }
        let is_sign = |k: usize, seen| !makes[k] || of(seen, Seen::is_inverse);
        if is_sign(0, wall) && is_sign(1, pair) {
            if self.is_explicit_without_dashpot() {
                return Some((Check::Energy, Mistake::ExplicitEuler));
            }
            return Some((first, Mistake::DampingSign));
        }
        // A spring that is not the integrator's victim in one kind of contact is not in the other.
        let is_everywhere = self.law == Law::Spring
            && [wall, pair].into_iter().flatten().all(|seen| seen.gain() > 0.5 * seen.tolerance);
        if !is_everywhere {
            return Some((first, Mistake::EnergyPump));
        }
        let fits = |seen: &Option<Seen>, is_wall| {
            seen.as_ref().is_none_or(|seen| is_explicit(seen.gain(), is_wall))
        };
        let is_explicit = fits(wall, true) && fits(pair, false);
        let cause = if is_explicit { Mistake::ExplicitEuler } else { Mistake::EnergyPump };
        Some((Check::Energy, cause))
    }

    /// Explicit Euler and no dashpot may give back the inverse of the right e. Then its forces act late; and
    /// if walls and pairs should be alike, its gains are not. Without either it cannot be told, and the sign is blamed.
    fn is_explicit_without_dashpot(&self) -> bool {
        let fits = |seen: &Option<Seen>, is_wall| {
            seen.as_ref().is_none_or(|seen| is_explicit(seen.e.ln(), is_wall))
        };
        if self.law != Law::Spring || !fits(&self.wall, true) || !fits(&self.pair, false) {
            return false;
        }
        let (Some(wall), Some(pair)) = (&self.wall, &self.pair) else {
            return self.delay.is_some_and(|delay| delay > 0.5);
        };
        let are_alike = pair.expected.1.ln() / wall.expected.1.ln() < 1.1;
        let is_rooted = pair.e.ln() / wall.e.ln() > 1.25;
        self.delay.map_or(are_alike && is_rooted, |delay| delay > 0.5)
    }

    /// Explicit Euler and a dashpot may leave e below 1: then both gains must be its.
    fn is_explicit_though_damped(&self) -> bool {
        let (Some(wall), Some(pair)) = (&self.wall, &self.pair) else { return false };
        let gains = [wall.gain(), pair.gain()];
        // Without any dashpot e is 1 at walls, whatever was asked for: that is no integrator.
        let is_elastic = (wall.e - 1.0).abs() < ELASTIC;
        wall.off() > 0.0
            && !is_elastic
            && is_explicit(gains[0], true)
            && (1.25..1.6).contains(&(gains[1] / gains[0]))
    }

    /// What to say of one kind of contact.
    pub fn verdict(&self, is_wall: bool, rubric: &Rubric) -> Verdict {
        let seen = if is_wall { &self.wall } else { &self.pair };
        let check = if is_wall { Check::RestitutionWall } else { Check::RestitutionPair };
        let Some(seen) = seen else { return Status::NotSeen };
        if seen.off() == 0.0 {
            return Status::Passed;
        }
        if self.is_printed_eta(rubric) {
            return Status::NotSeen; // a note says why
        }
        let maker = self.maker();
        if maker.is_some_and(|(blamed, _)| blamed == Check::Energy && seen.off() > 0.0) {
            return Status::NotSeen; // `energy` says so
        }
        let cause = match maker {
            Some((_, cause)) if seen.makes_energy() => cause,
            _ => self.cause(seen, check, rubric),
        };
        let failure = Failure::of(Finding::WrongRestitution, cause).at(seen.place.0, &seen.place.1);
        let failure = seen.wall.into_iter().fold(failure, Failure::on);
        let failure = failure.with(Quantity::Restitution, seen.e);
        Status::Failed(failure.with(Quantity::ExpectedRestitution, seen.expected.1))
    }

    /// Of contacts that make no energy.
    fn cause(&self, seen: &Seen, check: Check, rubric: &Rubric) -> Mistake {
        // Everywhere, it is a damping far above critical.
        let is_elsewhere = self.is_left || self.pair.as_ref().is_some_and(|pair| pair.e > STUCK);
        if check == Check::RestitutionWall && seen.e < STUCK && is_elsewhere {
            return Mistake::SticksToWall;
        }
        if rubric.is_elastic() && seen.off() < 0.0 && seen.e > STUCK {
            return Mistake::EnergyLostElastic;
        }
        if (seen.e - 1.0).abs() < ELASTIC {
            return Mistake::DashpotMissing;
        }
        // Twice the spring and twice the dashpot: zeta grows by the root of 2, and so does ln e.
        let twice = seen.expected.0.powf(SQRT_2);
        let is_wall_right = self.wall.as_ref().is_none_or(|wall| wall.off() == 0.0);
        let is_twice = check == Check::RestitutionPair && is_wall_right;
        if is_twice && seen.off() < 0.0 && (seen.e - twice).abs() < 0.5 * (seen.expected.0 - twice)
        {
            return Mistake::ForceAppliedTwice;
        }
        Mistake::RestitutionWrong
    }
}

/// Explicit Euler multiplies the swing of a contact by exp(pi² / (2 N_t)) at a wall, and the square
/// root of 2 times that much in the exponent for a pair, N_t of 10 to 50 in Eq. (2).
fn is_explicit(gain: f64, is_wall: bool) -> bool {
    let scale = if is_wall { 1.0 } else { SQRT_2 };
    let [least, most] = [50.0, 10.0].map(|n_t| PI * PI / (2.0 * n_t));
    (0.7 * least..1.3 * most).contains(&(gain / scale))
}

/// Each wall by itself, if it was met three times: one of four may be wrong.
fn walls(bounces: &[Bounce], stuck: &Stuck, rubric: &Rubric) -> Option<Seen> {
    let of = |wall: Option<u8>| {
        let chosen = bounces.iter().filter(|one| wall.is_none_or(|wall| one.wall == wall));
        let mut all: Vec<_> =
            chosen.map(|one| (one.after / one.before, (one.frame, vec![one.disc]))).collect();
        // Who stays for long and leaves all the same has been counted.
        let leaves = |(k, discs): &(usize, Vec<usize>)| {
            bounces.iter().any(|one| one.disc == discs[0] && one.begin < *k && *k <= one.frame)
        };
        let is_here = |bit: u8| wall.is_none_or(|wall| wall == bit);
        let stuck = stuck.walls.iter().filter(|(bit, place)| is_here(*bit) && !leaves(place));
        all.extend(stuck.map(|(_, place)| (0.0, place.clone())));
        // Nobody left it: two tell that.
        let is_dead = all.iter().all(|(e, _)| *e < STUCK);
        let is_enough = wall.is_none() || is_dead || all.len() >= 3;
        let seen = if is_enough { Seen::of(all, true, rubric) } else { None };
        seen.map(|seen| Seen { wall: wall.map(Wall::of), ..seen })
    };
    let each = [1, 2, 4, 8].into_iter().filter_map(|wall| of(Some(wall)));
    let worst = each.max_by(|a, b| a.off().abs().total_cmp(&b.off().abs()));
    worst.filter(|worst| worst.off() != 0.0).or_else(|| of(None))
}

/// Pairs: in an oblique contact the line of centres turns while they touch, and more comes back than
/// head-on (0.83 for 0.8, if they sink in deep). So each is replayed with the rubric's spring and dashpot,
/// and the difference is taken off.
fn pairs(
    collisions: &[Collision],
    stuck: &Stuck,
    flights: &Flights,
    rubric: &Rubric,
) -> Option<Seen> {
    let replay = Replay::of(flights, rubric);
    let straight = collisions.iter().filter(|one| one.aim < 0.8 && one.is_push());
    let all = straight
        .map(|one| (one.restitution + replay.correction(one), (one.frame, one.discs.to_vec())))
        .chain(stuck.pairs.iter().map(|place| (0.0, place.clone())))
        .collect();
    Seen::of(all, false, rubric)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(wall: Option<f64>, pair: Option<f64>, rubric: &Rubric) -> Restitutions {
        let of = |e: Option<f64>, is_wall| {
            e.and_then(|e| Seen::of(vec![(e, (1, vec![0])); 3], is_wall, rubric))
        };
        let (wall, pair) = (of(wall, true), of(pair, false));
        Restitutions { wall, pair, delay: None, is_left: true, law: rubric.law }
    }

    #[test]
    fn measured_restitutions_tell_the_mistake_and_the_check_that_says_so() {
        use Check::{Energy, RestitutionPair as Pair, RestitutionWall as Wall};
        use Mistake as M;
        let of = |e, law| Rubric { restitution: Some(e), law, ..Rubric::default() };
        let (spring, damped) = (of(1.0, Law::Spring), of(0.8, Law::Spring));
        let hard = of(1.0, Law::Hard);
        let weak = Rubric { eta: 0.5, ..Rubric::default() }; // 0.895 at walls, 0.855 of pairs
        // N_t = 50 and 10 of explicit Euler: exp(pi²/100) and exp(pi²/20), and the root of 2 for pairs.
        for (wall, pair, rubric, expected) in [
            (Some(1.104), Some(1.150), &spring, Some((Energy, M::ExplicitEuler))),
            (Some(1.64), Some(2.01), &spring, Some((Energy, M::ExplicitEuler))),
            (Some(1.104), None, &spring, Some((Energy, M::ExplicitEuler))),
            (Some(0.883), Some(0.920), &damped, Some((Energy, M::ExplicitEuler))),
            (Some(1.05), Some(1.03), &spring, Some((Energy, M::EnergyPump))),
            (Some(1.25), Some(1.25), &damped, Some((Wall, M::DampingSign))),
            (Some(0.8), Some(1.25), &damped, Some((Pair, M::DampingSign))),
            (Some(1.20), Some(1.29), &damped, Some((Energy, M::ExplicitEuler))), // walls and pairs differ
            (Some(1.03), Some(1.0), &hard, Some((Wall, M::EnergyPump))),
            (Some(1.0), Some(1.0), &spring, None),
            (Some(1.0), Some(0.8), &damped, None),
            (Some(1.0), Some(1.0), &weak, None), // a dashpot that was forgotten
        ] {
            let found = seen(wall, pair, rubric).maker();
            assert_eq!(found, expected, "e {wall:?} at walls, {pair:?} of pairs");
        }
    }

    #[test]
    fn contacts_that_take_too_much_or_too_little_are_told_apart() {
        let rubric = Rubric { restitution: Some(0.8), ..Rubric::default() };
        let elastic = Rubric { restitution: Some(1.0), ..Rubric::default() };
        let cause =
            |seen: Restitutions, is_wall, rubric: &Rubric| match seen.verdict(is_wall, rubric) {
                Status::Failed(failure) => failure.cause,
                _ => None,
            };
        let twice = 0.8f64.powf(SQRT_2);
        let of = |wall, pair| seen(Some(wall), Some(pair), &rubric);
        assert_eq!(cause(of(0.8, twice), false, &rubric), Some(Mistake::ForceAppliedTwice));
        assert_eq!(cause(of(twice, twice), false, &rubric), Some(Mistake::RestitutionWrong));
        assert_eq!(cause(of(0.9, 0.8), true, &rubric), Some(Mistake::RestitutionWrong));
        assert_eq!(cause(of(1.0, 0.8), true, &rubric), Some(Mistake::DashpotMissing));
        assert_eq!(cause(of(0.0, 0.8), true, &rubric), Some(Mistake::SticksToWall));
        assert_eq!(cause(of(0.8, 0.8), true, &rubric), None);
        let lossy = seen(Some(0.9), None, &elastic);
        assert_eq!(cause(lossy, true, &elastic), Some(Mistake::EnergyLostElastic));
    }
}
