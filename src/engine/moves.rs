//! Kicks and drifts of Eq. (3), block by block: each disc is fetched once for all that is to be done with it.

use glam::DVec2;

use super::added::Start;
use super::lanes::Lanes;
use super::phase::{Phase, Size};
use crate::particle::Particle;

/// A move of every disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Move {
    /// v' = v + (F/m) dt; dt in s.
    Kick(f64),
    /// x' = x + v dt; dt in s.
    Drift(f64),
}

/// Work of gravity, springs, dashpots and fields in one kick of one block, J.
pub(super) type Booked = [f64; 4];

/// A block of discs and what lies beside them.
pub(super) struct Block<'a> {
    pub phases: &'a mut [Phase],
    pub sizes: &'a [Size],
    /// The mass of all discs, if it is one, kg.
    pub mass: Option<f64>,
    /// Whole forces, N.
    pub forces: &'a [DVec2],
    /// Springs' share of them, N; empty without ledger.
    pub springs: &'a [DVec2],
    /// What their sums began with; empty if that was the weight.
    pub starts: &'a [Start],
    pub reference_positions: &'a [DVec2],
    /// One for each kick; empty without ledger.
    pub books: &'a mut [Booked],
    pub gravity: DVec2, // m/s2
}

/// Masses of discs, two at a time.
trait Masses: Copy {
    fn of(self, disc: usize) -> f64;
}

#[derive(Clone, Copy)]
struct One(f64);

impl Masses for One {
    #[inline(always)]
    fn of(self, _disc: usize) -> f64 {
        self.0
    }
}

impl Masses for &[Size] {
    #[inline(always)]
    fn of(self, disc: usize) -> f64 {
        self[disc].mass
    }
}

/// The forces on the discs of a block, two discs at a time.
pub(super) trait Forces<V> {
    /// The whole forces on the disc of this number and on the next, and the springs' shares, N.
    fn on_two(&self, first: usize) -> [V; 2];
}

/// Forces that were kept.
struct Kept<'a, V> {
    zero: V,
    forces: &'a [DVec2],
    springs: &'a [DVec2],
}

impl<V: Lanes> Forces<V> for Kept<'_, V> {
    #[inline(always)]
    fn on_two(&self, k: usize) -> [V; 2] {
        let springs = match self.springs.get(k..k + 2) {
            Some([one, other]) => both(self.zero, [*one, *other]),
            _ => self.zero,
        };
        [both(self.zero, [self.forces[k], self.forces[k + 1]]), springs]
    }
}

