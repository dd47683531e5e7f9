//! Discs placed at random or on a lattice: no overlap ever, uniform, and an end to all tries.

use glam::DVec2;
use parsim2d::neighbours::{Neighbours, all_pairs};
use parsim2d::particle::Particle;
use parsim2d::placement::{self, PlacementError, generator, lattice_capacity, packing_fraction};
use parsim2d::simulation::place_discs;
use proptest::prelude::*;

const SIDE: f64 = 0.04;

/// Neither a pair nor a disc and a wall may overlap, not by one bit.
fn assert_free(particles: &[Particle], side: f64) {
    for (k, p) in particles.iter().enumerate() {
        let low = p.position.min_element();
        let high = p.position.max_element();
        assert!(low >= p.radius && side - high >= p.radius, "disc {k} touches a wall");
    }
    let mut neighbours = Neighbours::default();
    neighbours.refresh(particles);
    let near: Vec<_> = if particles.len() < 200 {
        all_pairs(particles.len()).collect()
    } else {
        neighbours.pairs().collect()
    };
    for (i, j) in near {
        let reach = particles[i].radius + particles[j].radius;
        let distance = particles[i].position.distance(particles[j].position);
        assert!(distance >= reach, "discs {i} and {j} overlap");
    }
}

#[test]
fn the_guides_cases_are_placed_without_overlap_in_under_a_second() {
    for (n, radius) in [(20, 1e-4), (1000, 1e-4), (20, 5e-4), (1000, 5e-4)] {
        for seed in 0..5 {
            let begun = std::time::Instant::now();
            let discs = place_discs(n, radius, 1e-3, SIDE, seed).unwrap();
            assert!(begun.elapsed().as_secs_f64() < 1.0, "n = {n}, r = {radius}");
            assert_eq!(discs.len(), n);
            assert_free(&discs, SIDE);
            assert!(discs.iter().all(|p| p.velocity == DVec2::ZERO && p.mass == 1e-3));
        }
    }
}

#[test]
fn a_million_dilute_discs_take_seconds() {
    let begun = std::time::Instant::now();
    let discs = place_discs(1_000_000, 1e-5, 1e-3, SIDE, 1).unwrap();
    assert!(begun.elapsed().as_secs_f64() < 10.0, "{:?}", begun.elapsed()); // measured: 0.6 s
    assert_free(&discs, SIDE);
}

#[test]
fn dilute_placement_is_uniform_over_the_allowed_region() {
    // Chi-square over 10 by 10 equal cells of the region allowed to centres. For 99 degrees of
    // freedom a value above 161 has a chance of 1e-4 (and below 52, of 1e-4: too even is not
    // random either). Ten fixed seeds: they pass or fail for ever.
    let (n, radius) = (10_000, 1e-6);
    for seed in 0..10 {
        let discs = place_discs(n, radius, 1e-3, SIDE, seed).unwrap();
        let mut counts = [0.0; 100];
        for disc in &discs {
            let cell = (disc.position - radius) / (SIDE - 2.0 * radius) * 10.0;
            counts[10 * (cell.y as usize).min(9) + (cell.x as usize).min(9)] += 1.0;
        }
        let expected = n as f64 / 100.0;
        let chi_square: f64 =
            counts.iter().map(|count: &f64| (count - expected).powi(2) / expected).sum();
        assert!((52.0..161.0).contains(&chi_square), "seed {seed}: {chi_square}");
    }
}

#[test]
fn directions_are_uniform_on_the_circle() {
    let mut generator = generator(5);
    let mut counts = [0.0; 16];
    for _ in 0..16_000 {
        let direction = placement::direction(&mut generator);
        assert!((direction.length() - 1.0).abs() < 1e-15);
        let turn = direction.to_angle() / std::f64::consts::TAU + 0.5;
        counts[((turn * 16.0) as usize).min(15)] += 1.0;
    }
    let chi_square: f64 = counts.iter().map(|c: &f64| (c - 1000.0).powi(2) / 1000.0).sum();
    assert!(chi_square < 44.3, "{chi_square}"); // 15 degrees of freedom, chance 1e-4
}

#[test]
fn the_random_numbers_are_those_of_the_named_generator() {
    // Golden: PCG XSL RR 128/64 seeded by rand_core's seed_from_u64(1). A change here changes
    // every run ever made with a seed.
    let mut generator = generator(1);
    let drawn: Vec<String> =
        (0..3).map(|_| format!("{:.17}", placement::uniform(&mut generator))).collect();
    assert_eq!(drawn, ["0.83987365852592488", "0.01729867503557136", "0.11390171020416662"]);
}

#[test]
fn the_same_seed_places_the_same_discs_and_another_seed_others() {
    let place = |seed| place_discs(50, 1e-4, 1e-3, SIDE, seed).unwrap();
    assert_eq!(place(1), place(1));
    assert_ne!(place(1), place(2));
}

