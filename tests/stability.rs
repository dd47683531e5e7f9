//! The largest stable time step: by eigenvalues of the step's matrix, by those of contact networks,
//! and by running just below and just above it.

use crate::support::{ELASTIC, MASS, RADIUS, STIFFNESS, floor, law};
use glam::DVec2;
use parsim2d::analysis::stability::{Assembly, LimitedBy, Species, TwoAtWalls, limit, mode_limit};
use parsim2d::force::HalfPlane;
use parsim2d::integrator::SymplecticEuler;
use parsim2d::neighbours::all_pairs;
use parsim2d::particle::{Contact, Damping, Particle};
use parsim2d::scenario::Scenario;
use parsim2d::simulation::Simulation;

/// The larger modulus of the eigenvalues of Eq. (3)'s 2x2 matrix for x'' = -w² x - c v.
fn spectral_radius(w: f64, c: f64, dt: f64) -> f64 {
    // v' = v - dt (w² x + c v), x' = x + dt v'.
    let trace = (1.0 - c * dt) + (1.0 - w * w * dt * dt);
    let determinant = 1.0 - c * dt;
    let discriminant = 0.25 * trace * trace - determinant;
    match discriminant < 0.0 {
        true => determinant.sqrt(),
        false => 0.5 * trace.abs() + discriminant.sqrt(),
    }
}

#[test]
fn eigenvalues_leave_the_unit_circle_at_the_limit() {
    for zeta in [0.0, 0.1, 0.3, 0.7, 1.0, 3.0, 150.0] {
        let (w, c) = (7.0e3, 2.0 * zeta * 7.0e3);
        // k = w², lambda = 1, eta = c.
        let limit = mode_limit(w * w, c, 1.0);
        // At zeta = 0 the modulus is 1 up to the limit, to rounding.
        assert!(spectral_radius(w, c, 0.9999 * limit) <= 1.0 + 1e-12, "{zeta}");
        assert!(spectral_radius(w, c, 1.0001 * limit) > 1.0 + 1e-6, "{zeta}");
    }
}

/// omega²/k_n of the fastest mode of the contacts that `discs` have now, by power iteration on
/// M^-1/2 H M^-1/2; `planes` count with the stiffness of a disc.
fn fastest_lambda(discs: &[Particle], planes: &[HalfPlane]) -> f64 {
    let pairs: Vec<(usize, usize, DVec2)> = all_pairs(discs.len())
        .filter_map(|(i, j)| Some((i, j, Contact::between(&discs[i], &discs[j])?.normal)))
        .collect();
    let mut mode: Vec<DVec2> = (0..discs.len())
        .map(|i| DVec2::from_angle(2.4 * i as f64 * i as f64)) // no direction preferred
        .collect();
    let mut lambda = 0.0;
    for _ in 0..3000 {
        let moved: Vec<DVec2> =
            mode.iter().zip(discs).map(|(u, disc)| *u / disc.mass.sqrt()).collect();
        let mut force = vec![DVec2::ZERO; discs.len()];
        for &(i, j, n) in &pairs {
            let push = (moved[i] - moved[j]).dot(n) * n;
            force[i] += push;
            force[j] -= push;
        }
        for (i, disc) in discs.iter().enumerate() {
            for plane in planes {
                if plane.distance(disc.position) < disc.radius {
                    force[i] += moved[i].dot(plane.normal) * plane.normal;
                }
            }
        }
        let next: Vec<DVec2> =
            force.iter().zip(discs).map(|(f, disc)| *f / disc.mass.sqrt()).collect();
        lambda = next.iter().map(|u| u.length_squared()).sum::<f64>().sqrt();
        mode = next.into_iter().map(|u| u / lambda).collect();
    }
    lambda
}

/// A triangular packing, `rows` by `rows`, squeezed between the walls of its box so that every
/// neighbour and every wall is touched 1 % deep.
fn squeezed_packing(rows: usize) -> (Vec<Particle>, Vec<HalfPlane>) {
    let pitch = 1.98 * RADIUS;
    let mut discs = Vec::new();
    for row in 0..rows {
        for column in 0..rows {
            let x = (column as f64 + 0.5 * (row % 2) as f64) * pitch;
            let y = row as f64 * pitch * 0.75f64.sqrt();
            discs.push(Particle::at_rest(DVec2::new(x, y), RADIUS, MASS));
        }
    }
    let out = 0.99 * RADIUS;
    let low = DVec2::splat(-out);
    let high = DVec2::new(
        (rows as f64 - 0.5) * pitch + out,
        (rows as f64 - 1.0) * pitch * 0.75f64.sqrt() + out,
    );
    let planes = [(low, DVec2::NEG_X), (high, DVec2::X), (low, DVec2::NEG_Y), (high, DVec2::Y)];
    (discs, planes.map(|(point, normal)| HalfPlane { point, normal }).to_vec())
}