impl Block<'_> {
    /// Moves the discs and says how far the farthest is from where it was listed: the square of it, m2.
    #[inline(always)]
    pub fn go<V: Lanes>(mut self, zero: V, moves: &[Move]) -> f64 {
        // The last drift goes with a look at where it leads, and with the kick before it.
        let (before, last) = match *moves {
            [ref before @ .., Move::Kick(kick), Move::Drift(drift)] => {
                (before, Some([kick, drift]))
            }
            _ => (moves, None),
        };
        let mut kicks = 0;
        for to_do in before {
            match *to_do {
                Move::Kick(dt) => {
                    let booked = self.kick(dt);
                    if let Some(book) = self.books.get_mut(kicks) {
                        *book = booked;
                    }
                    kicks += 1;
                }
                Move::Drift(dt) => self.each(|disc, _| disc.drift(dt)),
            }
        }
        let Some(times) = last else {
            let listed = self.phases.iter().zip(self.reference_positions);
            return farthest(listed, 0.0);
        };
        let booked = kicks.min(self.books.len());
        self.books = &mut std::mem::take(&mut self.books)[booked..];
        let (forces, springs) = (self.forces, self.springs);
        self.kick_and_drift(zero, times, &Kept { zero, forces, springs })
    }

    /// Kicks by the first of `times` and drifts by the second (s), under these `forces`; those on the last disc of an odd
    /// number are the block's. Says what [`go`](Self::go) does.
    #[inline(always)]
    pub fn kick_and_drift<V: Lanes>(
        mut self,
        zero: V,
        times: [f64; 2],
        forces: &impl Forces<V>,
    ) -> f64 {
        let (farthest, booked) = match (self.mass, self.books.is_empty()) {
            (Some(mass), true) => self.move_all::<V, _, false>(zero, One(mass), times, forces),
            (Some(mass), false) => self.move_all::<V, _, true>(zero, One(mass), times, forces),
            (None, true) => self.move_all::<V, _, false>(zero, self.sizes, times, forces),
            (None, false) => self.move_all::<V, _, true>(zero, self.sizes, times, forces),
        };
        if let Some(book) = self.books.first_mut() {
            *book = booked;
        }
        farthest
    }

    /// Kicks by `dt` (s), and says what weight, springs and dashpots did in the kick, J; nothing without ledger.
    ///
    /// Only weight and contacts act here, so the dashpots' force is what is left of the whole.
    fn kick(&mut self, dt: f64) -> Booked {
        let mut booked = [0.0; 4];
        let (springs, starts, gravity) = (self.springs, self.starts, self.gravity);
        self.each(|disc, k| {
            let before = disc.velocity;
            disc.kick(dt);
            if let Some(&spring) = springs.get(k) {
                let path = (before + disc.velocity) * (0.5 * dt);
                let weight = disc.mass * gravity;
                let field = starts.get(k).map_or(DVec2::ZERO, |start| start.field);
                let forces = [weight, spring, disc.force - weight - spring - field, field];
                let works = forces.map(|force| force.dot(path));
                (0..4).for_each(|kind| booked[kind] += works[kind]);
            }
        });
        booked
    }

    /// Changes each disc, of which the number in the block is told.
    fn each(&mut self, mut change: impl FnMut(&mut Particle, usize)) {
        for (k, phase) in self.phases.iter_mut().enumerate() {
            let mut disc = phase.particle(self.sizes[k], self.forces[k]);
            change(&mut disc, k);
            *phase = Phase::from(&disc);
        }
    }

    /// v' = v + (F/m) kick, then x' = x + v' drift, two discs at a time; the last of an odd number by itself.
    #[inline(always)]
    fn move_all<V: Lanes, M: Masses, const BOOKS: bool>(
        &mut self,
        zero: V,
        masses: M,
        [kick, drift]: [f64; 2],
        forces: &impl Forces<V>,
    ) -> (f64, Booked) {
        let (mut most, mut booked) =
            self.move_twos::<V, M, BOOKS>(zero, masses, [kick, drift], forces);
        let n = self.phases.len();
        if n % 2 == 1 {
            let one = self.move_last([kick, drift]);
            (0..4).for_each(|kind| booked[kind] += if BOOKS { one[kind] } else { 0.0 });
            let last = self.phases[n - 1..].iter().zip(&self.reference_positions[n - 1..]);
            most = farthest(last, most);
        }
        if !most.is_finite() {
            // A disc whose position is no number any more touches nobody and does not count.
            let listed = self.phases.iter().zip(self.reference_positions);
            most = farthest(listed.filter(|(disc, _)| disc.position().is_finite()), 0.0);
        }
        (most, booked)
    }

    #[inline(always)]
    fn move_twos<V: Lanes, M: Masses, const BOOKS: bool>(
        &mut self,
        zero: V,
        masses: M,
        [kick, drift]: [f64; 2],
        forces: &impl Forces<V>,
    ) -> (f64, Booked) {
        let reference_positions = &self.reference_positions[..self.phases.len()];
        let (kicks, drifts, half) = (zero.all(kick), zero.all(drift), zero.all(0.5 * kick));
        let gravity = both(zero, [self.gravity; 2]);
        let (mut most, mut booked) = (zero, [zero; 4]);
        for (two, k) in self.phases.chunks_exact_mut(2).zip((0..).step_by(2)) {
            let (a, b) = (zero.of(two[0].0), zero.of(two[1].0));
            let [position, before] = V::halves_exchanged(a, b);
            let [force, spring] = forces.on_two(k);
            let [one, other] = [masses.of(k), masses.of(k + 1)];
            let mass = zero.of([one, one, other, other]);
            let velocity = before + force / mass * kicks;
            let position = position + velocity * drifts;
            let [a, b] = V::halves_exchanged(position, velocity);
            a.put(&mut two[0].0);
            b.put(&mut two[1].0);
            if BOOKS {
                let path = (before + velocity) * half;
                let weight = mass * gravity;
                let field = match self.starts.get(k..k + 2) {
                    Some([one, other]) => both(zero, [one.field, other.field]),
                    _ => zero,
                };
                booked[0] = booked[0] + weight * path;
                booked[1] = booked[1] + spring * path;
                booked[2] = booked[2] + (force - weight - spring - field) * path;
                booked[3] = booked[3] + field * path;
            }
            let moved = position - both(zero, [reference_positions[k], reference_positions[k + 1]]);
            let moved = moved * moved;
            most = (moved + moved.neighbours_exchanged()).greater(most);
        }
        let most = most.to_array().into_iter().fold(0.0, f64::max);
        (most, [total(booked[0]), total(booked[1]), total(booked[2]), total(booked[3])])
    }

    /// Kicks and drifts the last disc by itself.
    fn move_last(&mut self, [kick, drift]: [f64; 2]) -> Booked {
        let last = self.phases.len() - 1;
        let mut disc = Block {
            phases: &mut self.phases[last..],
            sizes: &self.sizes[last..],
            forces: &self.forces[last..],
            springs: self.springs.get(last..).unwrap_or_default(),
            starts: self.starts.get(last..).unwrap_or_default(),
            reference_positions: &[],
            books: &mut [],
            ..*self
        };
        let booked = disc.kick(kick);
        disc.each(|disc, _| disc.drift(drift));
        booked
    }
}

