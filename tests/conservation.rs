//! Momentum, symmetry, and sums that do not depend on who found the pairs.

use crate::support::{ELASTIC, INTEGRATORS, MASS, RADIUS, disc_at, law};
use glam::DVec2;
use parsim2d::force::Force;
use parsim2d::integrator::Motion;
use parsim2d::neighbours::all_pairs;
use parsim2d::particle::{Contact, ContactLaw, Damping, Particle, SpringDashpot};
use parsim2d::simulation::{Simulation, place_discs};
use parsim2d::work::Channel;

fn damped() -> SpringDashpot {
    law(Damping::Coefficient(0.3))
}

/// Discs of three masses and two radii that fly towards the origin, without walls or gravity.
fn implosion() -> Vec<Particle> {
    let mut discs = place_discs(60, 2.0 * RADIUS, MASS, 0.03, 11).unwrap();
    for (k, disc) in discs.iter_mut().enumerate() {
        disc.position -= DVec2::splat(0.015);
        disc.velocity = -40.0 * disc.position;
        disc.mass *= 1.0 + (k % 3) as f64;
        disc.radius /= 1.0 + (k % 2) as f64;
    }
    discs
}

#[test]
fn momentum_is_constant_to_round_off() {
    for (name, integrator) in INTEGRATORS {
        let mut simulation =
            Simulation::new(implosion(), DVec2::ZERO, damped(), &[], integrator(), 5e-6);
        let momentum =
            |s: &Simulation| s.particles().iter().map(|p| p.mass * p.velocity).sum::<DVec2>();
        let start = momentum(&simulation);
        let scale: f64 = simulation.particles().iter().map(|p| p.mass * p.velocity.length()).sum();
        (0..20_000).for_each(|_| simulation.step());
        assert!(simulation.largest_overlap() > 0.01, "no contact, no test");
        // Each kick rounds each momentum by 1e-16 of its size; 20,000 of them at random.
        assert!((momentum(&simulation) - start).length() < 1e-13 * scale, "{name}");
    }
}

#[test]
fn a_mirrored_start_gives_the_mirrored_run_to_the_bit() {
    for (name, integrator) in INTEGRATORS {
        let run = |mirror: DVec2| {
            let mut discs = implosion();
            for disc in &mut discs {
                disc.position *= mirror;
                disc.velocity *= mirror;
            }
            let mut simulation =
                Simulation::new(discs, DVec2::ZERO, damped(), &[], integrator(), 5e-6);
            (0..5000).for_each(|_| simulation.step());
            simulation.particles().iter().map(|p| p.position * mirror).collect::<Vec<_>>()
        };
        let plain = run(DVec2::ONE);
        for mirror in [DVec2::new(-1.0, 1.0), DVec2::new(1.0, -1.0)] {
            assert_eq!(plain, run(mirror), "{name}");
        }
    }
}

/// The plain way: each disc gathers from all others in ascending id, each contact computed twice.
struct GatheredContacts(SpringDashpot);

impl Force for GatheredContacts {
    fn apply(&mut self, particles: &mut [Particle]) -> f64 {
        let before = particles.to_vec();
        for (i, disc) in particles.iter_mut().enumerate() {
            for j in (0..before.len()).filter(|&j| j != i) {
                if let Some(contact) = Contact::between(&before[i], &before[j]) {
                    disc.force -= self.0.push(&contact) * contact.normal;
                }
            }
        }
        0.0
    }
}

#[test]
fn the_contact_sweep_has_the_bits_of_every_disc_gathering_in_ascending_id() {
    // A law that never pushes, where the force is another's.
    let nothing = SpringDashpot { stiffness: 0.0, ..law(ELASTIC) };
    let run = |law: SpringDashpot, other: Option<Box<dyn Force>>| {
        let integrator = INTEGRATORS[0].1();
        let mut simulation = Simulation::new(implosion(), DVec2::ZERO, law, &[], integrator, 5e-6);
        other.into_iter().for_each(|force| simulation.add_force(force));
        (0..4000).for_each(|_| simulation.step());
        assert!(simulation.time() > 0.0);
        simulation.state_hash()
    };
    let gathered = run(nothing, Some(Box::new(GatheredContacts(damped()))));
    assert_eq!(run(damped(), None), gathered);
}