#[test]
fn a_packed_bed_vibrates_no_faster_than_the_rule_says() {
    // The infinite packing has 6/m (Burns and Hanley 2017); 20 x 20 discs come close from below.
    let (discs, planes) = squeezed_packing(20);
    let lambda = fastest_lambda(&discs, &planes) * MASS;
    assert!((5.9..6.0).contains(&lambda), "{lambda}");
    let bed = Assembly::of(&[Species { n: discs.len(), radius: RADIUS, mass: MASS }], None);
    assert_eq!(limit(&law(ELASTIC), &bed).by, LimitedBy::PackedBed);
}

/// The packing after damping has brought it into balance, at rest, every contact still closed.
fn balanced_packing(rows: usize) -> (Vec<Particle>, Vec<HalfPlane>) {
    let (discs, planes) = squeezed_packing(rows);
    let law = law(Damping::Ratio(0.5));
    let integrator = Box::new(SymplecticEuler);
    let dt = 0.2 * mode_limit(STIFFNESS, 0.0, 6.1 / MASS);
    let mut simulation = Simulation::new(discs, DVec2::ZERO, law, &planes, integrator, dt);
    (0..20_000).for_each(|_| simulation.step());
    let mut discs = simulation.particles().to_vec();
    discs.iter_mut().for_each(|disc| disc.velocity = DVec2::ZERO);
    (discs, planes)
}

#[test]
fn a_packed_bed_runs_below_its_own_limit_and_explodes_above() {
    let (discs, planes) = balanced_packing(8);
    let lambda = fastest_lambda(&discs, &planes);
    for zeta in [0.0, 0.5] {
        let eta = 2.0 * zeta * (STIFFNESS / lambda).sqrt(); // zeta of the fastest mode
        let law = law(Damping::Coefficient(eta));
        let limit = mode_limit(STIFFNESS, eta, lambda);
        // Half a hundredth on both sides: squeezed contacts push sideways a little too.
        for (factor, grows) in [(0.995, false), (1.005, true)] {
            let mut discs = discs.clone();
            for (i, disc) in discs.iter_mut().enumerate() {
                // So slow that no contact opens: 1e-5 of the squeeze.
                disc.velocity = 1e-3 * DVec2::from_angle(2.4 * (i * i) as f64) * RADIUS;
            }
            let integrator = Box::new(SymplecticEuler);
            let mut simulation =
                Simulation::new(discs, DVec2::ZERO, law, &planes, integrator, factor * limit);
            (0..4000).for_each(|_| simulation.step());
            let fastest = simulation
                .particles()
                .iter()
                .map(|disc| disc.velocity.length())
                .fold(0.0, f64::max);
            // From 5e-7 m/s: at most a few times that below, until contacts open above.
            assert_eq!(fastest > 1e-4, grows, "zeta {zeta}, {factor}: {fastest}");
            assert!(grows || fastest < 2e-5, "zeta {zeta}, {factor}: {fastest}");
        }
    }
}

#[test]
fn a_large_disc_among_small_ones_has_a_limit_of_its_own() {
    // Found by running: one disc of 3 mm in a ring of 60 of 0.14 mm, all of the same mass, blew up
    // below the limit of equal discs.
    for (count, small, mass) in [(60, 1.4e-4, MASS), (12, 1e-3, MASS), (30, 3e-4, 0.2 * MASS)] {
        let large = 3e-3;
        let mut discs = vec![Particle::at_rest(DVec2::ZERO, large, MASS)];
        for k in 0..count {
            let angle = std::f64::consts::TAU * k as f64 / count as f64;
            let at = DVec2::from_angle(angle) * 0.999 * (large + small);
            discs.push(Particle::at_rest(at, small, mass));
        }
        let lambda = fastest_lambda(&discs, &[]);
        let species = [
            Species { n: 1, radius: large, mass: MASS },
            Species { n: count, radius: small, mass },
        ];
        let rule = Assembly::of(&species, None).large_disc.max(6.1 / mass);
        assert!(lambda <= rule && lambda > 0.1 * rule, "{count}: {lambda} {rule}");
    }
}

