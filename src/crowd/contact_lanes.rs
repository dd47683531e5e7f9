//! Four contacts at a time: [`Contact::between`](crate::particle::Contact::between) in four lanes.
//!
//! The arithmetic is that of `Contact::between`, operation by operation, so the bits are the same
//! (IEEE 754 says what each must give, one at a time or four); a test holds one against the other. What
//! differs is that nothing branches on which of four pairs touch: in a bed most of them do, but not all, and a
//! processor that guesses wrong loses more time than the contact costs.

use super::lane_law::{ContactLanes, LaneLaw};
use super::lanes::Lanes;
use super::largest::Largest;
use crate::particle::Particle;

/// Forces on four discs, N: the x and the y components.
pub(super) type Forces<V> = [V; 2];

/// The forces on discs `b` of their contacts with discs `a`, lane by lane, N: the whole and the springs'
/// share, if `with_springs`. Nothing for discs that do not touch; `None` if none do.
#[inline(always)]
pub(super) fn forces<L: LaneLaw, V: Lanes>(
    law: &L,
    zero: V,
    [a, b]: [[&Particle; 4]; 2],
    largest: &mut Largest,
) -> Option<[Forces<V>; 2]> {
    let motion = |disc: &Particle| {
        let (x, v) = (disc.position, disc.velocity);
        zero.of([x.x, x.y, v.x, v.y])
    };
    // Seen from a: velocities with the other sign than in `Contact::between`.
    let seen = |k: usize| motion(b[k]) - motion(a[k]);
    let [x, y, vx, vy] = V::transposed([seen(0), seen(1), seen(2), seen(3)]);
    let radii = |[a, b, c, d]: [&Particle; 4]| zero.of([a.radius, b.radius, c.radius, d.radius]);
    let (radius, other_radius) = (radii(a), radii(b));
    let reach = radius + other_radius;

    let distance_squared = x * x + y * y;
    let touch = distance_squared.is_less(reach * reach);
    if !touch.is_any() {
        return None; // most pairs of a gas; few of a bed
    }
    let distance = distance_squared.sqrt();
    let has_direction = zero.is_less(distance);
    let normal_x = (x / distance).or_else(has_direction, zero.all(1.0));
    let normal_y = (y / distance).where_all(has_direction);
    let overlap = reach - distance;
    let approach_speed = (vx * normal_x + vy * normal_y).negated();
    let contacts = ContactLanes { overlap, approach_speed, discs: [a, b] };

    let notable = zero.all(largest.notable) * radius.lesser(other_radius);
    if notable.is_less(overlap).where_all(touch).is_any() {
        let overlaps = overlap.where_all(touch).to_array();
        (0..4).for_each(|k| largest.note(overlaps[k], a[k].radius, b[k].radius));
    }
    let along_normal =
        |size: V| [(size * normal_x).where_all(touch), (size * normal_y).where_all(touch)];
    Some([along_normal(law.pushes(&contacts)), along_normal(law.springs(&contacts))])
}

#[cfg(test)]
mod tests {
    use glam::DVec2;
    use wide::f64x4;

    use super::*;
    use crate::particle::{Contact, ContactLaw, Damping, SpringDashpot};

    /// Discs about the origin: apart, touching, deep in each other, at one place, far away, no number.
    fn discs() -> Vec<Particle> {
        let golden = |k: usize| (0.618_034 * k as f64).fract() - 0.5;
        let disc = |k: usize| {
            let position = DVec2::new(golden(k), golden(7 * k + 3));
            let mut disc =
                Particle::at_rest(position, 0.1 + 0.3 * golden(3 * k).abs(), 1.0 + golden(k));
            disc.velocity = DVec2::new(golden(5 * k), golden(11 * k));
            disc
        };
        let mut discs: Vec<_> = (0..24).map(disc).collect();
        discs[1].position = discs[0].position; // no direction
        discs[3].position = discs[2].position + DVec2::X * (discs[2].radius + discs[3].radius);
        discs[4].velocity = discs[5].velocity; // no approach
        discs[6].position *= 1e200;
        discs[7].position.x = f64::NAN;
        discs
    }

    fn hold_against_one_at_a_time<V: Lanes>(zero: V, law: &SpringDashpot) {
        let discs = discs();
        let mut one_by_one = Largest::default();
        let mut in_lanes = Largest::default();
        let pairs: Vec<_> = (0..discs.len()).flat_map(|b| (0..b).map(move |a| (a, b))).collect();
        assert_eq!(pairs.len() % 4, 0);
        for four in pairs.chunks(4) {
            let side = |second: bool| {
                std::array::from_fn(|k| &discs[if second { four[k].1 } else { four[k].0 }])
            };
            let found = forces(law, zero, [side(false), side(true)], &mut in_lanes);
            let found = found.map(|all| all.map(|xy| xy.map(V::to_array)));
            for (k, &(a, b)) in four.iter().enumerate() {
                let contact = Contact::between(&discs[a], &discs[b]);
                let wanted = contact.map_or([DVec2::ZERO; 2], |contact| {
                    one_by_one.note(contact.overlap, discs[a].radius, discs[b].radius);
                    [law.push(&contact), law.spring(&contact)].map(|size| size * contact.normal)
                });
                let found =
                    found.map_or([DVec2::ZERO; 2], |all| all.map(|[x, y]| DVec2::new(x[k], y[k])));
                // Added to 0, as sums begin: the sign of a zero force changes no sum.
                let bits = |force: DVec2| (force + DVec2::ZERO).to_array().map(f64::to_bits);
                assert_eq!(found.map(bits), wanted.map(bits), "discs {a} and {b}");
            }
        }
        assert!(in_lanes.overlaps.largest_pair_overlap > 1.0);
        assert_eq!(
            in_lanes.overlaps.largest_pair_overlap,
            one_by_one.overlaps.largest_pair_overlap
        );
        assert_eq!(in_lanes.overlaps.largest_sinking, one_by_one.overlaps.largest_sinking);
    }

    #[test]
    fn four_contacts_at_a_time_have_the_bits_of_one_at_a_time_on_any_processor() {
        for damping in [Damping::Coefficient(4.0), Damping::Rate(30.0), Damping::Ratio(0.7)] {
            for tension in [false, true] {
                let law = SpringDashpot { stiffness: 5.0, damping, tension };
                hold_against_one_at_a_time(f64x4::ZERO, &law);
                #[cfg(target_arch = "x86_64")]
                if let Some(zero) = super::super::avx2::Four::on_this_processor() {
                    hold_against_one_at_a_time(zero, &law);
                }
            }
        }
    }
}
