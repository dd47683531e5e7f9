//! The grid and the list against all pairs, on random states and at the edges.

use glam::DVec2;
use parsim2d::neighbours::{Neighbours, all_pairs};
use parsim2d::particle::{Contact, Particle};
use proptest::prelude::*;

/// All touching pairs, found the plain way.
fn touching(
    particles: &[Particle],
    pairs: impl Iterator<Item = (usize, usize)>,
) -> Vec<(usize, usize)> {
    pairs.filter(|&(i, j)| Contact::between(&particles[i], &particles[j]).is_some()).collect()
}

fn assert_no_pair_is_missed(neighbours: &mut Neighbours, particles: &[Particle]) {
    neighbours.refresh(particles);
    let listed: Vec<_> = neighbours.pairs().collect();
    assert!(listed.is_sorted(), "pairs must come in lexicographic order");
    assert!(listed.iter().all(|&(i, j)| i < j && j < particles.len()));
    let unique = listed.windows(2).all(|two| two[0] != two[1]);
    assert!(unique, "a pair is listed twice");
    let plain = touching(particles, all_pairs(particles.len()));
    assert_eq!(touching(particles, listed.into_iter()), plain);
}

/// A coordinate in the box, beyond it, on its walls, far away, or no number at all.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        20 => 0.0..0.04,
        4 => prop_oneof![Just(0.0), Just(0.04), Just(0.02), Just(-0.0)],
        3 => -0.01..0.05,
        1 => prop_oneof![Just(1e6), Just(-1e6), Just(1e300), Just(f64::INFINITY)],
        1 => Just(f64::NAN),
    ]
}

fn discs(most: usize) -> impl Strategy<Value = Vec<Particle>> {
    let radius = prop_oneof![Just(1e-4), Just(1e-3), 1e-5..5e-3];
    prop::collection::vec((coordinate(), coordinate(), radius), 0..most).prop_map(|discs| {
        discs.into_iter().map(|(x, y, r)| Particle::at_rest(DVec2::new(x, y), r, 1e-3)).collect()
    })
}

/// Discs in and around the box: while one has no place at all, every list is a new one.
fn finite_discs(most: usize) -> impl Strategy<Value = Vec<Particle>> {
    let place = (-0.002..0.042, -0.002..0.042, prop_oneof![Just(1e-4), Just(1e-3), 1e-4..3e-3]);
    prop::collection::vec(place, 2..most).prop_map(|discs| {
        discs.into_iter().map(|(x, y, r)| Particle::at_rest(DVec2::new(x, y), r, 1e-3)).collect()
    })
}

proptest! {
    #![proptest_config(crate::support::steady())]

    #[test]
    fn a_fresh_list_has_every_touching_pair(particles in discs(120)) {
        assert_no_pair_is_missed(&mut Neighbours::default(), &particles);
    }

    #[test]
    fn a_list_stays_complete_while_discs_wander(
        start in finite_discs(60),
        steps in prop::collection::vec((0usize..60, -2e-4..2e-4, -2e-4..2e-4), 1..200),
    ) {
        let mut particles = start;
        let mut neighbours = Neighbours::default();
        for (who, dx, dy) in steps {
            assert_no_pair_is_missed(&mut neighbours, &particles);
            if let Some(disc) = particles.get_mut(who) {
                disc.position += DVec2::new(dx, dy);
            }
        }
    }
}

#[test]
fn a_violent_run_never_misses_a_contact() {
    // Elastic discs at 5 m/s in a small box, every step held against all pairs.
    use crate::support::{ELASTIC, INTEGRATORS, MASS, RADIUS, STIFFNESS, law};
    use parsim2d::force::HalfPlane;
    use parsim2d::simulation::{Simulation, place_discs, time_step};
    let side = 0.01;
    let mut discs = place_discs(40, RADIUS, MASS, side, 3).unwrap();
    for (k, disc) in discs.iter_mut().enumerate() {
        disc.velocity = 5.0 * DVec2::from_angle(k as f64);
    }
    let (law, walls, integrator) = (law(ELASTIC), HalfPlane::square(side), INTEGRATORS[0].1());
    let dt = time_step(MASS, STIFFNESS, 50.0);
    let mut simulation = Simulation::new(discs, DVec2::ZERO, law, &walls, integrator, dt);
    let mut neighbours = Neighbours::default();
    let mut contacts_seen = 0;
    for _ in 0..5000 {
        simulation.step();
        assert_no_pair_is_missed(&mut neighbours, simulation.particles());
        let pairs = touching(simulation.particles(), neighbours.pairs());
        contacts_seen += pairs.len();
    }
    assert!(contacts_seen > 1000, "{contacts_seen}");
}

#[test]
fn discs_on_a_line_or_in_a_point_are_handled() {
    for place in [|_: usize| DVec2::ZERO, |k: usize| DVec2::new(k as f64 * 1.5e-3, 0.0)] {
        let particles: Vec<_> = (0..50).map(|k| Particle::at_rest(place(k), 1e-3, 1.0)).collect();
        assert_no_pair_is_missed(&mut Neighbours::default(), &particles);
    }
}

#[test]
fn a_disc_that_grows_or_comes_back_is_seen_again() {
    let far = DVec2::new(0.01, 0.0);
    let mut particles =
        vec![Particle::at_rest(DVec2::ZERO, 1e-3, 1.0), Particle::at_rest(far, 1e-3, 1.0)];
    let mut neighbours = Neighbours::default();
    assert_no_pair_is_missed(&mut neighbours, &particles);
    particles[0].radius = 9.5e-3;
    assert_no_pair_is_missed(&mut neighbours, &particles);
    particles[1].position = DVec2::NAN;
    assert_no_pair_is_missed(&mut neighbours, &particles);
    particles[1].position = 3.0 * far;
    assert_no_pair_is_missed(&mut neighbours, &particles);
    particles[1].position = 0.5 * far;
    assert_no_pair_is_missed(&mut neighbours, &particles);
}

#[test]
fn a_giant_among_small_discs_costs_little_more_than_they_do() {
    let disc = |place, radius| Particle::at_rest(place, radius, 1.0);
    let columns = 400;
    let place = |k: usize| DVec2::new((k % columns) as f64, (k / columns) as f64) * 4e-5;
    let mut discs: Vec<_> = (0..columns * columns).map(|k| disc(place(k), 1e-5)).collect();
    let middle = 0.5 * (discs[0].position + discs[discs.len() - 1].position);
    discs.retain(|p| p.position.distance(middle) > 5e-3);
    let time = |discs: &[Particle]| {
        let started = std::time::Instant::now();
        let mut neighbours = Neighbours::default();
        neighbours.refresh(discs);
        (started.elapsed().as_secs_f64(), neighbours.pairs().collect::<Vec<_>>())
    };
    let (without, _) = time(&discs);
    discs.push(disc(middle, 5e-3));
    let (with, pairs) = time(&discs);
    let giant = discs.len() - 1;
    let of_giant = pairs.into_iter().filter(|pair| pair.1 == giant);
    let plain = touching(&discs, (0..giant).map(|k| (k, giant)));
    assert!(plain.len() > 100, "{}", plain.len());
    assert_eq!(touching(&discs, of_giant), plain);
    // A thousand times as much if each small disc looked over the giant's cells.
    assert!(with < 10.0 * without + 0.1, "{with} s, {without} s without it");
}
