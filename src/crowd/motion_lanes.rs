//! The kick and the drift of Eq. (3), two discs at a time, with a look at where they lead.
//!
//! The arithmetic is that of [`Particle::kick`] and [`Particle::drift`], operation by operation, so the
//! bits are the same; a test holds one against the other.

use glam::DVec2;

use super::lanes::Lanes;
use super::motion::{Booked, Farthest, kick_and_book};
use crate::particle::Particle;

/// What two discs do: v' = v + (F/m) kick, then x' = x + v' drift; times in s.
#[derive(Clone, Copy)]
pub(super) struct KickAndDrift {
    pub kick: f64,
    pub drift: f64,
    pub gravity: DVec2, // m/s2
}

impl KickAndDrift {
    /// Moves `particles`, and says how far the farthest is from where it was listed (the square of it, m2)
    /// and, if it `BOOKS`, what weight, `springs` and dashpots did in the kick, J. Without, no springs
    /// are needed.
    #[inline(always)]
    pub fn move_all<V: Lanes, const BOOKS: bool>(
        self,
        zero: V,
        particles: &mut [Particle],
        springs: &[DVec2],
        listed_at: &[[f64; 2]],
    ) -> (f64, Booked) {
        let (kick, drift, half) = (zero.all(self.kick), zero.all(self.drift), 0.5 * self.kick);
        let (gravity, half) = (both(zero, [self.gravity; 2]), zero.all(half));
        let (mut farthest, mut booked) = (zero, [zero; 3]);
        let even = particles.len() / 2 * 2;
        let (twos, last) = particles.split_at_mut(even);
        let twos = twos.chunks_exact_mut(2).zip(listed_at.chunks_exact(2));
        for (k, (two, at)) in twos.enumerate() {
            let [a, b] = two else { continue };
            let mass = zero.of([a.mass, a.mass, b.mass, b.mass]);
            let force = both(zero, [a.force, b.force]);
            let before = both(zero, [a.velocity, b.velocity]);
            let velocity = before + force / mass * kick;
            let position = both(zero, [a.position, b.position]) + velocity * drift;
            [a.velocity, b.velocity] = each(velocity);
            [a.position, b.position] = each(position);
            if BOOKS {
                let path = (before + velocity) * half;
                let weight = mass * gravity;
                let spring = both(zero, [springs[2 * k], springs[2 * k + 1]]);
                booked[0] = booked[0] + weight * path;
                booked[1] = booked[1] + spring * path;
                booked[2] = booked[2] + (force - weight - spring) * path;
            }
            let listed = [at[0][0], at[0][1], at[1][0], at[1][1]];
            let moved = position - zero.of(listed);
            let moved = moved * moved;
            farthest = (moved + moved.neighbours_exchanged()).greater(farthest);
        }
        let mut farthest = Farthest::of(farthest.to_array());
        let mut booked = booked.map(|work| {
            let [a, b, c, d] = work.to_array();
            (a + b) + (c + d)
        });
        if let ([disc], [.., at]) = (last, listed_at) {
            let one = self.move_one::<BOOKS>(disc, springs.last());
            (0..3).for_each(|kind| booked[kind] += one[kind]);
            farthest.look(disc, at);
        }
        (farthest.among_finite(particles, listed_at), booked)
    }

    /// Moves one disc, and says the same of it.
    fn move_one<const BOOKS: bool>(self, disc: &mut Particle, spring: Option<&DVec2>) -> Booked {
        let mut booked = [0.0; 3];
        match spring {
            Some(spring) if BOOKS => {
                let (disc, spring) = (std::slice::from_mut(disc), std::slice::from_ref(spring));
                booked = kick_and_book(disc, spring, self.gravity, self.kick);
            }
            _ => disc.kick(self.kick),
        }
        disc.drift(self.drift);
        booked
    }
}

#[inline(always)]
fn both<V: Lanes>(zero: V, [a, b]: [DVec2; 2]) -> V {
    zero.of([a.x, a.y, b.x, b.y])
}

#[inline(always)]
fn each<V: Lanes>(vectors: V) -> [DVec2; 2] {
    let [ax, ay, bx, by] = vectors.to_array();
    [DVec2::new(ax, ay), DVec2::new(bx, by)]
}

#[cfg(test)]
mod tests {
    use wide::f64x4;

    use super::*;

    fn hold_against_one_at_a_time<V: Lanes, const BOOKS: bool>(zero: V) {
        let golden = |k: usize| (0.618_034 * k as f64).fract() - 0.5;
        let vector = |k: usize| DVec2::new(golden(k), golden(7 * k + 3));
        let step = KickAndDrift { kick: 0.3, drift: 0.7, gravity: DVec2::new(0.1, -2.0) };
        for n in 0..=7 {
            let disc = |k| {
                let mut disc = Particle::at_rest(vector(k), 0.1, 1.5 + golden(k));
                (disc.velocity, disc.force) = (vector(5 * k + 1), vector(11 * k + 2));
                disc
            };
            let mut moved: Vec<_> = (0..n).map(disc).collect();
            if let Some(disc) = moved.get_mut(4) {
                disc.velocity.x = f64::NAN;
            }
            let springs: Vec<_> = (0..n).map(|k| vector(13 * k)).collect();
            let listed_at: Vec<_> = (0..n).map(|k| vector(k + 100).to_array()).collect();
            let mut one_by_one = moved.clone();
            let booked = kick_and_book(&mut one_by_one, &springs, step.gravity, step.kick);
            one_by_one.iter_mut().for_each(|disc| disc.drift(step.drift));
            let mut farthest = Farthest::of([0.0; 4]);
            let listed = one_by_one.iter().zip(&listed_at);
            listed.for_each(|(disc, at)| farthest.look(disc, at));

            let found = step.move_all::<V, BOOKS>(zero, &mut moved, &springs, &listed_at);
            let bits = |discs: &[Particle]| -> Vec<_> {
                let of =
                    |p: &Particle| [p.position, p.velocity].map(|v| v.to_array().map(f64::to_bits));
                discs.iter().map(of).collect()
            };
            assert_eq!(bits(&moved), bits(&one_by_one), "{n}");
            assert_eq!(found.0, farthest.among_finite(&one_by_one, &listed_at), "{n}");
            for (found, wanted) in found.1.into_iter().zip(booked) {
                let wanted = if BOOKS { wanted } else { 0.0 };
                // Numbers about 1, of which a few are added in another order.
                let is_near = (found - wanted).abs() < 1e-14 || (found.is_nan() && wanted.is_nan());
                assert!(is_near, "{n}: {found} {wanted}");
            }
        }
    }

    #[test]
    fn two_discs_at_a_time_move_to_the_bits_of_one_at_a_time_on_any_processor() {
        hold_against_one_at_a_time::<_, false>(f64x4::ZERO);
        hold_against_one_at_a_time::<_, true>(f64x4::ZERO);
        #[cfg(target_arch = "x86_64")]
        if let Some(zero) = super::super::avx2::Four::on_this_processor() {
            hold_against_one_at_a_time::<_, false>(zero);
            hold_against_one_at_a_time::<_, true>(zero);
        }
    }
}