#[test]
fn beds_of_unequal_discs_stay_below_the_rule() {
    // Settled under gravity: two sizes with masses as their areas, and with equal masses.
    for (radius, mass) in [(1e-3, 4e-3), (1e-3, 1e-3), (2e-3, 1e-3)] {
        let text = format!(
            "side = 0.02\nrestitution = 0.3\nseed = 3\ntime = 0.3\n\
             [[population]]\nn = 12\nradius = {radius}\nmass = {mass}\n\
             [[population]]\nn = 60\nradius = 5e-4\nmass = 1e-3"
        );
        let scenario = Scenario::from_toml(&text).unwrap();
        let mut simulation = scenario.build().unwrap();
        (0..scenario.steps()).for_each(|_| simulation.step());
        let lambda = fastest_lambda(simulation.particles(), &HalfPlane::square(0.02));
        let assembly = Assembly::of(&scenario.species(), Some(0.02));
        let rule = assembly.large_disc.max(6.1 / assembly.lightest);
        assert!(lambda <= rule && lambda > 2.0 / assembly.lightest, "{radius}: {lambda} {rule}");
    }
}

/// Places where two discs of these radii touch, pressed together and to walls by `depth` (m), the one of
/// them in a corner, on the floor or at the left wall, and the other anywhere around it.
fn touching_places(radii: [f64; 2], side: f64, depth: f64) -> Vec<[DVec2; 2]> {
    let reach = radii[0] + radii[1] - depth;
    let mut places = Vec::new();
    for here in 0..2 {
        let (low, high) = (radii[here] - depth, radii[1 - here] - depth);
        let mut place = |first: DVec2, second: DVec2| {
            places.push(if here == 0 { [first, second] } else { [second, first] });
        };
        let corner = DVec2::splat(low);
        for first in [corner, DVec2::new(0.5 * side, low)] {
            for k in 0..=60 {
                let angle = std::f64::consts::FRAC_PI_2 * f64::from(k) / 60.0;
                place(first, first + reach * DVec2::from_angle(angle));
            }
            // Both on one floor.
            let along = (reach * reach - (high - low) * (high - low)).sqrt();
            place(first, DVec2::new(first.x + along, high));
        }
        // From wall to wall.
        let across = side - radii[0] - radii[1] + 2.0 * depth;
        if across < reach {
            let up = (reach * reach - across * across).sqrt();
            place(corner, corner + DVec2::new(across, up));
        }
    }
    places
}

/// The fastest vibration of two discs in a box wherever they touch, omega²/k_n.
fn fastest_of_two(masses: [f64; 2], radii: [f64; 2], side: f64) -> f64 {
    let planes = HalfPlane::square(side);
    let depth = 1e-7 * radii[0].min(radii[1]); // what counts as a touch
    let is_inside = |radius: f64, at: DVec2| {
        at.min_element() > radius - 2.0 * depth && at.max_element() < side - radius + 2.0 * depth
    };
    let places = touching_places(radii, side, depth).into_iter();
    let inside =
        places.filter(|[one, other]| is_inside(radii[0], *one) && is_inside(radii[1], *other));
    let lambdas = inside.map(|places| {
        let discs = [0, 1].map(|k| Particle::at_rest(places[k], radii[k], masses[k]));
        fastest_lambda(&discs, &planes)
    });
    lambdas.fold(0.0, f64::max)
}