/// The square of how far the farthest is from where it was listed, at least `most`, m2.
fn farthest<'a>(listed: impl Iterator<Item = (&'a Phase, &'a DVec2)>, most: f64) -> f64 {
    listed.fold(most, |most, (disc, at)| {
        let moved = disc.position().distance_squared(*at);
        if moved > most { moved } else { most }
    })
}

#[inline(always)]
fn total<V: Lanes>(works: V) -> f64 {
    let [a, b, c, d] = works.to_array();
    (a + b) + (c + d)
}

#[inline(always)]
fn both<V: Lanes>(zero: V, [a, b]: [DVec2; 2]) -> V {
    zero.of([a.x, a.y, b.x, b.y])
}

#[cfg(test)]
mod tests {
    use wide::f64x4;

    use super::*;
    #[cfg(target_arch = "x86_64")]
    use crate::engine::avx2::{Avx2, Four};

    fn hold_against_one_at_a_time<V: Lanes>(zero: V, has_ledger: bool, are_equal: bool) {
        let golden = |k: usize| (0.618_034 * k as f64).fract() - 0.5;
        let vector = |k: usize| DVec2::new(golden(k), golden(7 * k + 3));
        for n in 0..=7 {
            let mass = |k: usize| if are_equal { 1.5 } else { 1.5 + golden(k) };
            let sizes: Vec<_> = (0..n).map(|k| Size { radius: 0.1, mass: mass(k) }).collect();
            let mut phases: Vec<_> =
                (0..n).map(|k| Phase::new(vector(k), vector(5 * k + 1))).collect();
            if let Some(disc) = phases.get_mut(4) {
                disc.0[2] = f64::NAN;
            }
            let forces: Vec<_> = (0..n).map(|k| vector(11 * k + 2)).collect();
            let springs: Vec<_> =
                (0..if has_ledger { n } else { 0 }).map(|k| vector(13 * k)).collect();
            let listed: Vec<_> = (0..n).map(|k| vector(k + 100)).collect();
            let moved = |moves: &[Move], zero: V| {
                let (mut phases, mut books) = (phases.clone(), [[0.0; 4]]);
                let block = Block {
                    phases: &mut phases,
                    sizes: &sizes,
                    mass: are_equal.then_some(1.5),
                    forces: &forces,
                    springs: &springs,
                    starts: &[],
                    reference_positions: &listed,
                    books: &mut books[..usize::from(has_ledger)],
                    gravity: DVec2::new(0.1, -2.0),
                };
                (block.go(zero, moves), phases, books[0])
            };
            // A drift of no time after it has the kick and the drift done disc by disc.
            let in_lanes = moved(&[Move::Kick(0.3), Move::Drift(0.7)], zero);
            let one_by_one = moved(&[Move::Kick(0.3), Move::Drift(0.7), Move::Drift(0.0)], zero);
            assert_same(&in_lanes, &one_by_one);
        }
    }

    fn assert_same(in_lanes: &(f64, Vec<Phase>, Booked), one_by_one: &(f64, Vec<Phase>, Booked)) {
        let bits = |discs: &[Phase]| -> Vec<_> {
            discs.iter().map(|disc| disc.0.map(f64::to_bits)).collect()
        };
        assert_eq!(bits(&in_lanes.1), bits(&one_by_one.1));
        if in_lanes.1.len() <= 4 {
            assert_eq!(in_lanes.0, one_by_one.0); // no disc is lost
        }
        for (found, wanted) in in_lanes.2.into_iter().zip(one_by_one.2) {
            // Numbers about 1, of which a few are added in another order.
            let is_near = (found - wanted).abs() < 1e-14 || (found.is_nan() && wanted.is_nan());
            assert!(is_near, "{found} {wanted}");
        }
    }

    #[test]
    fn two_discs_at_a_time_move_to_the_bits_of_one_at_a_time_on_any_processor() {
        for (has_ledger, are_equal) in [(false, false), (false, true), (true, false), (true, true)]
        {
            hold_against_one_at_a_time(f64x4::ZERO, has_ledger, are_equal);
            #[cfg(target_arch = "x86_64")]
            if let Some(zero) = Four::<Avx2>::on_this_processor() {
                hold_against_one_at_a_time(zero, has_ledger, are_equal);
            }
        }
    }
}
