//! Kicks and drifts, block by block: each disc is fetched once for all that is to be done with it.

use glam::DVec2;
use wide::f64x2;

use super::near::reference;
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
    pub listed_at: &'a [[f32; 2]],
    /// One for each kick; empty without ledger.
    pub books: &'a mut [Booked],
}

impl Block<'_> {
    /// Moves the discs under `gravity` (m/s2) and says how far the farthest is from where it was listed:
    /// the square of it, m2.
    pub fn go(self, moves: &[Move], gravity: DVec2) -> f64 {
        let Self { particles, springs, listed_at, books } = self;
        let mut books = books.iter_mut();
        // The last drift goes with a look at where it leads, and with the kick before it.
        let (before, last) = match moves {
            [before @ .., Move::Kick(kick), Move::Drift(drift)] => (before, Some((*kick, *drift))),
            _ => (moves, None),
        };
        for to_do in before {
            match (to_do, books.next_if_kick(to_do)) {
                (Move::Kick(dt), Some(booked)) => {
                    *booked = kick_and_book(particles, springs, gravity, *dt, |_| ());
                }
                (Move::Kick(dt), None) => particles.iter_mut().for_each(|disc| disc.kick(*dt)),
                (Move::Drift(dt), _) => particles.iter_mut().for_each(|disc| disc.drift(*dt)),
            }
        }
        let mut farthest = Farthest(0.0);
        let listed = listed_at.iter();
        match (last, books.next()) {
            (Some((kick, drift)), Some(booked)) => {
                let mut listed = listed;
                *booked = kick_and_book(particles, springs, gravity, kick, |disc| {
                    disc.drift(drift);
                    listed.next().into_iter().for_each(|at| farthest.look(disc, at));
                });
            }
            (Some((kick, drift)), None) => {
                for (disc, at) in particles.iter_mut().zip(listed) {
                    disc.kick(kick);
                    disc.drift(drift);
                    farthest.look(disc, at);
                }
            }
            (None, _) => {
                particles.iter().zip(listed).for_each(|(disc, at)| farthest.look(disc, at))
            }
        }
        farthest.among_finite(particles, listed_at)
    }
}

/// The square of how far the farthest disc is from where it was listed, m2.
struct Farthest(f64);

impl Farthest {
    #[inline(always)]
    fn look(&mut self, disc: &Particle, listed_at: &[f32; 2]) {
        let moved = disc.position.distance_squared(reference(*listed_at));
        self.0 = if moved > self.0 { moved } else { self.0 };
    }

    /// A disc whose position is no number any more touches nobody and does not count.
    fn among_finite(self, particles: &[Particle], listed_at: &[[f32; 2]]) -> f64 {
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

/// Kicks by `dt` (s), does what else is to be done with each disc `then`, and says what weight, springs
/// and dashpots did in the kick, J.
///
/// Only weight and contacts act here, so the dashpots' force is what is left of the whole.
fn kick_and_book(
    particles: &mut [Particle],
    springs: &[DVec2],
    gravity: DVec2,
    dt: f64,
    mut then: impl FnMut(&mut Particle),
) -> Booked {
    let vector = |v: DVec2| f64x2::new(v.to_array());
    let (gravity, half) = (vector(gravity), f64x2::splat(0.5 * dt));
    // By components, added at the end.
    let mut booked = [f64x2::ZERO; 3];
    for (disc, &spring) in particles.iter_mut().zip(springs) {
        let before = vector(disc.velocity);
        disc.kick(dt);
        let path = (before + vector(disc.velocity)) * half;
        let weight = f64x2::splat(disc.mass) * gravity;
        let spring = vector(spring);
        let dashpot = vector(disc.force) - weight - spring;
        booked[0] += weight * path;
        booked[1] += spring * path;
        booked[2] += dashpot * path;
        then(disc);
    }
    booked.map(|work| work.to_array()[0] + work.to_array()[1])
}