#[test]
fn near_the_random_limit_placement_stops_and_says_how_far_it_came() {
    for (radius, most_seconds) in [(5.4e-4, 5.0), (7e-4, 5.0)] {
        let begun = std::time::Instant::now();
        let error = place_discs(1000, radius, 1e-3, SIDE, 1).unwrap_err();
        assert!(begun.elapsed().as_secs_f64() < most_seconds);
        let PlacementError::NoRoomAtRandom { asked, placed, tried, fraction } = error else {
            panic!("{error}");
        };
        assert_eq!(asked, 1000);
        assert!(placed > 400 && placed < 1000 && tried >= 1_000_000, "{placed} {tried}");
        let expected = 1000.0 * std::f64::consts::PI * radius * radius / (SIDE * SIDE);
        assert!((fraction - expected).abs() < 1e-12);
    }
}

#[test]
fn a_lattice_goes_denser_than_random_placement_can() {
    for (n, radius) in [(1000, 5.5e-4), (1000, 6e-4), (1794, 5e-4), (1, 0.0199), (4, 9.9e-3)] {
        let mut discs = vec![Particle::at_rest(DVec2::ZERO, radius, 1e-3); n];
        placement::lattice(&mut discs, SIDE, &mut generator(1)).unwrap();
        assert_free(&discs, SIDE);
        if n == 1000 {
            assert!(packing_fraction(&discs, SIDE) > placement::RANDOM_LIMIT);
        }
    }
}

#[test]
fn a_full_lattice_is_refused_with_the_number_of_its_sites() {
    let mut discs = vec![Particle::at_rest(DVec2::ZERO, 5e-4, 1e-3); 2000];
    let error = placement::lattice(&mut discs, SIDE, &mut generator(1)).unwrap_err();
    let PlacementError::NoRoomOnLattice { asked, sites, .. } = error else { panic!("{error}") };
    assert_eq!((asked, sites), (2000, lattice_capacity(5e-4, SIDE)));
}

#[test]
fn discs_placed_around_fixed_ones_leave_them_where_they_are() {
    let mut discs = vec![Particle::at_rest(DVec2::splat(0.02), 0.01, 1e-3)];
    discs.extend(vec![Particle::at_rest(DVec2::ZERO, 2e-4, 1e-3); 500]);
    discs.extend(vec![Particle::at_rest(DVec2::ZERO, 1e-3, 1e-3); 50]);
    placement::at_random(&mut discs, 1, SIDE, &mut generator(1)).unwrap();
    assert_eq!(discs[0].position, DVec2::splat(0.02));
    assert_free(&discs, SIDE);
}

proptest! {
    #![proptest_config(crate::support::steady())]

    #[test]
    fn whatever_is_placed_never_overlaps(
        n in 1usize..150,
        radius in 1e-5..2e-3f64,
        side in 0.005..0.1f64,
        seed in any::<u64>(),
        on_lattice in any::<bool>(),
    ) {
        let mut discs = vec![Particle::at_rest(DVec2::ZERO, radius, 1e-3); n];
        for disc in discs.iter_mut().step_by(3) {
            disc.radius *= 0.4;
        }
        // Above the limit an error is the right answer, and takes longer to find.
        prop_assume!(packing_fraction(&discs, side) < 0.4);
        let placed = if on_lattice {
            placement::lattice(&mut discs, side, &mut generator(seed))
        } else {
            placement::at_random(&mut discs, 0, side, &mut generator(seed))
        };
        if placed.is_ok() {
            assert_free(&discs, side);
        }
    }
}

#[test]
fn random_placement_ends_where_help_readme_and_errors_say() {
    // A thousand discs of a radius that fills the box to `fraction`.
    let placed = |fraction: f64, seed: u64| {
        let radius = SIDE * (fraction / (1000.0 * std::f64::consts::PI)).sqrt();
        place_discs(1000, radius, 1e-3, SIDE, seed)
    };
    // Two digits are said: at this one all seeds find room, at the next none does.
    let (limit, next) = (placement::RANDOM_LIMIT, placement::RANDOM_LIMIT + 0.01);
    for seed in 1..=3 {
        assert!(placed(limit, seed).is_ok(), "seed {seed}");
        assert!(placed(next, seed).is_err(), "seed {seed}");
    }
    let said = format!("near {limit}");
    assert!(placed(next, 1).unwrap_err().to_string().contains(&said));

    let mut command = assert_cmd::Command::cargo_bin("parsim2d").unwrap();
    let help = String::from_utf8(command.arg("--help").output().unwrap().stdout).unwrap();
    let readme = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");
    let readme = std::fs::read_to_string(readme).unwrap();
    for text in [help, readme] {
        let numbers: Vec<&str> = text
            .split("packing fraction of about ")
            .skip(1)
            .map(|rest| rest.split_whitespace().next().unwrap().trim_end_matches(','))
            .collect();
        assert_eq!(numbers, [limit.to_string()]);
    }
}