#[test]
fn two_discs_at_walls_vibrate_as_fast_as_the_rule_says_and_no_faster() {
    let elastic = law(ELASTIC);
    for (masses, radii, side) in [
        ([1.0, 1.0], [1.0, 1.0], 40.0),   // golden section, squared
        ([1.0, 1e3], [1.0, 10.0], 200.0), // squeezed: 2/m
        ([1e3, 1.0], [1.0, 10.0], 200.0),
        ([1.0, 4.0], [1.0, 1.0], 40.0),
        ([4.0, 1.0], [1.0, 3.0], 40.0),
        ([1.0, 1.0], [1.0, 4.0], 40.0), // both on one floor: faster than in line
        ([1.0, 1.0], [1.0, 9.0], 60.0), // the small one in the corner does not reach the large one
        ([2.0, 1.0], [1.0, 9.0], 60.0),
        ([1.0, 1.0], [1.0, 1.0], 3.9), // from wall to wall
        ([1.0, 2.0], [1.0, 1.3], 4.3),
        ([1.0, 1.0], [1.0, 1.0], 3.45),  // in opposite corners, nearly
        ([1.0, 30.0], [1.0, 9.0], 19.0), // too narrow for the small one to stand under the large one
    ] {
        let seen = fastest_of_two(masses, radii, side);
        let two = TwoAtWalls { masses, radii, side };
        let omega = 2.0 / two.limit(&elastic);
        let rule = omega * omega / elastic.stiffness;
        // Places are tried in steps of 1.5 degrees, and contacts 1e-7 deep turn the normal by as much.
        let error = seen / rule - 1.0;
        assert!((-1e-3..1e-5).contains(&error), "{masses:?} {radii:?} {side}: {seen} {rule}");
    }
}

#[test]
fn the_closed_forms_of_two_discs_and_a_wall_hold() {
    let limit = |masses: [f64; 2], damping| {
        let two = TwoAtWalls { masses, radii: [1e-3; 2], side: 1.0 };
        two.limit(&law(damping))
    };
    // The larger root of the chain wall - a - b: (2/a - L)(1/b - L) = 1/(a b).
    for (a, b) in [(1e-3f64, 1e-3f64), (1e-3, 1.0), (1e-3, 5e-3), (1e-6, 1e-3)] {
        let half = 0.5 * (2.0 / a + 1.0 / b);
        let lambda = half + (half * half - 1.0 / (a * b)).sqrt();
        for masses in [[a, b], [b, a]] {
            let expected = mode_limit(STIFFNESS, 0.0, lambda);
            assert!((limit(masses, ELASTIC) / expected - 1.0).abs() < 1e-12, "{masses:?}");
            // One eta_n for all contacts damps the mode like its stiffness.
            let eta = 0.3 * (STIFFNESS / lambda).sqrt();
            let expected = mode_limit(STIFFNESS, eta, lambda);
            let found = limit(masses, Damping::Coefficient(eta));
            assert!((found / expected - 1.0).abs() < 1e-12, "{masses:?}");
        }
    }
}

#[test]
fn a_stack_of_two_holds_below_the_limit_and_explodes_above() {
    // Both orders, and a damping that is not the same coefficient for pair and wall.
    for (masses, damping) in [
        ([MASS, MASS], ELASTIC),
        ([MASS, 1000.0 * MASS], ELASTIC),
        ([MASS, MASS], Damping::Ratio(0.4)),
        ([MASS, 3.0 * MASS], Damping::Rate(4e3)),
    ] {
        let law = law(damping);
        let radii = [RADIUS; 2];
        let limit = TwoAtWalls { masses, radii, side: 0.04 }.limit(&law);
        for (factor, grows) in [(0.99, false), (1.01, true)] {
            // Pressed to the floor 1 % of a radius deep, and moved a hair: no contact opens.
            let depth = 0.01 * RADIUS;
            let push = STIFFNESS * depth / masses.iter().sum::<f64>();
            let between = masses[1] * push / STIFFNESS;
            let low = RADIUS - depth;
            let heights = [low, low + 2.0 * RADIUS - between];
            let mut discs =
                [0, 1].map(|k| Particle::at_rest(DVec2::new(0.0, heights[k]), RADIUS, masses[k]));
            let start = 1e-9 * depth * (STIFFNESS / MASS).sqrt(); // m/s
            discs[0].velocity.y = start;
            let (discs, gravity) = (discs.to_vec(), DVec2::new(0.0, -push));
            let integrator = Box::new(SymplecticEuler);
            let dt = factor * limit;
            let mut run = Simulation::new(discs, gravity, law, &[floor()], integrator, dt);
            (0..1000).for_each(|_| run.step());
            let fastest =
                run.particles().iter().map(|disc| disc.velocity.length()).fold(0.0, f64::max);
            // Above by 0.01 the mode grows by 1 % a step or more; below it beats, or is damped.
            assert_eq!(
                fastest > 1e3 * start,
                grows,
                "{masses:?} {damping:?} {factor}: {fastest} {start}"
            );
        }
    }
}