#[test]
fn every_pair_is_visited_once_and_in_order_by_the_oracle() {
    let pairs: Vec<_> = all_pairs(4).collect();
    assert_eq!(pairs, [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]);
}

#[test]
fn the_work_ledger_changes_no_bit_of_the_motion() {
    for (name, integrator) in INTEGRATORS {
        let run = |with_ledger: bool| {
            let mut simulation = Simulation::new(
                implosion(),
                DVec2::new(0.0, -9.81),
                damped(),
                &[],
                integrator(),
                5e-6,
            );
            if with_ledger {
                simulation.keep_work_ledger();
            }
            (0..3000).for_each(|_| simulation.step());
            simulation.state_hash()
        };
        assert_eq!(run(true), run(false), "{name}");
    }
}

#[test]
fn a_change_by_hand_is_booked_as_given_by_hand() {
    let discs = vec![disc_at(DVec2::ZERO, DVec2::new(1.0, 0.0))];
    let mut simulation =
        Simulation::new(discs, DVec2::ZERO, damped(), &[], INTEGRATORS[0].1(), 1e-3);
    simulation.keep_work_ledger();
    simulation.act(|discs| discs[0].velocity *= 3.0);
    // m/2 (9 - 1) v² = 4e-3 J
    assert!((simulation.works().unwrap().work(Channel::Hand) - 4e-3).abs() < 1e-17);
}

/// A custom integrator sees the discs themselves.
struct Teleport;

impl parsim2d::integrator::Integrator for Teleport {
    fn step(&mut self, discs: &mut dyn Motion, dt: f64) {
        discs.each(&|_, disc| disc.position.x += dt);
        discs.update_forces();
    }
}

#[test]
fn an_integrator_from_outside_may_move_discs_as_it_likes() {
    let discs = vec![disc_at(DVec2::ZERO, DVec2::ZERO)];
    let mut simulation =
        Simulation::new(discs, DVec2::ZERO, damped(), &[], Box::new(Teleport), 0.5);
    (0..3).for_each(|_| simulation.step());
    assert_eq!(simulation.particles()[0].position.x, 1.5);
}

#[test]
fn a_hook_that_changes_nothing_changes_no_bit() {
    for (name, integrator) in INTEGRATORS {
        let run = |with_hook: bool| {
            let mut simulation =
                Simulation::new(implosion(), DVec2::ZERO, damped(), &[], integrator(), 5e-6);
            for _ in 0..3000 {
                if with_hook {
                    simulation.act(|_| {});
                }
                simulation.step();
            }
            assert!(simulation.largest_overlap() > 0.01, "no contact, no test");
            simulation.state_hash()
        };
        assert_eq!(run(true), run(false), "{name}");
    }
}

#[test]
fn velocity_verlet_is_eq_3_started_half_a_kick_earlier_with_damping_too() {
    // Its dashpot is fed the half-step velocity: then the positions are those of Eq. (3) with
    // velocities half a step ahead. Equal to rounding over 200 steps in contact.
    let law = law(Damping::Ratio(0.3));
    let start = || {
        vec![disc_at(DVec2::ZERO, DVec2::new(0.5, 0.0)), disc_at(DVec2::X * 1.001e-3, DVec2::ZERO)]
    };
    let run = |k: usize| {
        let dt = 1e-6;
        Simulation::new(start(), DVec2::ZERO, law, &[], INTEGRATORS[k].1(), dt)
    };
    let (mut symplectic, mut verlet) = (run(0), run(2));
    for _ in 0..200 {
        symplectic.step();
        verlet.step();
        for (a, b) in symplectic.particles().iter().zip(verlet.particles()) {
            assert!((a.position - b.position).length() < 1e-17, "{} {}", a.position, b.position);
        }
    }
    assert!(verlet.largest_overlap() > 0.01, "no contact, no test");
}

#[test]
fn the_largest_overlap_is_told_in_the_smaller_radius() {
    let mut discs =
        vec![disc_at(DVec2::ZERO, DVec2::ZERO), disc_at(DVec2::X * 1.4e-3, DVec2::ZERO)];
    discs[1].radius = 2.0 * RADIUS;
    let simulation = Simulation::new(discs, DVec2::ZERO, damped(), &[], INTEGRATORS[0].1(), 1e-6);
    // Reach 1.5e-3 m: 1e-4 m over 5e-4 m.
    assert!((simulation.largest_overlap() - 0.2).abs() < 1e-12);
}
