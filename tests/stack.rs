//! Two equal discs stacked on the floor: an exact two-body problem with gravity.

use crate::support::{ELASTIC, INTEGRATORS, MASS, RADIUS, STIFFNESS, disc_at, floor, law};
use glam::DVec2;
use parsim2d::simulation::Simulation;

const GRAVITY: f64 = 9.81;

/// The stack at its static overlaps, 2 m g / k below and m g / k between, moved by `shifts` (m).
fn stack(shifts: [f64; 2], dt: f64) -> Simulation {
    let sag = MASS * GRAVITY / STIFFNESS;
    let lower = RADIUS - 2.0 * sag + shifts[0];
    let upper = 3.0 * RADIUS - 3.0 * sag + shifts[1];
    let discs = [lower, upper].map(|y| disc_at(DVec2::new(0.0, y), DVec2::ZERO)).to_vec();
    let gravity = DVec2::new(0.0, -GRAVITY);
    Simulation::new(discs, gravity, law(ELASTIC), &[floor()], INTEGRATORS[0].1(), dt)
}

#[test]
fn a_stack_at_its_static_overlaps_stays_at_rest() {
    let simulation = stack([0.0, 0.0], 1e-6);
    for disc in simulation.particles() {
        // The weight is 1e-2 N; overlaps are differences of 1e-3 m, rounded to 2e-19 m or 1e-14 N.
        assert!(disc.force.length() < 1e-13, "{}", disc.force);
    }
}

#[test]
fn a_stack_swings_at_its_two_exact_frequencies() {
    // omega² = (3 -+ sqrt 5)/2 k/m with shapes (1, golden ratio) and (golden ratio, -1).
    let golden = (1.0 + 5.0f64.sqrt()) / 2.0;
    let small = 0.1 * MASS * GRAVITY / STIFFNESS; // contacts never open
    for (sign, shape) in [(-1.0, [1.0, golden]), (1.0, [golden, -1.0])] {
        let omega = ((3.0 + sign * 5.0f64.sqrt()) / 2.0 * STIFFNESS / MASS).sqrt();
        let dt = 1e-3 / omega;
        let mut simulation = stack(shape.map(|s| small * s), dt);
        let rest = stack([0.0, 0.0], dt).particles()[0].position.y;
        // Twenty zero crossings are nine and a half periods.
        let mut crossings = Vec::new();
        let mut before = simulation.particles()[0].position.y - rest;
        while crossings.len() < 20 {
            simulation.step();
            let after = simulation.particles()[0].position.y - rest;
            if before * after <= 0.0 {
                crossings.push(simulation.time() - dt * after / (after - before));
            }
            before = after;
        }
        let period = 2.0 * (crossings[19] - crossings[0]) / 19.0;
        let measured = std::f64::consts::TAU / period;
        // Eq. (3) shifts a frequency by (omega dt)²/24 = 4e-8; crossings are good to 1e-6.
        assert!((measured / omega - 1.0).abs() < 1e-6, "{measured} {omega}");
    }
}
