//! Kicks and drifts, block by block: each disc is fetched once for all that is to be done with it.

use glam::DVec2;

use super::lanes::Lanes;
use super::motion_lanes::KickAndDrift;
use crate::particle::Particle;

/// A move of every disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Move {
    /// v' = v + (F/m) dt; dt in s.
    Kick(f64),
    /// x' = x + v dt; dt in s.
    Drift(f64),
}

/// Work of gravity, springs and dashpots in one kick of one block, J.
pub(super) type Booked = [f64; 3];

/// A block of discs and what lies beside them.
pub(super) struct Block<'a> {
    pub particles: &'a mut [Particle],
    /// Springs' forces, N; empty without ledger.
    pub springs: &'a [DVec2],
    pub listed_at: &'a [[f64; 2]],
    /// One for each kick; empty without ledger.
    pub books: &'a mut [Booked],
}

impl Block<'_> {
    /// Moves the discs under `gravity` (m/s2) and says how far the farthest is from where it was listed:
    /// the square of it, m2.
    #[inline(always)]
    pub fn go<V: Lanes>(self, zero: V, moves: &[Move], gravity: DVec2) -> f64 {
        let Self { particles, springs, listed_at, books } = self;
        let mut books = books.iter_mut();
        // The last drift goes with a look at where it leads, and with the kick before it.
        let (before, last) = match *moves {
            [ref before @ .., Move::Kick(kick), Move::Drift(drift)] => {
                (before, Some(KickAndDrift { kick, drift, gravity }))
            }
            _ => (moves, None),
        };
        for to_do in before {
            match (to_do, books.next_if_kick(to_do)) {
                (Move::Kick(dt), Some(booked)) => {
                    *booked = kick_and_book(particles, springs, gravity, *dt);
                }
                (Move::Kick(dt), None) => particles.iter_mut().for_each(|disc| disc.kick(*dt)),
                (Move::Drift(dt), _) => particles.iter_mut().for_each(|disc| disc.drift(*dt)),
            }
        }
        match (last, books.next()) {
            (Some(last), Some(booked)) => {
                let farthest;
                (farthest, *booked) = last.move_all::<V, true>(zero, particles, springs, listed_at);
                farthest
            }
            (Some(last), None) => last.move_all::<V, false>(zero, particles, &[], listed_at).0,
            (None, _) => {
                let mut farthest = Farthest::of([0.0; 4]);
                particles.iter().zip(listed_at).for_each(|(disc, at)| farthest.look(disc, at));
                farthest.among_finite(particles, listed_at)
            }
        }
    }
}

/// The square of how far the farthest disc is from where it was listed, m2.
pub(super) struct Farthest(f64);

impl Farthest {
    /// The largest of several.
    pub fn of(squares: [f64; 4]) -> Self {
        Self(squares.into_iter().fold(0.0, f64::max))
    }

    #[inline(always)]
    pub fn look(&mut self, disc: &Particle, listed_at: &[f64; 2]) {
        let moved = disc.position.distance_squared(DVec2::from_array(*listed_at));
        self.0 = if moved > self.0 { moved } else { self.0 };
    }

    /// A disc whose position is no number any more touches nobody and does not count.
    pub fn among_finite(self, particles: &[Particle], listed_at: &[[f64; 2]]) -> f64 {
        if self.0.is_finite() {
            return self.0;
        }
        let mut farthest = Self(0.0);
        let finite = particles.iter().zip(listed_at).filter(|(disc, _)| disc.position.is_finite());
        finite.for_each(|(disc, at)| farthest.look(disc, at));
        farthest.0
    }
}

/// The books of the kicks among moves, one after the other.
trait NextIfKick<'a> {
    fn next_if_kick(&mut self, to_do: &Move) -> Option<&'a mut Booked>;
}

impl<'a, I: Iterator<Item = &'a mut Booked>> NextIfKick<'a> for I {
    fn next_if_kick(&mut self, to_do: &Move) -> Option<&'a mut Booked> {
        if matches!(to_do, Move::Kick(_)) { self.next() } else { None }
    }
}

/// Kicks by `dt` (s), and says what weight, springs and dashpots did in the kick, J.
///
/// Only weight and contacts act here, so the dashpots' force is what is left of the whole.
pub(super) fn kick_and_book(
    particles: &mut [Particle],
    springs: &[DVec2],
    gravity: DVec2,
    dt: f64,
) -> Booked {
    let mut booked = [0.0; 3];
    for (disc, &spring) in particles.iter_mut().zip(springs) {
        let before = disc.velocity;
        disc.kick(dt);
        let path = (before + disc.velocity) * (0.5 * dt);
        let weight = disc.mass * gravity;
        let works = [weight, spring, disc.force - weight - spring].map(|force| force.dot(path));
        (0..3).for_each(|kind| booked[kind] += works[kind]);
    }
    booked
}
