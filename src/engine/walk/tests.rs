//! Walks in lanes, held against one contact at a time.

use wide::f64x4;

use super::*;
#[cfg(target_arch = "x86_64")]
use crate::engine::avx2::{Avx2, Four};
#[cfg(all(target_arch = "x86_64", has_avx512))]
use crate::engine::avx512::Avx512;
use crate::engine::block_pairs::Fixed;
use crate::engine::lookup::Lookup;
use crate::engine::pair_buffer::{Split, Whole};
use crate::engine::phase::{Phase, Size};
use crate::particle::{Damping, Particle, SpringDashpot};

/// Discs about the origin: apart, touching, deep in each other, at one place, far away, no number.
fn discs(are_equal: bool) -> Vec<Particle> {
    let golden = |k: usize| (0.618_034 * k as f64).fract() - 0.5;
    let disc = |k: usize| {
        let (radius, mass) = match are_equal {
            true => (0.2, 1.5),
            false => (0.1 + 0.3 * golden(3 * k).abs(), 1.0 + golden(k)),
        };
        let position = DVec2::new(golden(k), golden(7 * k + 3));
        let mut disc = Particle::at_rest(position, radius, mass);
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

fn constants(pairs: &[[u16; 2]], discs: &[Particle]) -> PairConstants {
    let mut constants = PairConstants::default();
    for pair in pairs {
        let [a, b] = pair.map(|at| &discs[usize::from(at)]);
        constants.reaches.push(a.radius + b.radius);
        constants.reduced_masses.push(a.mass * b.mass / (a.mass + b.mass));
        constants.smaller_radii.push(a.radius.min(b.radius) as f32 * 0.999_999);
    }
    let length = pairs.len() + CHUNK;
    constants.reaches.resize(length, 0.0);
    constants.reduced_masses.resize(length, 0.0);
    constants.smaller_radii.resize(length, 0.0);
    constants
}

/// Holds both sides of a pair against its contact by itself.
fn assert_same<V: Lanes, E: Entry<V>>(
    zero: V,
    law: &SpringDashpot,
    [a, b]: [&Particle; 2],
    [on_a, on_b]: [E::Stored; 2],
    largest: &mut Largest,
) {
    let wanted = Contact::between(a, b).map_or([DVec2::ZERO; 2], |contact| {
        largest.note(contact.overlap, a.radius, b.radius);
        [law.push(&contact), law.spring(&contact)].map(|size| size * contact.normal)
    });
    // Added to 0, as sums begin: the sign of a zero force changes no sum.
    let sum = |side| E::of(E::plus(E::start(zero, &E::Stored::default()), side));
    let bits = |force: DVec2| (force + DVec2::ZERO).to_array().map(f64::to_bits);
    let wanted = if E::HAS_SPRING { wanted } else { [wanted[0], DVec2::ZERO] };
    assert_eq!(sum(&on_b).map(bits), wanted.map(bits), "on {b:?} of {a:?}");
    assert_eq!(sum(&on_a).map(bits), wanted.map(|force| bits(-force)), "on {a:?} of {b:?}");
}

/// Where in the ring a walk begins: in the middle, so that it goes around.
const SLOT: usize = 200;

/// The ring after a walk over `pairs` of `discs`, and the largest overlaps.
fn walked<V: Lanes, E: Entry<V>>(
    zero: V,
    law: &SpringDashpot,
    (discs, are_equal): (&[Particle], bool),
    pairs: &[[u16; 2]],
) -> (Vec<E::Both>, Largest) {
    let phases: Vec<_> = discs.iter().map(Phase::from).collect();
    let sizes: Vec<_> = discs.iter().map(|p| Size { radius: p.radius, mass: p.mass }).collect();
    let ids: Vec<u32> = (0..24).collect();
    let constants = constants(pairs, discs);
    let block = BlockPairs {
        fixed: Fixed::of(&sizes, are_equal.then_some(sizes[0]), &ids, &[]),
        constants: &constants,
        // SAFETY: no pair names more than 24 discs.
        #[allow(unsafe_code)]
        discs: unsafe { Lookup::new(&phases, 24) },
        place: 0,
        pairs,
        first: 0,
        memory: &mut [],
        elapsed: 0.0,
    };
    let mut ring = vec![E::Both::default(); pairs.len() + 136];
    let (mut largest, scratch, block) = (Largest::default(), &mut Scratch::default(), &block);
    if are_equal {
        let walk = Walk { law, sizing: Equal::of(sizes[0]), block };
        walk.go::<V, E>(zero, &mut ring, SLOT, scratch, &mut largest);
    } else {
        let walk = Walk { law, sizing: Unequal::of(&constants), block };
        walk.go::<V, E>(zero, &mut ring, SLOT, scratch, &mut largest);
    }
    (ring, largest)
}

fn hold_against_one_at_a_time<V: Lanes, E: Entry<V>>(zero: V, law: &SpringDashpot, equal: bool) {
    let discs = discs(equal);
    let mut pairs: Vec<[u16; 2]> = (0..24).flat_map(|b| (0..b).map(move |a| [a, b])).collect();
    pairs.resize(pairs.len().next_multiple_of(8), [22, 23]);
    let (ring, in_lanes) = walked::<V, E>(zero, law, (&discs, equal), &pairs);
    let mut one_by_one = Largest::default();
    for (k, pair) in pairs.iter().enumerate() {
        let [a, b] = pair.map(|at| &discs[usize::from(at)]);
        let sides = E::apart(ring[(SLOT + k) % ring.len()]);
        assert_same::<V, E>(zero, law, [a, b], sides, &mut one_by_one);
    }
    assert!(in_lanes.overlaps.largest_pair_overlap > 1.0);
    assert_eq!(in_lanes.overlaps, one_by_one.overlaps);
}

#[test]
fn contacts_of_a_walk_have_the_bits_of_one_at_a_time_on_any_processor() {
    for damping in [Damping::Coefficient(4.0), Damping::Rate(30.0), Damping::Ratio(0.7)] {
        for (tension, equal) in [(false, false), (true, false), (false, true), (true, true)] {
            let law = SpringDashpot { stiffness: 5.0, damping, tension };
            hold_both(f64x4::ZERO, &law, equal);
            #[cfg(target_arch = "x86_64")]
            if let Some(zero) = Four::<Avx2>::on_this_processor() {
                hold_both(zero, &law, equal);
            }
            #[cfg(all(target_arch = "x86_64", has_avx512))]
            if let Some(zero) = Four::<Avx512>::on_this_processor() {
                hold_both(zero, &law, equal);
            }
        }
    }
}

fn hold_both<V: Lanes>(zero: V, law: &SpringDashpot, equal: bool) {
    hold_against_one_at_a_time::<V, Whole>(zero, law, equal);
    hold_against_one_at_a_time::<V, Split>(zero, law, equal);
}
